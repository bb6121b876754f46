"""What bounds the place of the cam's centre: limits of the pressure angle, convexity under a flat face (ограничения).

Each position of the follower bounds O by a straight line of its own; a bound is all the lines of one kind.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import NamedTuple, Protocol, TypeAlias

import numpy as np

from geometry.meet import dot
from plans.cam.course import law_of
from plans.cam.profile.touch import arm, closed_in
from plans.model.cam import FORCE, RETURN, RISE, Cam, Limits, Phase
from plans.model.cam_motion import Points
from plans.model.motion import Floats

PARTS = 48  # of a stretch, between which no law of the book has two extremes of anything


class Instant(NamedTuple):
    """S and its derivatives by the cam's turn, (N,) each: m, m/rad ..., of a follower that rocks rad, 1 ..."""

    s: Floats
    slope: Floats
    bend: Floats
    jerk: Floats


class SmoothStretch(NamedTuple):
    """A stretch of a phase within which its law is smooth, from one share of the phase to another."""

    phase: Phase
    start: float
    end: float

    def at(self, share: Floats, before: bool = False) -> Instant:
        """Give the motion at shares of the phase; at the end of the stretch that before the joint."""
        phase, law = self.phase, law_of(self.phase.law) if self.phase.law else None
        if law is None:
            return Instant(np.full_like(share, phase.level), *(np.zeros_like(share) for _ in range(3)))
        rows = [phase.change / phase.angle**order * law.at(share, order, before) for order in range(4)]
        return Instant(phase.level + rows[0], *rows[1:])

    def instant(self, share: float) -> Instant:
        """Give the motion at one share of the phase."""
        return self.at(np.array([share]), share == self.end)

    def turned(self, share: float) -> float:
        """Give the cam's turn at a share of the phase, rad."""
        return self.phase.start + self.phase.angle * share


@lru_cache(maxsize=64)
def sampled(stretch: SmoothStretch) -> tuple[Floats, Instant]:
    """Give the motion along a stretch densely, its ends from within; the shares first."""
    share = np.linspace(stretch.start, stretch.end, PARTS + 1)
    inner, last = stretch.at(share[:-1]), stretch.at(share[-1:], before=True)
    return share, Instant(*(np.concatenate(pair) for pair in zip(inner, last, strict=True)))


def stretches(cam: Cam, kinds: Iterable[str]) -> tuple[SmoothStretch, ...]:
    """Give the stretches of the phases of some kinds."""
    asked = frozenset(kinds)
    return tuple(
        SmoothStretch(phase, *ends)
        for phase in cam.phases
        if phase.kind in asked
        for ends in pairwise((*(law_of(phase.law).starts if phase.law else (0.0,)), 1.0))
    )


@dataclass(frozen=True)
class SlopeDiagram:
    """K and D of a cam's follower, in m."""

    cam: Cam

    @property
    def length(self) -> float:
        """The rocker's length l, m."""
        length = self.cam.follower.length
        assert length is not None  # asked of each rocker by the reader
        return length

    def leaning(self, s: Floats) -> Points:
        """Give how the way of K leans at some S: a unit vector, 1 where it goes straight up."""
        if not self.cam.rocks:
            return np.ones_like(s, dtype=complex)
        return self.cam.rising * arm(self.cam, s)

    def tip(self, motion: Instant) -> Points:
        """Give K: (N,) complex, m."""
        if not self.cam.rocks:
            return np.asarray(1j * motion.s)
        return np.asarray(self.cam.rising * self.length * self.leaning(motion.s))

    def end(self, motion: Instant) -> Points:
        """Give D: (N,) complex, m."""
        if not self.cam.rocks:
            return np.asarray(1j * motion.s - self.cam.sense * motion.slope)
        return np.asarray(self.tip(motion) * (1 - self.cam.follower.sense * motion.slope))

    def drift(self, motion: Instant) -> Points:
        """Give D', the derivative of D by the cam's turn."""
        if not self.cam.rocks:
            return np.asarray(1j * motion.slope - self.cam.sense * motion.bend)
        tip, sense = self.tip(motion), self.cam.follower.sense
        turning = 1j * self.cam.rising * motion.slope * (1 - sense * motion.slope)
        return np.asarray(tip * (turning - sense * motion.bend))

    def turning(self, motion: Instant) -> Floats:
        """Give how fast the way of K turns, by the cam's turn."""
        return self.cam.rising * motion.slope if self.cam.rocks else np.zeros_like(motion.slope)

    def limit(self, side: int, angle: float) -> complex:
        """Give the direction of a limiting line beside a way that goes straight up: up, leaning by the angle.

        `side` is +1 for pressure angles up to the limit, -1 for those down to the limit below 0.
        """
        return 1j * cmath.exp(1j * self.cam.sense * side * angle)


