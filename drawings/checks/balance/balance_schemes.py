"""The self-check of the schemes of balancing: points, main points, paths, counterweights to scale (проверка схем)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from drawings.checks import reading
from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance.balance_marks import Cover
from drawings.checks.precise import KNOWN
from drawings.checks.wrong import Wrong, on
from drawings.figures.balance.balance_scheme import PATH, RIM, STILL
from drawings.figures.balance.lanes import MOST
from drawings.figures.balance.scheme import AFTER, BEFORE, SCHEME
from drawings.layout.parallel_offsets import APART
from drawings.lettering.balance_letters import CENTRE
from drawings.paper.limits import QUANTUM, SEEN
from drawings.paper.strokes import Arc, Group, Leaf, Line
from drawings.paper.walk import group_named, walk
from drawings.symbols.symbols import BLOCK, STONE
from plans.model.balance.linkage import DISC, Counterweight
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes

PRIMES = {BEFORE: "", AFTER: "'"}  # behind the names of what is compared
SPOTS = 72  # of a rim, by which it is told how much of it is free of pairs
COVERED = 0.5  # of a rim: so much of it can be seen beside the pairs that cover it


def schemes(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold the schemes that stand on a sheet."""
    for state in expected.states:
        if SCHEME + state in leaf.metadata["figures"]:
            yield from Scheme(leaf, expected, state).faults()


@dataclass(frozen=True)
class Scheme:
    """A scheme on a sheet, with what it must show."""

    leaf: Leaf
    expected: Expected
    state: str

    @property
    def plan(self) -> str:
        """The name of its figure."""
        return SCHEME + self.state

    @cached_property
    def part(self) -> Group | None:
        """Its figure."""
        return group_named(self.leaf.groups, self.plan)

    @cached_property
    def mu(self) -> float:
        """Its scale, m/mm."""
        return marks.scale(self.expected.measured, self.plan)

    @cached_property
    def slack(self) -> float:
        """How far a place may be off, m."""
        known = self.expected.slack(f"r_S{PRIMES[self.state]}", position=self.expected.shown)
        return known + self.expected.near * self.mu + KNOWN * self.expected.reach

    @cached_property
    def origin(self) -> complex:
        """Where the shaft of the crank is on paper."""
        seen = marks.points(self.expected.measured, self.plan)
        return next((one.at - one.value / one.scale for one in seen.values()), 0j)

    def on(self, place: complex) -> complex:
        """Put a true place on paper."""
        return self.origin + place / self.mu

    def faults(self) -> Iterator[Wrong]:
        """Hold it."""
        yield from marks.titled(self.part, self.plan, self._title)
        yield from self._points()
        yield from self._vectors()
        yield from self._paths()
        for one in self.expected.weights(self.state):
            yield from self._rim(one)
        if self.part is not None:
            yield from reading.scales(self.part, {self.mu})

    @property
    def _title(self) -> str:
        word = self.expected.drafting.word
        return f"{word(f'scheme {self.state}')}, {word('position', position=self.expected.shown)}"

    def _points(self) -> Iterator[Wrong]:
        """Hold all points but the shaft, from which the others are measured."""
        pivot = self.expected.mechanism.drive.pivot
        due = {name: spot for name, spot in self.expected.points.items() if name != pivot}
        due |= {f"m_cw{one.link}": self.expected.at(one.link, one.centre) for one in self.expected.weights(self.state)}
        due[CENTRE] = self.expected.centre(self.state)
        yield from marks.held(marks.points(self.expected.measured, self.plan), due, self.plan, self.slack)

    def _vectors(self) -> Iterator[Wrong]:
        """Hold the main-point vectors: each that can be seen is there, and begins where the one before it ends."""
        sides = list(self.expected.chain(self.state))
        seen = marks.vectors(self.expected.measured, self.plan)
        due = {one.name: one.value for one in sides if one.name in seen or abs(one.value) > (SEEN + QUANTUM) * self.mu}
        yield from marks.held(seen, due, self.plan, self.slack)
        lane = MOST * APART * self.expected.drafting.hand.symbol
        yield from marks.laid(seen, sides, self.plan, self.origin, self.slack / self.mu, lane)

    def _paths(self) -> Iterator[Wrong]:
        """Hold the paths of the mass centre over the turn: of its own state, and of that before."""
        covers = list(self._covers())
        for state in dict.fromkeys((BEFORE, self.state)):
            name = f"{self.plan}-{PATH}{state}"
            part = group_named(self.leaf.groups, name)
            for spots in runs(self.expected.states[state].around.r) if self.expected.whole else ():
                places = [self.on(spot) for spot in spots]
                way = sum(abs(one - other) for one, other in pairwise(places))
                if way > 2 * STILL and not marks.follows(marks.lines(part), places, self.near, covers):
                    yield on("path", self.plan, name=state)
            if state != self.state:
                own = group_named(self.leaf.groups, f"{self.plan}-{PATH}{self.state}")
                yield from marks.thinner(part, own, self.plan)
            if part is not None and self.expected.states[state].path <= self.expected.none.way:
                yield on("stranger_on", self.plan, name=name)

    def _covers(self) -> Iterator[Cover]:
        """Give what paths are cut off at: the symbols of the points, and the blocks along their lines."""
        yield from (Cover(self.on(place)) for place in self.expected.points.values())
        for slide in self.expected.mechanism.slides:
            through, way = slide.on_owner.through, slide.on_owner.direction
            start = self.expected.at(slide.owner, through)
            along = self.expected.at(slide.owner, through + way) - start
            foot = start + along * ((self.expected.points[slide.point] - start) / along).real
            length, width = BLOCK if slide.owner == FRAME else STONE
            symbol = self.expected.drafting.hand.symbol / 2
            yield Cover(self.on(foot), along / abs(along), (length * symbol, width * symbol))

    @property
    def near(self) -> float:
        """How far a line may be off on paper, mm."""
        known = max(self.expected.slack(name, "costs") for name in ("r_S", "r_S'"))
        return known / self.mu + self.expected.near

    def _rim(self, one: Counterweight) -> Iterator[Wrong]:
        """Hold the outline of a counterweight to its sizes."""
        part = group_named(self.leaf.groups, f"{self.plan}-{RIM}{one.link}")
        strokes = [] if part is None else list(walk(part.strokes))
        arcs = [stroke for stroke in strokes if isinstance(stroke, Arc)]
        ends = [stroke for stroke in strokes if isinstance(stroke, Line)]
        begin, centre = (self.on(self.expected.at(one.link, spot)) for spot in (one.origin, one.centre))
        disc = one.place.shape == DISC
        whole = 2 * math.pi if disc else 2 * one.place.half_angle
        radius, middle = one.outer / self.mu, centre if disc else begin
        near = self.slack / self.mu + KNOWN * radius
        right = all(abs(arc.centre - middle) <= near and abs(arc.radius - radius) <= near for arc in arcs)
        right &= all(max(abs(end.start - begin), abs(end.end - begin)) <= radius + near for end in ends)
        turns = cmath.phase(centre - begin) + whole * (np.arange(SPOTS + 1) / SPOTS - 0.5)
        free = ~np.any([cover.hides(middle + radius * np.exp(1j * turns), near) for cover in self._covers()], axis=0)
        least = min(COVERED, float(free[:-1].mean())) * whole  # a small one may be all under the pairs
        covered = least <= sum(arc.sweep for arc in arcs) <= whole + 2 * near / radius
        tips = bool(free[0]), bool(free[-1])
        if not right or not covered or (not disc and not _sector(arcs, ends, (begin, centre), one, near, tips)):
            yield on("rim", self.plan, name=f"m_cw{one.link}")


