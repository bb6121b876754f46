"""The drawing that a cam is made by: contour with radii or ordinates, their table, notes (чертёж кулачка)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.cam.hub import KeyedBore, keyway_place
from drawings.cam.hub import notes as hub_notes
from drawings.cam.inversion import pushed
from drawings.cam.profile_view import SHOWN, SYMBOL, UNIT, ProfileView, curves, lettered, profile_view
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.lettering import text_width
from drawings.lettering.words import Slot, fixed, joined
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Kind, Line, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.figure import Subject, around, heading, point
from drawings.symbols.symbols import TurnArrow, fit, pole
from plans.cam.course import FollowerCourse, WorkshopTurns, stations
from plans.cam.hub import keyed
from plans.cam.profile.profile import profile
from plans.model.cam import DWELL, MM, Cam, Phase
from plans.model.cam_motion import CamFound, Points
from plans.model.motion import Floats

PLAN, QUANTITY = "manufacturing", "l"


class Manufacture(NamedTuple):
    """A cam to be made: its view, and the points of the profile at the tabled turns, m, (N,)."""

    view: ProfileView
    stations: WorkshopTurns
    spots: Points

    @property
    def cam(self) -> Cam:
        """The cam that was asked for."""
        return self.view.cam

    @property
    def corners(self) -> list[complex]:
        """The corners of what is drawn to scale, m."""
        spots = [complex(spot) for curve in (*self.view.outlines, self.view.curve.pitch) for spot in curve]
        return [*(self.view.body if self.cam.translates else ()), *spots]


def manufacture(found: CamFound) -> Manufacture:
    """Give what the drawing of a cam to be made shows of one that the construction found."""
    turns = stations(found.cam)
    at = profile(FollowerCourse(found.cam), found.sizes, found.roller, turns.turned).contour
    return Manufacture(profile_view(found), turns, found.made(at))


def zero(shown: Manufacture) -> complex:
    """Give the unit direction of the zero ray: from O to the first told point."""
    first = complex(shown.spots[0])
    return first / abs(first)


def angles(shown: Manufacture) -> Floats:
    """Give the polar angles of the told points from the zero ray, against the rotation, rad, (N,)."""
    return np.asarray(-shown.cam.sense * np.unwrap(np.angle(shown.spots / zero(shown))))


def dwells(shown: Manufacture) -> Iterator[tuple[Phase, float]]:
    """Give the dwells with the radii of their arcs, m: of the profile, of a groove of its middle."""
    contour = shown.view.found.contour
    spots = shown.view.found.made(contour)
    for phase in shown.cam.phases:
        if phase.kind == DWELL:
            yield phase, float(abs(spots[int(np.argmin(abs(contour.turned - phase.start)))]))


MARGINS = Margins(5.0, 4.0, 4.0)  # paper around it for letters, in their sizes
LETTERS, LARGE = 20.0, 40.0  # it is drawn at least so many letters large; of a smaller cam at most so many
TRUE, LARGER = 1000.0, 2.5  # mm of paper to a metre: at its own size it is drawn where it can be, and where paper
# is left beside that so many times as large
BESIDE = 1.0  # mm from a radius to its letter
PAST = 7.0  # mm that the zero ray and the axes go past the profile
OUT, SWEEP = 6.0, 22.0  # mm from the profile to the arrow of rotation, and its length
ROW = 0.5  # mm, radius of a tabled point
ORIGIN = "O"


def label(shown: Manufacture, name: float, drafting: Drafting) -> str:
    """Write the turn of a drawn radius in degrees, or a travel in millimetres."""
    number = drafting.number(name, 5)
    return f"x {number}" if shown.cam.translates else f"φ {number}°"


def measure(shown: Manufacture, drafting: Drafting) -> Picture:
    """Measure the room that the profile needs: it is drawn at its own size, enlarged where it is small or has room."""
    hand = drafting.hand
    title = text_width(Text(0j, drafting.word("working profile"), hand.title))
    room = picture(PLAN, shown.corners, (SYMBOL, UNIT), around(MARGINS, hand), title, LETTERS * hand.letter)
    natural = max(room.wide, room.high) * TRUE
    return room._replace(most=LARGER * natural if natural >= room.least else LARGE * hand.letter)


def draw(shown: Manufacture, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the profile in its spot: radii thin, the path of the roller's centre dash-dot, the profile in main lines."""
    place, hand, view = room.place(*spot), drafting.hand, shown.view
    lines = (
        heading(spot.box, drafting.word("working profile"), drafting.scale(spot.scale), hand),
        *_axes(shown, place, hand),
        *_sense(shown, place, hand),
        *_radii(shown, place, drafting),
        *curves(view, PLAN, place, hand),
        *(Circle(place.on(complex(spot)), ROW * hand.symbol, INK) for spot in shown.spots),
        *(KeyedBore(PLAN, hub, keyed(view.found, view.curve), place).lines(hand) if (hub := shown.cam.hub) else ()),
        point(Subject(PLAN, QUANTITY, None), ORIGIN, 0j, place, pole(place.on(0j)), "pole"),
    )
    return LetteredFigure(PLAN, lines, partial(_letters, shown, place, drafting))


