"""The follower at the start: its roller, tip or face, its rod in the guide, or its arm on the pivot (толкатель).

Its divisions stand where its tip is in each position: on the axis, or on the arc of a rocker.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.cam.inversion import POINT, face, highest
from drawings.figures.cam.profile_view import NAME, QUANTITY, ProfileView
from drawings.figures.cam.senses import CLEAR, GUIDE
from drawings.layout.place import Place
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Arc, Circle, Fill, Group, Line, Stroke
from drawings.paper.ties import tied
from drawings.symbols.figure import Subject, point
from drawings.symbols.symbols import HINGE, fixed_hinge, ground, hinge, tick
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


def foot(view: ProfileView) -> complex:
    """Give where the rod begins at the start, m: the tip, the roller's centre, the middle of a face."""
    return complex(view.axis, view.curve.tip[0].imag)


def _rod(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the rod as high as its guide, and the guide above the highest place that roller or face come to."""
    start = place.on(foot(view))
    low = highest(view, place, hand) if view.cam.translates else _above(view, place, hand)
    base, top = complex(start.real, low), complex(start.real, low + GUIDE * hand.symbol)
    yield Line(start, top + CLEAR * hand.symbol * 1j, hand.result)
    for side in (-1, 1):
        off = side * ROD * hand.symbol
        yield from ground(base + off, top + off, complex(side), hand)


def _above(view: ProfileView, place: Place, hand: Hand) -> float:
    """Give where the guide begins, mm: clear of roller or face in their highest place."""
    return place.on(1j * float(view.curve.tip.imag.max())).imag + place.length(view.found.roller) + CLEAR * hand.symbol


def _rocker(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the arm, the stand of its pivot, and of a flat one what holds its face before the pivot."""
    pivot, tip = place.on(view.sizes.pivot), place.on(complex(view.curve.tip[0]))
    radius = HINGE * hand.symbol
    yield from fixed_hinge(pivot, hand, radius, _downward(pivot - place.on(0j) or -1j, tip - pivot))
    if view.cam.flat:
        held = place.on(view.sizes.pivot + view.cam.follower.face * complex(view.curve.lever[0]))
        yield Line(held, tip, hand.result)
        tip = held
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
        yield _point(tip, hand, 1j * view.cam.rising if view.cam.rocks else 1j)


def _point(tip: complex, hand: Hand, up: complex) -> Fill:
    """Draw the point of a follower."""
    high = TIP * hand.symbol * (up if up.imag > 0 else -up)
    return Fill((tip, tip + high + 1j * SLIM * high, tip + high - 1j * SLIM * high))


def pivot_mark(view: ProfileView, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw the hinge of a rocker's pivot; it can be measured."""
    if view.sizes.pivot:
        (circle,) = hinge(place.on(view.sizes.pivot), hand)
        yield point(Subject(NAME, QUANTITY, None), "O_1", view.sizes.pivot, place, circle)


def divisions(view: ProfileView, place: Place, hand: Hand) -> tuple[Division, ...]:
    """Give the divisions that bear their numbers: on the rise on one side of the way, on the return on the other."""
    kept: list[Division] = []
    start = place.on(complex(view.curve.tip[0]))
    for one in _divisions(view, place):
        near = [start, *(other.spot for other in kept if other.towards == one.towards)]
        if all(tied(abs(one.spot - other) - APART * hand.number) >= 0 for other in near):
            kept.append(one)
    return tuple(kept)


def _divisions(view: ProfileView, place: Place) -> Iterator[Division]:
    """Give all divisions: of the first rise and the first return, the places of a dwell with neither."""
    if view.cam.flat and view.cam.rocks:
        return
    for phase in view.cam.moving():
        for k, turned in view.positions:
            if phase.start < turned < phase.end or (turned == phase.end and phase.change > 0):
                tip = complex(view.contour.tip[k])
                true = complex(view.axis, tip.imag) if view.cam.flat else tip
                yield Division(k, place.on(true), true, _towards(view, tip, phase.change > 0))


def _towards(view: ProfileView, tip: complex, rising: bool) -> float:
    """Direct the number of a division: across the way, the rise to the left of it."""
    if not view.cam.rocks:
        return cmath.pi if rising else 0.0
    level = view.curve.tip.mean() - view.sizes.pivot
    return cmath.phase(level if rising else -level)


def graduated(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the ticks of all divisions, the arc of a rocker's, and the points of those that bear numbers."""
    if view.cam.rocks and not view.cam.flat:
        yield _arc(view, place, hand)
    for one in _divisions(view, place):
        yield tick(one.spot, _across(view, one, place), hand)
    for one in divisions(view, place, hand):
        dot = Circle(one.spot, POINT * hand.symbol, INK)
        mark = point(Subject(NAME, QUANTITY, one.position), "K", one.true, place, dot)
        yield Group(mark.strokes, "", mark.data, str(one.position))


def _across(view: ProfileView, one: Division, place: Place) -> complex:
    """Give the direction of the follower's way at a division."""
    if not view.cam.rocks:
        return 1j
    arm = one.spot - place.on(view.sizes.pivot)
    return 1j * arm / abs(arm)


def _arc(view: ProfileView, place: Place, hand: Hand) -> Arc:
    pivot = place.on(view.sizes.pivot)
    turns = [place.on(complex(spot)) - pivot for spot in view.curve.tip]
    middle = cmath.phase(sum(turns))
    offs = [cmath.phase(turn * cmath.rect(1.0, -middle)) for turn in turns]
    return Arc(pivot, abs(turns[0]), middle + min(offs), middle + max(offs), hand.drafted)
