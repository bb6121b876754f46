"""A guess of the mechanism's poses: its rough sketch, made into links laid one after another (набросок).

No structural groups here: link by link, whatever is known of its points and guides says where it lies.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from plans.analytic.points import TURN, Constraints, X, Y
from plans.model.mechanism import FRAME, Drive, Mechanism, Slide
from plans.model.motion import Floats

Pose = tuple[complex, float]  # origin m and turn rad of a link's own frame


@dataclass
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

    def _seen(self, number: int) -> list[str]:
        return [point for point in self.mechanism.links[number].points if point in self.places]

    def _slides(self, number: int) -> list[tuple[Slide, int]]:
        """List the slides of a link, each with the link at its other side."""
        slides = self.mechanism.slides
        return [(s, s.owner if s.slider == number else s.slider) for s in slides if number in (s.slider, s.owner)]

    def _put(self, number: int, point: str, turn: float) -> bool:
        """Place a link by one point and its turn, and with it those points of the link that nobody sketched."""
        own = self.mechanism.links[number].points
        origin = self.places[point] - own[point] * cmath.rect(1, turn)
        self.known[number] = (origin, turn)
        sure = number == self.mechanism.drive.link
        for name, place in own.items():
            if sure or name not in self.places:
                self.places[name] = origin + place * cmath.rect(1, turn)
        return True

    def _by_points(self, number: int) -> bool:
        """Two points seen: their join gives the turn."""
        seen, own = self._seen(number), self.mechanism.links[number].points
        for point in seen[1:]:
            if self.places[point] != self.places[seen[0]] and own[point] != own[seen[0]]:
                join = (self.places[point] - self.places[seen[0]]) / (own[point] - own[seen[0]])
                return self._put(number, seen[0], cmath.phase(join))
        return False

    def _by_guide(self, number: int) -> bool:
        """One point seen, and a slide on a link already placed: the guide gives the turn."""
        for slide, other in self._slides(number):
            if other in self.known and self._seen(number):
                turn = self.known[other][1] + cmath.phase(slide.way(other).direction / slide.way(number).direction)
                return self._put(number, self._seen(number)[0], turn)
        return False

    def _by_slot(self, number: int) -> bool:
        """One point seen, and one of the link it slides on: the slot runs from the pivot through the block."""
        for slide, other in self._slides(number):
            mine, theirs = self._seen(number), self._seen(other)
            if number == slide.owner and mine and theirs and self.places[mine[0]] != self.places[theirs[0]]:
                join = (self.places[theirs[0]] - self.places[mine[0]]) / slide.on_owner.direction
                return self._put(number, mine[0], cmath.phase(join))
        return False

    def _by_default(self, number: int) -> bool:
        """Nothing better is known: lay the link along x, from its point seen or amid all that is placed."""
        own: Mapping[str, complex] = self.mechanism.links[number].points
        seen = self._seen(number)
        first = seen[0] if seen else next(iter(own))
        self.places.setdefault(first, complex(np.mean(list(self.places.values()))))
        return self._put(number, first, 0.0)