def _letters(shown: Manufacture, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Letter O, the sense of motion, the zero ray, each drawn radius with its turn outside the profile."""
    hand, zero, translates = drafting.hand, place.on(0j), shown.cam.translates
    yield labels.beside(zero, ORIGIN, hand.letter, BESIDE, -math.pi / 4)
    if translates:
        yield labels.along(*_straight(shown, place, hand), "v", hand.letter, BESIDE, math.pi / 2)
    else:
        end, (spot, turn) = _end(shown, place, hand), _arrow(shown, place, hand)
        yield labels.beside(end, drafting.word("zero ray"), hand.number, BESIDE, cmath.phase(end - zero))
        yield labels.beside(spot, "ω", hand.letter, BESIDE, turn)
    for k, name in shown.stations.rays():
        spot = place.on(complex(shown.spots[k]))
        towards = math.pi / 2 if translates else cmath.phase(spot - zero)
        yield labels.beside(spot, label(shown, name, drafting), hand.number, BESIDE, towards)
    yield from lettered(shown.view, place, drafting, labels)


def _end(shown: Manufacture, place: Place, hand: Hand) -> complex:
    """Give the end of the zero ray, mm."""
    out = max(place.length(abs(complex(outline[0]))) for outline in shown.view.outlines)
    return place.on(0j) + (out + PAST * hand.symbol) * zero(shown)


def _axes(shown: Manufacture, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the axes of the shaft, and the zero ray; of a cam that translates the level of O."""
    if shown.cam.translates:
        left, right = (place.on(complex(corner.real)) for corner in shown.view.body)
        yield Line(left, right, fit(hand.axis, abs(right - left)))
        return
    centre, end = place.on(0j), _end(shown, place, hand)
    past = place.length(shown.cam.hub.bore / 2) if shown.cam.hub else 0.0
    along = zero(shown) * (past + PAST * hand.symbol)
    for start, stop in ((centre - along, end), (centre - 1j * along, centre + 1j * along)):
        yield Line(start, stop, fit(hand.axis, abs(stop - start)))


def _arrow(shown: Manufacture, place: Place, hand: Hand) -> tuple[complex, float]:
    """Give the middle of the arrow of rotation, mm, and its direction from O: outside where the profile dwells."""
    view = shown.view
    middle = sum(view.step) / 2
    spot, _ = view.at(middle)
    outermost = max(float(np.interp(middle, view.curve.turned, abs(outline))) for outline in view.outlines)
    radius = place.length(max(outermost, abs(spot))) + OUT * hand.symbol
    turn = cmath.phase(spot)
    return place.on(0j) + cmath.rect(radius, turn), turn


def _straight(shown: Manufacture, place: Place, hand: Hand) -> tuple[complex, complex]:
    """Give the ends of the arrow of a cam that translates, within its body."""
    left, right = (place.on(corner) for corner in shown.view.body)
    middle = (left + right) / 2 + 0.25j * place.length(shown.cam.lift)
    half = shown.cam.sense * PAST * hand.symbol
    return middle + half, middle - half


def _sense(shown: Manufacture, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the arrow of rotation, or that of a cam that translates in its body."""
    if shown.cam.translates:
        yield pushed(PLAN, _straight(shown, place, hand), hand)
    else:
        spot, turn = _arrow(shown, place, hand)
        radius = abs(spot - place.on(0j))
        sweep = shown.cam.sense * SWEEP * hand.symbol / radius
        arrow = TurnArrow(place.on(0j), radius, turn - sweep / 2, sweep).draw(hand)
        yield stating(Statement(Kind.DIRECTION, PLAN, "ω"), *arrow)


def _radii(shown: Manufacture, place: Place, drafting: Drafting) -> Iterator[Group]:
    """Draw the radii at even turns, or ordinates from the level of O; each can be measured."""
    hand = drafting.hand
    for number, (k, name) in enumerate(shown.stations.rays()):
        end = complex(shown.spots[k])
        start = complex(end.real) if shown.cam.translates else 0j
        data = Subject(PLAN, QUANTITY, number).data("vector", "r", end - start, place.scale)
        yield Group((Line(place.on(start), place.on(end), hand.drafted),), "", data, label(shown, name, drafting))


DIGITS = 5


def notes(shown: Manufacture, drafting: Drafting) -> Iterator[str]:
    """Say what a workshop must know beside the curve."""
    cam = shown.cam
    names = ("leftward cam", "rightward cam") if shown.cam.translates else ("counter-clockwise cam", "clockwise cam")
    yield drafting.word(names[shown.cam.sense < 0])
    curve = drafting.word("mill path" if shown.view.found.grooved else "profile told")
    if cam.translates:
        yield drafting.word("plane datum", curve=curve)
    else:
        yield drafting.phrase("polar datum", curve=curve, keyway=keyway_place(cam.hub, drafting, cam.name))
    if cam.setting:
        yield drafting.phrase("cam setting", angle=Slot(f"setting {cam.name}", math.degrees(cam.setting), DIGITS))
    if shown.view.found.roller:
        yield drafting.letter(_roller(shown, drafting))
    if not cam.translates:
        yield from _dwells(shown, drafting)
        yield from hub_notes(shown.view.found, drafting)
    yield drafting.word("drawn pieces", tolerance=drafting.number(MM * cam.tolerance))
    wrong = dict.fromkeys(flaw.kind for flaw in shown.view.found.flaws if flaw.kind in SHOWN)
    if wrong:
        yield drafting.word("profile flaws", flaws=", ".join(drafting.word(f"cam {kind}") for kind in wrong))


def _roller(shown: Manufacture, drafting: Drafting) -> str:
    radius = Slot(f"r_rol {shown.cam.name}", MM * shown.view.found.roller, DIGITS)
    if not shown.view.found.grooved:
        return drafting.phrase("roller of cam", radius=radius)
    breadth = Slot(f"breadth {shown.cam.name}", 2 * MM * shown.view.found.roller, DIGITS)
    return drafting.phrase("groove of cam", radius=radius, breadth=breadth)


def _dwells(shown: Manufacture, drafting: Drafting) -> Iterator[str]:
    """Tell the radii of the arcs, and between which turns they are."""
    arcs = []
    for k, (phase, radius) in enumerate(dwells(shown)):
        turns = (("r", MM * radius), ("start", math.degrees(phase.start)), ("end", math.degrees(phase.end)))
        size, *ends = (drafting.slot(Slot(f"{name} {k} {shown.cam.name}", value, DIGITS)) for name, value in turns)
        arcs.append(joined("", ("r = ", size, ", φ ", joined(" … ", ends), "°")))
    if arcs:
        yield drafting.phrase("dwells of cam", radii=joined(";  ", arcs))


NAME = "radii"
PLACES = 3  # of a millimetre and of a degree: finer than any machine divides
POLAR, PLANE = ("polar radius, mm", "polar angle, °"), ("abscissa, mm", "ordinate, mm")


def radii(shown: Manufacture, every: int, drafting: Drafting) -> RuledTable:
    """Tell the profile, of a groove its middle, at every so many of the tabled turns."""
    names, spots = shown.stations.names, cells(shown)
    sizes = [tuple(fixed(size, drafting.language, PLACES) for size in spot) for spot in spots]
    lines = [TableRow(drafting.number(names[k], 5), sizes[k]) for k in range(0, len(names), every)]
    words = PLANE if shown.cam.translates else POLAR
    first = drafting.word("x of cam, mm" if shown.cam.translates else "φ of cam, °")
    return table(lines, first, tuple(drafting.word(key) for key in words), drafting.hand.text)._replace(name=NAME)


def cells(shown: Manufacture) -> list[tuple[float, float]]:
    """Give what the rows tell: polar radii mm and angles in degrees, or coordinates of a cam that translates, mm."""
    if shown.cam.translates:
        return [(spot.real, spot.imag) for spot in (MM * shown.spots).tolist()]
    return [*zip((MM * np.abs(shown.spots)).tolist(), np.degrees(angles(shown)).tolist(), strict=True)]
