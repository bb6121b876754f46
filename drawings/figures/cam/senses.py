"""The sense in which a cam moves, and in which the frame is turned about it (направления вращения и обращения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.cam.profile_view import ProfileView
from drawings.figures.cam.rings import Rings
from drawings.layout.labels import Labels
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.symbols.symbols import arrowhead, turning_arrow

WITHIN = (0.55, 0.78)  # of what is free within the profile: radii of both arrows
ASIDE = math.radians(32)  # their middles to either side of the widest step
SWEEP = math.radians(55)
LEAST = 7.0  # mm, radius of an arrow
STRAIGHT = 22.0  # mm, length of the arrow of a cam that translates
BESIDE = 1.2


class Sense(NamedTuple):
    """An arrow about O with its letter: the direction of its middle rad, its radius mm, its sense."""

    letter: str
    centre: complex
    radius: float
    middle: float
    sense: int

    def draw(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw it."""
        start = self.middle - self.sense * SWEEP / 2
        return turning_arrow(self.centre, self.radius, start, self.sense * SWEEP, hand)

    def letter_beside(self, labels: Labels, hand: Hand) -> Stroke:
        """Letter it beyond its middle."""
        spot = self.centre + cmath.rect(self.radius, self.middle)
        return labels.beside(spot, self.letter, hand.letter, BESIDE, self.middle)


def senses(view: ProfileView, rings: Rings) -> tuple[Sense, ...]:
    """Give the arrows: the cam's own; the frame's, if there is room within the profile."""
    if view.cam.translates:
        return ()
    zero, hand, own = rings.place.on(0j), rings.hand, view.cam.sense
    free = rings.place.length(float(abs(view.curve.profile).min()))
    radii = [max(share * free, LEAST * hand.symbol) for share in WITHIN]
    both = (Sense("ω", zero, radii[0], view.quiet - ASIDE, own), Sense("−ω", zero, radii[1], view.quiet + ASIDE, -own))
    return both if radii[1] > LEAST * hand.symbol else both[:1]


def straight(view: ProfileView, rings: Rings) -> Iterator[tuple[complex, complex]]:
    """Give the ends of the arrow of a cam that translates, within its body."""
    if view.cam.translates:
        left, right = (rings.place.on(one) for one in view.body)
        middle = (left + right) / 2 + 1j * rings.place.length(view.cam.lift) * 0.4
        half = view.cam.sense * STRAIGHT / 2 * rings.hand.symbol
        yield middle + half, middle - half


def pushed(ends: tuple[complex, complex], hand: Hand) -> Iterator[Stroke]:
    """Draw a straight arrow."""
    yield Line(*ends, hand.other)
    head = arrowhead(*ends, hand.symbol)
    yield from () if head is None else (head,)
