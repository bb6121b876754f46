"""Kinematic symbols and arrows, in millimetres (условные обозначения; GOST 2.770-68, sizes by custom).

Sizes are those of A1; every symbol is drawn to the factor of the sheet's hand. A symbol's body is filled with paper.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.lettering.lettering import GRAIN
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Arc, Circle, Curve, Fill, Line, LineStyle, Polyline, Stroke, numeral
from drawings.paper.walk import tied
from geometry.curve import sampled

ARROW_LENGTH = 5.0
ARROW_HALF = ARROW_LENGTH * math.tan(math.radians(10))  # an arrowhead of 20 degrees
ARROW_BLUNT = ARROW_LENGTH * math.tan(math.radians(15))  # of 30, the bluntest of ISO 129-1: where one is small
ARROW_LEAST = 1.5  # of one that is seen as such: a shorter vector is all head
HINGE = 2.0  # radius of a hinge of two links
DOUBLE = (2.8, 1.5)  # radii of a hinge of three links or more
POINT = 0.9  # radius of a point that is no hinge
MASS = 1.7  # radius of a mass centre
BLOCK, STONE = (12.0, 7.0), (10.0, 7.0)  # length and width of a slider on the frame, and of a stone on a moving link
SLOT = (13.0, 2.9)  # length of the piece of slot drawn about a pin, and half its width
STAND = (8.0, 4.5, 1.5)  # a fixed hinge: height, half the width of its foot, and what the base is longer
HATCH, HATCH_STEP = 3.0, 2.0  # length and step of hatching
GUSSET = 1.8  # thickness of a rigid corner's filling, across the corner
LEG = 1.5  # the legs of that filling, as often as the thickness beyond a hinge: a wide corner is filled less far
CROSS = 1.8  # half an arm of the cross at a crank position that is a gap
TICK = 1.2  # half a tick of a position
HEAD = (3.5, 0.9)  # length and half width of the head of an arc


def arrowhead(start: complex, tip: complex, factor: float = 1.0) -> Fill | None:
    """Draw the filled head of an arrow; a short vector gets a smaller, blunter head, a vanishing one none."""
    length = abs(tip - start)
    if length < 0.1:
        return None
    size = min(factor, max(length / 1.5, min(length, ARROW_LEAST)) / ARROW_LENGTH)
    along = (tip - start) / length
    base, half = tip - along * size * ARROW_LENGTH, 1j * along * min(factor * ARROW_HALF, size * ARROW_BLUNT)
    return Fill((tip, base + half, base - half))


def hinge(at: complex, hand: Hand, links: int = 2) -> tuple[Circle, ...]:
    """Draw a hinge (вращательная пара): a circle; one of three links or more is two circles, one in the other."""
    radii = (HINGE,) if links < 3 else DOUBLE
    return tuple(Circle(at, radius * hand.symbol, hand.body) for radius in radii)


def fixed_hinge(at: complex, hand: Hand, radius: float, downward: complex = -1j) -> tuple[Stroke, ...]:
    """Draw the stand of a fixed hinge (стойка): two legs from its circle, a base, hatching on the ground's side."""
    height, half, more = (size * hand.symbol for size in STAND)
    side = 1j * downward
    feet = [at + height * downward + half * side, at + height * downward - half * side]
    legs = [Line(at + (foot - at) / abs(foot - at) * radius, foot, hand.result) for foot in feet]
    return *legs, *ground(feet[0] + more * side, feet[1] - more * side, downward, hand)


def ground(start: complex, end: complex, into: complex, hand: Hand) -> tuple[Stroke, ...]:
    """Draw a fixed line with equal hatching at 45 degrees on the side `into`, within the line's length."""
    length = abs(end - start)
    along = (end - start) / length
    lean = HATCH * hand.symbol * math.sqrt(0.5)
    count = max(math.floor((length - lean) / (HATCH_STEP * hand.symbol)), 1)
    feet = [start + along * (lean + (length - lean) * k / count) for k in range(count + 1)]
    return Line(start, end, hand.result), *(Line(foot, foot + lean * (into - along), hand.drafted) for foot in feet)


