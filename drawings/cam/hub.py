"""Bore and keyway of a cam on the drawing that it is made by, and what is said of them (отверстие и шпоночный паз)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.lettering.words import Slot, joined, telling
from drawings.page.page import Drafting
from drawings.paper.strokes import Arc, Circle, Kind, Line, Statement, Stroke
from drawings.paper.walk import stating
from drawings.symbols.figure import Dimension
from drawings.symbols.symbols import fit
from plans.cam.hub import keyed, wall
from plans.model.cam import MM, Hub
from plans.model.cam_motion import CamFound, Contour

OFF, FAR = 6.0, 12.0  # mm from bore and keyway to the lines of their dimensions: of what is small nearer
PAST = 5.0  # mm that the keyway's axis goes past it
BESIDE = 0.8  # mm from a dimension line to its letters
DIGITS = 5


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

    def dimensions(self, drafting: Drafting) -> Iterator[Dimension]:
        """Give the dimensions, in millimetres of the cam: bore, width of the keyway, bore with keyway."""
        hub, hand, key, zero = self.hub, drafting.hand, self.key, self.zero
        radius = self.place.length(hub.bore / 2)
        far = (radius + FAR * hand.symbol) * key

        def sized(letter: str, name: str, size: float, start: complex, end: complex, off: complex) -> Dimension:
            states = Statement(Kind.LENGTH, self.plan, name, scale=self.place.scale.mu)
            text = joined("", (letter, drafting.slot(Slot(name, MM * size, DIGITS))))
            return Dimension(text, start, end, off, states)

        yield sized("⌀", "bore", hub.bore, zero - 1j * radius * key, zero + 1j * radius * key, -far)
        if hub.width:
            _, first, last, _ = self.corners
            end = zero + (radius + self.place.length(hub.depth)) * key
            yield sized("b = ", "keyway", hub.width, first, last, OFF * hand.symbol * key)
            yield sized("d + t_2 = ", "over keyway", hub.bore + hub.depth, zero - radius * key, end, 1j * far)

    def lines(self, drafting: Drafting) -> Iterator[Stroke]:
        """Draw the bore, the keyway with its axis, and their dimensions."""
        hand = drafting.hand
        if not self.hub.width:
            yield Circle(self.zero, self.place.length(self.hub.bore / 2), hand.result)
        else:
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
        for dimension in self.dimensions(drafting):
            yield from dimension.draw(hand)

    def letters(self, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
        """Write the sizes beside their dimension lines."""
        for size in self.dimensions(drafting):
            away, number = cmath.phase(size.off), drafting.hand.number
            yield telling(self.plan, labels.beside(size.middle, size.letter, number, BESIDE, away))


def bore(plan: str, found: CamFound, at: Contour, place: Place) -> KeyedBore | None:
    """Give the bore of a cam that has one, the first of the contour's points being on the zero ray."""
    hub = found.cam.hub
    return KeyedBore(plan, hub, keyed(found, at), place) if hub is not None else None


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
