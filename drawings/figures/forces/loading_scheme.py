"""The loading scheme of a group, or of the primary link, in one position: its links with all forces (схема нагружения).

The links are to scale, the forces are not: an arrow is true in direction, a larger force has a longer arrow.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import dataclass

from drawings.figures.forces.leverage import Leverage, leverages
from drawings.figures.forces.scheme import Scheme, scheme
from drawings.figures.forces.scheme_layout import Layout
from drawings.figures.linkage.numbering import link_numbers
from drawings.layout.labels import Labels, free_side
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.place import Place
from drawings.lettering.extent import bounds
from drawings.lettering.indices import with_index
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.page.scale import Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, Stroke, Text
from drawings.symbols.figure import heading

__all__ = ["Leverage", "Scheme", "SchemeFigure", "draw", "leverages", "measure", "scheme"]

NEAR = 4.0  # mm beyond its letter: lines that end so near to a point are lines at it
LEAST = 14.0  # a scheme is drawn at least so many of its letters large: below, its forces hide it
LETTERS, BESIDE = 1.6, 2.4  # letters' sizes below and above the lines of a scheme, and beside them


@dataclass(frozen=True)
class SchemeFigure:
    """A scheme placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: Scheme
    layout: Layout
    lines: tuple[Stroke, ...]
    hand: Hand

    @property
    def place(self) -> Place:
        """Where the scheme lies on paper."""
        return self.layout.place

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure, its letters placed."""
        letters = Group(tuple(_letters(self.layout, labels, self.hand)))
        return (Group((*self.lines, letters), f"scheme-{self.shown.cut.label}-{self.shown.column}"),)


def measure(shown: Scheme, name: str, drafting: Drafting) -> Picture:
    """Measure the room that a scheme needs: its links to scale, and what of its arrows is outside them, in mm."""
    hand = drafting.hand
    least = LEAST * hand.letter
    bare = picture(name, shown.points, ("l", "m"), Margins(0, 0, 0), 0.0)
    solid = picture(name, shown.solid, ("l", "m"), Margins(0, 0, 0), 0.0)
    extent, own = max(bare.wide, bare.high), max(solid.wide, solid.high)
    least *= extent / own if own else 1.0  # the links are as large beside a long spring as without one
    bare = bare._replace(least=least if extent else 0.0)  # a lone point is not drawn smaller at any scale
    place = Place(0j, bare.middle, Scale((extent or 1.0) / least, "l", "m"))
    left, bottom, right, top = bounds(Group(tuple(Layout(shown, place, drafting, None).strokes())))
    wide, high = bare.wide / place.scale.mu / 2, bare.high / place.scale.mu / 2
    around = LETTERS * hand.letter
    side = max(-left - wide, right - wide, 0.0) + BESIDE * hand.letter
    margins = Margins(side, max(-bottom - high, 0.0) + around, max(top - high, 0.0) + around + _head(hand))
    return bare._replace(margins=margins, heading=text_width(Text(0j, _title(shown, drafting), hand.title)))


def _head(hand: Hand) -> float:
    return 1.6 * hand.title + 2 * hand.text


def _title(shown: Scheme, drafting: Drafting) -> str:
    key = "primary scheme" if shown.cut.group is None else "loading scheme"
    return f"{drafting.word(key, group=shown.cut.label)}, {drafting.word('position', position=shown.column)}"


def draw(shown: Scheme, room: Picture, spot: Spot, drafting: Drafting) -> SchemeFigure:
    """Draw the scheme in its spot, with its title and its written scale above it."""
    place, hand = room.place(*spot), drafting.hand
    box = Field(spot.box.left, spot.box.bottom, spot.box.right, spot.box.top - _head(hand))
    laid = Layout(shown, place, drafting, box)
    under = f"{drafting.scale(spot.scale)};  {drafting.word('not to scale')}"
    title = heading(spot.box, _title(shown, drafting), under, hand)
    return SchemeFigure(shown, laid, (title, *laid.strokes()), hand)


def _letters(laid: Layout, labels: Labels, hand: Hand) -> Iterator[Stroke]:
    """Letter arms, points, forces and moments, and number the links."""
    for arm in laid.arms:
        yield arm.letter_beside(labels, hand)
    for shift in laid.shifts:
        yield labels.beside(shift.middle, shift.letter, hand.letter, 0.8, cmath.phase(shift.off))
    yield from _points(laid, labels, hand)
    for arrow in laid.arrows:
        yield arrow.letter_beside(labels, hand)
    for couple in laid.couples:
        yield couple.letter_beside(labels, hand)
    if laid.gear is not None and laid.gear.slants(laid.hand):
        middle, turn = laid.gear.angle(laid.hand)
        yield labels.beside(middle, "α", hand.letter, 1.0, turn)
    yield from link_numbers(laid.joints, laid.shown.links.links, labels, hand)


def _points(laid: Layout, labels: Labels, hand: Hand) -> Iterator[Stroke]:
    """Letter each point where the widest angle between the lines at it is free."""
    lines = [*_lines(laid.links), *(arrow.shaft for arrow in laid.arrows)]
    for name, value in laid.shown.named.items():
        spot, gap = laid.place.on(value), laid.clear(name) + 1.0
        yield labels.beside(spot, with_index(name), hand.letter, gap, free_side(spot, lines, gap + NEAR))


def _lines(strokes: list[Stroke]) -> Iterator[Line]:
    return (stroke for stroke in strokes if isinstance(stroke, Line))
