"""The figure of a cam's profile: its construction by turning the frame about it, curves, follower, sizes (профиль)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from drawings.figures.cam import follower, inversion, outlines, phase_arcs, senses, size_marks
from drawings.figures.cam.profile_view import NAME, QUANTITY, SYMBOL, UNIT, ProfileView
from drawings.figures.cam.senses import BODY_GUIDE, Rings, around, beyond
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.place import Place
from drawings.lettering.lettering import text_width
from drawings.lettering.phrase import telling
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, Stroke, Text
from drawings.symbols.dashes import fit
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.symbols import HINGE, fixed_hinge, hinge, pole

LETTERS, MOST = 21.0, 80.0  # it is drawn at least so many letters large, and at most
BESIDE = 1.0  # mm from a point to its number
END = 0.9  # mm from the end of an axis to its number
AXIS = 6.0  # mm that the axes of the shaft go past it
ORIGIN = "O"


@dataclass(frozen=True)
class ProfileFigure:
    """The profile placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    view: ProfileView
    place: Place
    lines: tuple[Stroke, ...]
    drafting: Drafting

    @cached_property
    def rings(self) -> Rings:
        """What lies how far out."""
        return Rings(self.view, self.place, self.drafting.hand)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure: phases, senses, sizes and points lettered, every position numbered."""
        letters = (
            *self._points(labels),
            *self._phases(labels),
            *self._sizes(labels),
            *self._numbers(labels),
            *self._divisions(labels),
            *outlines.lettered(self.view, self.place, self.drafting, labels),
        )
        return (Group((*self.lines, Group(letters)), NAME),)

    def _points(self, labels: Labels) -> Iterator[Stroke]:
        """Letter O, a rocker's pivot, the senses."""
        view, hand = self.view, self.drafting.hand
        gap = BESIDE + (0.0 if view.cam.translates else HINGE * hand.symbol)
        yield labels.beside(self.place.on(0j), ORIGIN, hand.letter, gap, view.quiet)
        if view.sizes.pivot:
            yield labels.beside(self.place.on(view.sizes.pivot), "O_1", hand.letter, gap, math.pi / 2)
        for one in senses.senses(view, self.rings):
            yield one.letter_beside(labels, hand)
        for start, end in senses.straight(view, self.rings):
            yield labels.along(start, end, "v", hand.letter, BESIDE, math.pi / 2)

    def _phases(self, labels: Labels) -> Iterator[Stroke]:
        hand = self.drafting.hand
        for arc in phase_arcs.phase_arcs(self.view, self.rings, self.drafting):
            yield arc.letter_beside(labels, hand)
        for angle in size_marks.rocking(self.view, self.place, self.drafting):
            yield angle.letter_beside(labels, hand)
        for one in phase_arcs.travels(self.view, self.rings, self.drafting):
            yield telling(NAME, labels.along(*one.lines[0], one.letter, hand.number, BESIDE, math.pi / 2))

    def _sizes(self, labels: Labels) -> Iterator[Stroke]:
        hand = self.drafting.hand
        for one in size_marks.size_marks(self.view, self.place, self.drafting):
            yield telling(NAME, labels.along(one.start, one.end, one.letter, hand.number, BESIDE, math.pi / 2))

    def _numbers(self, labels: Labels) -> Iterator[Stroke]:
        """Number the positions at the ends of their axes, and at the points of the curve."""
        hand, view = self.drafting.hand, self.view
        for k, spot, towards in self._ends():
            yield labels.beside(spot, str(k), hand.number, END, towards)
        for k in inversion.marked(view, self.place, hand):
            spot, normal = self.place.on(complex(view.contour.pitch[k])), view.at(view.contour.turned[k])[1]
            towards = math.atan2(normal.imag, normal.real)
            yield labels.beside(spot, str(k), hand.number, BESIDE, towards)

    def _ends(self) -> Iterator[tuple[int, complex, float]]:
        """Give the ends of the turned axes with the directions outward."""
        view, rings = self.view, self.rings
        for k, turned in view.positions:
            if view.cam.translates:
                high = inversion.highest(view, self.place, self.drafting.hand)
                yield k, complex(self.place.on(complex(view.contour.pitch[k])).real, high), math.pi / 2
            else:
                pivot = self.place.on(view.back(view.sizes.pivot, turned)) - self.place.on(0j)
                off = pivot if view.cam.rocks and k else rings.crossing(turned, rings.ends)
                yield k, self.place.on(0j) + off, math.atan2(off.imag, off.real)

    def _divisions(self, labels: Labels) -> Iterator[Stroke]:
        for one in follower.divisions(self.view, self.place, self.drafting.hand):
            yield labels.beside(one.spot, str(one.position), self.drafting.hand.number, BESIDE, one.towards)


