"""Kinematic symbols and arrows, in millimetres (условные обозначения; GOST 2.770-68, sizes by custom)."""

from __future__ import annotations

import cmath
import math

from drawings.hand import Hand
from drawings.strokes import INK, Arc, Circle, Fill, Line, LineStyle, Polyline, Stroke

ARROW_LENGTH = 5.0
ARROW_HALF = ARROW_LENGTH * math.tan(math.radians(10))  # an arrowhead of 20 degrees


def arrowhead(start: complex, tip: complex) -> Fill | None:
    """Draw the filled head of an arrow; a vector shorter than its head gets a smaller head, a vanishing one none."""
    length = abs(tip - start)
    if length < 0.1:
        return None
    size = min(1.0, length / (1.5 * ARROW_LENGTH))
    along = (tip - start) / length * size
    base = tip - along * ARROW_LENGTH
    return Fill((tip, base + 1j * along * ARROW_HALF, base - 1j * along * ARROW_HALF))


def hinge(at: complex, hand: Hand, radius: float = 2.0) -> Circle:
    """Draw a hinge (вращательная пара): a circle of paper over the links' lines."""
    return Circle(at, radius, hand.body)


def fixed_hinge(at: complex, hand: Hand, downward: complex = -1j) -> tuple[Stroke, ...]:
    """Draw a fixed hinge (стойка): two legs, a base, and hatching on the side of the ground."""
    side = 1j * downward
    left, right = at + 8 * downward + 4.5 * side, at + 8 * downward - 4.5 * side
    legs = Polyline((left, at, right), False, LineStyle(hand.main))
    return legs, *ground(left + 1.5 * side, right - 1.5 * side, downward, hand)


def ground(start: complex, end: complex, into: complex, hand: Hand) -> tuple[Stroke, ...]:
    """Draw a fixed line with hatching at 45 degrees on the side `into`."""
    length = abs(end - start)
    along = (end - start) / length
    count = max(int(length / 2), 1)
    hatch = 3 * (into - along) / abs(into - along)
    lines = [
        Line(start + along * length * k / count, start + along * length * k / count + hatch, hand.drafted)
        for k in range(1, count + 1)
    ]
    return Line(start, end, LineStyle(hand.main)), *lines


def slider(at: complex, direction: complex, hand: Hand, size: tuple[float, float] = (12.0, 7.0)) -> Polyline:
    """Draw a sliding block (ползун, камень) turned along its line."""
    half_length, half_width = direction * size[0] / 2, 1j * direction * size[1] / 2
    corners = (
        at + half_length + half_width,
        at - half_length + half_width,
        at - half_length - half_width,
        at + half_length - half_width,
    )
    return Polyline(corners, True, hand.body)


def guide(start: complex, end: complex, block: complex, hand: Hand) -> tuple[Stroke, ...]:
    """Draw a guide of the frame (направляющая): its axis, and ground beside the block on the right of its direction."""
    along = (end - start) / abs(end - start)
    bar = block - 1j * along * 3.5
    return (
        Line(start, end, hand.axis),
        *ground(bar - 14.0 * along, bar + 14.0 * along, -1j * along, hand),
    )


def turning_arrow(centre: complex, radius: float, start: float, sweep: float, hand: Hand) -> tuple[Stroke, ...]:
    """Draw an arc with an arrowhead at its end: the sense of rotation; a negative sweep is clockwise."""
    low, high = (start, start + sweep) if sweep > 0 else (start + sweep, start)
    tip = centre + cmath.rect(radius, start + sweep)
    head = 3.5 / radius * (1 if sweep > 0 else -1)
    back = centre + cmath.rect(radius, start + sweep - head)
    along = (tip - back) / abs(tip - back)
    wings = (tip, back + 1j * along * 0.9, back - 1j * along * 0.9)
    return Arc(centre, radius, low, high, hand.other), Fill(wings, INK)


def pole(at: complex) -> Circle:
    """Draw the pole of a plan: a small filled circle."""
    return Circle(at, 0.8, INK)
