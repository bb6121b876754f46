"""A slider-crank that is asked for (задание на кривошипно-ползунный механизм)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from plans.model.synthesis.design import QUARTER, Design
from plans.model.synthesis.extremes import PAIR, SliderTask
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import degrees, met, millimetres, number, radians
from plans.synthesis.asked.slots import drive, overlap_in, pace, pace_faults, pace_notes
from plans.synthesis.slider import drawn, with_best
from plans.synthesis.tables.extremes import SliderTable
from plans.synthesis.written import MechanismText

PATH: Path = ("synthesis", "slider_crank")


def task(table: SliderTable) -> SliderTask:
    """Make the task; no offset and no overlap are one demand."""
    stroke, speeds = float(table.stroke), pace(table)
    theta = overlap_in(table, stroke, speeds)
    made = SliderTask(stroke, number(table.offset), theta, number(table.ratio), radians(table.pressure), pace=speeds)
    return made._replace(overlap=None) if made.overlap == 0 and made.offset == 0 else with_best(made)


def faults(scene: Scene, task: SliderTask) -> Iterator[Fault]:
    """Say what is too little, what contradicts, and by how much a demand is beyond what can be met."""
    known = frozenset(task.demands)
    if paced := [*pace_faults(scene, PATH, task.stroke, task.pace)]:
        yield from paced
    elif len(known) < PAIR and not (known & {"ratio", "pressure"} or task.turned):
        yield scene.fault(PATH, "synthesis_free")
    elif task.overlap is not None and task.offset is not None and bool(task.overlap) != bool(task.offset):
        yield scene.fault((*PATH, "offset"), "synthesis_axial")
    elif not met(drawn(task)):
        yield _beyond(scene, task)


def _beyond(scene: Scene, task: SliderTask) -> Fault:
    """Tell how much of a demand can be met beside the others."""
    stroke, ratio = task.stroke, task.ratio
    if task.pressure is not None and ratio is not None:
        return scene.fault((*PATH, "pressure"), "synthesis_least_pressure", least=degrees(math.asin(1 / ratio)))
    if task.pressure is not None and task.overlap:
        best = with_best(task.only("overlap"))
        least = drawn(best)[0].found[0].design.sizes["α_max"]
        return scene.fault((*PATH, "pressure"), "synthesis_least_pressure", least=degrees(least))
    if task.overlap is None:
        assert ratio is not None  # else too little is told
        most = stroke * (ratio**2 - 1) / (4 * ratio)
        return scene.fault((*PATH, "offset"), "synthesis_offset", most=millimetres(most))
    if ratio is not None:
        angle = math.acos((ratio - 1) / (ratio + 1))
    else:
        angle = math.atan(stroke / task.offset) if task.offset else QUARTER
    name = next((one for one in ("time_ratio", "mean_speed") if scene.has((*PATH, one))), "overlap")
    return scene.fault((*PATH, name), "synthesis_overlap", most=degrees(angle))


def mechanism(made: Design) -> MechanismText:
    """Give the tables of the mechanism, O at its origin."""
    size, offset = made.sizes, complex(0.0, made.sizes["e"])
    slide = {"link": 3, "along": {"through": offset, "angle": 0}}
    lengths = {"OA": size["l_1"], "AB": size["l_2"]}
    there = complex(size["l_1"] + size["l_2"]) + offset
    return MechanismText({"O": 0j}, ("OA", "AB", "B"), lengths, {"B": there}, (slide,), drive(made))


def notes(task: SliderTask) -> Iterator[str]:
    """Name what the sheet says of readings, and of what is read."""
    if task.turned is not None:
        yield "synthesis best"
    if len(task.readings) > 1:
        yield "synthesis readings"
    if task.pressure is not None and (task.offset or task.overlap):
        yield "synthesis tried"
    yield "synthesis similar" if task.similar else "synthesis read"
    yield from pace_notes(task.pace)
