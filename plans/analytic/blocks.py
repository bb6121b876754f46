"""The equations in blocks: which links they give together, and in what order (блочно-треугольная форма).

Nothing is known here of structural groups: every equation is given to one of the links it moves, three to each link; a
link rests on those whose poses its equations use; links that rest on each other are one block (A. L. Dulmage, N. S.
Mendelsohn, Coverings of bipartite graphs, 1958; the blocks are strong components after R. Tarjan, 1972).
"""

import cmath
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from plans.analytic.grouping import circles
from plans.analytic.points import TURN, Constraints, Indices, TurningDrive, X, Y
from plans.model.mechanism import FRAME, Drive, Mechanism, Slide, StructureError
from plans.model.motion import Floats
from plans.words.words import message

Pose = tuple[complex, float]  # origin m and turn rad of a link's own frame


@dataclass(eq=False, repr=False)
class Guess:
    """Rough poses of all links, found link by link from the places of points known so far."""

    mechanism: Mechanism
    phi: float
    places: dict[str, complex] = field(default_factory=dict)
    known: dict[int, Pose] = field(default_factory=dict)

    def poses(self, constraints: Constraints) -> Floats:
        """Guess all poses, (links, 3), in the units of the constraints."""
        links, drive = self.mechanism.links, self.mechanism.drive
        self.places |= {**self.mechanism.sketch, **links[FRAME].points}
        self.known[FRAME] = (0j, 0.0)
        self._put(drive.link, drive.pivot, self._primary(drive))
        while len(self.known) < len(links):
            self._next()
        poses = np.zeros((len(links), 3))
        for place, number in enumerate(constraints.numbers):
            origin, turn = self.known[number]
            poses[place, [X, Y]] = np.array((origin.real, origin.imag)) / constraints.size
            poses[place, TURN] = turn
        return poses

    def _primary(self, drive: Drive) -> float:
        """Give the turn of the primary link; a slider that is pushed along is put in its place."""
        points = self.mechanism.links[drive.link].points
        if drive.guide is None:
            return self.phi - cmath.phase(points[drive.end] - points[drive.pivot])
        line = drive.guide.on_owner
        left = ((points[drive.pivot] - drive.guide.on_slider.through) / drive.guide.on_slider.direction).imag
        self.places[drive.pivot] = line.through + (drive.unit * self.phi + 1j * left) * line.direction
        return cmath.phase(line.direction / drive.guide.on_slider.direction)

    def _next(self) -> None:
        """Place one more link by the surest rule that applies to any."""
        rules: tuple[Callable[[int], bool], ...] = (self._by_points, self._by_guide, self._by_slot, self._by_default)
        for rule in rules:
            for number in self.mechanism.links:
                if number not in self.known and rule(number):
                    return

    def _placed(self, number: int) -> list[str]:
        return [point for point in self.mechanism.links[number].points if point in self.places]

    def _slides(self, number: int) -> list[tuple[Slide, int]]:
        slides = self.mechanism.slides
        return [(s, s.owner if s.slider == number else s.slider) for s in slides if number in (s.slider, s.owner)]

    def _put(self, number: int, point: str, turn: float) -> bool:
        """Place a link by one point and its turn, and with it those points of the link that nobody sketched."""
        points = self.mechanism.links[number].points
        origin = self.places[point] - points[point] * cmath.rect(1, turn)
        self.known[number] = (origin, turn)
        sure = number == self.mechanism.drive.link
        for name, place in points.items():
            if sure or name not in self.places:
                self.places[name] = origin + place * cmath.rect(1, turn)
        return True

    def _by_points(self, number: int) -> bool:
        """Two points seen: their join gives the turn."""
        placed, points = self._placed(number), self.mechanism.links[number].points
        for point in placed[1:]:
            if self.places[point] != self.places[placed[0]] and points[point] != points[placed[0]]:
                join = (self.places[point] - self.places[placed[0]]) / (points[point] - points[placed[0]])
                return self._put(number, placed[0], cmath.phase(join))
        return False

    def _by_guide(self, number: int) -> bool:
        """One point seen, and a slide on a link already placed: the guide gives the turn."""
        for slide, other in self._slides(number):
            if other in self.known and self._placed(number):
                turn = self.known[other][1] + cmath.phase(slide.way(other).direction / slide.way(number).direction)
                return self._put(number, self._placed(number)[0], turn)
        return False

    def _by_slot(self, number: int) -> bool:
        """One point seen, and one of the link it slides on: the slot runs from the pivot through the block."""
        for slide, other in self._slides(number):
            mine, theirs = self._placed(number), self._placed(other)
            if number == slide.owner and mine and theirs and self.places[mine[0]] != self.places[theirs[0]]:
                join = (self.places[theirs[0]] - self.places[mine[0]]) / slide.on_owner.direction
                return self._put(number, mine[0], cmath.phase(join))
        return False

    def _by_default(self, number: int) -> bool:
        """Nothing better is known: lay the link along x, from its point seen or amid all that is placed."""
        points: Mapping[str, complex] = self.mechanism.links[number].points
        placed = self._placed(number)
        first = placed[0] if placed else next(iter(points))
        self.places.setdefault(first, complex(np.mean(list(self.places.values()))))
        return self._put(number, first, 0.0)


