"""A rocker that is asked to rest (задание: механизм с выстоем)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final

from plans.analytic.synthesis.dwell import crank, readings, turns
from plans.analytic.synthesis.guided import centres
from plans.model.synthesis.design import Design
from plans.model.synthesis.positions import DwellTask
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import millimetres
from plans.synthesis.tables.positions import DwellTable
from plans.synthesis.written import SPEED, MechanismText

PATH: Path = ("synthesis", "dwell")
TRIED: Final = 3600  # crank angles


def task(table: DwellTable) -> DwellTask:
    """Make the task."""
    lengths = float(table.crank), float(table.coupler), float(table.rocker), float(table.frame)
    begin, end = map(math.radians, table.dwell)
    arm = float(table.arm), math.radians(table.lean)
    return DwellTask(lengths, *arm, (begin, end), float(table.output), table.crossed)


def faults(scene: Scene, task: DwellTask) -> Iterator[Fault]:
    """Say that the crank does not go round, that K goes straight, or which rockers follow."""
    if not turns(task):
        _, l2, l3, l4 = task.lengths
        most = min(l2 + l3 - l4, l4 - abs(l2 - l3))
        yield scene.fault((*PATH, "crank"), "synthesis_goes_round", most=millimetres(most) if most > 0 else "—")
    elif not [*centres(near := [crank(task, task.stations[k])[2] for k in (0, 2, 4)], None)]:
        yield scene.fault((*PATH, "dwell"), "synthesis_point_straight", off=millimetres(_sagitta(near)))
    elif not readings(task)[0].found:
        within = [
            f"{millimetres(low)} … {millimetres(high)}" for side in (1, -1) for low, high in (following(task, side),) if low < high
        ]
        yield scene.fault((*PATH, "output"), "synthesis_follows", within="; ".join(within) or "—")


def following(task: DwellTask, side: int) -> tuple[float, float]:
    """Give between what lengths m a rocker follows K over the whole turn, its pivot to one side of the rod.

    With d from D to K and v from D to the pivot's side, (rod - r)^2 < |d - r v|^2 < (rod + r)^2 is linear in r.
    """
    places = [crank(task, math.tau * k / TRIED)[2] for k in range(TRIED)]
    near = [crank(task, task.stations[k])[2] for k in (0, 2, 4)]
    (centre,) = centres(near, None)
    rod, way = abs(near[1] - centre), side * 1j * (near[1] - centre) / abs(near[1] - centre)
    low, high = 0.0, math.inf
    for place in places:
        off, along = abs(place - centre) ** 2 - rod**2, ((place - centre) * way.conjugate()).real
        for slope, least in ((2 * (rod + along), off), (2 * (rod - along), -off)):  # r slope > least
            if slope > 0:
                low = max(low, least / slope)
            elif slope < 0:
                high = min(high, least / slope)
    return low, high


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
