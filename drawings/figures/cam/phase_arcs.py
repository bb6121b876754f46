"""The phases of a cam about it: arcs between the turned axes that they begin and end with (фазовые углы кулачка)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from drawings.figures.cam.inversion import highest
from drawings.figures.cam.profile_view import NAME, ProfileView
from drawings.figures.cam.senses import Rings, beyond
from drawings.layout.labels import Labels
from drawings.lettering.phrase import telling
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import TURN, Line, Stroke
from drawings.paper.walk import stating
from drawings.report.phase_letters import phase_letter
from drawings.symbols.dimension import Dimension
from drawings.symbols.symbols import turning_arrow
from plans.model.cam import Phase

PAST = 1.5  # mm that an axis goes past the arc that ends at it
BESIDE = 1.2  # mm from an arc to its letter


class AngleArc(NamedTuple):
    """The arc of an angle on paper: where it begins, rad, and how far it goes, below 0 clockwise."""

    name: str
    letter: str
    centre: complex
    radius: float
    start: float
    sweep: float

    @property
    def middle(self) -> float:
        """The direction of its middle, rad."""
        return self.start + self.sweep / 2

    def draw(self, hand: Hand) -> Iterator[Stroke]:
        """Draw it, an arrow at either end."""
        ways = (way * self.sweep / 2 for way in (1, -1))
        arrows = (turning_arrow(self.centre, self.radius, self.middle, way, hand, hand.drafted) for way in ways)
        yield stating(Statement(Kind.ANGLE, NAME, self.name), *(stroke for arrow in arrows for stroke in arrow))

    def letter_beside(self, labels: Labels, hand: Hand) -> Stroke:
        """Letter it beyond its middle."""
        spot = self.centre + cmath.rect(self.radius, self.middle)
        return telling(NAME, labels.beside(spot, self.letter, hand.number, BESIDE, self.middle))


def phase_arcs(view: ProfileView, rings: Rings, drafting: Drafting) -> tuple[AngleArc, ...]:
    """Give the arcs of the phases: they run against the cam's motion, as the frame is turned."""
    if view.cam.translates:
        return ()
    return tuple(_arcs(view, rings, drafting))


def _arcs(view: ProfileView, rings: Rings, drafting: Drafting) -> Iterator[AngleArc]:
    for number, phase in enumerate(view.cam.phases):
        start = cmath.phase(rings.crossing(phase.start, rings.phases))
        text, sweep = phase_letter(view.cam, number, drafting), -view.cam.sense * min(phase.angle, TURN)
        yield AngleArc(f"φ_{number}", text, rings.place.on(0j), rings.phases, start, sweep)


def bounds(view: ProfileView, rings: Rings, hand: Hand) -> Iterator[Stroke]:
    """Draw the axes at which phases begin as far as the arcs between them."""
    zero = rings.place.on(0j)
    for phase in view.cam.phases:
        ends = (rings.crossing(phase.start, radius) for radius in (rings.ends, rings.phases + PAST * hand.symbol))
        start, end = (zero + one for one in ends)
        yield Line(start, end, hand.drafted)


def travels(view: ProfileView, rings: Rings, drafting: Drafting) -> tuple[Dimension, ...]:
    """Give the dimensions of the phases of a cam that translates, above its follower's guide."""
    if not view.cam.translates:
        return ()
    hand = drafting.hand
    off = 1j * (beyond(hand) + 2 * hand.number)
    said = partial(Statement, Kind.LENGTH, NAME, scale=rings.place.scale.mu)
    return tuple(
        Dimension(phase_letter(view.cam, number, drafting), *_over(view, rings, one), off, said(f"φ_{number}"))
        for number, one in enumerate(view.cam.phases)
    )


def _over(view: ProfileView, rings: Rings, phase: Phase) -> tuple[complex, complex]:
    """Give the ends of the axes at which a phase of a cam that translates begins and ends, mm."""
    level = highest(view, rings.place, rings.hand)
    start, end = (rings.place.on(view.back(0j, turned)).real for turned in (phase.start, phase.end))
    return complex(start, level), complex(end, level)