def measure(view: ProfileView, drafting: Drafting) -> Picture:
    """Measure the room that the profile needs: the cam, the ends of the axes around it, the arcs of the phases."""
    hand = drafting.hand
    title = text_width(Text(0j, drafting.word("cam profile"), hand.title))
    far = around(view, hand)
    if view.cam.translates:
        above = beyond(hand) + 4 * hand.number + hand.letter
        margins = Margins(2 * hand.letter, BODY_GUIDE * hand.symbol, above + 2 * hand.title + hand.text)
    else:
        margins = Margins(far, far, far + 2 * hand.title + hand.text)
    return picture(NAME, view.corners, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)._replace(
        most=MOST * hand.letter
    )


def draw(view: ProfileView, room: Picture, spot: Spot, drafting: Drafting) -> ProfileFigure:
    """Draw the profile in its spot: the construction thin, the follower at the start, the curves over all."""
    place, hand = room.place(*spot), drafting.hand
    rings = Rings(view, place, hand)
    lines = (
        heading(spot.box, drafting.word("cam profile"), drafting.scale(spot.scale), hand),
        *_shaft(view, place, hand),
        *inversion.construction(view, rings),
        *size_marks.thin(view, place, hand),
        *_around(view, rings, drafting),
        *follower.follower(view, place, hand),
        *outlines.curves(view, NAME, place, hand),
        *(one.draw(place, hand) for one in size_marks.size_marks(view, place, drafting)),
        *inversion.pivots(view, place, hand),
        *inversion.marks(view, place, hand),
        *follower.graduated(view, place, hand),
        *follower.pivot_mark(view, place, hand),
        _origin(view, place, hand),
    )
    return ProfileFigure(view, place, lines, drafting)


def _around(view: ProfileView, rings: Rings, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the phases and the senses."""
    hand = drafting.hand
    for arc in (*phase_arcs.phase_arcs(view, rings, drafting), *size_marks.rocking(view, rings.place, drafting)):
        yield from arc.draw(hand)
    if not view.cam.translates:
        yield from phase_arcs.bounds(view, rings, hand)
    for one in phase_arcs.travels(view, rings, drafting):
        yield from one.draw(hand)
    for sense in senses.senses(view, rings):
        yield from sense.draw(hand)
    for ends in senses.straight(view, rings):
        yield senses.pushed(NAME, ends, hand)


def _shaft(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the axes of the shaft, and its stand."""
    if view.cam.translates:
        return
    zero, half = place.on(0j), (HINGE + AXIS) * hand.symbol
    for along in (1, 1j):
        yield Line(zero - along * half, zero + along * half, fit(hand.axis, 2 * half))
    yield from fixed_hinge(zero, hand, HINGE * hand.symbol)


def _origin(view: ProfileView, place: Place, hand: Hand) -> Group:
    spot = place.on(0j)
    circle = pole(spot) if view.cam.translates else hinge(spot, hand)[0]
    return point(Subject(NAME, QUANTITY, None), ORIGIN, 0j, place, circle, "pole")
