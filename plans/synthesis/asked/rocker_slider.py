"""A rocker-slider that is asked for (задание на коромыслово-ползунный механизм)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from plans.model.synthesis.design import Design
from plans.model.synthesis.positions import TOUCH
from plans.model.synthesis.swings import RockerSliderTask
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import met, number, radians
from plans.synthesis.rocker_slider import drawn
from plans.synthesis.tables.swings import RockerSliderTable
from plans.synthesis.written import SPEED, MechanismText

PATH: Path = ("synthesis", "rocker_slider")
PARTS = 8  # of the swing, between the positions of the written scene


def task(table: RockerSliderTable) -> RockerSliderTask:
    """Make the task."""
    angles = None if table.angles is None else (math.radians(table.angles[0]), math.radians(table.angles[1]))
    return RockerSliderTask(float(table.stroke), radians(table.pressure), number(table.ratio), angles)


def faults(scene: Scene, task: RockerSliderTask) -> Iterator[Fault]:
    """Say what is too little, and how large a ratio must or may be."""
    most = "" if task.angles is None else f"{1 / math.sin(task.steepest):.6g}"
    if task.angles is not None and task.ratio is None and task.pressure is None:
        yield scene.fault(PATH, "synthesis_any_ratio", most=most)
    elif task.angles is not None and task.ratio is not None and task.ratio * math.sin(task.steepest) >= 1 - TOUCH**2:
        yield scene.fault((*PATH, "ratio"), "synthesis_reach", most=most)
    elif not met(drawn(task)):
        assert task.pressure is not None  # with a ratio that reaches the slider moves, but of rods as long as rockers
        sine = math.sin(task.pressure)
        yield scene.fault((*PATH, "ratio"), "synthesis_turns_back", least=f"{2 * sine / (1 - sine):.6g}")


def mechanism(made: Design) -> MechanismText:
    """Give the tables of the mechanism, driven by its rocker from one end to the other."""
    size, place = made.sizes, made.places
    first, second = (math.degrees(cmath.phase(place[f"A_{k}"] - place["C"])) for k in (1, 2))
    slide = {"link": 3, "along": {"through": place["B_1"], "angle": 0}}
    angles = [first + (second - first) * k / PARTS for k in range(PARTS + 1)]
    drive = {"link": 1, "speed": SPEED if second > first else f"-{SPEED}", "positions": angles}
    lengths = {"CA": size["l_1"], "AB": size["l_2"]}
    return MechanismText({"C": place["C"]}, ("CA", "AB", "B"), lengths, {"B": place["B_1"]}, (slide,), drive)


def notes(task: RockerSliderTask) -> Iterator[str]:
    """Name what the sheet says of how it was found."""
    yield "synthesis axial" if task.angles else "synthesis leaning"
    if len(task.readings) > 1:
        yield "synthesis readings of rods"
