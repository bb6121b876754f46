"""Synthesis by closed forms and roots: no figure is drawn (аналитический синтез)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final

from plans.analytic.synthesis import dwell, guided, rocker, rocker_slider, slider
from plans.model.synthesis.design import ANALYSIS, Reading, Synthesis, Task
from plans.model.synthesis.extremes import RockerTask, SliderTask
from plans.model.synthesis.positions import DwellTask, FunctionTask, RodTask
from plans.model.synthesis.swings import RockerSliderTask

ROADS: Final[Mapping[type, Callable[[Any], Iterable[Reading]]]] = {
    RockerTask: rocker.readings,
    SliderTask: slider.readings,
    RockerSliderTask: rocker_slider.readings,
    RodTask: guided.rods,
    FunctionTask: guided.functions,
    DwellTask: dwell.readings,
}


def analysed(task: Task) -> Synthesis:
    """Solve a task: every mechanism of each of its readings."""
    return Synthesis(ANALYSIS, tuple(ROADS[type(task)](task)))
