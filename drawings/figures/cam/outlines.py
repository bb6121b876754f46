"""The curves of a cam on paper: pitch curve, working profile, and where something is wrong with it (профиль)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.figures.cam.profile_view import OUTER, PITCH, QUANTITY, UNIT, WORKING, ProfileView, ShownCurve
from drawings.layout.labels import Labels
from drawings.layout.place import Place
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Curve, Group, LineStyle, Polyline, Stroke, numeral, stated
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.symbols import ground
from plans.cam.path import Bound, ProfilePath
from plans.model.cam_motion import Flaw
from plans.model.motion import Complexes

TOLD = 2  # digits of a stated deviation


def profile_curve(
    path: ProfilePath, place: Place, plan: str, name: str, style: LineStyle, turned: float = 0.0
) -> Group:
    """Draw a path of a cam, turned by degrees from its start, on a plan whose pole is the cam's centre.

    Its name is the letter of its points.
    """
    turn = cmath.exp(1j * math.radians(turned)) / place.scale.mu
    pieces = tuple(piece.placed(turn, place.on(0j)) for piece in path.pieces)
    data = {
        "kind": "profile",
        "plan": plan,
        "quantity": QUANTITY,
        "name": name,
        "value": stated(path.pieces[0].start),
        "unit": UNIT,
        "scale": numeral(place.scale.mu),
        "deviation": numeral(upward(path.deviation)),
        **({"turned": numeral(turned)} if turned else {}),
    }
    return Group(tuple(fit_dashes([Curve(pieces, path.closed, style)])), "", data, name)


def upward(value: float) -> float:
    """Round a deviation to a few digits, never to a lesser one.

    >>> upward(8.24e-08), upward(0.0)
    (8.3e-08, 0.0)
    """
    if value == 0:
        return 0.0
    digit = math.floor(math.log10(value)) + 1 - TOLD
    return float(f"{math.ceil(value * 10.0**-digit)}e{digit}")


# Flaws of a curve's own shape, and the curve that has them.
SHOWN = {"undercut": WORKING, "crossing": WORKING, "concave": WORKING, "sharp": WORKING, "hollow": OUTER}
LOOPS = ("undercut", "crossing", "hollow")  # what the follower never touches
BESIDE_CURVE = {**SHOWN, "short face": WORKING}  # all that is lettered at a place of a curve
HEAVY = 1.4  # times a main line: a stretch that is touched and has a flaw
BESIDE = 1.0  # mm from a place to its letters
SIDE = 30.0  # mm of ground under a cam that translates
UNDER = 1.2  # mm from its body to the ground


class FlawMark(NamedTuple):
    """A flaw on paper: its kind, and the worst place of its stretch."""

    kind: str
    spot: complex


def curves(view: ProfileView, plan: str, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw pitch curve and profile, of a groove both sides.

    Loops are thin and dashed, the contour that is left stands in main lines. A stretch
    that is touched and has a flaw is heavier and dashed.
    """
    for one in sorted(view.curves, key=lambda one: one.name != PITCH):
        flawed = any(SHOWN.get(flaw.kind) == one.name for flaw in view.found.flaws)
        style = hand.axis if one.name == PITCH else hand.path if flawed else hand.result
        yield profile_curve(one.path, place, plan, one.name, style)
        if flawed:
            yield from _contour(view, one, place, hand)
    if view.cam.translates:
        yield from _body(view, place, hand)


def _contour(view: ProfileView, one: ShownCurve, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw what of a curve with flaws lies between its loops."""
    own = [flaw for flaw in view.found.flaws if SHOWN.get(flaw.kind) == one.name]
    turns = {0.0, view.cam.turn, *(end for flaw in own for end in (flaw.start, flaw.end))}
    bounds = [Bound(turned, _spot(view, one, turned)) for turned in sorted(turns)]
    for low, high in pairwise(bounds):
        kinds = [flaw.kind for flaw in own if _holds(flaw, (low.turned + high.turned) / 2)]
        pieces = one.path.between(low, high, view.cam.turn)
        if pieces and not any(kind in LOOPS for kind in kinds):
            style = LineStyle(HEAVY * hand.main, hand.dashed) if kinds else hand.result
            placed = tuple(piece.placed(1 / place.scale.mu, place.on(0j)) for piece in pieces)
            yield from fit_dashes([Curve(placed, False, style)])


def _spot(view: ProfileView, one: ShownCurve, turned: float) -> complex:
    """Give the point of a curve at a turn, m."""
    return complex(np.interp(turned, view.curve.turned, _points(view, one.name)))


def flaws(view: ProfileView, place: Place) -> Iterator[FlawMark]:
    """Give the flaws of the curves' shapes, each at its worst place."""
    for one in view.found.flaws:
        if one.kind in BESIDE_CURVE:
            nearest = int(np.argmin(abs(view.curve.turned - one.worst.turned)))
            yield FlawMark(one.kind, place.on(complex(_points(view, BESIDE_CURVE[one.kind])[nearest])))


def lettered(view: ProfileView, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Name the flaws at their worst places, outside the curve."""
    for one in flaws(view, place):
        towards = cmath.phase(one.spot - place.on(0j))
        yield labels.beside(one.spot, drafting.word(f"cam {one.kind}"), drafting.hand.number, BESIDE, towards)


def _points(view: ProfileView, name: str) -> Complexes:
    """Give a curve by its many points, m."""
    outer = view.curve.outer
    return view.curve.profile if name == WORKING or outer is None else outer


def _holds(one: Flaw, turned: float) -> bool:
    """Tell whether a flaw's stretch holds a turn; one may run over the beginning of the turn."""
    if one.start <= one.end:
        return one.start <= turned <= one.end
    return not one.end < turned < one.start


def _body(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Close the body of a cam that translates below its profile, on the ground that it slides on."""
    left, right = (place.on(one) for one in view.body)
    ends = (place.on(complex(view.curve.profile[k])) for k in (0, -1))
    first, last = sorted(ends, key=lambda spot: spot.real)
    yield Polyline((first, left, right, last), False, hand.result)
    middle, half = (left + right) / 2 - 1j * UNDER * hand.symbol, SIDE * hand.symbol / 2
    yield from ground(middle - half, middle + half, -1j, hand)
