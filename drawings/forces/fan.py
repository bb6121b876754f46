"""The forces on a cut's links as arrows that can be told apart: each true in direction, bounded in length (веер сил).

Forces of a machine differ by thousands of times: their lengths on a scheme grow with their logarithm. Arrows at one
point, or along a link, start there, end there, or stand off it on their line of action, wherever the fewest lines run.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from drawings.forces.scheme import Scheme
from drawings.layout.ink import Ink
from drawings.layout.picture import Place
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Line, Stroke, stated
from drawings.symbols.couples import coupling, spring
from drawings.symbols.force_arrow import ForceArrow
from drawings.symbols.symbols import HINGE, fixed_hinge

SEEN = 0.4  # mm that a friction circle must be wider than the hinge's own circle
ATTACHMENTS_OFF, REACH = 20.0, 8.0  # mm from the shaft to its coupling, and how far the coupled shafts reach
WAYS = (1, -1, 1j, -1j)


def springs(shown: Scheme, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw each spring from its point on the links; one that the frame holds has its stand."""
    own = shown.links.points
    for one in shown.springs:
        start, end = place.on(one.start), place.on(one.end)
        data = {"kind": "spring", "name": one.name, "direction": stated((end - start) / abs(end - start))}
        strokes: tuple[Stroke, ...] = (spring(start, end, hand),)
        if one.fixed and one.letter not in own:
            strokes += fixed_hinge(end, hand, HINGE * hand.symbol)
        yield Group(strokes, "", data)


def friction_circles(shown: Scheme, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw the friction circles that are to be seen at the scheme's scale, each about its hinge."""
    for one in dict.fromkeys(shown.circles):  # a point that joins three links has a circle for each two of them
        radius = place.length(one.radius)
        if radius > HINGE * hand.symbol + SEEN and one.point in shown.named:
            circle = Circle(place.on(shown.named[one.point]), radius, hand.drafted)
            yield Group((circle,), "", {"kind": "friction", "name": one.point})


def coupled(shown: Scheme, place: Place, hand: Hand, ink: Ink) -> Iterator[Group]:
    """Draw the coupling beside the shaft, where it crosses the fewest lines."""
    if not shown.coupled:
        return
    shaft = place.on(shown.links.spot(shown.links.mechanism.drive.pivot, shown.links.shown))
    choices = [coupling(shaft + way * ATTACHMENTS_OFF * hand.symbol, way, hand, REACH) for way in WAYS]
    best = min(choices, key=ink.crossed_by)
    yield Group(tuple(best), "", {"kind": "coupling", "name": str(shown.links.mechanism.drive.link)})


SHORT, LONG, UNSIZED = 13.0, 26.0, 16.0  # mm: the least and the largest known force, and every unknown one
RUNG, BESIDE = 2.5, 1.8  # mm between the rungs that feel along an arrow, and how far they reach to its sides
CLEAR = 1.5  # mm from the end of an arrow at its point that are not felt: symbols are there; off it, felt before it
STEP, STEPS = 4.0, 25  # mm by which an arrow may stand off its point on its line of action, and how often
# What ending at the point costs, standing off it, and each mm of that; a crossed thin line costs 1.
ENDING, OFF, FURTHER = 3.0, 4.0, 0.3
PASSED, NEAR = 40.0, 3.0  # what a known force costs whose line to its point passes another point, so many mm near
OUTSIDE = 10.0  # what each mm outside the figure's box costs
ROUNDS = 2  # times that every arrow looks for its place among all others
WEIGHT = 6.0  # thin lines that an arrow counts as for the others


class _Room(NamedTuple):
    """Where an arrow looks for its place: the lines and points around, and the box."""

    ink: Ink
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


def fan(
    arrows: Sequence[ForceArrow],
    reaches: Sequence[float],
    around: Iterable[tuple[Stroke, float]],
    spots: Sequence[complex],
    box: Field | None,
    hand: Hand,
) -> list[ForceArrow]:
    """Place arrows among the lines around, each with its weight, among the points, and among each other.

    Each arrow is given at its point, as it would stand alone; symbols reach some mm from there.
    """
    lines = list(around)
    standing = [_standing(arrow, reach, arrow.ending, 0.0) for arrow, reach in zip(arrows, reaches, strict=True)]
    for _ in range(ROUNDS):
        for k, (arrow, reach) in enumerate(zip(arrows, reaches, strict=True)):
            ink = Ink()
            for stroke, weight in lines:
                ink.draw([stroke], weight)
            ink.draw((other.shaft for other in (*standing[:k], *standing[k + 1 :])), WEIGHT)
            standing[k] = _best(arrow, reach, _Room(ink, spots, box), hand)
    return standing


def _best(arrow: ForceArrow, reach: float, room: _Room, hand: Hand) -> ForceArrow:
    """Give the cheapest place of an arrow; the customary ones come first."""
    best, cheapest = None, math.inf
    for least, ending, off in sorted(_places(arrow.ending)):
        if least >= cheapest:
            break
        trial = _standing(arrow, reach, ending, off * hand.symbol)
        cost = least + _cost(trial, room, hand) + (0.0 if arrow.unknown else PASSED * _passed(arrow, trial, room))
        if cost < cheapest:
            best, cheapest = trial, cost
    assert best is not None  # the first place costs less than infinitely much
    return best


def _places(pressing: bool) -> Iterator[tuple[float, bool, float]]:
    """Give what each place costs at least: starting or ending at the point, and mm off it."""
    for ending in (False, True):
        own = ENDING * (ending != pressing)
        yield own, ending, 0.0
        yield from ((own + OFF + FURTHER * STEP * k, ending, STEP * k) for k in range(1, STEPS + 1))


def _standing(arrow: ForceArrow, reach: float, ending: bool, off: float) -> ForceArrow:
    """Stand an arrow at a place: starting or ending at its point's symbol, or off it on a thin line."""
    back = -arrow.direction if ending else arrow.direction
    lead = arrow.at + back * reach if off else None
    return arrow._replace(at=arrow.at + back * (reach + off), ending=ending, lead=lead)


def _cost(arrow: ForceArrow, room: _Room, hand: Hand) -> float:
    """Weigh a place: the lines that an arrow crosses or runs beside, and what of it is outside the box."""
    far = -arrow.direction if arrow.ending else arrow.direction
    start, end = arrow.at + far * CLEAR * hand.symbol * (1 if arrow.lead is None else -1), arrow.free
    length = abs(end - start)
    across = 1j * far * BESIDE * hand.symbol
    count = max(int(length / (RUNG * hand.symbol)), 1)
    first = 1 if arrow.lead is None else 0
    spots = [start + (end - start) * k / count for k in range(first, count + 1)]
    felt: list[Stroke] = [Line(start, end), *(Line(spot - across, spot + across) for spot in spots)]
    return room.ink.crossed_by(felt) + (0.0 if room.box is None else OUTSIDE * _beyond(end, room.box))


def _passed(arrow: ForceArrow, trial: ForceArrow, room: _Room) -> bool:
    """Tell whether an arrow that stands off its point would seem to act at another one."""
    if trial.lead is None:
        return False
    run = trial.at - arrow.at
    off = [(spot - arrow.at) / run for spot in room.spots if abs(spot - arrow.at) > NEAR]
    return any(0 < place.real <= 1 and abs(place.imag) * abs(run) < NEAR for place in off)


def _beyond(spot: complex, box: Field) -> float:
    """Give how far a place is outside a box, mm."""
    across = max(box.left - spot.real, spot.real - box.right, 0.0)
    return across + max(box.bottom - spot.imag, spot.imag - box.top, 0.0)
