"""Assembling the mechanism at one position as its sketch shows it (сборка механизма).

No structural groups here: rough poses of all links are read off the sketch and brought together by the equations of all
joints; of the assemblies found, the one nearest to the sketch is taken.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from random import Random  # numpy's own is slow to import, and not needed for a few numbers
from typing import NamedTuple

import numpy as np

from plans.analytic.closure import EPS, SQRT_EPS, settle
from plans.analytic.constraints import TURN, Constraints, X, Y
from plans.mechanism import FRAME, Mechanism, Slide
from plans.motion import Floats

GRID = 24  # crank angles tried where the first one is not given: every 15 degrees
SCATTERED, SCATTER = 8, 0.5  # scattered starts; share of the mechanism's size by which links are thrown about
Pose = tuple[complex, float]  # origin m and turn rad of a link's own frame


class Assembly(NamedTuple):
    """A closed position: crank angle rad and poses (links, 3) in the units of the constraints."""

    phi: float
    poses: Floats


def assemble(mechanism: Mechanism, constraints: Constraints, phi: float) -> Assembly | None:
    """Assemble at a given crank angle, or None if the links cannot be joined there."""
    base = _Guess(mechanism, phi).poses(constraints)
    starts = [base]
    for place, number in enumerate(constraints.numbers):
        # A link of one point (a block) takes its direction from its guide; others may be sketched badly or not at all.
        if number not in (FRAME, mechanism.drive.link) and len(mechanism.links[number].points) > 1:
            starts += [_turned(base, place, quarter * np.pi / 2) for quarter in (1, -1, 2)]
    starts += _scattered(base)
    poses, misfits = _settled(mechanism, constraints, np.array(starts), np.full(len(starts), phi))
    misfits = _regular(constraints, poses, misfits)
    # Assemblies that differ only where the sketch is silent fit it equally: then the first start decides.
    near = np.flatnonzero(misfits <= np.min(misfits) + SQRT_EPS)
    return Assembly(phi, poses[near[0]]) if np.isfinite(misfits[near[0]]) else None


def assemble_anywhere(mechanism: Mechanism, constraints: Constraints) -> Assembly | None:
    """Assemble at whichever crank angle of a coarse grid fits the sketch best, or None if there is none."""
    grid = np.linspace(0.0, 2.0 * np.pi, GRID, endpoint=False)
    starts = np.array([_Guess(mechanism, float(phi)).poses(constraints) for phi in grid])
    _, misfits = _settled(mechanism, constraints, starts, grid)
    for place in np.argsort(misfits, kind="stable"):
        assembly = assemble(mechanism, constraints, float(grid[place])) if np.isfinite(misfits[place]) else None
        if assembly:
            return assembly
    return None


def _regular(constraints: Constraints, poses: Floats, misfits: Floats) -> Floats:
    """Pass over singular assemblies, such as two rods of a rhombus on each other, where there are regular ones."""
    known = np.flatnonzero(np.isfinite(misfits))
    kappa = np.linalg.cond(constraints.jacobian(constraints.place(poses[known])))
    regular = kappa * SQRT_EPS < 1.0
    if not regular.any():
        return misfits
    passed = np.full_like(misfits, np.inf)
    passed[known[regular]] = misfits[known[regular]]
    return passed


def _scattered(base: Floats) -> list[Floats]:
    """Scatter the rough poses: a rough sketch alone may lie in the basin of an assembly that is not the nearest one."""
    chance = Random(0)  # the same scatter each time
    spread = np.array((SCATTER, SCATTER, np.pi / 2))
    found = []
    for _ in range(SCATTERED):
        thrown = np.array([chance.uniform(-1.0, 1.0) for _ in range(base.size)]).reshape(base.shape)
        thrown[0] = 0.0  # the frame stays
        found.append(base + spread * thrown)
    return found


def _settled(mechanism: Mechanism, constraints: Constraints, starts: Floats, phi: Floats) -> tuple[Floats, Floats]:
    """Settle all starts; give their poses and squared distances from the sketch, infinite where nothing was found."""
    poses, reached = settle(constraints, starts, phi)
    # At a singular position Newton's method is slow, but the joints are closed all the same.
    rounding = EPS * constraints.pattern.shape[0]
    reached |= np.abs(constraints.residual(constraints.place(poses), phi)).max(axis=1) <= rounding
    misfits = np.zeros(len(poses))
    for point, place in mechanism.sketch.items():
        number = mechanism.link_of(point)
        own = mechanism.links[number].points[point] / constraints.size
        x, y, turn = poses[:, constraints.numbers.index(number)].T
        misfits += np.abs(x + 1j * y + own * np.exp(1j * turn) - place / constraints.size) ** 2
    return poses, np.where(reached, misfits, np.inf)


def _turned(poses: Floats, place: int, angle: float) -> Floats:
    turned = poses.copy()
    turned[place, TURN] += angle
    return turned


@dataclass
class _Guess:
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
        arm = links[drive.link].points[drive.end] - links[drive.link].points[drive.pivot]
        self._put(drive.link, drive.pivot, self.phi - cmath.phase(arm))
        while len(self.known) < len(links):
            self._next()
        poses = np.zeros((len(links), 3))
        for place, number in enumerate(constraints.numbers):
            origin, turn = self.known[number]
            poses[place, [X, Y]] = np.array((origin.real, origin.imag)) / constraints.size
            poses[place, TURN] = turn
        return poses

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
