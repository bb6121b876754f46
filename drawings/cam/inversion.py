"""The follower's places about a cam that stands still, and the senses of motion (обращение движения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.cam.profile_view import NAME, QUANTITY, ProfileView
from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, TURN, Arc, Circle, Group, Kind, Line, LineStyle, Polyline, Statement, Stroke
from drawings.paper.walk import stating, tied
from drawings.symbols.figure import Subject, point
from drawings.symbols.symbols import HATCH, HINGE, STAND, TurnArrow, arrowhead, fit
from drawings.symbols.trimming import Mask, holds, trim

CLEAR = 2.0  # mm between a follower at its highest and its guide
GUIDE = 9.0  # mm, length of a guide
PAST = 2.0  # mm that an axis goes past its guide
NUMBER = 2.4  # sizes of a number from the ends of the axes to the arcs of the phases
PHASE = 1.2  # sizes of a letter beyond the arcs of the phases
BODY_GUIDE = 8.0  # mm under a cam that translates, for its guide


class ProfileRings(NamedTuple):
    """Radii on paper about O, mm, each beyond the one before."""

    view: ProfileView
    place: Place
    hand: Hand

    @property
    def cam(self) -> float:
        """The farthest place of the cam and of rollers on it."""
        return self.place.length(self.view.reach)

    @property
    def ends(self) -> float:
        """The ends of the turned axes, or the turned pivots of a rocker."""
        if self.view.cam.rocks:
            return max(self.place.length(abs(self.view.found.sizes.pivot)), self.cam + CLEAR * self.hand.symbol)
        return self.cam + beyond(self.hand)

    @property
    def phases(self) -> float:
        """The arcs of the phases."""
        return self.ends + NUMBER * self.hand.number

    def crossing(self, turned: float, radius: float) -> complex:
        """Give where a turned axis, or the ray through a turned pivot, meets a circle about O, mm from O."""
        view = self.view
        if view.cam.rocks:
            ray = view.way(view.found.sizes.pivot, turned)
            return radius * ray / abs(ray)
        off = self.place.length(view.axis)
        return view.way(complex(off, cmath.sqrt(radius**2 - off**2).real), turned)


def beyond(hand: Hand) -> float:
    """Give how far the axes go past the cam, mm: to where a guide ends, and on."""
    return (2 * CLEAR + GUIDE + PAST) * hand.symbol


def around(view: ProfileView, hand: Hand) -> float:
    """Give the paper around what is drawn to scale, mm."""
    ends = CLEAR * hand.symbol if view.cam.rocks else beyond(hand)
    return ends + NUMBER * hand.number + PHASE * hand.letter


WITHIN = (0.3, 0.68)  # of what is free from the cam to the ends of the axes: radii of both arrows
ASIDE, MOST = 0.25, math.radians(30)  # of the widest step: their middles to either side of its own, and at most
SWEEP, WIDE = 0.35, math.radians(32)  # of the widest step: how far they go, and at most
STRAIGHT = 22.0  # mm, length of the arrow of a cam that translates
BESIDE = 1.2


class Sense(NamedTuple):
    """An arrow about O with its letter."""

    letter: str
    arc: TurnArrow

    def draw(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw it."""
        return (stating(Statement(Kind.DIRECTION, NAME, self.letter), *self.arc.draw(hand)),)

    def letter_beside(self, labels: Labels, hand: Hand) -> Stroke:
        """Letter it beyond its middle."""
        spot, away = self.arc.middle
        return labels.beside(spot, self.letter, hand.letter, BESIDE, away)


def senses(view: ProfileView, rings: ProfileRings) -> tuple[Sense, ...]:
    """Give the arrows, the cam's own and the frame's, beside the cam where no axis is turned to."""
    if view.cam.translates:
        return ()
    zero, (start, end) = rings.place.on(0j), view.step
    inner = rings.place.length(abs(view.at((start + end) / 2)[0]) + view.found.roller)
    first, second = (inner + share * (rings.ends - inner) for share in WITHIN)
    aside, sweep = min(ASIDE * (end - start), MOST), view.cam.sense * min(SWEEP * (end - start), WIDE)
    turning = TurnArrow(zero, first, view.quiet - aside - sweep / 2, sweep)
    return Sense("ω", turning), Sense("−ω", TurnArrow(zero, second, view.quiet + aside + sweep / 2, -sweep))


