"""The S-S' diagram: the follower's point K with KD = S' turned with the cam, wherever O will be (диаграмма S - dS/dφ).

Its own frame: of a follower that translates the start A is the origin, of one that rocks its pivot O1.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from plans.cam.laws import law_of
from plans.cam.profile.tip import arm
from plans.model.cam import RISE, Cam, Phase
from plans.model.cam_motion import Points
from plans.model.motion import Floats

PARTS = 48  # of a stretch, between which no law of the book has two extremes of anything


class Instant(NamedTuple):
    """S and its derivatives by the cam's turn, (N,) each: m, m/rad ..., of a follower that rocks rad, 1 ..."""

    s: Floats
    slope: Floats
    bend: Floats
    jerk: Floats


class Stretch(NamedTuple):
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

    def one(self, share: float) -> Instant:
        """Give the motion at one share of the phase."""
        return self.at(np.array([share]), share == self.end)

    def turned(self, share: float) -> float:
        """Give the cam's turn at a share of the phase, rad."""
        return self.phase.start + self.phase.angle * share


@lru_cache(maxsize=64)
def sampled(stretch: Stretch) -> tuple[Floats, Instant]:
    """Give the motion along a stretch densely, its ends from within; the shares first."""
    share = np.linspace(stretch.start, stretch.end, PARTS + 1)
    inner, last = stretch.at(share[:-1]), stretch.at(share[-1:], before=True)
    return share, Instant(*(np.concatenate(pair) for pair in zip(inner, last, strict=True)))


def stretches(cam: Cam, kinds: Iterable[str]) -> tuple[Stretch, ...]:
    """Give the stretches of the phases of some kinds."""
    asked = frozenset(kinds)
    return tuple(
        Stretch(phase, *ends)
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
        return np.asarray(
            tip * (1j * self.cam.rising * motion.slope * (1 - sense * motion.slope) - sense * motion.bend)
        )

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