def side_of(kind: str) -> int:
    """Give on which side a phase presses: rises above 0, returns below."""
    return 1 if kind == RISE else -1


# What is sought along a law: how far each place of it goes beyond a line, and the derivative of that by the cam's turn.
Rule: TypeAlias = Callable[[Instant], tuple[Floats, Floats]]


class RulerTouch(NamedTuple):
    """Where a ruler touches: the stretch, the share of its phase, and how far beyond the line that is."""

    stretch: SmoothStretch
    share: float
    beyond: float

    @property
    def turned(self) -> float:
        """The cam's turn, rad."""
        return self.stretch.turned(self.share)

    @property
    def instant(self) -> Instant:
        """The follower's motion there, (1,) each."""
        return self.stretch.instant(self.share)

    @property
    def motion(self) -> tuple[float, float]:
        """S and S' there."""
        return float(self.instant.s[0]), float(self.instant.slope[0])


def touch(along: Iterable[SmoothStretch], rule: Rule) -> RulerTouch:
    """Give the place of some stretches that goes farthest beyond a line; of several, the first."""
    return max((top for stretch in along for top in _tops(stretch, rule)), key=lambda top: top.beyond)


def _tops(stretch: SmoothStretch, rule: Rule) -> Iterator[RulerTouch]:
    """Give the places of a stretch beyond their neighbours, each refined to the root of the derivative."""
    share, motion = sampled(stretch)
    beyond, slope = (np.broadcast_to(row, share.shape) for row in rule(motion))
    padded = np.concatenate([[-np.inf], beyond, [-np.inf]])
    for k in np.flatnonzero((beyond >= padded[:-2]) & (beyond > padded[2:])).tolist():
        node, top = float(share[k]), _refined(stretch, rule, share, slope, k)
        height = float(beyond[k]) if top == node else float(rule(stretch.instant(top))[0][0])
        yield RulerTouch(stretch, top, height) if height > beyond[k] else RulerTouch(stretch, node, float(beyond[k]))


def _refined(stretch: SmoothStretch, rule: Rule, share: Floats, slope: Floats, k: int) -> float:
    """Give the root of the derivative between the neighbours of a place, or the place itself where it is a corner."""
    other = k + 1 if slope[k] > 0 else k - 1
    if slope[k] == 0 or not 0 <= other < len(share) or slope[k] * slope[other] > 0:
        return float(share[k])
    ends = (row[[end]] for row in (share, slope) for end in (other, k))
    return float(closed_in(lambda at: rule(stretch.at(at))[1], *ends)[0])


class Lines(NamedTuple):
    """Limiting lines of N positions: O lies where dot(normal, O) does not exceed the bound, m; normals are no units."""

    normals: Points
    bounds: Floats


class Bound(Protocol):
    """A kind of limiting lines."""

    @property
    def along(self) -> tuple[SmoothStretch, ...]:
        """The stretches whose positions it is of."""
        ...

    def lines(self, motion: Instant) -> Lines:
        """Give the limiting lines of some positions."""
        ...

    def moving(self, motion: Instant) -> Lines:
        """Give the derivatives of the lines by the cam's turn."""
        ...


class Limit(NamedTuple):
    """The limiting line of one position that a bound touches."""

    bound: Bound
    touch: RulerTouch
    normal: complex
    reach: float

    def beyond(self, centre: complex) -> float:
        """Give how far a centre is beyond it, in m of a unit normal."""
        return float(dot(self.normal, centre)) - self.reach


@dataclass(frozen=True)
class PressureBound:
    """The limiting lines of a phase's pressure angle: up to the limit (side +1), or down to it below 0 (side -1)."""

    diagram: SlopeDiagram
    kind: str
    side: int
    angle: float  # rad
    level: bool = False  # by the chord of the book: all its lines are parallel

    @cached_property
    def along(self) -> tuple[SmoothStretch, ...]:
        """The stretches of the phases of its kind."""
        return stretches(self.diagram.cam, (self.kind,))

    @property
    def normal(self) -> complex:
        """The normal of its line where the way of K goes straight up."""
        return -1j * self.diagram.cam.sense * self.side * self.diagram.limit(self.side, self.angle)

    def _normals(self, motion: Instant) -> Points:
        leaning = np.ones_like(motion.s, dtype=complex) if self.level else self.diagram.leaning(motion.s)
        return self.normal * leaning

    def lines(self, motion: Instant) -> Lines:
        """Give the lines through D."""
        normals = self._normals(motion)
        return Lines(normals, np.asarray(dot(normals, self.diagram.end(motion))))

    def moving(self, motion: Instant) -> Lines:
        """Give how they turn and shift."""
        normals = self._normals(motion)
        turning = np.zeros_like(normals) if self.level else 1j * self.diagram.turning(motion) * normals
        shift = dot(turning, self.diagram.end(motion)) + dot(normals, self.diagram.drift(motion))
        return Lines(turning, np.asarray(shift))