def straight(view: ProfileView, rings: ProfileRings) -> Iterator[tuple[complex, complex]]:
    """Give the ends of the arrow of a cam that translates, within its body."""
    if view.cam.translates:
        left, right = (rings.place.on(corner) for corner in view.body)
        middle = (left + right) / 2 + 1j * rings.place.length(view.cam.lift) * 0.4
        half = view.cam.sense * STRAIGHT / 2 * rings.hand.symbol
        yield middle + half, middle - half


def pushed(figure: str, ends: tuple[complex, complex], hand: Hand) -> Group:
    """Draw the straight arrow of a cam that translates, in a figure."""
    head = arrowhead(*ends, hand.symbol)
    heads = () if head is None else (head,)
    return stating(Statement(Kind.DIRECTION, figure, "v"), Line(*ends, hand.other), *heads)


NOTCH = 3.0  # mm, half the arc of a notch
POINT = 0.6  # mm, radius of a found point
MISSED = 1.2  # mm, radius of the ring about contact that a face does not reach
TOUCHES = 1e-6  # of a face: contact so near to its end is at it
APART = 1.8  # sizes of a number from one marked point to the next
FEW = 2.2  # radii of the roller from one drawn roller to the next


def construction(view: ProfileView, rings: ProfileRings) -> Iterator[Stroke]:
    """Draw all thin lines: circles, turned axes, notches, faces, rollers; nothing of them within the shaft."""
    place, hand = rings.place, rings.hand
    lines = [*_circles(view, place, hand), *_turned(view, rings), *_notches(view, place, hand)]
    yield from trim(lines, () if view.cam.translates else _shaft(view, place, hand))
    radius = place.length(view.found.roller)  # it is drawn where it can be told apart
    for k in [*_apart(view, place, FEW * radius)][1:] if radius else ():
        yield Circle(place.on(complex(view.found.contour.pitch[k])), radius, hand.other)


def _shaft(view: ProfileView, place: Place, hand: Hand) -> tuple[Mask, ...]:
    """Give the outlines of the shaft and of its stand that no thin line enters: none hides a point of the profile."""
    zero, (high, half, more) = place.on(0j), (size * hand.symbol for size in STAND)
    wide, low = half + more, zero - 1j * (high + HATCH * hand.symbol)
    outlines = (Circle(zero, HINGE * hand.symbol), Polyline((zero, low - wide, low + wide), True))
    spots = [place.on(point) for point in view.found.contour.pitch.tolist()]
    return tuple(outline for outline in outlines if not any(holds(outline, spot) for spot in spots))


