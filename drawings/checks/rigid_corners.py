"""The filled corners of rigid links: each where two lines of a link meet, as deep as it must be, and no other (уголки).

A corner is filled up to its hinge and a little beyond; a rod is filled on both sides where it leaves its block.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from drawings.checks.standing import ROUNDED
from drawings.paper.strokes import Circle, Fill
from drawings.symbols.symbols import GUSSET, HINGE, LEG

SHALLOW = 0.25  # of its depth: a corner so wide that less of it would be seen stays white
SHARP = 3  # corners of a filling that has no circle about it
NONE = 1e-8  # mm: a shorter line has no direction; of a rod that none sees the corner is filled all the same
EDGE = 0.02  # of that: what rounding may make one of a corner that is nearly so wide


class Corner(NamedTuple):
    """A corner on paper, the unit directions of its lines from it, whether it must be filled, or may be.

    One about a point is filled beyond the circle of that point; the side of a block has none, whatever stands there.
    """

    at: complex
    first: complex
    second: complex
    due: bool = True
    ringed: bool = True

    @property
    def half(self) -> float:
        """Half its angle, rad."""
        return abs(cmath.phase(self.second / self.first)) / 2


class Corners(NamedTuple):
    """The corners of the links of a figure, with what is filled in it, its hinges' circles, its factor of symbols.

    Among links that are `alone`, without arrows, every triangle at the side of a block is the filling of a corner.
    """

    corners: Sequence[Corner]
    fills: Sequence[Fill]
    rings: Sequence[Circle]
    size: float
    alone: bool = False

    def missing(self) -> bool:
        """Tell whether a corner that must be filled is not."""
        due = [one for one in self.corners if one.due and self._shown(one)]
        return not all(any(self._fills(fill, one) for fill in self.fills) for one in due)

    def stray(self) -> bool:
        """Tell whether something is filled that is no corner; a rod's own block may fill more of it."""
        held = [fill for fill in self.fills if len(fill.points) > SHARP or (self.alone and self._leaves(fill))]
        return not all(any(self._fills(fill, one) for one in self.corners) for fill in held)

    def _leaves(self, fill: Fill) -> bool:
        """Tell whether a filling is where a rod surely leaves its block."""
        sides = (one.at for one in self.corners if one.due and not one.ringed)
        return any(abs(fill.points[0] - at) <= ROUNDED for at in sides)

    def _radii(self, one: Corner) -> tuple[float, ...]:
        """Give the radii of the hinge about a corner: with the smaller circle of a mass centre there, and without."""
        about = [ring.radius for ring in self.rings if one.ringed and abs(ring.centre - one.at) < ring.radius]
        hinges = [radius for radius in about if radius > HINGE * self.size - ROUNDED]
        return max(hinges, default=0.0), max(about, default=0.0)

    def _reach(self, one: Corner, radius: float) -> float:
        """Give how far along its lines a corner about a circle is filled, mm."""
        depth = radius + GUSSET * self.size
        return depth * min(1 / max(math.cos(one.half), 1 / (2 * LEG)), LEG)

    def _shown(self, one: Corner) -> bool:
        """Tell whether a corner is surely not too wide to be filled, whichever circle is about it."""
        beyond = min(self._reach(one, radius) * math.cos(one.half) - radius for radius in self._radii(one))
        return one.half > EDGE and beyond > (SHALLOW + EDGE) * GUSSET * self.size

    def _fills(self, fill: Fill, one: Corner) -> bool:
        """Tell whether a filling is of a corner: its outermost places lie on the corner's lines, as far as is due."""
        outer = fill.points[-2:]
        reaches = {self._reach(one, radius) for radius in self._radii(one)}
        ends = [(one.at + one.first * reach, one.at + one.second * reach) for reach in reaches]
        turned = (*ends, *(own[::-1] for own in ends))
        return any(max(abs(a - b) for a, b in zip(outer, own, strict=True)) <= 2 * ROUNDED for own in turned)


def around(corners: Sequence[complex]) -> Iterator[Corner]:
    """Give the corners of a closed polygon."""
    for before, at, after in zip((corners[-1], *corners[:-1]), corners, (*corners[1:], corners[0]), strict=True):
        yield Corner(at, _unit(before - at), _unit(after - at))


def between(at: complex, ends: Iterable[complex]) -> Iterator[Corner]:
    """Give what may be corners at a place where lines of one link meet, by where those lead."""
    ways = [_unit(one - at) for one in ends if abs(one - at) > NONE]
    yield from (Corner(at, one, other, False) for k, one in enumerate(ways) for other in ways[:k])


def welded(start: complex, end: complex, block: Sequence[complex]) -> Iterator[Corner]:
    """Give the corners of a rod with the sides of its block, where it leaves that."""
    for one, other in pairwise((*block, block[0])):
        side, run = other - one, end - start
        across = (side.conjugate() * run).imag
        if not across:
            continue
        along, share = (
            ((start - one).conjugate() * run).imag / across,
            ((start - one).conjugate() * side).imag / across,
        )
        if 0 < along < 1 and 0 < share < 1:
            far, inside = max((start, end), key=lambda spot: _outside(spot, one, side, block)), min(along, 1 - along)
            spot = start + share * run
            due = inside * abs(side) > ROUNDED
            yield from (Corner(spot, _unit(far - spot), _unit(way), due, False) for way in (side, -side))


def _outside(spot: complex, one: complex, side: complex, block: Sequence[complex]) -> float:
    """Give how far a place is beyond a side, away from the middle of its block."""
    inner = ((sum(block) / len(block) - one) / side).imag
    return -((spot - one) / side).imag * math.copysign(1.0, inner)


def _unit(run: complex) -> complex:
    return run / abs(run)