FREEDOM = 3  # unknowns of a link


class Block(NamedTuple):
    """Links whose poses are found together: their own equations, and where these stand among all equations."""

    equations: Constraints
    rows: Indices  # places of the equations among those of the whole mechanism
    columns: Indices  # places of the unknowns in the Jacobian of the whole mechanism

    @property
    def links(self) -> Indices:
        """Places of the links."""
        return self.equations.sought

    def of(self, jacobian: Floats) -> Floats:
        """Cut the block's own Jacobian out of that of the whole mechanism, (N, k, k)."""
        return np.asarray(jacobian[:, self.rows[:, None], self.columns])

    @property
    def linear(self) -> bool:
        """Whether slides, and a crank's drive, give all its links their directions: it is assembled in one way only."""
        turned = self.equations.driven and isinstance(self.equations.drive, TurningDrive)
        return len(self.equations.slide_ways[0]) + turned == len(self.links)

    def of_own(self, poses: Floats) -> Floats:
        """Differentiate the block's own equations at poses (links, 3), (k, k)."""
        return np.asarray(self.equations.jacobian(self.equations.place(poses[None]))[0])


def triangular(constraints: Constraints) -> tuple[Block, ...]:
    """Break the equations of a mechanism into blocks in solving order.

    Raises StructureError where some links have more equations than unknowns.
    """
    keepers = _keepers(constraints)
    rests: dict[int, set[int]] = {place: set() for place in range(1, len(constraints.numbers))}
    for (_, links), keeper in zip(_equations(constraints), keepers, strict=True):
        rests[keeper] |= set(links) - {0, keeper}
    return tuple(_block(constraints, links, keepers) for links in circles(rests))


def _equations(constraints: Constraints) -> list[tuple[int, tuple[int, ...]]]:
    """List all equations in the order of rows: their joint (the drive counts as one more) and the links they move."""
    joints = [(int(a), int(b)) for a, b in constraints.links.T]
    hinged, slid = joints[: constraints.hinges], joints[constraints.hinges :]
    rows = [*enumerate(hinged)] * 2 + [*enumerate(slid, constraints.hinges)] * 2
    return [*rows, (len(joints), constraints.drive.moved)]


def _keepers(constraints: Constraints) -> list[int]:
    """Give every equation to a link, three to each, by augmenting paths."""
    links = [[place for place in moved if place] for _, moved in _equations(constraints)]
    kept: dict[int, list[int]] = {place: [] for place in range(1, len(constraints.numbers))}

    def give(row: int, visited: set[int]) -> bool:
        for place in links[row]:
            if place in visited:
                continue
            visited.add(place)
            if len(kept[place]) < FREEDOM:
                kept[place].append(row)
                return True
            for other in kept[place]:
                if give(other, visited):
                    kept[place][kept[place].index(other)] = row
                    return True
        return False

    for row in range(len(links)):
        if not give(row, set()):
            raise StructureError(message("structure.truss"))
    keepers = {row: place for place, rows in kept.items() for row in rows}
    return [keepers[row] for row in range(len(links))]


def _block(constraints: Constraints, links: list[int], keepers: list[int]) -> Block:
    joints = constraints.links.shape[1]
    rows = [row for row, keeper in enumerate(keepers) if keeper in links]
    held = {joint for row, (joint, _) in enumerate(_equations(constraints)) if keepers[row] in links}
    equations = constraints.part(links, sorted(held - {joints}), joints in held)
    return Block(equations, np.array(rows, dtype=np.intp), equations.columns - FREEDOM)
