"""The star of cranks: a bank seen along its shaft at phi = 0, with the axes of its guides (звезда кривошипов)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass

from drawings.figures.bank.bank_view import BankView
from drawings.figures.rotor.along import AXIS, ORIGIN, SYMBOL, UNIT
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.place import Place
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Line, Stroke, Text
from drawings.symbols.dashes import fit
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.symbols import HINGE, hinge, turning_arrow
from plans.model.balance.bank import Member

NAME = "star"
QUANTITY = "r"
MARGINS = Margins(5.0, 4.0, 4.0)  # paper around it for letters, in their sizes
LETTERS, MOST = 9.0, 23.4  # it is drawn at least so many letters large, and at most
BESIDE = 1.0  # mm from a pin to its number
PIN = 1.6  # mm, radius of a crank pin
TURN = (10.0, math.radians(12), math.radians(60))  # radius mm, start and sweep of the arrow of rotation


@dataclass(frozen=True)
class StarFigure:
    """The star placed on paper: its lines, and the numbers still to be placed among the lines of all figures."""

    shown: BankView
    place: Place
    lines: tuple[Stroke, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole star, its cranks numbered outward, its guides where they differ, its sense."""
        letters = (*self._cranks(labels), *self._guides(labels), *self._shaft(labels))
        return (Group((*self.lines, Group(letters)), NAME),)

    def _cranks(self, labels: Labels) -> Iterator[Stroke]:
        hand = self.drafting.hand
        for way, names in together((self.shown.crank_at(one), one) for one in self.shown.members).items():
            spot, gap = self.place.on(way * reach(self.shown)), PIN * hand.symbol + BESIDE
            yield labels.beside(spot, names, hand.letter, gap, cmath.phase(way))

    def _guides(self, labels: Labels) -> Iterator[Stroke]:
        hand, far = self.drafting.hand, self.place.length(reach(self.shown)) + AXIS * self.drafting.hand.symbol
        guides = together((self.shown.guide_at(one), one) for one in self.shown.members)
        for way, names in guides.items() if len(guides) > 1 else ():
            text = self.drafting.word("guide of", names=names)
            yield labels.beside(self.place.on(0j) + far * way, text, hand.number, BESIDE, cmath.phase(way))

    def _shaft(self, labels: Labels) -> Iterator[Stroke]:
        hand, centre = self.drafting.hand, self.place.on(0j)
        yield labels.beside(centre, ORIGIN, hand.letter, BESIDE + HINGE * hand.symbol, -math.pi / 4)
        yield labels.beside(centre + turned(self.shown, hand), "ω", hand.letter, BESIDE, TURN[1])


def together(pairs: Iterator[tuple[complex, Member]]) -> dict[complex, str]:
    """Name the members of one direction together, in their order."""
    found: dict[complex, str] = {}
    for way, one in pairs:
        key = next((other for other in found if abs(other - way) < NEAR), way)
        found[key] = f"{found[key]}, {one.name}" if key in found else one.name
    return found


NEAR = 1e-9  # of a unit direction: an angle that was rounded once is still the same


def reach(shown: BankView) -> float:
    """Give the length of a crank as it is drawn, m; 1 where it is not known."""
    return shown.crank or 1.0


def turned(shown: BankView, hand: Hand) -> complex:
    """Give the middle of the arrow of rotation from the shaft on paper."""
    radius, start, sweep = TURN
    return cmath.rect(radius * hand.symbol, start + math.copysign(sweep, shown.task.speed) / 2)


def measure(shown: BankView, drafting: Drafting) -> Picture:
    """Measure the room that the star needs: a circle about the shaft."""
    hand, far = drafting.hand, reach(shown)
    title = text_width(Text(0j, drafting.word("star of cranks"), hand.title))
    side, below, above = (share * hand.letter + AXIS * hand.symbol for share in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    corners = [complex(x, y) for x in (-far, far) for y in (-far, far)]
    found = picture(NAME, corners, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)
    return found._replace(most=MOST * hand.letter)


def draw(shown: BankView, room: Picture, spot: Spot, drafting: Drafting) -> StarFigure:
    """Draw the star in its spot: the circle of the pins, the guides' axes, the cranks at phi = 0."""
    place, hand = room.place(*spot), drafting.hand
    under = drafting.scale(spot.scale) if shown.crank else drafting.word("angles alone")
    title = heading(spot.box, drafting.word("star of cranks"), under, hand)
    radius, start, sweep = TURN
    arrow = turning_arrow(place.on(0j), radius * hand.symbol, start, math.copysign(sweep, shown.task.speed), hand)
    lines = (title, *_axes(shown, place, hand), *arrow)
    cranks = [Line(place.on(0j), place.on(shown.crank_at(one) * reach(shown)), hand.result) for one in shown.members]
    pins = (_pin(shown, one, place, hand) for one in shown.members)
    (circle,) = hinge(place.on(0j), hand)
    shaft = point(Subject(NAME, QUANTITY, None), ORIGIN, 0j, place, circle, "pole")
    return StarFigure(shown, place, (*lines, *cranks, *pins, shaft), drafting)


def _axes(shown: BankView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the circle of the pins, and the axis of every guide from beyond the shaft outward."""
    radius = place.length(reach(shown))
    yield Circle(place.on(0j), radius, fit(hand.axis, math.tau * radius, True))
    far, centre = radius + AXIS * hand.symbol, place.on(0j)
    for way in together((shown.guide_at(one), one) for one in shown.members):
        yield Line(centre - AXIS * hand.symbol * way, centre + far * way, fit(hand.axis, far + AXIS * hand.symbol))


def _pin(shown: BankView, one: Member, place: Place, hand: Hand) -> Group:
    """Draw a crank pin; it can be measured where the crank's length is known."""
    centre = shown.crank_at(one) * reach(shown)
    circle = Circle(place.on(centre), PIN * hand.symbol, hand.body)
    if not shown.crank:
        return Group((circle,), "", {}, one.name)
    return point(Subject(NAME, QUANTITY, None), one.name, centre, place, circle)._replace(title=one.name)
