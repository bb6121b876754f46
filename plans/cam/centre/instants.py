"""The follower's motion along the smooth stretches of a law, to its third derivative (участки закона движения)."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from plans.cam.laws import law_of
from plans.model.cam import Cam, Phase
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
