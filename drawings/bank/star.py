"""The star of a bank's cranks and the members' vectors as they are seen on the sheet (звезда кривошипов)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.bank.report import mirrored, slight_force, slight_left, slight_moment, slight_order, straight
from drawings.kinds.polygon import RESULT, SIDE, ShownVector
from drawings.kinds.view import AXIS, BESIDE, ORIGIN, QUANTITY, SYMBOL, UNIT, origin, square
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Line, Stroke, Text
from drawings.symbols.figure import Subject, around, heading, point
from drawings.symbols.symbols import HINGE, fit, hinge, rotation
from plans.bank.harmonics import FORCE, MOMENT
from plans.bank.polygons import Total
from plans.model.balance.bank import BankBalance, Member
from plans.model.motion import Complexes
from plans.rotor.balancing import heading as direction

ALIKE = 0.1  # degrees: vectors whose directions differ by less are laid off as if they had one


class ShownOrder(NamedTuple):
    """A polygon of an order, with the crank or against it: its vectors end to end, their sum last unless they close."""

    kind: str  # FORCE or MOMENT
    signed: int
    vectors: tuple[ShownVector, ...]
    closed: bool

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(vector.end for vector in self.vectors)]


def fanned(sides: Sequence[tuple[str, complex]]) -> list[tuple[str, complex]]:
    """Order the sides of a polygon by their directions, from that of the first one on: no side crosses another then.

    >>> [name for name, _ in fanned([("1", 1 + 0j), ("2", -1j), ("3", 2j), ("4", 3 + 0j)])]
    ['1', '4', '3', '2']
    """
    first = next((value for _, value in sides if value), 1 + 0j)
    steps = round(360 / ALIKE)
    return sorted(sides, key=lambda side: round(math.degrees(cmath.phase(side[1] / first)) / ALIKE) % steps)


class BankView(NamedTuple):
    """A bank and what the construction found of it; `crank` m is the crank's length."""

    balance: BankBalance
    polygons: Mapping[str, Mapping[int, Total]]  # of forces and of moments, by signed order
    crank: float
    linkage: tuple[str, ...] = ()  # what is given of a linkage of the bank

    @property
    def members(self) -> tuple[Member, ...]:
        """The mechanisms."""
        return self.balance.task.members

    @property
    def turn(self) -> complex:
        """The direction of the reference guide on the sheet."""
        return direction(Fraction(float(np.degrees(self.balance.task.axis))))

    def shown(self) -> Iterator[ShownOrder]:
        """Give the polygons of every order that can be seen, but no mirror images and none of a single side."""
        for order in (order for order in self.balance.single if not slight_order(self.balance, order)):
            for kind in (FORCE, MOMENT):
                for signed in (order,) if mirrored(self.balance, order) else (order, -order):
                    if self.acts(kind, signed):
                        yield self._shown(kind, signed)

    def acts(self, kind: str, signed: int) -> bool:
        """Tell whether several mechanisms of the bank have something to lay off in a polygon."""
        single = self.balance.single[abs(signed)]
        several = sum(1 for member in self.members if member.place or kind == FORCE) > 1
        return several and abs(single.ahead if signed > 0 else single.back) > single.slack

    def _shown(self, kind: str, signed: int) -> ShownOrder:
        found, vectors, end = self.polygons[kind][signed], list[ShownVector](), 0j
        for name, spot in fanned([(side.vector.name, complex(side.vector.point)) for side in found.polygon.sides]):
            vectors.append(ShownVector(name, SIDE, end, spot * self.turn))
            end += spot * self.turn
        whole = (self.balance.forces if kind == FORCE else self.balance.moments)[abs(signed)]
        closed = found.vanishes or abs(complex(found.vector.point)) <= whole.slack
        if not closed:
            vectors.append(ShownVector(found.vector.name, RESULT, 0j, complex(found.vector.point) * self.turn))
        return ShownOrder(kind, signed, tuple(vectors), closed)

    @property
    def straight(self) -> bool:
        """Whether the force of the bank, before and after, keeps to the line of the reference guide."""
        return all(straight(course, self.balance.force) for course in (self.balance.force, self.balance.left))

    @property
    def lasting(self) -> bool:
        """Whether the compensators leave some force that can be seen."""
        left = bool(np.abs(self.balance.left).max() > self.balance.left_slack)
        return left and not slight_left(self.balance)

    @property
    def compensated(self) -> bool:
        """Whether some compensator has a mass."""
        return any(compensator.masses for compensator in self.balance.compensators)

    @property
    def shaken(self) -> bool:
        """Whether a force of the bank is left that can be seen."""
        left = bool(np.abs(self.balance.force).max() > self.balance.force_slack)
        return left and not slight_force(self.balance)

    @property
    def rocked(self) -> bool:
        """Whether a moment of the bank is left that can be seen."""
        left = bool(np.abs(self.balance.moment).max() > self.balance.moment_slack)
        return left and not slight_moment(self.balance)

    def crank_at(self, member: Member) -> complex:
        """Give the direction of the crank of a member at phi = 0 on the sheet."""
        return direction(member.crank) * self.turn

    def guide_at(self, member: Member) -> complex:
        """Give the direction of the guide of a member on the sheet."""
        return direction(member.axis) * self.turn

    def along(self, values: Complexes) -> Complexes:
        """Give what is followed over the turn as the shaft turns, whichever way round that is."""
        return values if self.balance.task.speed > 0 else values[::-1]

    def on_sheet(self, values: Complexes) -> Complexes:
        """Turn vectors as the sheet shows them, over the turn as the shaft turns."""
        return np.asarray(self.along(values) * self.turn)