def block(at: complex, direction: complex, hand: Hand, size: tuple[float, float] = BLOCK) -> Polyline:
    """Draw a sliding block (ползун, камень) turned along its line."""
    along, across = direction * size[0] / 2 * hand.symbol, 1j * direction * size[1] / 2 * hand.symbol
    corners = at + along + across, at - along + across, at - along - across, at + along - across
    return Polyline(corners, True, hand.body)


def slot(at: complex, direction: complex, hand: Hand) -> Polyline:
    """Draw the slot of a link about its pin: two lines beside the pin, closed by half circles."""
    half, radius = SLOT[0] / 2 * hand.symbol, SLOT[1] * hand.symbol
    bend = [cmath.rect(radius, math.pi * (k / 12 - 0.5)) for k in range(13)]
    ends = [half - radius + step for step in bend] + [radius - half - step for step in bend]
    return Polyline(tuple(at + direction * end for end in ends), True, hand.body)


def gusset(corner: complex, first: complex, second: complex, radius: float, hand: Hand) -> Fill | None:
    """Fill the corner of two lines of one link beyond a circle about it: the corner is rigid; a wide one is left."""
    half, depth = abs(cmath.phase(second / first)) / 2, radius + GUSSET * hand.symbol
    reach = depth * min(1 / math.cos(half), LEG)
    if half == 0 or reach * math.cos(half) <= radius + GUSSET * hand.symbol / 4:
        return None  # one line, or a corner so wide that it is nearly one
    middle = (first + second) / abs(first + second)
    turn = cmath.phase(first / middle)
    rim = [middle * cmath.rect(radius, turn * (k / 4 - 1)) for k in range(9)] if radius else [0j]
    return Fill((*(corner + spot for spot in rim), corner + first * reach, corner + second * reach))


def mass_centre(at: complex, hand: Hand) -> tuple[Stroke, ...]:
    """Draw a mass centre (центр масс): a circle with two opposite quarters filled."""
    radius = MASS * hand.symbol
    quarters = [
        Fill((at, *(at + cmath.rect(radius, start + math.pi / 12 * k) for k in range(7)))) for start in (0.0, math.pi)
    ]
    return Circle(at, radius, LineStyle(hand.thin, fill="#ffffff")), *quarters


def cross(at: complex, hand: Hand) -> tuple[Line, Line]:
    """Draw the cross at a position that is a gap."""
    arms = (CROSS * hand.symbol * cmath.rect(1.0, turn) for turn in (math.pi / 4, -math.pi / 4))
    first, second = (Line(at - arm, at + arm, hand.other) for arm in arms)
    return first, second


def tick(at: complex, direction: complex, hand: Hand) -> Line:
    """Draw a position's tick across a line or a circle of some direction."""
    across = 1j * direction * TICK * hand.symbol
    return Line(at - across, at + across, hand.drafted)


class TurnArrow(NamedTuple):
    """An arc about a centre on paper, mm and rad, that turns clockwise where its sweep is negative."""

    centre: complex
    radius: float
    start: float
    sweep: float

    @property
    def middle(self) -> tuple[complex, float]:
        """Its middle, and the direction away from the centre there: so stands its letter."""
        turn = self.start + self.sweep / 2
        return self.centre + cmath.rect(self.radius, turn), turn

    def draw(self, hand: Hand, style: LineStyle | None = None) -> tuple[Stroke, ...]:
        """Draw it with an arrowhead at its end: the sense of rotation; one that is longer than the arc is its half."""
        run = abs(self.sweep) * self.radius / (HEAD[0] * hand.symbol)
        length, half = (size * hand.symbol * (1.0 if run >= 1.0 else run / 2) for size in HEAD)
        end = self.start + self.sweep
        neck = end - math.copysign(length / self.radius, self.sweep)
        tip, back = self.centre + cmath.rect(self.radius, end), self.centre + cmath.rect(self.radius, neck)
        wing = 1j * (tip - back) / abs(tip - back) * half
        arc = Arc(self.centre, self.radius, min(self.start, neck), max(self.start, neck), style or hand.other)
        return arc, Fill((tip, back + wing, back - wing), INK)

    def angle(self, hand: Hand, ways: Sequence[int] = (1, -1)) -> Iterator[Stroke]:
        """Draw it thin from its middle to both sides, with an arrowhead at either end: an angle."""
        for way in ways:
            half = TurnArrow(self.centre, self.radius, self.middle[1], way * self.sweep / 2)
            yield from half.draw(hand, hand.drafted)


