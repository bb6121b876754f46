"""Synthesis by closed forms and roots: no figure is drawn (аналитический синтез)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final

from plans.analytic.synthesis import rocker, slider
from plans.model.synthesis.design import ANALYSIS, Reading, Synthesis, Task
from plans.model.synthesis.extremes import RockerTask, SliderTask

ROADS: Final[Mapping[type, Callable[[Any], Iterable[Reading]]]] = {
    RockerTask: rocker.readings,
    SliderTask: slider.readings,
}


def analysed(task: Task) -> Synthesis:
    """Solve a task: every mechanism of each of its readings."""
    return Synthesis(ANALYSIS, tuple(ROADS[type(task)](task)))
