"""The view of a cam's profile: its curves, and where its outline is sharp, hollow or undercut (вид профиля)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Curve, Group, LineStyle, Polyline, Stroke, numeral, stated
from drawings.paper.walk import tied
from drawings.symbols.symbols import fit_dashes, ground
from plans.cam.course import FollowerCourse
from plans.cam.path import PathCut, ProfilePath, path
from plans.cam.profile.profile import profile
from plans.model.cam import GROOVE, Cam
from plans.model.cam_motion import CamFlaw, CamFound, Contour, Points
from plans.model.motion import Complexes, Floats

MANY = 1441  # turns at which the contour is known: every quarter of a degree
WORKING, PITCH, OUTER = "profile", "pitch", "outer"  # the curves by their names in the data
BODY = 0.8  # of the lift: how far below its lowest profile the body of a cam that translates goes
BEYOND = 0.12  # of the range of contact: how far a face is drawn past it
NAME, QUANTITY, SYMBOL, UNIT = "profile", "l", "l", "m"


class ShownCurve(NamedTuple):
    """A curve of the cam in pieces: how far from the pitch curve outward it lies, m, its name in the data."""

    name: str
    away: float
    path: ProfilePath


class ProfileView(NamedTuple):
    """A cam to be seen: what is found at its numbered positions, its contour at many turns, its curves in pieces."""

    found: CamFound
    curve: Contour
    curves: tuple[ShownCurve, ...]  # the working profile, then its pitch curve, then the other side of a groove

    @property
    def cam(self) -> Cam:
        """The cam that was asked for."""
        return self.found.cam

    @property
    def positions(self) -> list[tuple[int, float]]:
        """The numbered positions with the turns of the cam, rad."""
        return list(enumerate(self.found.contour.turned.tolist()))

    @property
    def apart(self) -> bool:
        """Whether pitch curve and working profile are two."""
        return self.found.roller > 0

    def back(self, place: complex, turned: float) -> complex:
        """Carry a place of the frame back with the frame, against the motion of the cam."""
        return complex(self.backs(np.array([place]), np.array([turned]))[0])

    def backs(self, places: Points, turned: Floats) -> Complexes:
        """Carry places of the frame back, each by its own turn, (N,)."""
        sense = self.cam.sense
        moved = places + sense * turned if self.cam.translates else places * np.exp(-1j * sense * turned)
        return np.asarray(moved)

    def way(self, direction: complex, turned: float) -> complex:
        """Turn a direction of the frame back with the frame."""
        return direction if self.cam.translates else self.back(direction, turned)

    @property
    def outlines(self) -> tuple[Complexes, ...]:
        """The working profile by points, m; of a groove its other side too."""
        curve = self.curve
        return (curve.profile,) if curve.outer is None or not self.apart else (curve.profile, curve.outer)

    @property
    def axis(self) -> float:
        """Where the axis of a follower that translates stands, x in m."""
        return self.cam.sense * self.found.sizes.offset

    @property
    def reach(self) -> float:
        """How far from O the cam and its rollers reach, m."""
        curve = self.curve
        if self.cam.flat and not self.cam.rocks:
            return float(abs(curve.tip.imag + 1j * max(map(abs, self.face))).max())
        far = [abs(curve.pitch).max() + self.found.roller, *(abs(outline).max() for outline in self.outlines)]
        if self.cam.follower.reach is not None:  # the end of a rocker's face
            lever, face = curve.lever, self.cam.follower.face
            end = self.found.sizes.pivot - 1j * lever * max(self.face, key=abs) + face * lever
            far.append(abs(end).max())
        return float(max(far))

    @property
    def face(self) -> tuple[float, float]:
        """How far a face is drawn from its follower's axis or pivot to either side, m.

        As far as it reaches, of a rocker from its pivot on; where that is not said a little past all contact.
        """
        foot = self.found.sizes.pivot if self.cam.rocks else complex(self.axis)
        off = ((self.curve.tip - foot) * (-1j * self.curve.lever).conj()).real
        low, high = float(off.min()), float(off.max())
        reach = self.cam.follower.reach
        if reach is None:
            return low - BEYOND * (high - low), high + BEYOND * (high - low)
        if not self.cam.rocks:
            return -reach, reach
        return (0.0, reach) if low + high > 0 else (-reach, 0.0)

    @property
    def body(self) -> tuple[complex, complex]:
        """The lower left and the lower right corner of a cam that translates, m."""
        profile = self.curve.profile
        low = float(profile.imag.min()) - BODY * self.cam.lift
        return complex(float(profile.real.min()), low), complex(float(profile.real.max()), low)

    @property
    def corners(self) -> list[complex]:
        """The corners of all that is drawn to scale, m."""
        if self.cam.translates:
            top = float(self.curve.tip.imag.max()) + self.found.roller
            across, by = self.curve.pitch.real, self.found.roller
            return [*self.body, *(complex(x, top) for x in (across.min() - by, across.max() + by))]
        reach = max(self.reach, abs(self.found.sizes.pivot))
        return [complex(x, y) for x in (-reach, reach) for y in (-reach, reach)]

    def at(self, turned: float) -> tuple[complex, complex]:
        """Give the point of the pitch curve at a turn, m, and the unit normal out of the cam."""
        curve, turns = self.curve, self.curve.turned
        spot, lever = (
            complex(np.interp(turned, turns, points.real), np.interp(turned, turns, points.imag))
            for points in (curve.pitch, curve.lever)
        )
        normal = self.way(lever, turned)
        return spot, normal / abs(normal)

    @property
    def step(self) -> tuple[float, float]:
        """The longest step from one numbered position to the next: the turns of both, rad."""
        return max(
            pairwise([*self.found.contour.turned.tolist(), self.cam.turn]), key=lambda pair: tied(pair[1] - pair[0])
        )

    @property
    def quiet(self) -> float:
        """The direction from O, rad, about which the frame is turned to no position: the middle of the longest step."""
        return cmath.phase(self.way(self.found.sizes.pivot if self.cam.rocks else 1j, sum(self.step) / 2))


def profile_view(found: CamFound) -> ProfileView:
    """Give what a figure shows of a cam that the construction found."""
    course = FollowerCourse(found.cam)
    turns = course.with_joints(np.linspace(0.0, found.cam.turn, MANY))
    contour = profile(course, found.sizes, found.roller, turns).contour
    return ProfileView(found, contour, tuple(_curves(found)))


def _curves(found: CamFound) -> Iterator[ShownCurve]:
    cam, sizes, away = found.cam, found.sizes, found.roller
    yield ShownCurve(WORKING, -away, path(cam, sizes, -away))
    if away:
        yield ShownCurve(PITCH, 0.0, path(cam, sizes))
        if cam.closure == GROOVE:
            yield ShownCurve(OUTER, away, path(cam, sizes, away))


DEVIATION_DIGITS = 2  # digits of a stated deviation


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
    digit = math.floor(math.log10(value)) + 1 - DEVIATION_DIGITS
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
    for curve in sorted(view.curves, key=lambda curve: curve.name != PITCH):
        flawed = any(SHOWN.get(flaw.kind) == curve.name for flaw in view.found.flaws)
        style = hand.axis if curve.name == PITCH else hand.path if flawed else hand.result
        yield profile_curve(curve.path, place, plan, curve.name, style)
        if flawed:
            yield from _contour(view, curve, place, hand)
    if view.cam.translates:
        left, right = (place.on(corner) for corner in view.body)
        ends = (place.on(complex(view.curve.profile[k])) for k in (0, -1))
        first, last = sorted(ends, key=lambda spot: spot.real)
        yield Polyline((first, left, right, last), False, hand.result)
        middle, half = (left + right) / 2 - 1j * UNDER * hand.symbol, SIDE * hand.symbol / 2
        yield from ground(middle - half, middle + half, -1j, hand)


def _contour(view: ProfileView, curve: ShownCurve, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw what of a curve with flaws lies between its loops."""
    flaws = [flaw for flaw in view.found.flaws if SHOWN.get(flaw.kind) == curve.name]
    turns = {0.0, view.cam.turn, *(end for flaw in flaws for end in (flaw.start, flaw.end))}
    points = _points(view, curve.name)
    bounds = [PathCut(turned, complex(np.interp(turned, view.curve.turned, points))) for turned in sorted(turns)]
    for low, high in pairwise(bounds):
        kinds = [flaw.kind for flaw in flaws if _holds(flaw, (low.turned + high.turned) / 2)]
        pieces = curve.path.between(low, high, view.cam.turn)
        if pieces and not any(kind in LOOPS for kind in kinds):
            style = LineStyle(HEAVY * hand.main, hand.dashed) if kinds else hand.result
            placed = tuple(piece.placed(1 / place.scale.mu, place.on(0j)) for piece in pieces)
            yield from fit_dashes([Curve(placed, False, style)])


def flaws(view: ProfileView, place: Place) -> Iterator[FlawMark]:
    """Give the flaws of the curves' shapes, each at its worst place."""
    for flaw in view.found.flaws:
        if flaw.kind in BESIDE_CURVE:
            nearest = int(np.argmin(abs(view.curve.turned - flaw.worst.turned)))
            yield FlawMark(flaw.kind, place.on(complex(_points(view, BESIDE_CURVE[flaw.kind])[nearest])))


def lettered(view: ProfileView, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Name the flaws at their worst places, outside the curve."""
    for mark in flaws(view, place):
        towards = cmath.phase(mark.spot - place.on(0j))
        yield labels.beside(mark.spot, drafting.word(f"cam {mark.kind}"), drafting.hand.number, BESIDE, towards)


def _points(view: ProfileView, name: str) -> Complexes:
    """Give a curve by its many points, m."""
    outer = view.curve.outer
    return view.curve.profile if name == WORKING or outer is None else outer


def _holds(flaw: CamFlaw, turned: float) -> bool:
    """Tell whether a flaw's stretch holds a turn; one may run over the beginning of the turn."""
    if flaw.start <= flaw.end:
        return flaw.start <= turned <= flaw.end
    return not flaw.end < turned < flaw.start
