"""The figure of a cam's profile with its follower in its lowest place (профиль кулачка с толкателем)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from drawings.cam import inversion, profile_view, size_marks
from drawings.cam.inversion import BODY_GUIDE, CLEAR, GUIDE, POINT, ProfileRings, around, beyond, face, highest
from drawings.cam.profile_view import NAME, QUANTITY, SYMBOL, UNIT, ProfileView
from drawings.kinds.axes import placed
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.words import telling
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Arc, Circle, Fill, Group, Line, Stroke, Text
from drawings.paper.walk import tied
from drawings.symbols.figure import Subject, explained, heading, point
from drawings.symbols.symbols import HINGE, fit, fixed_hinge, ground, hinge, pole, tick
from plans.model.cam import POINTED

PIN = 0.9  # mm, radius of a roller's pin
TIP = 3.5  # mm, height of a pointed end
SLIM = 0.28  # of its height: half its width
ROD = 1.3  # mm from the middle of a rod to its guide
ALONG = 0.64  # cosine: a stand so near to the direction of its arm would be crossed by it
APART = 1.25  # sizes of a number from one division that bears one to the next
SIDES = (-1j, 1j, 1.0 + 0j, -1.0 + 0j)


class Division(NamedTuple):
    """A division of the follower's way: its position, its place on paper, the direction of its number, rad."""

    position: int
    spot: complex
    true: complex
    towards: float


