"""Bore and keyway of a cam on the drawing that it is made by, and what is said of them (отверстие и шпоночный паз)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.words import Slot, joined, telling
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Circle, Kind, Line, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.figure import Dimension, Subject, around, heading, heading_width, point
from drawings.symbols.symbols import fit, pole
from plans.cam.hub import wall
from plans.model.cam import MM, Hub
from plans.model.cam_motion import CamFound

NAME, QUANTITY, SYMBOL, UNIT = "hub", "l", "l", "m"  # the view of the bore by itself
MARGINS = Margins(1.0, 1.0, 1.0)  # paper around it in sizes of its letters, beyond its dimensions
LETTERS, LARGE = 8.0, 12.0  # it is drawn at least so many letters large, and at most
OFF = 7.0  # mm from bore and keyway to the lines of their dimensions
PAST = 5.0  # mm that the keyway's axis goes past it, and the axes past the bore
BESIDE = 0.8  # mm from a dimension line to its letters
DIGITS, ORIGIN = 5, "O"


class KeyedBore(NamedTuple):
    """A bore with its keyway as a figure shows it: the figure's name, the hub, its keyway's unit direction from O."""

    plan: str
    hub: Hub
    key: complex
    place: Place

    @property
    def zero(self) -> complex:
        """The place of O, mm."""
        return self.place.on(0j)

    @property
    def corners(self) -> tuple[complex, ...]:
        """Where the keyway's sides leave the bore, and its corners between them, mm."""
        hub, half = self.hub, self.hub.width / 2
        foot, end = math.sqrt((hub.bore / 2) ** 2 - half**2), hub.bore / 2 + hub.depth
        local = complex(foot, -half), complex(end, -half), complex(end, half), complex(foot, half)
        return tuple(self.place.on(spot * self.key) for spot in local)

    def lines(self, hand: Hand) -> Iterator[Stroke]:
        """Draw the bore, and the keyway with its axis."""
        if not self.hub.width:
            yield Circle(self.zero, self.place.length(self.hub.bore / 2), hand.result)
            return
        start, first, last, end = self.corners
        turn, half = cmath.phase(self.key), math.asin(self.hub.width / self.hub.bore)
        yield Arc(self.zero, abs(start - self.zero), turn + half, turn + 2 * math.pi - half, hand.result)
        # each side tells by its corner where the keyway is
        for side, (corner, foot) in enumerate(((first, start), (last, end))):
            states = Statement(Kind.POINT, self.plan, f"keyway {side}")
            yield stating(states, Line(corner, foot, hand.result))
        yield Line(first, last, hand.result)
        axis = (first + last) / 2 + PAST * hand.symbol * self.key
        yield Line(self.zero, axis, fit(hand.axis, abs(axis - self.zero)))

    def dimensions(self, drafting: Drafting) -> Iterator[Dimension]:
        """Give the dimensions, in millimetres of the cam: bore, width of the keyway, bore with keyway."""
        hub, key, zero = self.hub, self.key, self.zero
        radius, off = self.place.length(hub.bore / 2), OFF * drafting.hand.symbol

        def sized(letter: str, name: str, size: float, start: complex, end: complex, away: complex) -> Dimension:
            states = Statement(Kind.LENGTH, self.plan, name, scale=self.place.scale.mu)
            text = joined("", (letter, drafting.slot(Slot(name, MM * size, DIGITS))))
            return Dimension(text, start, end, away, states)

        yield sized("⌀", "bore", hub.bore, zero - 1j * radius * key, zero + 1j * radius * key, -(radius + off) * key)
        if hub.width:
            _, first, last, _ = self.corners
            end = zero + (radius + self.place.length(hub.depth)) * key
            yield sized("b = ", "keyway", hub.width, first, last, off * key)
            low, away = zero - radius * key, 1j * (radius + off) * key
            yield sized("d + t_2 = ", "over keyway", hub.bore + hub.depth, low, end, away)


def measure(shown: Hub, drafting: Drafting) -> Picture:
    """Measure the room that the view of a bore needs, its keyway upwards."""
    hand, radius = drafting.hand, shown.bore / 2
    corners = [complex(x, y) for x in (-radius, radius) for y in (-radius, radius + shown.depth)]
    beside = text_width(Text(0j, f"d + t_2 = {drafting.number(MM * (shown.bore + shown.depth), DIGITS)}", hand.number))
    off = OFF * hand.symbol + BESIDE
    margins = around(MARGINS, hand, off + beside, off + hand.number, off + hand.number)
    title = heading_width(drafting.word("bore of the hub"), hand)
    room = picture(NAME, corners, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)
    return room._replace(most=LARGE * hand.letter)


def draw(shown: Hub, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw a bore by itself in its spot, its axes and its dimensions; what they say of the cam is no part of them."""
    view, hand = KeyedBore(NAME, shown, 1j, room.place(*spot)), drafting.hand
    reach = view.place.length(shown.bore / 2) + PAST * hand.symbol
    axes = (Line(view.zero - reach * way, view.zero + reach * way, fit(hand.axis, 2 * reach)) for way in (1, 1j))
    title = heading(spot.box, drafting.word("bore of the hub"), drafting.scale(spot.scale), hand)
    sizes = [*view.dimensions(drafting)]
    drawn = (stroke for size in sizes for stroke in size.draw(hand))

    def letters(labels: Labels) -> Iterator[Stroke]:
        yield labels.beside(view.zero, ORIGIN, hand.letter, BESIDE, -math.pi / 4)
        for size in sizes:
            beside = labels.beside(size.middle, size.letter, hand.number, BESIDE, cmath.phase(size.off))
            yield telling(NAME, beside)

    origin = point(Subject(NAME, QUANTITY, None), ORIGIN, 0j, view.place, pole(view.zero), "pole")
    return LetteredFigure(NAME, (title, *axes, *view.lines(hand), *drawn, origin), letters)


def notes(found: CamFound, drafting: Drafting) -> Iterator[str]:
    """Say how the cam sits on its shaft, and what is left of it to its profile."""
    hub = found.cam.hub
    if hub is None:
        yield drafting.word("bore of cam")
        return

    def slot(name: str, size: float, unit: float = MM) -> Slot:
        return Slot(f"{name} {found.cam.name}", unit * size, DIGITS)

    sizes = {"bore": slot("bore", hub.bore), "wall": slot("wall", wall(found))}
    if hub.width:
        sizes |= {"width": slot("keyway", hub.width), "depth": slot("keyway depth", hub.depth)}
    kind = "standard keyway" if hub.standard else "keyway" if hub.width else "no keyway"
    yield drafting.phrase(f"cam {kind}", **sizes)
    if hub.length is not None:
        yield drafting.phrase("cam hub length", length=slot("hub length", hub.length))


def keyway_place(hub: Hub | None, drafting: Drafting, name: str) -> str:
    """Say where the keyway's axis lies beside the zero ray; nothing of a bore without a keyway."""
    if hub is None or (hub.width and not hub.angle):
        return drafting.word("keyway at zero")
    angle = Slot(f"keyway angle {name}", math.degrees(hub.angle), DIGITS)
    return drafting.phrase("keyway at", angle=angle) if hub.width else ""
