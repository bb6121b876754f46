"""A four-bar that is asked to guide its rod (задание: положения шатуна)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import Final

from plans.analytic.synthesis.guided import centres, moves_of, rods
from plans.model.synthesis.design import Design
from plans.model.synthesis.positions import RodTask
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import millimetres
from plans.synthesis.asked.nearest import nearest
from plans.synthesis.tables.positions import Place, RodTable
from plans.synthesis.written import SPEED, MechanismText

PATH: Path = ("synthesis", "rod_positions")
STANDS: Final = 1e-9  # m, the least length of a scene


def task(table: RodTable) -> RodTask:
    """Make the task."""
    places, angles = tuple(map(_place, table.places)), tuple(map(math.radians, table.angles))
    pairs = (None if pair is None else (_place(pair[0]), _place(pair[1])) for pair in (table.hinges, table.pivots))
    return RodTask(places, angles, *pairs, None if table.arms is None else (float(table.arms[0]), float(table.arms[1])))


def _place(pair: Place) -> complex:
    return complex(*map(float, pair))


def _spot(at: complex) -> str:
    return f"({millimetres(at.real)}, {millimetres(at.imag)})"


def faults(scene: Scene, task: RodTask) -> Iterator[Fault]:
    """Say which hinge has no pivot, and by how much; or that no link leads through the positions in their order."""
    if rods(task)[0].found:
        return
    kind, known = ("hinges", task.hinges) if task.hinges else ("pivots", task.pivots)
    assert known is not None  # one of them is told
    moves = [*moves_of(task)]
    if kind == "pivots":
        moves = [(1 / turn, -shift / turn) for turn, shift in moves]  # the frame, seen from the rod
    alone = False
    for k, (name, at) in enumerate(zip("AB" if kind == "hinges" else "OC", known, strict=True)):
        places = [turn * at + shift for turn, shift in moves]
        if not [*centres(places, task.arms and task.arms[k])]:
            alone = True
            yield _alone(scene, (*PATH, kind, k), name, places, moves, task)
    if not alone:
        yield _unled(scene, (*PATH, kind), task, known)


def _alone(
    scene: Scene,
    at: Path,
    name: str,
    places: Sequence[complex],
    moves: Sequence[tuple[complex, complex]],
    task: RodTask,
) -> Fault:
    """Tell of a hinge that stands, that goes straight, or whose arm is too short."""
    still = [(i, j) for i in range(len(places)) for j in range(i) if abs(places[i] - places[j]) < STANDS]
    if still:
        return scene.fault(at, "synthesis_hinge_still", hinge=name, first=still[0][1] + 1, second=still[0][0] + 1)
    if task.arms:
        arms: Path = (*at[:2], "arms", at[-1])
        return scene.fault(arms, "synthesis_arm", least=millimetres(abs(places[1] - places[0]) / 2))
    centre, radius = straight(moves)
    if not math.isfinite(radius):
        return scene.fault(at, "synthesis_hinge_shifted", hinge=name)
    return scene.fault(at, "synthesis_hinge_straight", hinge=name, centre=_spot(centre), radius=millimetres(radius))


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


def _unled(scene: Scene, path: Path, task: RodTask, known: tuple[complex, complex]) -> Fault:
    first, second = known

    def moved(times: float) -> RodTask:
        pair = first, first + times * (second - first)
        return task._replace(hinges=pair) if task.hinges else task._replace(pivots=pair)

    times = nearest(lambda times: bool(rods(moved(times))[0].found))
    name = "B" if task.hinges else "C"
    met = "—" if times is None else f"{name} {_spot(first + times * (second - first))}"
    return scene.fault(path, "synthesis_not_led", met=met)


def mechanism(made: Design) -> MechanismText:
    """Give the tables of the mechanism, driven by the link that leads from the first position on."""
    size, place = made.sizes, made.places
    lengths = {"OA": size["l_1"], "AB": size["l_2"], "CB": size["l_3"]}
    links, pivot, letter = (("OA", "AB", "CB"), "O", "A") if "φ_12" in size else (("CB", "BA", "OA"), "C", "B")
    (first, last) = links[1]
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
    yield "synthesis bisectors" if task.hinges else "synthesis inverted"
    if task.poles:
        yield "synthesis poles"
    if len(task.poles) < math.comb(len(task.places), 2):
        yield "synthesis far poles"
    yield "synthesis order"
