"""The sense in which a cam moves, and in which the frame is turned about it (направления вращения и обращения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.cam.profile_view import NAME, ProfileView
from drawings.layout.labels import Labels
from drawings.layout.place import Place
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Group, Line, Stroke
from drawings.paper.walk import stating
from drawings.symbols.symbols import arrowhead, turning_arrow

CLEAR = 2.0  # mm between a follower at its highest and its guide
GUIDE = 9.0  # mm, length of a guide
PAST = 2.0  # mm that an axis goes past its guide
NUMBER = 2.4  # sizes of a number from the ends of the axes to the arcs of the phases
PHASE = 1.2  # sizes of a letter beyond the arcs of the phases
BODY_GUIDE = 8.0  # mm under a cam that translates, for its guide


class Rings(NamedTuple):
    """Radii on paper about O, mm, each beyond the one before."""

    view: ProfileView
    place: Place
    hand: Hand

    @property
    def cam(self) -> float:
        """The farthest place of the cam and of rollers on it."""
        return self.place.length(self.view.reach)

    @property
    def ends(self) -> float:
        """The ends of the turned axes, or the turned pivots of a rocker."""
        if self.view.cam.rocks:
            return max(self.place.length(abs(self.view.sizes.pivot)), self.cam + CLEAR * self.hand.symbol)
        return self.cam + beyond(self.hand)

    @property
    def phases(self) -> float:
        """The arcs of the phases."""
        return self.ends + NUMBER * self.hand.number

    def crossing(self, turned: float, radius: float) -> complex:
        """Give where a turned axis, or the ray through a turned pivot, meets a circle about O, mm from O."""
        view = self.view
        if view.cam.rocks:
            ray = view.way(view.sizes.pivot, turned)
            return radius * ray / abs(ray)
        off = self.place.length(view.axis)
        return view.way(complex(off, cmath.sqrt(radius**2 - off**2).real), turned)


def beyond(hand: Hand) -> float:
    """Give how far the axes go past the cam, mm: to where a guide ends, and on."""
    return (2 * CLEAR + GUIDE + PAST) * hand.symbol


def around(view: ProfileView, hand: Hand) -> float:
    """Give the paper around what is drawn to scale, mm."""
    ends = CLEAR * hand.symbol if view.cam.rocks else beyond(hand)
    return ends + NUMBER * hand.number + PHASE * hand.letter


WITHIN = (0.3, 0.68)  # of what is free from the cam to the ends of the axes: radii of both arrows
ASIDE, MOST = 0.25, math.radians(30)  # of the widest step: their middles to either side of its own, and at most
SWEEP, WIDE = 0.35, math.radians(32)  # of the widest step: how far they go, and at most
STRAIGHT = 22.0  # mm, length of the arrow of a cam that translates
BESIDE = 1.2


class Sense(NamedTuple):
    """An arrow about O with its letter: the direction of its middle rad, its radius mm, how far it goes."""

    letter: str
    centre: complex
    radius: float
    middle: float
    sweep: float  # below 0 clockwise

    def draw(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw it."""
        arrow = turning_arrow(self.centre, self.radius, self.middle - self.sweep / 2, self.sweep, hand)
        return (stating(Statement(Kind.DIRECTION, NAME, self.letter), *arrow),)

    def letter_beside(self, labels: Labels, hand: Hand) -> Stroke:
        """Letter it beyond its middle."""
        spot = self.centre + cmath.rect(self.radius, self.middle)
        return labels.beside(spot, self.letter, hand.letter, BESIDE, self.middle)


def senses(view: ProfileView, rings: Rings) -> tuple[Sense, ...]:
    """Give the arrows, the cam's own and the frame's, beside the cam where no axis is turned to."""
    if view.cam.translates:
        return ()
    zero, (start, end) = rings.place.on(0j), view.step
    inner = rings.place.length(abs(view.at((start + end) / 2)[0]) + view.found.roller)
    first, second = (inner + share * (rings.ends - inner) for share in WITHIN)
    aside, sweep = min(ASIDE * (end - start), MOST), view.cam.sense * min(SWEEP * (end - start), WIDE)
    return Sense("ω", zero, first, view.quiet - aside, sweep), Sense("−ω", zero, second, view.quiet + aside, -sweep)


def straight(view: ProfileView, rings: Rings) -> Iterator[tuple[complex, complex]]:
    """Give the ends of the arrow of a cam that translates, within its body."""
    if view.cam.translates:
        left, right = (rings.place.on(one) for one in view.body)
        middle = (left + right) / 2 + 1j * rings.place.length(view.cam.lift) * 0.4
        half = view.cam.sense * STRAIGHT / 2 * rings.hand.symbol
        yield middle + half, middle - half


def pushed(figure: str, ends: tuple[complex, complex], hand: Hand) -> Group:
    """Draw the straight arrow of a cam that translates, in a figure."""
    head = arrowhead(*ends, hand.symbol)
    heads = () if head is None else (head,)
    return stating(Statement(Kind.DIRECTION, figure, "v"), Line(*ends, hand.other), *heads)
