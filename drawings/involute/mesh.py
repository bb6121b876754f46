"""Three pairs of teeth in mesh: base circles and their tangent, flanks unrolled, the active part (зацепление)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from drawings.involute.due import DIGITS, MILLIMETRES
from drawings.kinds.axes import arrow
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.words import Slot, joined, telling, with_index
from drawings.page.page import Drafting
from drawings.paper.strokes import INK, Circle, Group, Kind, Line, LineStyle, Polyline, Statement, Stroke
from drawings.paper.walk import stating
from drawings.symbols.figure import Dimension, Subject, around, heading, heading_width, point
from drawings.symbols.symbols import TurnArrow, fit_dashes, rotation
from plans.involute.flanks import Flanks
from plans.involute.study import InvoluteStudy
from plans.model.motion import Complexes
from plans.model.teeth import PlacedWheel, placed

NAME, SYMBOL, UNIT = "mesh", "l", "m"
MARGINS = Margins(4.5, 2.0, 2.0)
LETTERS = 34.0  # it is drawn at least so many letters high
DOT, BESIDE = 0.9, 1.2  # mm: radius of a point, from it to its letter
STRIP, PAST = 1.6, 6.0  # mm: width of the strip along an active flank; how far lines go on beyond their ends
TICKS = 24  # across a strip
STUB = 1.2  # modules: what is shown of a radius whose centre is far
SQUARE = 3.0  # mm: side of the mark of a right angle
ANGLE, TURN = 30.0, (12.0, math.radians(40), math.radians(100))  # mm: radius of the angle's arc; arrow of a rotation
COMMON = 34.0  # mm of the common tangent to either side of P
OFF, RUN, WAY = 4.0, (3.0, 15.0), 9.0  # mm: off a root circle, along it, the arrow of a rotation; to a far centre
LEFT = 20.0  # mm: the dimension of a_w from all of a pair, from the centre of an internal one


class ShownMesh(NamedTuple):
    """A mesh to be drawn, in true places about P, m."""

    points: Mapping[str, complex]
    wheels: tuple[PlacedWheel, PlacedWheel]
    teeth: Mapping[str, Complexes]
    circles: Mapping[str, Complexes]
    strings: Mapping[str, tuple[complex, complex]]  # of the flanks unrolled, by the number at the base circle
    active: tuple[tuple[Complexes, Complexes], ...]  # the parts of the flanks in P that touch, with the ways inwards
    angle: float

    @property
    def known(self) -> list[complex]:
        """All places that the figure must hold."""
        curves = (complex(spot) for curve in (*self.teeth.values(), *self.circles.values()) for spot in curve[::6])
        ends = (complex(curve[k]) for curve in self.circles.values() for k in (0, -1))
        return [*curves, *ends, *self.points.values(), *map(self.inner, self.wheels)]

    def inner(self, one: PlacedWheel) -> complex:
        """Give where the radius to the line of action begins: at the centre, or near its end if that is far."""
        end = self.points[f"N_{one.wheel.number}"]
        inwards = one.centre - end
        return one.centre if one.shown else end + inwards / abs(inwards) * STUB * one.wheel.rack.module


def shown(study: InvoluteStudy) -> ShownMesh:
    """Give what is drawn of a pair."""
    action, wheels = study.action, placed(study.pair, study.sizes)
    marks = {mark.name: complex(mark.point) for mark in (*action.ends, action.pole, *action.active)}
    marks |= {f"O_{one.wheel.number}": complex(centre.point)
              for one, centre in zip(wheels, action.centres, strict=True) if one.shown}  # fmt: skip
    marks[action.pole.name] = 0j  # the origin: what the meeting leaves is rounding
    teeth, circles, strings = dict[str, Complexes](), dict[str, Complexes](), dict[str, tuple[complex, complex]]()
    for one, flanks in zip(wheels, study.flanks, strict=True):
        n = one.wheel.number
        unrolled = flanks.points if one.unrolled else ()
        pairs = [(complex(point.leaves.point), complex(point.end.point)) for point in unrolled]
        strings |= {f"{n}.{k}": pair for k, pair in enumerate(pairs, 1)}
        last = pairs[-1][0] if pairs else marks[f"N_{n}"]
        circles |= one.circles(cmath.phase((last - one.centre) / one.up))
        teeth[f"teeth {n}"] = one.teeth(study.profile(flanks))
    active = tuple(map(touching, study.flanks, action.feet, action.strings))
    return ShownMesh(marks, wheels, teeth, circles, strings, active, action.angle)


def touching(flanks: Flanks, foot: float, long: float) -> tuple[Complexes, Complexes]:
    """Give the part of the flank in P that touches, by how long the string is at its ends; and the ways inwards."""
    start, centre = complex(flanks.start.point), complex(flanks.centre.point)
    slopes = np.linspace(foot, long, TICKS + 1) / abs(start)
    arms = start * np.exp(1j * slopes)
    return np.asarray(centre + arms * (1 - 1j * slopes)), np.asarray(1j * flanks.wheel.inward * arms / abs(start))


def measure(mesh: ShownMesh, drafting: Drafting) -> Picture:
    """Measure the room that a mesh needs."""
    hand, outer = drafting.hand, not mesh.wheels[1].wheel.internal
    title, more = heading_width(drafting.word("involute mesh"), hand), outer * (LEFT * hand.symbol + hand.letter)
    margins = around(MARGINS, hand, outer * LEFT / 3 * hand.symbol, 0.0 if mesh.wheels[0].shown else more, more)
    return picture(NAME, mesh.known, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)


def draw(mesh: ShownMesh, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw a mesh in its spot."""
    drawing = _DrawnMesh(mesh, room.place(*spot), drafting)
    head = heading(spot.box, drafting.word("involute mesh"), drafting.scale(spot.scale), drafting.hand)
    return LetteredFigure(NAME, (head, *drawing.lines()), drawing.letters)


