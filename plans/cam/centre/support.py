"""A ruler pushed until it touches a curve: at a smooth place of it, or at a corner (опорная касательная)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.cam.centre.instants import Instant, Stretch, sampled
from plans.cam.false_position import closed_in
from plans.model.motion import Floats

# What is sought along a law: how far each place of it goes beyond a line, and the derivative of that by the cam's turn.
Rule: TypeAlias = Callable[[Instant], tuple[Floats, Floats]]


class Touch(NamedTuple):
    """Where a ruler touches: the stretch, the share of its phase, and how far beyond the line that is."""

    stretch: Stretch
    share: float
    beyond: float

    @property
    def turned(self) -> float:
        """The cam's turn, rad."""
        return self.stretch.turned(self.share)

    @property
    def instant(self) -> Instant:
        """The follower's motion there, (1,) each."""
        return self.stretch.one(self.share)

    @property
    def corner(self) -> bool:
        """Whether it is an end of a smooth stretch."""
        return self.share in (self.stretch.start, self.stretch.end)


def touch(along: Iterable[Stretch], rule: Rule) -> Touch:
    """Give the place of some stretches that goes farthest beyond a line; of several, the first."""
    return max((one for stretch in along for one in _tops(stretch, rule)), key=lambda one: one.beyond)


def _tops(stretch: Stretch, rule: Rule) -> Iterator[Touch]:
    """Give the places of a stretch beyond their neighbours, each refined to the root of the derivative."""
    share, motion = sampled(stretch)
    beyond, slope = (np.broadcast_to(row, share.shape) for row in rule(motion))
    padded = np.concatenate([[-np.inf], beyond, [-np.inf]])
    for k in np.flatnonzero((beyond >= padded[:-2]) & (beyond > padded[2:])).tolist():
        node, top = float(share[k]), _refined(stretch, rule, share, slope, k)
        own = float(beyond[k]) if top == node else float(rule(stretch.one(top))[0][0])
        yield Touch(stretch, top, own) if own > beyond[k] else Touch(stretch, node, float(beyond[k]))


def _refined(stretch: Stretch, rule: Rule, share: Floats, slope: Floats, k: int) -> float:
    """Give the root of the derivative between the neighbours of a place, or the place itself where it is a corner."""
    other = k + 1 if slope[k] > 0 else k - 1
    if slope[k] == 0 or not 0 <= other < len(share) or slope[k] * slope[other] > 0:
        return float(share[k])
    ends = (row[[one]] for row in (share, slope) for one in (other, k))
    return float(closed_in(lambda at: rule(stretch.at(at))[1], *ends)[0])
