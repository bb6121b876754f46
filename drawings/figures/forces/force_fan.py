"""The forces on a cut's links as arrows that can be told apart: each true in direction, bounded in length (веер сил).

Forces of a machine differ by thousands of times: their lengths on a scheme grow with their logarithm. Arrows at one
point, or along a link, start there, end there, or stand off it on their line of action, wherever the fewest lines run.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from drawings.layout.ink import Ink
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, Stroke
from drawings.symbols.force_arrow import ForceArrow, marked

SHORT, LONG, UNKNOWN = 13.0, 26.0, 16.0  # mm: the least and the largest known force, and every unknown one
RUNG, BESIDE = 2.5, 1.8  # mm between the rungs that feel along an arrow, and how far they reach to its sides
CLEAR = 1.5  # mm from the end of an arrow at its point that are not felt: symbols are there; off it, felt before it
STEP, STEPS = 4.0, 25  # mm by which an arrow may stand off its point on its line of action, and how often
# What ending at the point costs, standing off it, and each mm of that; a crossed thin line costs 1.
ENDING, OFF, FURTHER = 3.0, 4.0, 0.3
PASSED, NEAR = 40.0, 3.0  # what a known force costs whose line to its point passes another point, so many mm near
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
    def shaft(self) -> Line:
        """The arrow's own line; the thin one under it does not keep others away."""
        return Line(self.arrow.start, self.arrow.tip)


class _Room(NamedTuple):
    """Where an arrow looks for its place: the lines and points around, and the box."""

    drawn: Ink
    spots: Sequence[complex]
    box: Field | None


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


def fanned(
    spokes: Sequence[Spoke],
    around: Iterable[tuple[Stroke, float]],
    spots: Sequence[complex],
    box: Field | None,
    hand: Hand,
) -> list[Held]:
    """Place the arrows among the lines around, each with its weight, among the points, and among each other."""
    lines = list(around)
    held = [_held(spoke, spoke.pressing, 0.0, hand) for spoke in spokes]
    for _ in range(ROUNDS):
        for k, spoke in enumerate(spokes):
            drawn = Ink()
            for stroke, weight in lines:
                drawn.draw([stroke], weight)
            drawn.draw((other.shaft for other in (*held[:k], *held[k + 1 :])), WEIGHT)
            held[k] = _best(spoke, _Room(drawn, spots, box), hand)
    return held


def _best(spoke: Spoke, room: _Room, hand: Hand) -> Held:
    """Give the cheapest place of an arrow; the customary ones come first."""
    best, cheapest = None, math.inf
    for least, ending, off in sorted(_places(spoke.pressing)):
        if least >= cheapest:
            break
        held = _held(spoke, ending, off, hand)
        cost = least + _cost(held, room, hand) + (0.0 if spoke.unknown else PASSED * _passed(spoke, held, room))
        if cost < cheapest:
            best, cheapest = held, cost
    assert best is not None  # the first place costs less than infinitely much
    return best


def _places(pressing: bool) -> Iterator[tuple[float, bool, float]]:
    """Give what each place costs at least: starting or ending at the point, and mm off it."""
    for ending in (False, True):
        own = ENDING * (ending != pressing)
        yield own, ending, 0.0
        yield from ((own + OFF + FURTHER * STEP * k, ending, STEP * k) for k in range(1, STEPS + 1))


def _held(spoke: Spoke, ending: bool, off: float, hand: Hand) -> Held:
    """Hold an arrow at a place: starting or ending at its point's symbol, or off it on a thin line."""
    factor = hand.symbol
    back = -spoke.direction if ending else spoke.direction
    near = spoke.at + back * (spoke.rim + off * factor)
    arrow = marked(spoke.letter, spoke.direction, near, spoke.length * factor, ending, spoke.unknown)
    return Held(arrow, Line(spoke.at + back * spoke.rim, near, hand.drafted) if off else None)


def _cost(held: Held, room: _Room, hand: Hand) -> float:
    """Weigh a place: the lines that an arrow crosses or runs beside, and what of it is outside the box."""
    arrow = held.arrow
    far = -arrow.direction if arrow.ending else arrow.direction
    start, end = arrow.at + far * CLEAR * hand.symbol * (1 if held.lead is None else -1), arrow.free
    length = abs(end - start)
    across = 1j * far * BESIDE * hand.symbol
    count = max(int(length / (RUNG * hand.symbol)), 1)
    spots = [start + (end - start) * k / count for k in range(0 if held.lead else 1, count + 1)]
    felt: list[Stroke] = [Line(start, end), *(Line(spot - across, spot + across) for spot in spots)]
    return room.drawn.crossed_by([Group(tuple(felt))]) + (0.0 if room.box is None else OUTSIDE * _beyond(end, room.box))


def _passed(spoke: Spoke, held: Held, room: _Room) -> bool:
    """Tell whether an arrow that stands off its point would seem to act at another one."""
    if held.lead is None:
        return False
    run = held.lead.end - spoke.at
    off = [(spot - spoke.at) / run for spot in room.spots if abs(spot - spoke.at) > NEAR]
    return any(0 < place.real <= 1 and abs(place.imag) * abs(run) < NEAR for place in off)


def _beyond(spot: complex, box: Field) -> float:
    """Give how far a place is outside a box, mm."""
    across = max(box.left - spot.real, spot.real - box.right, 0.0)
    return across + max(box.bottom - spot.imag, spot.imag - box.top, 0.0)
