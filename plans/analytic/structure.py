"""Structure by the analytic road: ranks of a spatial Jacobian, and groups by matching equations to unknowns.

A pair takes from the relative motion of its links, a screw (w, v), those components that are a wrench's to do work on.
The Jacobian of all pairs stands in the mechanism's own position, where its axes are exactly parallel, and in one with
axes and places a little off in space, as they are made: there nothing that holds twice is hidden by the plane.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from plans.model.mechanism import FRAME
from plans.model.motion import Floats
from plans.model.structure import SPACE, TURNING, Joint, Structure

LOST = 1e-8  # of the largest singular value: rounding of the data, and far under what a perturbation brings about
ASKEW = 0.05  # shares of the size: how far axes and places are off in the perturbed position
# Which turns and shifts each kind holds: about and along its axis 0, its other direction 1, and square to both 2.
HELD: Final[Mapping[str, tuple[tuple[int, ...], tuple[int, ...]]]] = {
    **{"R": ((1, 2), (0, 1, 2)), "P": ((0, 1, 2), (1, 2)), "C": ((1, 2), (1, 2)), "T": ((1,), (0, 1, 2))},
    **{"S": ((), (0, 1, 2)), "E": ((1, 2), (0,)), "B": ((), (1, 2)), "L": ((2,), (0,)), "K": ((), (0,))},
}
NORMAL = np.array([0.0, 0.0, 1.0])  # to the plane of a mechanism


@dataclass(frozen=True, eq=False)
class SpatialPair:
    """A pair in space: its links, its kind, its place, its axis and another direction square to that.

    The axis is that of turning, sliding or rolling, or the normal of a contact; the other direction is that of a
    finger, or of the line of contact.
    """

    links: tuple[int, ...]
    kind: str
    at: Floats
    axis: Floats
    other: Floats

    @property
    def wrenches(self) -> Floats:
        """What it takes of a relative screw (w, v at the origin), row by row."""
        first = self.other - (self.other @ self.axis) * self.axis
        first = first / np.linalg.norm(first)
        ways = self.axis, first, np.cross(self.axis, first)
        turns, shifts = HELD[self.kind]
        rows = [np.concatenate([ways[k], np.zeros(3)]) for k in turns]
        rows += [np.concatenate([np.cross(self.at, ways[k]), ways[k]]) for k in shifts]  # of its place: v + w x r
        return np.array(rows)

    def askew(self, chance: np.random.Generator) -> SpatialPair:
        """Give it with its place and its directions a little off, as a real one is."""
        at, axis, other = (way + ASKEW * chance.standard_normal(3) for way in (self.at, self.axis, self.other))
        return SpatialPair(self.links, self.kind, at, axis / np.linalg.norm(axis), other)


def spatial(pairs: Sequence[Joint]) -> list[SpatialPair]:
    """Put the pairs of a planar mechanism in space, places in shares of how far they lie apart."""
    middle = sum(pair.at for pair in pairs) / len(pairs)
    size = max((abs(pair.at - middle) for pair in pairs), default=0.0) or 1.0
    return [_spatial(pair, (pair.at - middle) / size) for pair in pairs]


def _spatial(pair: Joint, place: complex) -> SpatialPair:
    at, along = np.array([place.real, place.imag, 0.0]), np.array([pair.along.real, pair.along.imag, 0.0])
    if pair.nature == TURNING:
        return SpatialPair(pair.links, pair.kind, at, NORMAL, along)
    if pair.kind == "E":
        return SpatialPair(pair.links, pair.kind, at, np.cross(NORMAL, along), NORMAL)
    return SpatialPair(pair.links, pair.kind, at, along, NORMAL)


class Ranks(NamedTuple):
    """What the rank of a Jacobian comes to: how many motions are left, and how many rows depend on others."""

    mobility: int
    redundant: int


def ranks(links: Sequence[int], pairs: Iterable[SpatialPair]) -> Ranks:
    """Give the rank of the Jacobian of all pairs."""
    rows = [_row(wrench, pair, links) for pair in pairs for wrench in pair.wrenches]
    jacobian = np.array(rows or np.zeros((0, SPACE * len(links))))
    sizes = np.linalg.svd(jacobian, compute_uv=False) if rows else np.zeros(0)
    rank = int((sizes > LOST * max(sizes, default=1.0)).sum())
    return Ranks(SPACE * len(links) - rank, len(rows) - rank)


def _row(wrench: Floats, pair: SpatialPair, links: Sequence[int]) -> Floats:
    row = np.zeros(SPACE * len(links))
    for link, sign in zip(pair.links, (-1, 1), strict=True):
        if link != FRAME:
            start = SPACE * list(links).index(link)
            row[start : start + SPACE] = sign * wrench
    return row


def in_place(structure: Structure) -> Ranks:
    """Give the rank in the mechanism's own position, its axes parallel."""
    return ranks(structure.links, spatial(structure.pairs))


def perturbed(structure: Structure, seed: int = 1) -> Ranks:
    """Give the rank where all axes and places are a little off in space: it has all rows, or all motions."""
    chance = np.random.default_rng(seed)
    return ranks(structure.links, [pair.askew(chance) for pair in spatial(structure.pairs)])
