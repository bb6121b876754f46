"""The drawing that a cam is made by: contour with radii or ordinates, their table, notes (чертёж кулачка)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.cam.inversion import pushed
from drawings.cam.profile_view import SHOWN, SYMBOL, UNIT, ProfileView, curves, lettered, profile_view
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.lettering import text_width
from drawings.lettering.phrase import Slot, joined
from drawings.lettering.words import fixed
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.dashes import fit
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.symbols import pole, turning_arrow
from plans.cam.course import Course, settled
from plans.cam.profile.profile import profile
from plans.model.cam import DWELL, GROOVE, Cam, Phase
from plans.model.cam_motion import CamFound, Contour, Points
from plans.model.motion import Floats

PLAN, QUANTITY = "manufacturing", "l"
COUNT = 72  # tabled turns: every 5 degrees; of a cam that translates so many at most, and its end
RAY = 6  # tabled turns from one drawn radius to the next: 30 degrees
TRAVELS = 10  # from one drawn ordinate of a cam that translates to the next
MANTISSAS = (1.0, 2.0, 2.5, 5.0, 10.0)  # of the travel in mm from one to the next


def tabled(cam: Cam) -> Floats:
    """Give the turns of the cam that a sheet tells radii at, rad: every 5 degrees, or by a round length of travel."""
    if not cam.translates:
        return settled(np.linspace(0.0, cam.turn, COUNT + 1)[:-1], Course(cam))
    step = _step(cam.turn * 1000 / COUNT) / 1000
    return settled(np.append(np.arange(0.0, cam.turn - step / 2, step), cam.turn), Course(cam))


def _step(least: float) -> float:
    """Give the least round length that is not less than another, mm."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(one * power for one in MANTISSAS if one * power >= least * (1 - 1e-12))


class TabledProfile(NamedTuple):
    """The profile at the tabled turns, by either road: what is found of the cam, its contour there."""

    found: CamFound
    at: Contour

    @property
    def cam(self) -> Cam:
        """The cam that was asked for."""
        return self.found.cam

    @property
    def grooved(self) -> bool:
        """Whether a mill as broad as the groove makes it, so that the path of its centre is told."""
        return self.cam.closure == GROOVE and self.found.roller > 0

    @property
    def told(self) -> Points:
        """The tabled points, m, (N,): of the working profile, of a groove those of its middle."""
        return self.at.pitch if self.grooved else self.at.profile

    @property
    def zero(self) -> complex:
        """The unit direction of the zero ray: from O to the first tabled point."""
        first = complex(self.told[0])
        return first / abs(first)

    @property
    def radii(self) -> Floats:
        """Polar radii of the tabled points, m, (N,)."""
        return np.asarray(np.abs(self.told))

    @property
    def angles(self) -> Floats:
        """Polar angles of the tabled points from the zero ray, against the rotation, rad, (N,)."""
        return np.asarray(-self.cam.sense * np.unwrap(np.angle(self.told / self.zero)))

    @property
    def names(self) -> list[float]:
        """The tabled turns, degrees; of a cam that translates its travels, mm."""
        own = 1000 * self.at.turned if self.cam.translates else np.degrees(self.at.turned)
        return [float(one) for one in own.round(9)]

    def rays(self) -> Iterator[tuple[int, float]]:
        """Give the tabled turns whose radii are drawn, with their names."""
        every = TRAVELS if self.cam.translates else RAY
        yield from ((k, self.names[k]) for k in range(every, len(self.names), every))

    def dwells(self) -> Iterator[tuple[Phase, float]]:
        """Give the dwells with the radii of their arcs, m: of the profile, of a groove of its middle."""
        spots = self.found.contour.pitch if self.grooved else self.found.contour.profile
        for one in self.cam.phases:
            if one.kind == DWELL:
                yield one, float(abs(spots[int(np.argmin(abs(self.found.contour.turned - one.start)))]))


