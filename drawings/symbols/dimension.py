"""Dimensions, and arms of forces with theirs (размеры, плечи)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.page.page import Scale
from drawings.paper.hand import Hand
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import NO_DATA, Group, Line, Polyline, Statement, Stroke
from drawings.paper.walk import stating, tied
from drawings.symbols.couples import plain_name
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead

PAST = 1.5  # mm that an extension line goes past the dimension line


class Dimension(NamedTuple):
    """A distance dimensioned beside it: its letter, its ends, and the way to its line, mm."""

    letter: str
    start: complex
    end: complex
    off: complex
    states: Statement | None = None

    @property
    def length(self) -> float:
        """The distance on paper, mm."""
        return abs(self.end - self.start)

    @property
    def middle(self) -> complex:
        """The middle of its line: beside it stands the letter."""
        return (self.start + self.end) / 2 + self.off

    @property
    def lines(self) -> tuple[tuple[complex, complex], ...]:
        """The dimension line, then the two extension lines."""
        past = self.off * (1 + PAST / abs(self.off))
        ends = ((end, end + past) for end in (self.start, self.end))
        return (self.start + self.off, self.end + self.off), *ends

    def draw(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw its lines, its arrows within or, where there is no room, outside."""
        line, *others = arrows(*self.lines[0], hand)
        extensions = (Line(*ends, hand.drafted) for ends in self.lines[1:])
        drawn = line, *extensions, *others
        return drawn if self.states is None else (stating(self.states, *drawn),)


def arrows(start: complex, end: complex, hand: Hand) -> tuple[Stroke, ...]:
    """Draw a dimension line with arrows at both ends: within or, where there is no room, outside."""
    along = (end - start) / abs(end - start) * ARROW_LENGTH * hand.symbol
    tails = (end, start) if tied(abs(end - start) - 3 * abs(along)) > 0 else (start - 2 * along, end + 2 * along)
    heads = (arrowhead(tail, tip, hand.symbol) for tail, tip in zip(tails, (start, end), strict=True))
    outer = () if tails[0] == end else (Line(tails[0], tails[1], hand.drafted),)
    return Line(start, end, hand.drafted), *outer, *(head for head in heads if head is not None)


BEYOND = 4.0  # mm that a line of action is drawn past the foot of the perpendicular
SQUARE = 2.5  # side of the mark of a right angle
LEAST = 0.5  # mm: a shorter arm is a point on paper
BESIDE = 1.0  # mm from the perpendicular to its letter


class Arm(NamedTuple):
    """The arm of a force about a point: places on paper, and the unit direction of the force."""

    letter: str
    about: complex
    at: complex  # a place on the line of action: where the force acts, or the end of its arrow
    direction: complex
    data: Mapping[str, str] = NO_DATA  # of a measurable one
    aside: float = 0.0  # mm along the force: where lines run on the perpendicular it is dimensioned beside them

    @property
    def ends(self) -> tuple[complex, complex]:
        """The ends of the line that is dimensioned: on the perpendicular or aside of it."""
        return self.about + self.aside * self.direction, self.foot + self.aside * self.direction

    @property
    def foot(self) -> complex:
        """The foot of the perpendicular on the line of action."""
        return self.at + self.direction * ((self.about - self.at) * self.direction.conjugate()).real

    @property
    def length(self) -> float:
        """Length on paper, mm."""
        return abs(self.foot - self.about)

    def draw(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw the perpendicular, the line of action as far as its foot, and the mark of the right angle."""
        if self.length < LEAST:
            return (self._action(hand),)
        start, end = self.ends
        perpendicular: list[Stroke] = [Line(start, end, hand.drafted)]
        if self.length > 3 * ARROW_LENGTH * hand.symbol:  # a shorter one has no room for arrows
            heads = arrowhead(start, end, hand.symbol), arrowhead(end, start, hand.symbol)
            perpendicular += [head for head in heads if head is not None]
        group = Group(tuple(perpendicular), "", self.data, self.letter)
        return self._action(hand), *self._extension(hand), *self._square(hand), group

    def _extension(self, hand: Hand) -> tuple[Line, ...]:
        """Draw the line from the point of moments to a perpendicular that is dimensioned aside."""
        past = math.copysign(BEYOND / 2 * hand.symbol, self.aside)
        return (
            (Line(self.about, self.about + (self.aside + past) * self.direction, hand.drafted),) if self.aside else ()
        )

    def _action(self, hand: Hand) -> Line:
        """Draw the line of action from the force's point to a little past the foot, or past what stands aside of it."""
        end = self.ends[1]
        along = end - self.at
        ahead = along / abs(along) if abs(along) > QUANTUM else self.direction
        return Line(self.at, end + ahead * BEYOND * hand.symbol, hand.drafted)

    def _square(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw the mark of the right angle, on the side of the force's point."""
        side = SQUARE * hand.symbol
        if self.length < 2 * side:
            return ()
        foot = self.ends[1]
        back = self.at - foot
        along = (back / abs(back) if abs(back) > LEAST else self.direction) * side
        across = (self.about - self.foot) / self.length * side
        return (Polyline((foot + along, foot + along + across, foot + across), False, hand.drafted),)

    def letter_beside(self, labels: Labels, hand: Hand) -> Stroke:
        """Letter it beside its middle."""
        middle = sum(self.ends) / 2
        across = cmath.phase(1j * (self.foot - self.about)) if self.length >= LEAST else math.pi / 4
        return labels.beside(middle, self.letter, hand.letter, BESIDE, across)


def to_scale(letter: str, about: complex, at: complex, direction: complex, scale: Scale, subject: Subject) -> Arm:
    """Give an arm on a scheme drawn to scale, measurable: the vector from the point to the line of action."""
    arm = Arm(letter, about, at, direction / abs(direction))
    return arm._replace(data=subject.data("vector", plain_name(letter), (arm.foot - about) * scale.mu, scale))