NAME = "star"
MARGINS = Margins(5.0, 4.0, 4.0)  # paper around it for letters, in their sizes
LETTERS, MOST = 9.0, 23.4  # it is drawn at least so many letters large, and at most
PIN = 1.6  # mm, radius of a crank pin
TURN = (10.0, math.radians(12), math.radians(60))  # radius mm, start and sweep of the arrow of rotation


def _letters(shown: BankView, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Number the cranks outward, letter the guides where they differ, the shaft and its sense."""
    hand, centre = drafting.hand, place.on(0j)
    for way, names in together((shown.crank_at(member), member) for member in shown.members).items():
        spot, gap = place.on(way * shown.crank), PIN * hand.symbol + BESIDE
        yield labels.beside(spot, names, hand.letter, gap, cmath.phase(way))
    far = place.length(shown.crank) + AXIS * hand.symbol
    guides = together((shown.guide_at(member), member) for member in shown.members)
    for way, names in guides.items() if len(guides) > 1 else ():
        text = drafting.word("guide of", names=names)
        yield labels.beside(centre + far * way, text, hand.number, BESIDE, cmath.phase(way))
    yield labels.beside(centre, ORIGIN, hand.letter, BESIDE + HINGE * hand.symbol, -math.pi / 4)
    spot, _ = rotation(centre, shown.balance.task.speed, TURN, hand).middle
    yield labels.beside(spot, "ω", hand.letter, BESIDE, TURN[1])


def together(pairs: Iterator[tuple[complex, Member]]) -> dict[complex, str]:
    """Name the members of one direction together, in their order."""
    found: dict[complex, str] = {}
    for way, member in pairs:
        key = next((other for other in found if abs(other - way) < NEAR), way)
        found[key] = f"{found[key]}, {member.name}" if key in found else member.name
    return found


NEAR = 1e-9  # of a unit direction: an angle that was rounded once is still the same


def measure(shown: BankView, drafting: Drafting) -> Picture:
    """Measure the room that the star needs: a circle about the shaft."""
    hand = drafting.hand
    title = text_width(Text(0j, drafting.word("star of cranks"), hand.title))
    margins = around(MARGINS, hand, *(AXIS * hand.symbol,) * 3)
    found = picture(NAME, square(shown.crank), (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)
    return found._replace(most=MOST * hand.letter)


def draw(shown: BankView, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the star in its spot: the circle of the pins, the guides' axes, the cranks at phi = 0."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, drafting.word("star of cranks"), drafting.scale(spot.scale), hand)
    arrow = rotation(place.on(0j), shown.balance.task.speed, TURN, hand)
    lines = (title, *_axes(shown, place, hand), *arrow.draw(hand))
    ends = (shown.crank_at(member) * shown.crank for member in shown.members)
    cranks = [Line(place.on(0j), place.on(end), hand.result) for end in ends]
    pins = (_pin(shown, member, place, hand) for member in shown.members)
    (circle,) = hinge(place.on(0j), hand)
    shaft = origin(NAME, 0j, place, circle)
    return LetteredFigure(NAME, (*lines, *cranks, *pins, shaft), partial(_letters, shown, place, drafting))


def _axes(shown: BankView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the circle of the pins, and the axis of every guide from beyond the shaft outward."""
    radius = place.length(shown.crank)
    yield Circle(place.on(0j), radius, fit(hand.axis, math.tau * radius, True))
    far, centre = radius + AXIS * hand.symbol, place.on(0j)
    for way in together((shown.guide_at(member), member) for member in shown.members):
        yield Line(centre - AXIS * hand.symbol * way, centre + far * way, fit(hand.axis, far + AXIS * hand.symbol))


def _pin(shown: BankView, member: Member, place: Place, hand: Hand) -> Group:
    """Draw a crank pin, which can be measured."""
    centre = shown.crank_at(member) * shown.crank
    circle = Circle(place.on(centre), PIN * hand.symbol, hand.body)
    return point(Subject(NAME, QUANTITY, None), member.name, centre, place, circle)