class Manufacture(NamedTuple):
    """A cam to be made: its view, and the profile at the tabled turns."""

    view: ProfileView
    table: TabledProfile

    @property
    def corners(self) -> list[complex]:
        """The corners of what is drawn to scale, m."""
        if self.view.cam.translates:
            left, right = self.view.body
            return [left, complex(right.real, float(self.view.curve.pitch.imag.max()))]
        return [complex(spot) for one in (*self.view.outlines, self.view.curve.pitch) for spot in one]


def manufacture(found: CamFound) -> Manufacture:
    """Give what the drawing of a cam to be made shows of one that the construction found."""
    at = profile(Course(found.cam), found.sizes, found.roller, tabled(found.cam)).contour
    return Manufacture(profile_view(found), TabledProfile(found, at))


MARGINS = Margins(5.0, 4.0, 4.0)  # paper around it for letters, in their sizes
LETTERS, LARGE = 20.0, 40.0  # it is drawn at least so many letters large; enlarged, at most so many
TRUE = 1000.0  # mm of paper to a metre: at its own size it is drawn where it can be
BESIDE = 1.0  # mm from a radius to its letter
PAST = 7.0  # mm that the zero ray and the axes go past the profile
OUT, SWEEP = 6.0, 22.0  # mm from the profile to the arrow of rotation, and its length
ROW = 0.5  # mm, radius of a tabled point
ORIGIN = "O"


@dataclass(frozen=True)
class ManufacturingFigure:
    """The profile placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: Manufacture
    place: Place
    lines: tuple[Stroke, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure: datum and radii lettered."""
        letters = (
            *self._datum(labels),
            *self._rays(labels),
            *lettered(self.shown.view, self.place, self.drafting, labels),
        )
        return (Group((*self.lines, Group(letters)), PLAN),)

    @cached_property
    def _rotation(self) -> tuple[complex, float]:
        return _arrow(self.shown, self.place, self.drafting.hand)

    def _datum(self, labels: Labels) -> Iterator[Stroke]:
        """Letter O, the zero ray, the sense of rotation."""
        hand, place = self.drafting.hand, self.place
        yield labels.beside(place.on(0j), ORIGIN, hand.letter, BESIDE, -math.pi / 4)
        if not self.shown.view.cam.translates:
            end = _end(self.shown, place, hand)
            text = self.drafting.word("zero ray")
            yield labels.beside(end, text, hand.number, BESIDE, cmath.phase(end - place.on(0j)))
            spot, turn = self._rotation
            yield labels.beside(spot, "ω", hand.letter, BESIDE, turn)
        else:
            yield labels.along(*_straight(self.shown, place, hand), "v", hand.letter, BESIDE, math.pi / 2)

    def _rays(self, labels: Labels) -> Iterator[Stroke]:
        """Letter each drawn radius with its turn, outside the profile."""
        hand = self.drafting.hand
        for k, name in self.shown.table.rays():
            spot = self.place.on(complex(self.shown.table.told[k]))
            towards = math.pi / 2 if self.shown.view.cam.translates else cmath.phase(spot - self.place.on(0j))
            yield labels.beside(spot, label(self.shown, name, self.drafting), hand.number, BESIDE, towards)


def label(shown: Manufacture, name: float, drafting: Drafting) -> str:
    """Write the turn of a drawn radius in degrees, or a travel in millimetres."""
    number = drafting.number(name, 5)
    return f"x {number}" if shown.view.cam.translates else f"φ {number}°"


