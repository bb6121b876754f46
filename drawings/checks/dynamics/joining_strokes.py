"""The strokes that join the graphs: pole and rays of the moments, lines that carry points into the loop (связи)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from drawings.checks.dynamics.dynamics_expected import Expected
from drawings.checks.graphs.figure_strokes import FLUSH, FigureStrokes
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.linework import Linework, Way
from drawings.checks.wrong import Wrong, on
from drawings.lettering.extent import bounds
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Box, Group, Text
from drawings.paper.walk import texts
from plans.model.motion import Complexes

POLE, MOMENTS, JOINING = "P", "moments", "machine"
CLEAR = 2.0  # mm around a caption that lines leave free
TITLES = ("reduced moments", "works", "surplus energy", "speed over the turn", "reduced inertia", "loop")
SHORT = 1e-3  # mm: a value that is shorter lies on the axis
BULGE = 0.1  # of its height: so far a smooth curve may go past the ordinates of its edges
SAME = 1e-9  # rad: the end of a turn is its beginning


def pole_strokes(
    group: Group, zero: complex, distance: float, tips: Complexes, feet: Complexes, near: float, drafting: Drafting
) -> Iterator[Wrong]:
    """Hold the pole left of a zero with its distance and letters, and rays to tips on the axis, each carried on.

    `tips` and `feet` (n,) are where the mean ordinates cut the axis and where they stand, mm on paper.
    """
    own, at = Inventory("pole", (group,), near + FLUSH), zero - distance
    own.circle(at, on("differs_on", MOMENTS, name=POLE))
    own.letter(POLE, [at], on("letter", MOMENTS, name=POLE))
    own.line(at, zero, on("line", MOMENTS))
    ends = list[complex]()
    for tip, foot in zip(tips.tolist(), feet.tolist(), strict=True):
        if any(abs(tip - end) <= near for end in ends) or own.line(at, tip) is None:
            continue
        ends.append(tip)
        if abs(tip - zero) > SHORT:
            own.line(tip, foot, on("ray", MOMENTS))
    # After the rays: that of a mean that vanishes lies on the axis, like a dimension with no distance from it.
    line = own.dimension(at, zero, on("size", MOMENTS, name="Hp"))
    if line is not None:
        own.letter("Hp", [(line.start + line.end) / 2], on("letter", MOMENTS, name="Hp"))
    yield from own.faults()
    apart = np.abs(tips[:, None] - np.array(ends or [complex(np.inf)])).min(axis=1)
    if (apart > drafting.hand.letter + near).any():
        yield on("ray", MOMENTS)


@dataclass(frozen=True)
class Joined:
    """Two graphs and the loop that the points of edges are carried into, by their places on paper, mm (n + 1,) each.

    `surplus` is None where the graphs stand elsewhere; `jumps` are the ends of the lines at jumps.
    """

    group: Group
    inertia: Complexes
    surplus: Complexes | None
    loop: Complexes
    jumps: Sequence[tuple[complex, complex]]
    captions: Sequence[Box]
    symbol: float

    def faults(self, expected: Expected | None) -> Iterator[Wrong]:
        """Hold a line from each graph into the loop for each edge that a tangent touches, and those at jumps."""
        touched = () if expected is None else _touched(expected)
        due = [self._way(f"{k}", start, self.loop[k]) for k in touched for start in self._starts(k)]
        due += [self._way("+0", start, end)._replace(beyond=BULGE * abs(end - start)) for start, end in self.jumps]
        yield from Linework(JOINING, FigureStrokes(self.group), self.symbol).ways(due)

    def _starts(self, k: int) -> Iterator[complex]:
        yield self.inertia[k]
        if self.surplus is not None:
            yield self.surplus[k]

    def _way(self, name: str, start: complex, end: complex) -> Way:
        hidden = sum(_overlap(box, start, end) for box in self.captions)
        return Way(name, complex(start), complex(end), hidden=FLUSH + hidden, due=abs(end - start) > SHORT)


def captions(groups: Sequence[Group], drafting: Drafting) -> list[Box]:
    """Give the box of what is written over each graph: lines that join them leave it free."""
    boxes = [[bounds(one) for one in texts((group,)) if _captioned(one, drafting)] for group in groups]
    return [_around(own) for own in boxes if own]


def _around(boxes: Sequence[Box]) -> Box:
    left, bottom, right, top = zip(*boxes, strict=True)
    return min(left), min(bottom), max(right), max(top)


def _captioned(one: Text, drafting: Drafting) -> bool:
    return one.plain in map(drafting.word, TITLES) or (one.plain.startswith(("μ", "K")) and " = " in one.plain)


def _overlap(box: Box, start: complex, end: complex) -> float:
    """Give how much of a level or an upright line lies within a box and what is clear of it, mm."""
    left, bottom, right, top = box[0] - CLEAR, box[1] - CLEAR, box[2] + CLEAR, box[3] + CLEAR
    (x, y), (u, v) = (sorted(pair) for pair in ((start.real, end.real), (start.imag, end.imag)))
    if x > right or y < left or u > top or v < bottom:
        return 0.0
    return max(min(y, right) - max(x, left), 0.0) + max(min(v, top) - max(u, bottom), 0.0)


def _touched(expected: Expected) -> Iterator[int]:
    """Give the edges that tangents touch."""
    turned, last = expected.cycle.turned, float(expected.cycle.turned[-1])
    for touch in expected.wheel.touches if expected.wheel is not None else ():
        at = touch.turned if touch.turned < last - SAME else 0.0
        yield from np.flatnonzero(np.abs(turned - at) <= 1e-7)[:1].tolist()
