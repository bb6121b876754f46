"""A crank-rocker that is asked for (задание на кривошипно-коромысловый механизм)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from decimal import Decimal

from plans.model.synthesis.design import Design
from plans.model.synthesis.extremes import BEYOND, TOWARDS, RockerTask
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import MILLIMETRES, met, millimetres, number, overlap, radians
from plans.synthesis.rocker import admitted, drawn, with_best
from plans.synthesis.tables.extremes import RockerTable, SwingTable
from plans.synthesis.written import MechanismText

RIGHT = 90.0  # degrees
PATH: Path = ("synthesis", "crank_rocker")


def task(table: RockerTable) -> RockerTask:
    """Make the task; where no parameter is told, O is put where it is best."""
    return made(table, table.rocker, table.frame)


def made(table: SwingTable, rocker: Decimal, frame: Decimal | None) -> RockerTask:
    """Make the task of a rocker and a frame of some lengths."""
    place = radians(table.place)
    told = place is not None or "beyond" in table.given
    side = (BEYOND if table.beyond else TOWARDS) if told else None
    theta = overlap(table)
    assert theta is not None  # the form has asked for it
    swing = math.radians(table.swing)
    return with_best(RockerTask(float(rocker), swing, theta, number(frame), place, side))


def faults(scene: Scene, task: RockerTask, path: Path = PATH, free: str = "frame") -> Iterator[Fault]:
    """Say what frames or places can be met, where that asked for cannot."""
    outside = math.degrees(task.swing / 2 + task.overlap)
    if task.side == BEYOND and task.overlap and outside >= RIGHT:
        yield scene.fault((*path, "beyond"), "synthesis_beyond", sum=f"{outside:.6g}")
    elif task.frame is None and task.place is None:
        why = "synthesis_centric" if path == PATH else f"synthesis_centric_{free}"
        yield scene.fault(path, why, least=millimetres(task.rocker))
    elif not met(drawn(task)):
        name = free if task.place is None else "place"
        within = "; ".join(f"{low:.10g} … {high:.10g}" for low, high in _within(task))
        yield scene.fault((*path, name), f"synthesis_{name}", within=within or "—")


def _within(task: RockerTask) -> Iterator[tuple[float, float]]:
    """Give the frames mm, or the places in degrees, that some mechanism has."""
    if not task.overlap:
        yield MILLIMETRES * task.rocker, math.inf
        return
    for places, frames in admitted(task):
        if task.place is None:
            yield MILLIMETRES * frames[0], MILLIMETRES * frames[1]
        else:
            yield math.degrees(places[0]), math.degrees(places[1])


def mechanism(made: Design) -> MechanismText:
    """Give the tables of the mechanism."""
    size, place = made.sizes, made.places
    lengths = {"OA": size["l_1"], "AB": size["l_2"], "CB": size["l_3"]}
    return MechanismText({"O": place["O"], "C": 0j}, ("OA", "AB", "CB"), lengths, {"B": place["B_1"]})


def notes(task: RockerTask) -> Iterator[str]:
    """Name what the sheet says of the place of O."""
    yield "synthesis best" if task.best else "synthesis free" if task.frame is None else "synthesis framed"
    if task.overlap:
        yield "synthesis barred"
    yield "synthesis read"
