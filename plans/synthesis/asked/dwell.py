"""A rocker that is asked to rest (задание: механизм с выстоем)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from plans.model.synthesis.design import Design
from plans.model.synthesis.positions import DwellTask, bent
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import met, millimetres
from plans.synthesis.dwell import drawn, following, goes_round, near
from plans.synthesis.tables.positions import DwellTable
from plans.synthesis.written import SPEED, MechanismText

PATH: Path = ("synthesis", "dwell")


def task(table: DwellTable) -> DwellTask:
    """Make the task."""
    lengths = float(table.crank), float(table.coupler), float(table.rocker), float(table.frame)
    begin, end = map(math.radians, table.dwell)
    arm = float(table.arm), math.radians(table.lean)
    return DwellTask(lengths, *arm, (begin, end), float(table.output), table.crossed)


def faults(scene: Scene, task: DwellTask) -> Iterator[Fault]:
    """Say that the crank does not go round, that K goes straight, or which rockers follow."""
    if not goes_round(task):
        _, l2, l3, l4 = task.lengths
        most = min(l2 + l3 - l4, l4 - abs(l2 - l3))
        yield scene.fault((*PATH, "crank"), "synthesis_goes_round", most=millimetres(most) if most > 0 else "—")
    elif not bent(places := near(task)):
        yield scene.fault((*PATH, "dwell"), "synthesis_point_straight", off=millimetres(_sagitta(places)))
    elif not met(drawn(task)):
        sides = [following(task, side) for side in (1, -1)]
        within = [f"{millimetres(low)} … {millimetres(high)}" for low, high in sides if low < high]
        yield scene.fault((*PATH, "output"), "synthesis_follows", within="; ".join(within) or "—")


def _sagitta(places: Sequence[complex]) -> float:
    """Give how far the middle of three places is off the line of the others, m."""
    chord = places[2] - places[0]
    return abs(((places[1] - places[0]) * chord.conjugate()).imag) / abs(chord) if chord else 0.0


def mechanism(made: Design) -> MechanismText:
    """Give the tables of the six-bar, its crank at first where the dwell begins."""
    size, place = made.sizes, made.places
    lengths = {"OA": size["l_1"], "AB": size["l_2"], "CB": size["l_3"], "KD": size["l_5"], "FD": size["l_6"]}
    along = place["B_1"] - place["A_1"]
    points = {"K": {"on": 2, "at": (place["K_1"] - place["A_1"]) * along.conjugate() / abs(along)}}
    start = math.degrees(math.atan2(place["A_1"].imag, place["A_1"].real))
    frame = {name: place[name] for name in "OCF"}
    drive = {"link": 1, "speed": SPEED, "start": start, "positions": 24}
    sketch = {"B": place["B_1"], "D": place["D"]}
    return MechanismText(frame, ("OA", "AB", "CB", "KD", "FD"), lengths, sketch, drive=drive, points=points)


def notes(task: DwellTask) -> Iterator[str]:
    """Name what the sheet says of the circle and of the rest."""
    yield "synthesis circle of rest"
    yield "synthesis rest"