def rotation(centre: complex, sense: float, sizes: tuple[float, float, float], hand: Hand) -> TurnArrow:
    """Give the arrow of a rotation in a sense, by its sign; `sizes` are the radius mm, start and sweep rad."""
    radius, start, sweep = sizes
    return TurnArrow(centre, radius * hand.symbol, start, math.copysign(sweep, sense))


def pole(at: complex) -> Circle:
    """Draw the pole of a plan: a small filled circle."""
    return Circle(at, 0.8, INK)


DASHED, DASH_DOT = (2.0, 8.0), (5.0, 30.0)


def fit_dashes(strokes: Iterable[Stroke]) -> Iterator[Stroke]:
    """Fit the dashes of lines, chains, arcs and curves to their lengths; strokes of full lines pass."""
    for stroke in strokes:
        match stroke:
            case Line(start, end, style) if style.dash:
                yield stroke._replace(style=fit(style, abs(end - start)))
            case Arc(radius=radius, style=style) if style.dash:
                yield stroke._replace(style=fit(style, radius * stroke.sweep))
            case Polyline(points, closed, style) if style.dash:
                length = sum(abs(end - start) for start, end in pairwise((*points, points[0]) if closed else points))
                yield stroke._replace(style=fit(style, length, closed))
            case Curve(pieces, closed, style) if style.dash:
                length = sum(abs(end - start) for start, end in pairwise(sampled(pieces, GRAIN)))
                yield stroke._replace(style=fit(style, length, closed))
            case _:
                yield stroke


def fit(style: LineStyle, length: float, closed: bool = False) -> LineStyle:
    """Give a broken line's style with dashes that fill its length from end to end; a line too short for two is full.

    A closed line has a gap before its beginning: it has as many gaps as dashes.

    >>> fit(LineStyle(0.35, (4, 1.5)), 20.0).dash  # four dashes and three gaps
    (3.875, 1.5)
    >>> fit(LineStyle(0.35, (15, 1.5, 0.5, 1.5)), 9.0).dash
    ()
    """
    dash, *rest = style.dash
    between, last = sum(rest), 0 if closed else 1
    least, most = DASHED if len(rest) == 1 else DASH_DOT

    def fitting(gaps: int) -> float:
        return float(numeral((length - gaps * between) / (gaps + last)))  # of lines of one length it is one

    gaps = max(round(tied((length - last * dash) / (dash + between))), 1)
    while gaps > 1 and fitting(gaps) < least:
        gaps -= 1
    while fitting(gaps) > most:
        gaps += 1
    return style._replace(dash=(fitting(gaps), *rest) if fitting(gaps) >= least else ())


LEAN = 1 + 1j  # along the lines


def hatching(outline: Sequence[complex], hand: Hand) -> Iterator[Line]:
    """Hatch the inside of a closed outline on paper; lines of neighbouring parts of one body meet."""
    turned = [corner / LEAN for corner in outline]  # the lines lie level
    apart = HATCH_STEP * hand.symbol / abs(LEAN)
    first, last = min(corner.imag for corner in turned), max(corner.imag for corner in turned)
    for k in range(math.floor(first / apart) + 1, math.ceil(last / apart)):
        for start, end in _inside(turned, k * apart):
            yield Line(start * LEAN, end * LEAN, hand.drafted)


def _inside(outline: Sequence[complex], level: float) -> Iterator[tuple[complex, complex]]:
    """Give the pieces of a level line that lie within an outline."""
    ends = np.array(outline)
    starts = np.roll(ends, 1)
    cut = (starts.imag > level) != (ends.imag > level)
    before, after = starts[cut], ends[cut]
    share = (level - before.imag) / (after.imag - before.imag)
    places = np.sort(before.real + share * (after.real - before.real))
    pieces = list(pairwise(places.tolist()))[::2]
    yield from ((complex(start, level), complex(end, level)) for start, end in pieces if end > start)
