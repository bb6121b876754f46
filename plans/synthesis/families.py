"""The families of mechanisms that a task may ask for, by the keys of their tables (виды задач синтеза)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final, NamedTuple

from plans.model.synthesis.design import Design
from plans.model.synthesis.region import Region
from plans.scene.faults import Fault
from plans.scene.scene import Scene
from plans.synthesis import double_crank, dwell, rocker, rocker_slider, rod_positions, slider
from plans.synthesis.asked import double_crank as asked_double_crank
from plans.synthesis.asked import dwell as asked_dwell
from plans.synthesis.asked import function_points as asked_function
from plans.synthesis.asked import rocker as asked_rocker
from plans.synthesis.asked import rocker_slider as asked_rocker_slider
from plans.synthesis.asked import rod_positions as asked_rod
from plans.synthesis.asked import slider as asked_slider
from plans.synthesis.asked import slots
from plans.synthesis.drawn import DrawnReading
from plans.synthesis.sine import drawn_sines, drawn_tangents
from plans.synthesis.slotted import drawn_levers, drawn_whitworths
from plans.synthesis.written import MechanismText


class SynthesisFamily(NamedTuple):
    """How a task of a family is drawn, and of its table: the task, its faults, its scene, what its sheet says."""

    drawn: Callable[[Any], tuple[DrawnReading, ...]]
    task: Callable[[Any], Any]
    faults: Callable[[Scene, Any], Iterable[Fault]]
    mechanism: Callable[[Design], MechanismText]
    notes: Callable[[Any], Iterable[str]]  # the names of phrases
    region: Callable[[Any, Design], Region | None] = lambda task, design: None  # of a free parameter


def _family(drawn: Callable[[Any], tuple[DrawnReading, ...]], asked: Any) -> SynthesisFamily:
    return SynthesisFamily(drawn, asked.task, asked.faults, asked.mechanism, asked.notes)


FAMILIES: Final[Mapping[str, SynthesisFamily]] = {
    "crank_rocker": _family(rocker.drawn, asked_rocker)._replace(region=rocker.region),
    "double_crank": _family(double_crank.drawn, asked_double_crank),
    "slider_crank": _family(slider.drawn, asked_slider)._replace(region=slider.region),
    "slotted_lever": SynthesisFamily(
        drawn_levers, slots.lever_task, slots.lever_faults, slots.slotted, slots.slotted_notes
    ),
    "whitworth": SynthesisFamily(
        drawn_whitworths, slots.whitworth_task, slots.whitworth_faults, slots.slotted, slots.slotted_notes
    ),
    "sine": SynthesisFamily(drawn_sines, slots.sine_task, slots.sine_faults, slots.sine, slots.sine_notes),
    "tangent": SynthesisFamily(
        drawn_tangents, slots.tangent_task, slots.tangent_faults, slots.tangent, slots.tangent_notes
    ),
    "rocker_slider": _family(rocker_slider.drawn, asked_rocker_slider),
    "rod_positions": _family(rod_positions.rod_positions, asked_rod),
    "function_points": _family(rod_positions.function_points, asked_function),
    "dwell": _family(dwell.drawn, asked_dwell),
}