def drawn(figure: str, name: str, curve: Complexes, place: Place, style: LineStyle) -> Group:
    """Draw a curve of true places as a chain, and say what it is."""
    chain = Polyline(tuple(map(place.on, curve.tolist())), False, style)
    return stating(Statement(Kind.CURVE, figure, name), *fit_dashes([chain]))


class _DrawnMesh:
    """A mesh at its place on paper."""

    def __init__(self, mesh: ShownMesh, place: Place, drafting: Drafting) -> None:
        self.mesh, self.place, self.hand, self.drafting = mesh, place, drafting.hand, drafting
        self.spots = {name: place.on(spot) for name, spot in mesh.points.items()}
        self.way, self.inner = cmath.exp(1j * mesh.angle), mesh.wheels[1].wheel.internal

    def lines(self) -> Iterator[Stroke]:
        """Draw circles, strings, teeth, the line of action, the points."""
        yield from self._circles()
        for start, end in self.mesh.strings.values():
            yield Line(self.place.on(start), self.place.on(end), self.hand.drafted)
        for name, curve in self.mesh.teeth.items():
            yield drawn(NAME, name, curve, self.place, self.hand.result)
        yield from self._strips()
        yield from self._action()
        yield from self._rotations()
        yield from self._points()

    def _circles(self) -> Iterator[Stroke]:
        styles = {"d_a": self.hand.other, "d_f": self.hand.drafted, "d_b": self.hand.other, "d_w": self.hand.axis}
        for name, curve in self.mesh.circles.items():
            yield drawn(NAME, name, curve, self.place, styles.get(name[:3], self.hand.axis))

    def _strips(self) -> Iterator[Stroke]:
        """Hatch a strip along the active parts of the flanks that touch in P."""
        for curve, ways in self.mesh.active:
            spots = [self.place.on(spot) for spot in curve.tolist()]
            inner = [spot + STRIP * self.hand.symbol * way for spot, way in zip(spots, ways.tolist(), strict=True)]
            yield Polyline(tuple(inner), False, self.hand.drafted)
            yield from (Line(spot, end, self.hand.drafted) for spot, end in zip(spots, inner, strict=True))

    def _action(self) -> Iterator[Stroke]:
        """Draw the line of centres, the radii of touch, the line of action with its active part, and its angle."""
        spots, hand, past = self.spots, self.hand, PAST * self.hand.symbol
        low, high = self._upright
        yield from fit_dashes([Line(low - 1j * past, high + 1j * past, hand.axis)])
        yield from (*self._radii(), *self._apart())
        ends = [spots[name] for name in ("N_1", "N_2", "B_1", "B_2")]
        ends.sort(key=lambda spot: (spot * self.way.conjugate()).real)
        yield Line(ends[0] - past * self.way, ends[-1] + past * self.way, hand.other)
        yield Line(spots["B_1"], spots["B_2"], hand.result)
        pole, long = spots["P"], COMMON * hand.symbol
        yield Line(pole - long, pole + long, hand.drafted)
        arrow = TurnArrow(pole, ANGLE * hand.symbol, 0.0, self.mesh.angle)
        yield stating(Statement(Kind.ANGLE, NAME, "α_w"), *arrow.angle(hand))

    def _radii(self) -> Iterator[Stroke]:
        """Draw the radii to where the line of action touches the base circles, square to it."""
        hand, pole = self.hand, self.spots["P"]
        for one in self.mesh.wheels:
            end = self.spots[f"N_{one.wheel.number}"]
            inwards, towards = self.place.on(one.centre) - end, pole - end
            side, along = (SQUARE * hand.symbol * way / abs(way) for way in (inwards, towards))
            begin = self.place.on(self.mesh.inner(one))
            yield from (Line(begin, end, hand.drafted),) if one.shown else arrow(end, begin, hand)
            yield Polyline((end + side, end + side + along, end + along), False, hand.drafted)

    @property
    def _upright(self) -> tuple[complex, complex]:
        """Where the line of centres begins and ends: at centres, or where the teeth do."""
        heights = [spot.imag for name, spot in self.spots.items() if name[0] == "O"]
        heights += [self.place.on(complex(curve[len(curve) // 2])).imag for curve in self.mesh.circles.values()]
        across = self.spots["P"].real
        return complex(across, min(heights)), complex(across, max(heights))

    @property
    def _beyond(self) -> dict[str, complex]:
        """Where arrows along the line of centres end that point to centres which are not shown."""
        (low, high), long = self._upright, 1j * ((0 if self.inner else PAST) + WAY) * self.hand.symbol
        far = (one for one in self.mesh.wheels if not one.shown)
        return {f"O_{one.wheel.number}": high + long if one.centre.imag > 0 else low - long for one in far}

    def _apart(self) -> Iterator[Stroke]:
        """Draw the arrows to far centres, and dimension the distance of the axes: broken off where one is far."""
        low, high = self._upright
        for end in self._beyond.values():
            yield from arrow(low if end.imag < low.imag else high, end, self.hand)
        if (size := self._distance) and not self._beyond:
            yield from size.draw(self.hand)
        elif size:
            far, (start, end) = "O_1" in self._beyond, size.lines[0]
            yield from arrow(*((start, end) if far else (end, start)), self.hand)
            yield Line(*size.lines[1 + far], self.hand.drafted)

    @property
    def _distance(self) -> Dimension | None:
        """The distance of the axes, left of the teeth; none where neither of them is shown."""
        first, second = (one.centre for one in self.mesh.wheels)
        start, end = ((self.spots | self._beyond)[name] for name in ("O_1", "O_2"))
        left = start.real if self.inner else min(self.place.on(spot).real for spot in self.mesh.known)
        told = self.drafting.slot(Slot("a_w", round(1e3 * abs(second - first), MILLIMETRES), DIGITS))
        states = None if self._beyond else Statement(Kind.LENGTH, NAME, "a_w", scale=self.place.scale.mu)
        off = complex(left - LEFT * self.hand.symbol - start.real)
        return Dimension(joined("", ("a_{w} = ", told)), start, end, off, states) if len(self._beyond) < 2 else None

    def _rotations(self) -> Iterator[Stroke]:
        """Draw how the wheels turn: wheel 1 clockwise."""
        for one in self.mesh.wheels:
            turns = self._turn(one).draw(self.hand)
            yield stating(Statement(Kind.DIRECTION, NAME, f"ω_{one.wheel.number}"), *turns)

    def _turn(self, one: PlacedWheel) -> TurnArrow:
        sense = -1.0 if one.up == 1j else 1.0
        if one.shown:
            return rotation(self.spots[f"O_{one.wheel.number}"], sense, TURN, self.hand)
        radius = self.place.length(one.sizes.root) - one.wheel.inward * OFF * self.hand.symbol
        start, end = (sense * run * self.hand.symbol / radius for run in RUN)
        return TurnArrow(self.place.on(one.centre), radius, cmath.phase(one.up) + start, end - start)

    def _points(self) -> Iterator[Stroke]:
        subject = Subject(NAME, SYMBOL, None)
        for name, spot in self.spots.items():
            circle = Circle(spot, DOT * self.hand.symbol, INK)
            yield point(subject, name, self.mesh.points[name], self.place, circle, "pole" if name == "P" else "point")

    def letters(self, labels: Labels) -> Iterator[Stroke]:
        """Letter the points, the angle, the circles at their ends, the numbers of the strings."""
        hand, away = self.hand, cmath.phase(-1j * self.way)
        sides = {"P": away - 0.3, "N_1": away + math.pi, "N_2": away, "B_1": away, "B_2": away + math.pi}
        sides |= {"O_1": 0.0} if self._beyond else {}
        for name, spot in self.spots.items():
            yield labels.beside(spot, with_index(name), hand.letter, BESIDE, sides.get(name, math.pi))
        middle = self.spots["P"] + ANGLE * hand.symbol * cmath.exp(0.5j * self.mesh.angle)
        yield labels.beside(middle, with_index("α_w"), hand.letter, BESIDE, 0.0)
        for one in self.mesh.wheels:
            spot, turned = self._turn(one).middle
            turned += 0.0 if one.shown or one.wheel.internal else math.pi
            yield labels.beside(spot, with_index(f"ω_{one.wheel.number}"), hand.letter, BESIDE, turned)
        for name, end in self._beyond.items():
            to = self.drafting.word("involute to", name=with_index(name))
            yield labels.beside(end, to, hand.letter, BESIDE, math.pi)
        if size := self._distance:
            (start, end), *_ = size.lines
            spot = start + (0.25 if self._beyond else 0.75) * (end - start)
            side = math.pi * self.inner
            yield telling(NAME, labels.beside(spot, size.letter, hand.number, BESIDE, side), size.letter)
        for name, curve in self.mesh.circles.items():
            ends = curve[:-3:-1] if self.inner and name in ("d_a2", "d_w2", "d_f2") else curve  # of a ring left
            end, before = self.place.on(complex(ends[0])), self.place.on(complex(ends[1]))
            yield labels.beside(end, self._letter(name), hand.number, BESIDE, cmath.phase(end - before))
        for name, (start, _) in self.mesh.strings.items():
            one = self.mesh.wheels[int(name[0]) - 1]
            at, centre = self.place.on(start), self.place.on(one.centre)
            yield labels.beside(at, name[2:], hand.number, BESIDE / 2, cmath.phase(centre - at))

    def _letter(self, circle: str) -> str:
        """Letter a circle: one that is both pitch and operating circle by both."""
        other = f"d_w{circle[1:]}"
        alone = not circle[1:].isdigit() or other in self.mesh.circles
        return with_index(circle) if alone else f"{with_index(circle)} = {with_index(other)}"
