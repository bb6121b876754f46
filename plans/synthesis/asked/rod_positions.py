"""A four-bar that is asked to guide its rod (задание: положения шатуна)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Final

from plans.model.synthesis.design import Design
from plans.model.synthesis.positions import TOUCH, RodTask, bent
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import met, millimetres
from plans.synthesis.asked.nearest import nearest
from plans.synthesis.rod_positions import rod_positions
from plans.synthesis.tables.positions import Place, RodTable
from plans.synthesis.written import SPEED, MechanismText

PATH: Path = ("synthesis", "rod_positions")
STANDS: Final = 1e-9  # m, the least length of a scene


def task(table: RodTable) -> RodTask:
    """Make the task."""
    places, angles = tuple(map(_place, table.places)), tuple(map(math.radians, table.angles))
    arms = None if table.arms is None else (float(table.arms[0]), float(table.arms[1]))
    return RodTask(places, angles, _both(table.hinges), _both(table.pivots), arms)


def _place(pair: Place) -> complex:
    return complex(*map(float, pair))


def _both(pair: tuple[Place, Place] | None) -> tuple[complex, complex] | None:
    return None if pair is None else (_place(pair[0]), _place(pair[1]))


def _spot(at: complex) -> str:
    return f"({millimetres(at.real)}, {millimetres(at.imag)})"


def faults(scene: Scene, task: RodTask) -> Iterator[Fault]:
    """Say which hinge has no pivot, and by how much; or that no link leads through the positions in their order."""
    if met(rod_positions(task)):
        return
    kind, known = ("hinges", task.hinges) if task.hinges else ("pivots", task.pivots)
    assert known is not None  # one of them is told
    alone = [fault for k in (0, 1) for fault in _alone(scene, task, (*PATH, kind, k), known[k])]
    yield from alone or [_unled(scene, task, kind, known)]


def _alone(scene: Scene, task: RodTask, path: Path, at: complex) -> Iterator[Fault]:
    """Tell of a hinge that stands, that goes straight, or whose arm is too short; of a pivot as the rod sees it."""
    _, kind, k = path[1:]
    moves = task.moves if kind == "hinges" else tuple((1 / turn, -shift / turn) for turn, shift in task.moves)
    places, hinge = [turn * at + shift for turn, shift in moves], ("AB" if kind == "hinges" else "OC")[int(k)]
    still = [pair for pair in combinations(range(len(places)), 2) if abs(places[pair[0]] - places[pair[1]]) < STANDS]
    if still:
        yield scene.fault(path, "synthesis_hinge_still", hinge=hinge, first=still[0][0] + 1, second=still[0][1] + 1)
    elif task.arms:
        if abs(places[1] - places[0]) >= 2 * task.arms[int(k)] * (1 - TOUCH**2):
            least = millimetres(abs(places[1] - places[0]) / 2)
            yield scene.fault((*PATH, "arms", k), "synthesis_arm", least=least)
    elif not bent(places):
        centre, radius = straight(moves)
        if math.isfinite(radius):
            told = {"centre": _spot(centre), "radius": millimetres(radius)}
            yield scene.fault(path, "synthesis_hinge_straight", hinge=hinge, **told)
        else:
            yield scene.fault(path, "synthesis_hinge_shifted", hinge=hinge)


def straight(moves: Sequence[tuple[complex, complex]]) -> tuple[complex, float]:
    """Give the circle of the points of a body that are on one line in three positions: its centre and radius.

    Im((p a + s)(q a + t)*) = 0, where the moves take a by p a + s and q a + t on.
    """
    (p, s), (q, t) = ((turn - 1, shift) for turn, shift in moves[1:])
    both = (p * q.conjugate()).imag
    if not both:  # two of the positions are parallel: such points are on a line, or all are such
        return complex(math.inf), math.inf
    centre = -1j * (p * t.conjugate() - s.conjugate() * q).conjugate() / (2 * both)
    return centre, math.sqrt(max(abs(centre) ** 2 - (s * t.conjugate()).imag / both, 0.0))


def _unled(scene: Scene, task: RodTask, kind: str, known: tuple[complex, complex]) -> Fault:
    """Tell with what second point, on the line of both, one of the links leads."""
    first, second = known

    def leads(times: float) -> bool:
        pair = first, first + times * (second - first)
        return met(rod_positions(task._replace(hinges=pair) if task.hinges else task._replace(pivots=pair)))

    times, name = nearest(leads), "B" if task.hinges else "C"
    there = "—" if times is None else f"{name} {_spot(first + times * (second - first))}"
    return scene.fault((*PATH, kind), "synthesis_not_led", met=there)


def mechanism(made: Design) -> MechanismText:
    """Give the tables of the mechanism, driven by the link that leads from the first position on."""
    size, place = made.sizes, made.places
    lengths = {"OA": size["l_1"], "AB": size["l_2"], "CB": size["l_3"]}
    links, pivot, letter = (("OA", "AB", "CB"), "O", "A") if "φ_12" in size else (("CB", "BA", "OA"), "C", "B")
    first, last = links[1][0], links[1][1]
    turns = [0.0, *(turn for name, turn in size.items() if name[:3] in ("φ_1", "ψ_1"))]
    begin = cmath.phase(place[f"{letter}_1"] - place[pivot])
    drive = {"link": 1, "speed": SPEED if turns[-1] > 0 else f"-{SPEED}"}
    angles = [math.degrees(begin + turn) for turn in turns]
    along = place[f"{last}_1"] - place[f"{first}_1"]
    at = (place["D_1"] - place[f"{first}_1"]) * along.conjugate() / abs(along)
    sketch = {last: place[f"{last}_1"]}
    frame = {"O": place["O"], "C": place["C"]}
    points = {"D": {"on": 2, "at": at}}
    return MechanismText(frame, links, lengths, sketch, drive={**drive, "positions": angles}, points=points)


def notes(task: RodTask) -> Iterator[str]:
    """Name what the sheet says of how the pivots were found."""
    yield "synthesis bisectors" if task.hinges else "synthesis seen pivots"
    if task.poles:
        yield "synthesis poles"
    if len(task.poles) < math.comb(len(task.places), 2):
        yield "synthesis far poles"
    yield "synthesis order"