def rule_of(bound: Bound, centre: complex) -> Rule:
    """Give how far a centre is beyond the lines of a bound, for a ruler."""

    def rule(motion: Instant) -> tuple[Floats, Floats]:
        lines, moving = bound.lines(motion), bound.moving(motion)
        size = np.abs(lines.normals)
        beyond = (dot(lines.normals, centre) - lines.bounds) / size
        turning = (dot(moving.normals, centre) - moving.bounds) / size
        return beyond, turning - beyond * dot(lines.normals, moving.normals) / size**2

    return rule


def limit(bound: Bound, centre: complex) -> Limit:
    """Give the line of a bound that a centre is farthest beyond: push a ruler until it touches."""
    found = touch(bound.along, rule_of(bound, centre))
    lines = bound.lines(found.instant)
    normal = complex(lines.normals[0])
    return Limit(bound, found, normal / abs(normal), float(lines.bounds[0]) / abs(normal))


def pressure_bounds(diagram: SlopeDiagram, limits: Limits, level: bool = False) -> Iterator[PressureBound]:
    """Give the bounds of the pressure angle: rises from above, returns from below; a spring's rises from below too.

    On the return a spring drives, so that nothing limits it where the scene does not.
    """
    if limits.rise is not None:
        yield PressureBound(diagram, RISE, 1, limits.rise, level)
    if limits.back is not None:
        yield PressureBound(diagram, RETURN, -1, limits.back, level)
    if limits.rise is not None and diagram.cam.closure == FORCE:
        yield PressureBound(diagram, RISE, -1, limits.rise, level)


@dataclass(frozen=True)
class CurvatureBound:
    """The limiting lines of convexity under the face of a rocker: the profile's radius is no less than it may be.

    ρ = h - c·n(1 - 2m)/(1 - m)2 + ψ'' c·u/(1 - m)3 with c = O1O, m = ψ' where they turn alike, -ψ' where not.
    """

    diagram: SlopeDiagram
    radius: float

    @cached_property
    def along(self) -> tuple[SmoothStretch, ...]:
        """All that moves the follower, and its dwells."""
        return stretches(self.diagram.cam, {phase.kind for phase in self.diagram.cam.phases})

    def lines(self, motion: Instant) -> Lines:
        """Give the lines on which the radius is the least allowed."""
        cam, m = self.diagram.cam, self.diagram.cam.follower.sense * motion.slope
        up, arm = self._axes(motion.s)
        normals = up * (1 - 2 * m) / (1 - m) ** 2 - arm * motion.bend / (1 - m) ** 3
        return Lines(normals, np.full_like(motion.s, cam.follower.face - self.radius))

    def moving(self, motion: Instant) -> Lines:
        """Give how they turn."""
        cam, sense = self.diagram.cam, self.diagram.cam.follower.sense
        m, dm = sense * motion.slope, sense * motion.bend
        up, arm = self._axes(motion.s)
        turn = 1j * cam.rising * motion.slope
        turning = (turn * (1 - 2 * m) - 2 * dm + 2 * dm * (1 - 2 * m) / (1 - m)) * up / (1 - m) ** 2
        rest = (turn * motion.bend + motion.jerk + 3 * dm * motion.bend / (1 - m)) * arm / (1 - m) ** 3
        return Lines(turning - rest, np.zeros_like(motion.s))

    @property
    def upright(self) -> tuple[complex, complex]:
        """The face's normal and the direction along the arm at the start."""
        up, arm = self._axes(np.zeros(1))
        return complex(up[0]), complex(arm[0])

    def _axes(self, s: Floats) -> tuple[Points, Points]:
        """Give the face's normal, out of the cam, and the direction along the arm."""
        leaning = self.diagram.leaning(s)
        return 1j * leaning, self.diagram.cam.rising * leaning
