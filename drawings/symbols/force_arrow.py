"""Forces at their points: to scale and measurable, of one length and marked, or known in direction only (силы)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.page.scale import Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import NO_DATA, Group, Line, Polyline, Stroke, stated
from drawings.symbols.dashes import fit
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import ARROW_HALF, ARROW_LENGTH, arrowhead

BESIDE = 1.4  # mm from the free end of a force to its letter
ASIDE = math.radians(55)  # the letter stands ahead of the free end, to the left of the line of action


class ForceArrow(NamedTuple):
    """A force on paper: its letter, its point, its unit direction and its length in mm.

    It starts from its point or, `ending`, comes to it; one that stands off it is led to it by a thin line. Of an
    `unknown` one only the line of action is known.
    """

    letter: str  # marked up: "R^t_{34}"
    at: complex
    direction: complex
    length: float
    ending: bool = False
    unknown: bool = False
    data: Mapping[str, str] = NO_DATA  # of a measurable one
    lead: complex | None = None  # where the thin line begins

    @property
    def start(self) -> complex:
        """Where it begins."""
        return self.at - self.direction * self.length if self.ending else self.at

    @property
    def tip(self) -> complex:
        """Where its arrowhead ends."""
        return self.start + self.direction * self.length

    @property
    def shaft(self) -> Line:
        """Its own line."""
        return Line(self.start, self.tip)

    @property
    def free(self) -> complex:
        """The end that is not at its point: there stands its letter."""
        return self.start if self.ending else self.tip

    def draw(self, hand: Hand) -> Group:
        """Draw it: known in full lines with a filled head, unknown dashed with an open one."""
        if self.unknown:
            style = fit(hand.path, abs(self.tip - self.start))
            return Group((Line(self.start, self.tip, style), *_open_head(self, hand)), "", self._marked, self.letter)
        head = arrowhead(self.start, self.tip, hand.symbol)
        shaft = Line(self.start, self.tip, hand.result)
        return Group((shaft,) if head is None else (shaft, head), "", self.data or self._marked, self.letter)

    @property
    def _marked(self) -> dict[str, str]:
        return {"kind": "force", "name": plain_name(self.letter), "direction": stated(self.direction)}

    def letter_beside(self, labels: Labels, hand: Hand) -> Stroke:
        """Letter it: one to scale beside its middle, where no other of its polygon ends; a marked one at its end."""
        ahead = cmath.phase(self.direction) + (math.pi if self.ending else 0.0)
        if self.data:
            return labels.beside((self.start + self.tip) / 2, self.letter, hand.letter, BESIDE, ahead + math.pi / 2)
        return labels.beside(self.free, self.letter, hand.letter, BESIDE, ahead + ASIDE)


def to_scale(
    letter: str, value: complex, at: complex, scale: Scale, subject: Subject, ending: bool = False
) -> ForceArrow:
    """Give a force of a true value at a place on paper, to scale and measurable; its name is its letter."""
    direction = value / abs(value) if value else 1 + 0j  # of no force the direction is of no account
    data = subject.data("vector", plain_name(letter), value, scale)
    return ForceArrow(letter, at, direction, abs(value) / scale.mu, ending, data=data)


def plain_name(letter: str) -> str:
    """Name a force or an arm by its letter, without the braces of its index.

    >>> plain_name("R^t_{34}")
    'R^t_34'
    """
    return letter.replace("{", "").replace("}", "")


def not_to_scale(
    letter: str, direction: complex, at: complex, length: float, ending: bool = False, unknown: bool = False
) -> ForceArrow:
    """Give a force that only shows where and which way it acts, of some length on paper, mm."""
    return ForceArrow(letter, at, direction / abs(direction), length, ending, unknown)


def letters(forces: Iterable[ForceArrow], labels: Labels, hand: Hand) -> Group:
    """Letter forces, each where the lines of all figures leave room."""
    return Group(tuple(force.letter_beside(labels, hand) for force in forces))


def _open_head(force: ForceArrow, hand: Hand) -> tuple[Stroke, ...]:
    """Draw an open arrowhead: two thin lines of the size of a filled one."""
    along = force.direction * hand.symbol
    base, wing = force.tip - along * ARROW_LENGTH, 1j * along * ARROW_HALF
    return (Polyline((base + wing, force.tip, base - wing), False, hand.other),)
