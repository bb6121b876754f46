"""The forces on a cut's links as arrows that can be told apart: each true in direction, bounded in length (веер сил).

Forces of a machine differ by thousands of times: their lengths on a scheme grow with their logarithm. Arrows at one
point, or along a link, start there, end there, or stand off it on their line of action, wherever the fewest lines run.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from typing import NamedTuple

from drawings.clearance import Drawn
from drawings.force_arrow import ForceArrow, marked
from drawings.hand import Hand
from drawings.page import Field
from drawings.strokes import Group, Line, Stroke

SHORT, LONG, UNKNOWN = 13.0, 26.0, 16.0  # mm: the least and the largest known force, and every unknown one
RUNG, BESIDE = 2.5, 1.8  # mm between the rungs that feel along an arrow, and how far they reach to its sides
CLEAR = 1.5  # mm from the end of an arrow at its point that are not felt: its own symbols are there
OFFSETS = (8.0, 16.0, 30.0, 40.0)  # mm that an arrow may stand off its point on its line of action
ENDING, OFF = 1.5, 0.25  # what ending at the point costs, and each mm off it; a crossed thin line costs 1
OUTSIDE = 10.0  # what each mm outside the figure's box costs
ROUNDS = 2  # times that every arrow looks for its place among all others
WEIGHT = 6.0  # thin lines that an arrow counts as for the others


class Spoke(NamedTuple):
    """A force at a place on paper: its letter, unit direction, length, and how far from the place symbols reach, mm.

    A pressing one ends at its place rather than starts there: the reaction of a guide on its slider.
    """

    letter: str
    at: complex
    direction: complex
    length: float
    rim: float
    unknown: bool
    pressing: bool = False


class Held(NamedTuple):
    """An arrow at its place, and the thin line of action to its point where it stands off it."""

    arrow: ForceArrow
    lead: Line | None

    @property
    def strokes(self) -> list[Stroke]:
        """The lines that others look at."""
        return [Line(self.arrow.start, self.arrow.tip), *([self.lead] if self.lead else [])]


def lengths(sizes: Sequence[float]) -> list[float]:
    """Give arrows' lengths, mm: in the order of the forces and within bounds, by their logarithms.

    >>> [round(length, 1) for length in lengths([1.0, 100.0, 10000.0])]
    [13.0, 19.5, 26.0]
    >>> lengths([5.0])
    [19.5]
    """
    if not sizes:
        return []
    low, high = math.log(min(sizes)), math.log(max(sizes))
    shares = [(math.log(size) - low) / (high - low) if high > low else 0.5 for size in sizes]
    return [SHORT + (LONG - SHORT) * share for share in shares]


def fanned(spokes: Sequence[Spoke], around: Iterable[tuple[Stroke, float]], box: Field | None, hand: Hand) -> list[Held]:
    """Place the arrows among the lines around, each with its weight, and among each other."""
    lines = list(around)
    held = [next(_candidates(spoke, hand))[0] for spoke in spokes]
    for _ in range(ROUNDS):
        for k, spoke in enumerate(spokes):
            drawn = Drawn()
            for stroke, weight in lines:
                drawn.draw([stroke], weight)
            drawn.draw(chain(*(other.strokes for other in (*held[:k], *held[k + 1 :]))), WEIGHT)
            held[k] = min(_candidates(spoke, hand), key=lambda one, drawn=drawn: one[1] + _cost(one[0], drawn, box, hand))[0]  # type: ignore[misc]
    return held


def _candidates(spoke: Spoke, hand: Hand) -> Iterator[tuple[Held, float]]:
    """Give the places that an arrow may have, with what each costs, the customary one first."""
    factor = hand.symbol
    first = (True, False) if spoke.pressing else (False, True)
    for dear, ending in enumerate(first):
        for off in (0.0, *OFFSETS):
            shift = (spoke.rim + off * factor) * (-1 if ending else 1)
            near = spoke.at + spoke.direction * shift
            arrow = marked(spoke.letter, spoke.direction, near, spoke.length * factor, ending, spoke.unknown)
            lead = Line(spoke.at + spoke.direction * spoke.rim * (-1 if ending else 1), near, hand.drafted)
            yield Held(arrow, lead if off else None), ENDING * dear + OFF * off


def _cost(held: Held, drawn: Drawn, box: Field | None, hand: Hand) -> float:
    """Weigh a place: the lines that an arrow crosses or runs beside, and what of it is outside the box."""
    arrow = held.arrow
    clear, far = CLEAR * hand.symbol * (1 if not arrow.ending else -1), arrow.direction
    start, end = arrow.at + far * clear, arrow.free
    length = abs(end - start)
    across = 1j * far * BESIDE * hand.symbol
    count = max(int(length / (RUNG * hand.symbol)), 1)
    spots = [start + (end - start) * k / count for k in range(1, count + 1)]
    felt: list[Stroke] = [Line(start, end), *(Line(spot - across, spot + across) for spot in spots)]
    return drawn.crossed_by([Group(tuple(felt))]) + (0.0 if box is None else OUTSIDE * _beyond(end, box))


def _beyond(spot: complex, box: Field) -> float:
    """Give how far a place is outside a box, mm."""
    across = max(box.left - spot.real, spot.real - box.right, 0.0)
    return across + max(box.bottom - spot.imag, spot.imag - box.top, 0.0)