def measure(shown: Manufacture, drafting: Drafting) -> Picture:
    """Measure the room that the profile needs: it is drawn at its own size, enlarged only where it is small."""
    hand = drafting.hand
    title = text_width(Text(0j, drafting.word("working profile"), hand.title))
    side, below, above = (share * hand.letter for share in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    room = picture(PLAN, shown.corners, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)
    natural = max(room.wide, room.high) * TRUE
    return room._replace(most=natural if natural >= room.least else LARGE * hand.letter)


def draw(shown: Manufacture, room: Picture, spot: Spot, drafting: Drafting) -> ManufacturingFigure:
    """Draw the profile in its spot: radii thin, the path of the roller's centre dash-dot, the profile in main lines."""
    place, hand, view = room.place(*spot), drafting.hand, shown.view
    lines = (
        heading(spot.box, drafting.word("working profile"), drafting.scale(spot.scale), hand),
        *_axes(shown, place, hand),
        *_sense(shown, place, hand),
        *_radii(shown, place, drafting),
        *curves(view, PLAN, place, hand),
        *_rows(shown, place, hand),
        point(Subject(PLAN, QUANTITY, None), ORIGIN, 0j, place, pole(place.on(0j)), "pole"),
    )
    return ManufacturingFigure(shown, place, lines, drafting)


def _end(shown: Manufacture, place: Place, hand: Hand) -> complex:
    """Give the end of the zero ray, mm."""
    out = max(place.length(abs(complex(one[0]))) for one in shown.view.outlines)
    return place.on(0j) + (out + PAST * hand.symbol) * shown.table.zero


def _axes(shown: Manufacture, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the axes of the shaft, and the zero ray; of a cam that translates the level of O."""
    if shown.view.cam.translates:
        left, right = (place.on(complex(one.real)) for one in shown.view.body)
        yield Line(left, right, fit(hand.axis, abs(right - left)))
        return
    zero, half = place.on(0j), PAST * hand.symbol
    end = _end(shown, place, hand)
    for start, stop in (
        (zero - shown.table.zero * half, end),
        (zero - 1j * shown.table.zero * half, zero + 1j * shown.table.zero * half),
    ):
        yield Line(start, stop, fit(hand.axis, abs(stop - start)))


def _arrow(shown: Manufacture, place: Place, hand: Hand) -> tuple[complex, float]:
    """Give the middle of the arrow of rotation, mm, and its direction from O: outside where the profile dwells."""
    view = shown.view
    middle = sum(view.step) / 2
    spot, _ = view.at(middle)
    outermost = max(float(np.interp(middle, view.curve.turned, abs(one))) for one in view.outlines)
    radius = place.length(max(outermost, abs(spot))) + OUT * hand.symbol
    turn = cmath.phase(spot)
    return place.on(0j) + cmath.rect(radius, turn), turn


def _straight(shown: Manufacture, place: Place, hand: Hand) -> tuple[complex, complex]:
    """Give the ends of the arrow of a cam that translates, within its body."""
    left, right = (place.on(one) for one in shown.view.body)
    middle, half = (
        (left + right) / 2 + 0.25j * place.length(shown.view.cam.lift),
        shown.view.cam.sense * PAST * hand.symbol,
    )
    return middle + half, middle - half


def _sense(shown: Manufacture, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the arrow of rotation, or that of a cam that translates in its body."""
    if shown.view.cam.translates:
        yield pushed(PLAN, _straight(shown, place, hand), hand)
    else:
        spot, turn = _arrow(shown, place, hand)
        radius = abs(spot - place.on(0j))
        sweep = shown.view.cam.sense * SWEEP * hand.symbol / radius
        arrow = turning_arrow(place.on(0j), radius, turn - sweep / 2, sweep, hand)
        yield stating(Statement(Kind.DIRECTION, PLAN, "ω"), *arrow)


def _radii(shown: Manufacture, place: Place, drafting: Drafting) -> Iterator[Group]:
    """Draw the radii at even turns, or ordinates from the level of O; each can be measured."""
    hand = drafting.hand
    for number, (k, name) in enumerate(shown.table.rays()):
        end = complex(shown.table.told[k])
        start = complex(end.real) if shown.view.cam.translates else 0j
        data = Subject(PLAN, QUANTITY, number).data("vector", "r", end - start, place.scale)
        yield Group((Line(place.on(start), place.on(end), hand.drafted),), "", data, label(shown, name, drafting))


def _rows(shown: Manufacture, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the points that the table tells."""
    yield from (Circle(place.on(complex(spot)), ROW * hand.symbol, INK) for spot in shown.table.told)


MM = 1000.0  # of a metre
DIGITS = 5


def notes(shown: TabledProfile, drafting: Drafting) -> Iterator[str]:
    """Say what a workshop must know beside the curve."""
    cam = shown.cam
    yield drafting.word(_moves(shown))
    curve = drafting.word("mill path" if shown.grooved else "profile told")
    yield drafting.word("plane datum" if cam.translates else "polar datum", curve=curve)
    if shown.found.roller:
        yield drafting.letter(_roller(shown, drafting))
    if not cam.translates:
        yield from _dwells(shown, drafting)
        yield drafting.word("bore of cam")
    yield drafting.word("drawn pieces", tolerance=drafting.number(MM * cam.tolerance))
    wrong = dict.fromkeys(one.kind for one in shown.found.flaws if one.kind in SHOWN)
    if wrong:
        yield drafting.word("profile flaws", flaws=", ".join(drafting.word(f"cam {kind}") for kind in wrong))


def _moves(shown: TabledProfile) -> str:
    """Name the sense in which the cam moves."""
    names = ("leftward cam", "rightward cam") if shown.cam.translates else ("counter-clockwise cam", "clockwise cam")
    return names[shown.cam.sense < 0]


def _roller(shown: TabledProfile, drafting: Drafting) -> str:
    radius = Slot(f"r_rol {shown.cam.name}", MM * shown.found.roller, DIGITS)
    if not shown.grooved:
        return drafting.phrase("roller of cam", radius=radius)
    breadth = Slot(f"breadth {shown.cam.name}", 2 * MM * shown.found.roller, DIGITS)
    return drafting.phrase("groove of cam", radius=radius, breadth=breadth)


def _dwells(shown: TabledProfile, drafting: Drafting) -> Iterator[str]:
    """Tell the radii of the arcs, and between which turns they are."""
    told = []
    for k, (one, radius) in enumerate(shown.dwells()):
        turns = (("r", MM * radius), ("start", math.degrees(one.start)), ("end", math.degrees(one.end)))
        size, *ends = (drafting.slot(Slot(f"{name} {k} {shown.cam.name}", value, DIGITS)) for name, value in turns)
        told.append(joined("", ("r = ", size, ", φ ", joined(" … ", ends), "°")))
    if told:
        yield drafting.phrase("dwells of cam", radii=joined(";  ", told))


NAME = "radii"
PLACES = 3  # of a millimetre and of a degree: finer than any machine divides
POLAR, PLANE = ("polar radius, mm", "polar angle, °"), ("abscissa, mm", "ordinate, mm")


def radii(shown: TabledProfile, every: int, drafting: Drafting) -> RuledTable:
    """Tell the profile, of a groove its middle, at every so many of the tabled turns."""
    lines = [_row(shown, k, drafting) for k in range(0, len(shown.names), every)]
    words = PLANE if shown.cam.translates else POLAR
    first = drafting.word("x of cam, mm" if shown.cam.translates else "φ of cam, °")
    return table(lines, first, tuple(drafting.word(key) for key in words), drafting.hand.text)._replace(name=NAME)


def _row(shown: TabledProfile, k: int, drafting: Drafting) -> TableRow:
    cells = (fixed(value, drafting.language, PLACES) for value in told(shown, k))
    return TableRow(drafting.number(shown.names[k], 5), tuple(cells))


def told(shown: TabledProfile, k: int) -> tuple[float, float]:
    """Give what a row tells: polar radius mm and angle in degrees, or the coordinates of a cam that translates, mm."""
    if shown.cam.translates:
        spot = MM * complex(shown.told[k])
        return spot.real, spot.imag
    return MM * float(shown.radii[k]), math.degrees(float(shown.angles[k]))