def follower(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the follower at the start."""
    if view.apart:
        yield Circle(place.on(complex(view.curve.tip[0])), place.length(view.found.roller), hand.body)
    if view.cam.rocks:
        yield from _rocker(view, place, hand)
    else:
        yield from _rod(view, place, hand)
    yield from _end(view, place, hand)


def _rod(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the rod as high as its guide, and the guide above the highest place that roller or face come to."""
    start = place.on(complex(view.axis, view.curve.tip[0].imag))  # the tip, the roller's centre, the middle of a face
    low = highest(view, place, hand) if view.cam.translates else highest(view, place, hand, CLEAR)
    base, top = complex(start.real, low), complex(start.real, low + GUIDE * hand.symbol)
    yield Line(start, top + CLEAR * hand.symbol * 1j, hand.result)
    for side in (-1, 1):
        off = side * ROD * hand.symbol
        yield from ground(base + off, top + off, complex(side), hand)


def _rocker(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the arm, the stand of its pivot, and of a flat one what holds its face before the pivot."""
    pivot, tip = place.on(view.found.sizes.pivot), place.on(complex(view.curve.tip[0]))
    radius = HINGE * hand.symbol
    yield from fixed_hinge(pivot, hand, radius, _downward(pivot - place.on(0j) or -1j, tip - pivot))
    if view.cam.flat:
        root = place.on(view.found.sizes.pivot + view.cam.follower.face * complex(view.curve.lever[0]))
        yield Line(root, tip, hand.result)
        tip = root
    if abs(tip - pivot) > radius:
        yield Line(pivot + (tip - pivot) / abs(tip - pivot) * radius, tip, hand.result)


def _downward(outward: complex, arm: complex) -> complex:
    """Choose the side of a stand: towards the cam, off the arm."""

    def cost(side: complex) -> float:
        along = (side * arm.conjugate()).real / abs(arm) > ALONG
        return (side * outward.conjugate()).real / abs(outward) + 2 * along

    return min(SIDES, key=cost)


def _end(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the end: the roller's pin, the point, the face."""
    tip = place.on(complex(view.curve.tip[0]))
    if view.apart:
        yield Circle(tip, PIN * hand.symbol, hand.body)
    elif view.cam.flat:
        yield Line(*face(view, place, 0.0), hand.result)
    elif view.cam.follower.end == POINTED:
        up = 1j * view.cam.rising if view.cam.rocks else 1j
        high = TIP * hand.symbol * (up if up.imag > 0 else -up)
        yield Fill((tip, tip + high + 1j * SLIM * high, tip + high - 1j * SLIM * high))


def pivot_mark(view: ProfileView, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw the hinge of a rocker's pivot; it can be measured."""
    if view.found.sizes.pivot:
        (circle,) = hinge(place.on(view.found.sizes.pivot), hand)
        yield point(Subject(NAME, QUANTITY, None), "O_1", view.found.sizes.pivot, place, circle)


def divisions(view: ProfileView, place: Place, hand: Hand) -> tuple[Division, ...]:
    """Give the divisions that bear their numbers: on the rise on one side of the way, on the return on the other."""
    kept: list[Division] = []
    start = place.on(complex(view.curve.tip[0]))
    for division in _divisions(view, place):
        near = [start, *(other.spot for other in kept if other.towards == division.towards)]
        if all(tied(abs(division.spot - other) - APART * hand.number) >= 0 for other in near):
            kept.append(division)
    return tuple(kept)


def _divisions(view: ProfileView, place: Place) -> Iterator[Division]:
    """Give all divisions: of the first rise and the first return, the places of a dwell with neither."""
    if view.cam.flat and view.cam.rocks:
        return
    for phase in view.cam.moving():
        for k, turned in view.positions:
            if phase.start < turned < phase.end or (turned == phase.end and phase.change > 0):
                tip = complex(view.found.contour.tip[k])
                true = complex(view.axis, tip.imag) if view.cam.flat else tip
                yield Division(k, place.on(true), true, _towards(view, phase.change > 0))


def _towards(view: ProfileView, rising: bool) -> float:
    """Direct the number of a division: across the way, the rise to the left of it."""
    if not view.cam.rocks:
        return cmath.pi if rising else 0.0
    level = view.curve.tip.mean() - view.found.sizes.pivot
    return cmath.phase(level if rising else -level)


def graduated(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the ticks of all divisions, the arc of a rocker's, and the points of those that bear numbers."""
    if view.cam.rocks and not view.cam.flat:
        pivot = place.on(view.found.sizes.pivot)
        turns = [place.on(complex(spot)) - pivot for spot in view.curve.tip]
        middle = cmath.phase(sum(turns))
        offs = [cmath.phase(turn * cmath.rect(1.0, -middle)) for turn in turns]
        yield Arc(pivot, abs(turns[0]), middle + min(offs), middle + max(offs), hand.drafted)
    for division in _divisions(view, place):
        yield tick(division.spot, _across(view, division, place), hand)
    for division in divisions(view, place, hand):
        dot, k = Circle(division.spot, POINT * hand.symbol, INK), division.position
        yield point(Subject(NAME, QUANTITY, k), "K", division.true, place, dot, title=str(k))


def _across(view: ProfileView, division: Division, place: Place) -> complex:
    """Give the direction of the follower's way at a division."""
    if not view.cam.rocks:
        return 1j
    arm = division.spot - place.on(view.found.sizes.pivot)
    return 1j * arm / abs(arm)


LETTERS, MOST = 21.0, 80.0  # it is drawn at least so many letters large, and at most
BESIDE = 1.0  # mm from a point to its number
END = 0.9  # mm from the end of an axis to its number
AXIS = 6.0  # mm that the axes of the shaft go past it
ORIGIN = "O"


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
    room = picture(NAME, view.corners, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)
    return explained(room._replace(most=MOST * hand.letter), _lines(view, drafting), hand)


def _lines(view: ProfileView, drafting: Drafting) -> list[str]:
    """Say which line shows where the centre of a roller goes."""
    return drafting.word("cam lines").split("\n") if view.found.roller else []


def draw(view: ProfileView, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the profile in its spot: the construction thin, the follower at the start, the curves over all."""
    place, hand = room.place(*spot), drafting.hand
    rings = ProfileRings(view, place, hand)
    lines = (
        heading(spot.box, drafting.word("cam profile"), drafting.scale(spot.scale), hand, *_lines(view, drafting)),
        *_shaft(view, place, hand),
        *inversion.construction(view, rings),
        *size_marks.thin(view, place, hand),
        *_around(view, rings, drafting),
        *follower(view, place, hand),
        *profile_view.curves(view, NAME, place, hand),
        *(mark.draw(place, hand) for mark in size_marks.size_marks(view, place, drafting)),
        *inversion.pivots(view, place, hand),
        *inversion.marks(view, place, hand),
        *graduated(view, place, hand),
        *pivot_mark(view, place, hand),
        _origin(view, place, hand),
    )
    return LetteredFigure(NAME, lines, partial(_letters, view, rings, drafting))


def _letters(view: ProfileView, rings: ProfileRings, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Letter phases, senses, sizes and points, number every position."""
    place, hand = rings.place, drafting.hand
    for division in divisions(view, place, hand):
        yield labels.beside(division.spot, str(division.position), hand.number, BESIDE, division.towards)
    yield from _points(view, rings, labels)
    for arc in (*size_marks.phase_arcs(view, rings, drafting), *size_marks.rocking(view, place, drafting)):
        yield arc.letter_beside(labels, hand)
    for travel in size_marks.travels(view, rings, drafting):
        yield telling(NAME, labels.along(*travel.lines[0], travel.letter, hand.number, BESIDE, math.pi / 2))
    for size in size_marks.size_marks(view, place, drafting):
        yield telling(NAME, labels.along(size.start, size.end, size.letter, hand.number, BESIDE, math.pi / 2))
    yield from placed(NAME, size_marks.centre_letters(view, place, hand), labels)
    yield from _numbers(view, rings, labels)
    yield from profile_view.lettered(view, place, drafting, labels)


def _points(view: ProfileView, rings: ProfileRings, labels: Labels) -> Iterator[Stroke]:
    """Letter O, a rocker's pivot, the inversion."""
    place, hand = rings.place, rings.hand
    gap = BESIDE + (0.0 if view.cam.translates else HINGE * hand.symbol)
    yield labels.beside(place.on(0j), ORIGIN, hand.letter, gap, view.quiet)
    if view.found.sizes.pivot:
        yield labels.beside(place.on(view.found.sizes.pivot), "O_1", hand.letter, gap, math.pi / 2)
    for sense in inversion.senses(view, rings):
        yield sense.letter_beside(labels, hand)
    for start, end in inversion.straight(view, rings):
        yield labels.along(start, end, "v", hand.letter, BESIDE, math.pi / 2)


def _numbers(view: ProfileView, rings: ProfileRings, labels: Labels) -> Iterator[Stroke]:
    """Number the positions at the ends of their axes, and at the points of the curve."""
    place, size = rings.place, rings.hand.number
    for k, turned in view.positions:
        spot, towards = _end_of(view, rings, k, turned)
        yield labels.beside(spot, str(k), size, END, towards)
    for k in inversion.marked(view, place, rings.hand):
        normal = view.at(view.found.contour.turned[k])[1]
        spot = place.on(complex(view.found.contour.pitch[k]))
        yield labels.beside(spot, str(k), size, BESIDE, math.atan2(normal.imag, normal.real))


def _end_of(view: ProfileView, rings: ProfileRings, k: int, turned: float) -> tuple[complex, float]:
    """Give the end of a turned axis with the direction outward."""
    place, zero = rings.place, rings.place.on(0j)
    if view.cam.translates:
        high = inversion.highest(view, place, rings.hand)
        return complex(place.on(complex(view.found.contour.pitch[k])).real, high), math.pi / 2
    pivot = place.on(view.back(view.found.sizes.pivot, turned)) - zero
    off = pivot if view.cam.rocks and k else rings.crossing(turned, rings.ends)
    return zero + off, math.atan2(off.imag, off.real)


def _around(view: ProfileView, rings: ProfileRings, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the phases and the inversion."""
    hand = drafting.hand
    for arc in (*size_marks.phase_arcs(view, rings, drafting), *size_marks.rocking(view, rings.place, drafting)):
        yield from arc.draw(hand)
    if not view.cam.translates:
        yield from size_marks.bounds(view, rings, hand)
    for travel in size_marks.travels(view, rings, drafting):
        yield from travel.draw(hand)
    for sense in inversion.senses(view, rings):
        yield from sense.draw(hand)
    for ends in inversion.straight(view, rings):
        yield inversion.pushed(NAME, ends, hand)


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
