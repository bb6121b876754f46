"""A double crank that is asked for (задание на двухкривошипный механизм)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from plans.model.synthesis.design import Design
from plans.model.synthesis.extremes import DoubleCrankTask
from plans.scene.faults import Fault
from plans.scene.scene import Scene
from plans.synthesis.asked import rocker
from plans.synthesis.tables.extremes import DoubleCrankTable
from plans.synthesis.written import SPEED, MechanismText


def task(table: DoubleCrankTable) -> DoubleCrankTask:
    """Make the task of the crank-rocker that is inverted."""
    return DoubleCrankTask(rocker.made(table, table.coupler, table.driver))


def faults(scene: Scene, task: DoubleCrankTask) -> Iterator[Fault]:
    """Say what drivers or places can be met, where that asked for cannot."""
    return rocker.faults(scene, task.inverted, ("synthesis", "double_crank"), "driver")


def mechanism(made: Design) -> MechanismText:
    """Give the tables of the mechanism; position 0 is where O, A and B are in one line."""
    size, place = made.sizes, made.places
    lengths = {"OC": size["l_1"], "CB": size["l_2"], "AB": size["l_3"]}
    start = math.degrees(cmath.phase(place["C"] - place["O"]))
    frame, sketch = {"O": place["O"], "A": place["A_1"]}, {"C": place["C"], "B": place["B_1"]}
    drive = {"link": 1, "speed": SPEED, "start": start, "positions": 12}
    return MechanismText(frame, ("OC", "CB", "AB"), lengths, sketch, drive=drive)


def notes(task: DoubleCrankTask) -> Iterator[str]:
    """Name what the sheet says of the place of O, and of the inversion."""
    yield from (one for one in rocker.notes(task.inverted) if one != "synthesis read")
    yield "synthesis inverted"