def _circles(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the circle of the least radius, of the offset, of the pivots; of a cam that translates its base line."""
    if view.cam.translates:
        across = view.curve.pitch.real
        left, right = (place.on(complex(x)) for x in (across.min(), across.max()))
        yield Line(left, right, hand.other)
        return
    zero, sizes = place.on(0j), view.found.sizes
    yield Circle(zero, place.length(sizes.base), hand.other)
    if place.length(abs(sizes.offset)) > POINT:
        yield Circle(zero, place.length(abs(sizes.offset)), hand.other)
    if sizes.pivot:
        far = place.length(abs(sizes.pivot))
        yield Circle(zero, far, fit(hand.axis, TURN * far, True))


def _turned(view: ProfileView, rings: ProfileRings) -> Iterator[Stroke]:
    """Draw the turned frame of each position: the axis of the follower, or the arm from the turned pivot."""
    place, hand = rings.place, rings.hand
    for k, turned in view.positions:
        spot = place.on(complex(view.found.contour.pitch[k]))
        if view.cam.rocks:
            pivot = view.back(view.found.sizes.pivot, turned)
            if view.cam.flat:
                normal = view.way(complex(view.found.contour.lever[k]), turned)
                yield Line(place.on(pivot), place.on(pivot + view.cam.follower.face * normal), hand.drafted)
            else:
                yield Line(place.on(pivot), place.on(complex(view.found.contour.pitch[k])), hand.drafted)
        elif view.cam.translates:
            foot = complex(spot.real, min(spot.imag, place.on(0j).imag))
            yield Line(foot, complex(spot.real, highest(view, place, hand)), hand.drafted)
        else:
            foot = place.on(view.back(complex(view.axis), turned))
            yield Line(foot, place.on(0j) + rings.crossing(turned, rings.ends), hand.drafted)
        if view.cam.flat:
            yield Line(*face(view, place, turned), hand.other)
            yield from _missed(place.on(complex(view.found.contour.pitch[k])), face(view, place, turned), hand)


def highest(view: ProfileView, place: Place, hand: Hand, clear: float = 3.0) -> float:
    """Give the level, mm, clear of roller or face in their highest place: over a cam that translates its axes end."""
    return place.on(1j * float(view.curve.tip.imag.max())).imag + place.length(view.found.roller) + clear * hand.symbol


def face(view: ProfileView, place: Place, turned: float) -> tuple[complex, complex]:
    """Give the ends of a turned face on paper: as far as contact goes over the whole turn, and a little more."""
    spot, normal = view.at(turned)
    along = -1j * normal
    foot = view.back(complex(view.axis) if not view.cam.rocks else view.found.sizes.pivot, turned)
    low, high = view.face
    off = ((spot - foot) * along.conjugate()).real
    return place.on(spot + (low - off) * along), place.on(spot + (high - off) * along)


def _missed(spot: complex, ends: tuple[complex, complex], hand: Hand) -> Iterator[Stroke]:
    """Mark contact beyond the end of a face that is too short: a ring about it, a dashed line from the face to it."""
    nearest = min(ends, key=lambda end: abs(end - spot))
    middle = sum(ends) / 2
    if abs(spot - middle) > abs(nearest - middle) * (1 + TOUCHES):
        yield Line(nearest, spot, fit(hand.path, abs(spot - nearest)))
        yield Circle(spot, MISSED * hand.symbol, hand.other)


def _notches(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the notch of each position that S carries over: an arc about O, of a rocker one about its pivot too."""
    if view.cam.translates or view.cam.flat:
        return
    zero = place.on(0j)
    for k, turned in view.positions:
        spot = place.on(complex(view.found.contour.pitch[k]))
        yield _notch(zero, spot, hand)
        if view.cam.rocks:
            yield _notch(place.on(view.back(view.found.sizes.pivot, turned)), spot, hand)
    # The middle one of the first motion is drawn whole, from the initial frame on.
    moves = [*view.cam.moving()][:1]
    within = [k for k, turned in view.positions for phase in moves if phase.start < turned < phase.end]
    for carried in within[len(within) // 2 :][:1]:
        start, end = (
            place.on(complex(curve[carried])) - zero for curve in (view.found.contour.tip, view.found.contour.pitch)
        )
        first, last = (start, end) if view.cam.sense < 0 else (end, start)
        yield Arc(zero, abs(start), cmath.phase(first), cmath.phase(last), hand.drafted)


def _notch(centre: complex, spot: complex, hand: Hand) -> Arc:
    radius, turn = abs(spot - centre), cmath.phase(spot - centre)
    half = min(NOTCH * hand.symbol / radius, math.pi)
    return Arc(centre, radius, turn - half, turn + half, hand.drafted)


def marked(view: ProfileView, place: Place, hand: Hand) -> Iterator[int]:
    """Choose the positions whose points are marked and numbered: those that stand apart on paper."""
    return _apart(view, place, APART * hand.number)


def _apart(view: ProfileView, place: Place, least: float) -> Iterator[int]:
    last = first = place.on(complex(view.found.contour.pitch[0]))
    yield 0
    for k, _ in view.positions[1:]:
        spot = place.on(complex(view.found.contour.pitch[k]))
        if tied(min(abs(spot - last), abs(spot - first)) - least) >= 0:
            yield k
            last = spot


def marks(view: ProfileView, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw the found points of the numbered positions, and the normals from the roller's centre to the profile."""
    for k in marked(view, place, hand):
        subject, letter = Subject(NAME, QUANTITY, k), str(k)
        spot, touch = complex(view.found.contour.pitch[k]), complex(view.found.contour.profile[k])
        if view.apart:
            line = Line(place.on(spot), place.on(touch), hand.drafted)
            yield Group((line,), "", subject.data("vector", "Q", touch - spot, place.scale), letter)
        dot = Circle(place.on(spot), POINT * hand.symbol, INK)
        yield point(subject, "P" if view.apart else "Q", spot, place, dot, title=letter)


def pivots(view: ProfileView, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw the turned pivots of a rocker."""
    style = LineStyle(hand.thin, fill="#ffffff")
    for k, turned in view.positions[1:] if view.found.sizes.pivot else ():
        spot = view.back(view.found.sizes.pivot, turned)
        circle = Circle(place.on(spot), 0.8 * hand.symbol, style)
        yield point(Subject(NAME, QUANTITY, k), "O_1", spot, place, circle, title=str(k))
