"""A four-bar that is asked to meet a function (задание: функция по точкам)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from plans.model.synthesis.design import Design
from plans.model.synthesis.positions import TOUCH, FunctionTask, bent
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import met, millimetres, number
from plans.synthesis.asked.nearest import nearest
from plans.synthesis.rod_positions import function_points
from plans.synthesis.tables.positions import FunctionTable
from plans.synthesis.written import SPEED, MechanismText

PATH: Path = ("synthesis", "function_points")


def task(table: FunctionTable) -> FunctionTask:
    """Make the task."""
    inputs, outputs = (tuple(map(math.radians, one)) for one in (table.inputs, table.outputs))
    return FunctionTask(inputs, outputs, float(table.crank), float(table.frame), number(table.rocker))


def faults(scene: Scene, task: FunctionTask) -> Iterator[Fault]:
    """Say that the rocker is too short, or with which crank the function is met."""
    if met(function_points(task)):
        return
    pins = [cmath.rect(task.crank, angle) - task.frame for angle in task.inputs]
    seen = [pin * cmath.rect(1.0, task.outputs[0] - angle) for pin, angle in zip(pins, task.outputs, strict=True)]
    if task.rocker is not None and abs(seen[1] - seen[0]) > 0:
        least = abs(abs(seen[1]) ** 2 - abs(seen[0]) ** 2) / (2 * abs(seen[1] - seen[0]))
        if least >= task.rocker * (1 - TOUCH**2):
            yield scene.fault((*PATH, "rocker"), "synthesis_rocker", least=millimetres(least))
            return
    times = nearest(lambda times: met(function_points(task._replace(crank=times * task.crank))))
    there = "—" if times is None else f"{millimetres(times * task.crank)} mm"
    straight = task.rocker is None and not bent(seen)
    yield scene.fault((*PATH, "crank"), "synthesis_pins_straight" if straight else "synthesis_function", met=there)


def mechanism(made: Design) -> MechanismText:
    """Give the tables of the mechanism, its crank in the positions of the function."""
    size, place = made.sizes, made.places
    lengths = {"OA": size["l_1"], "AB": size["l_2"], "CB": size["l_3"]}
    angles = [math.degrees(cmath.phase(at)) for name, at in place.items() if name in ("A_1", "A_2", "A_3")]
    drive = {"link": 1, "speed": SPEED, "positions": angles}
    return MechanismText({"O": 0j, "C": place["C"]}, ("OA", "AB", "CB"), lengths, {"B": place["B_1"]}, drive=drive)


def notes(task: FunctionTask) -> Iterator[str]:
    """Name what the sheet says of how the rocker's end was found."""
    yield "synthesis held"