def _sector(
    arcs: list[Arc], ends: list[Line], along: tuple[complex, complex], one: Counterweight, near: float,
    tips: tuple[bool, bool],
) -> bool:  # fmt: skip
    """Tell whether a sector opens as far as it must to both sides of its direction, with a line at each free tip."""
    way, half = along[1] - along[0], one.place.half_angle
    turns = [cmath.phase((arc.at(share) - along[0]) / way) for arc in arcs for share in (0.0, 0.5, 1.0)]
    sides = sorted(
        cmath.phase((max(end.start, end.end, key=lambda p: abs(p - along[0])) - along[0]) / way) for end in ends
    )
    loose = near / abs(way) + near / max((abs(end.end - end.start) for end in ends), default=abs(way))
    if not all(abs(turn) <= half + loose for turn in turns):
        return False
    right = all(min(abs(side + half), abs(side - half)) <= loose for side in sides)
    met = (any(abs(side - turn) <= loose for side in sides) for turn in (-half, half))
    return right and all(there or not free for there, free in zip(met, tips, strict=True))


def runs(path: Complexes) -> Iterator[list[complex]]:
    """Give the stretches of a path between its gaps."""
    run: list[complex] = []
    for spot in path.tolist():
        if cmath.isfinite(spot):
            run.append(spot)
        elif run:
            yield run
            run = []
    if run:
        yield run
