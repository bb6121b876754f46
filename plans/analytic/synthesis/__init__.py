"""Synthesis by closed forms and roots: no figure is drawn (аналитический синтез)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final

from plans.analytic.synthesis import double_crank, dwell, guided, rocker, rocker_slider, slider, slots
from plans.model.synthesis.design import ANALYSIS, Design, Synthesis, SynthesisTask, TaskReading
from plans.model.synthesis.extremes import DoubleCrankTask, RockerTask, SliderTask
from plans.model.synthesis.positions import DwellTask, FunctionTask, RodTask
from plans.model.synthesis.region import Region
from plans.model.synthesis.slots import LeverTask, SineTask, TangentTask, WhitworthTask
from plans.model.synthesis.swings import RockerSliderTask

ROADS: Final[Mapping[type, Callable[[Any], Iterable[TaskReading]]]] = {
    RockerTask: rocker.readings,
    SliderTask: slider.readings,
    DoubleCrankTask: double_crank.readings,
    **dict.fromkeys((LeverTask, WhitworthTask, SineTask, TangentTask), slots.readings),
    RockerSliderTask: rocker_slider.readings,
    RodTask: guided.rods,
    FunctionTask: guided.functions,
    DwellTask: dwell.readings,
}


def analysed(task: SynthesisTask) -> Synthesis:
    """Solve a task: every mechanism of each of its readings."""
    return Synthesis(ANALYSIS, tuple(ROADS[type(task)](task)))


REGIONS: Final[Mapping[type, Callable[[Any, Design], Region | None]]] = {
    RockerTask: rocker.region,
    SliderTask: slider.region,
}


def region_of(task: SynthesisTask, design: Design) -> Region | None:
    """Give what the free parameter of a task makes of a mechanism that does what is asked, if it has one."""
    found = REGIONS.get(type(task))
    return None if found is None else found(task, design)
