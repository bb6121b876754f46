"""The outline of a cam beside its pitch curve, at any turn: where it is, and how it runs (очертание кулачка)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from geometry.board import Board, Mark
from geometry.meet import Vectors
from plans.cam.course import FollowerCourse
from plans.cam.profile.touch import FaceTouch, Tip, arm, guide_start
from plans.model.cam import GROOVE, Cam
from plans.model.cam_motion import CamSizes, Contour, Points
from plans.model.motion import Floats
from plans.words.words import because

PROFILE = "profile"


class Inversion(NamedTuple):
    """The follower in all its turned positions: the board, the point it leaves on the cam, the normal there."""

    board: Board
    point: Mark  # P
    normal: Mark  # a vector on the normal, out of the cam
    back: Points  # unit: how far the frame is turned at each position


class Start(NamedTuple):
    """The cam's centre on the board, the directions of the turned positions, and the tip that is followed."""

    board: Board
    centre: Mark
    back: Mark
    tip: Tip


def inversion(tip: Tip) -> Inversion:
    """Turn the follower about the cam to all positions."""
    board = Board(PROFILE)
    centre = board.given("O", 0j, because("cam_centre"))
    back = board.given("φ", np.exp(-1j * tip.turns * tip.turned), because("cam_back"))
    start = Start(board, centre, back, tip)
    if tip.cam.translates:
        return _shifted(start)
    if tip.cam.flat:
        return _rocking_face(start) if tip.cam.rocks else _face(start)
    return _rocker(start) if tip.cam.rocks else _guide(start)


def _made(start: Start, point: Mark, normal: Mark) -> Inversion:
    return Inversion(start.board, point, normal, np.asarray(start.back.point))


def _guide(start: Start) -> Inversion:
    """Turn the guide round the circle of the offset, and cut it by notches of the distances OK."""
    board, centre, back, tip = start
    offset = tip.cam.sense * tip.sizes.offset
    foot = board.lay_off("A", centre, board.given("e", complex(offset), because("cam_offset")), because("cam_offset"))
    divisions = board.given("S_0+S", 1j * (guide_start(tip.sizes) + tip.travel.s), because("cam_divisions"))
    tip_mark = board.lay_off("K", foot, divisions, because("cam_divisions"))
    circle = board.arc("(e)", centre, abs(offset), because("cam_offset_circle"))
    towards = board.turn("t", back, math.copysign(1.0, offset), because("cam_back"))
    touching = board.divide("T", circle, towards, because("cam_guide_touches"))
    guide = board.square("TP", touching, back, because("cam_guide"))
    notch = board.arc("OK", centre, np.abs(tip_mark.point), because("cam_notch"))
    point = board.meet("P", guide, notch, 1.0, because("cam_on_guide"))
    turned = board.given("S'", -tip.cam.sense * tip.travel.slope + 0j, because("cam_slope"))
    slope = board.turn("KD", turned, back.point, because("cam_back"))
    return _made(start, point, _normal(start, point, slope))


def _rocker(start: Start) -> Inversion:
    """Turn the pivot round the circle of the distance of centres, and find the rocker's end by two notches."""
    board, centre, _, tip = start
    turned = _pivot(start)
    length, pivot = tip.cam.follower.length or 0.0, complex(tip.sizes.pivot)
    rocker = board.given("O1K", length * arm(tip.cam, tip.travel.s), because("cam_rocker"))
    tip_mark = board.lay_off("K", board["O1"], rocker, because("cam_rocker"))
    side = np.where((np.conj(pivot) * tip_mark.point).imag < 0, -1.0, 1.0)
    notch = board.arc("OK", centre, np.abs(tip_mark.point), because("cam_notch"))
    point = board.meet("P", notch, board.arc("l", turned, length, because("cam_arm")), side, because("cam_two_notches"))
    radius = board.join("O1P", turned, point, because("cam_rocker"))
    slope = board.turn("KD", radius, -tip.cam.follower.sense * tip.travel.slope + 0j, because("cam_slope_arm"))
    return _made(start, point, _normal(start, point, slope))


def _pivot(start: Start) -> Mark:
    board, centre, back, tip = start
    pivot = board.given("O1", complex(tip.sizes.pivot), because("cam_pivot"))
    size = abs(complex(pivot.point))
    circle = board.arc("(L)", centre, size, because("cam_centres"))
    towards = board.turn("t", back, complex(pivot.point) / size, because("cam_back"))
    return board.divide("O1'", circle, towards, because("cam_pivot_turned"))


def _face(start: Start) -> Inversion:
    """Turn the face, and lay S' off along it."""
    board, centre, back, tip = start
    height = board.given("h", 1j * (tip.sizes.base + tip.travel.s), because("cam_face_height"))
    foot = board.lay_off("F", centre, board.turn("OF", height, back.point, because("cam_back")), because("cam_face"))
    board.parallel("f", foot, back, because("cam_face"))
    slope = board.given("S'", tip.cam.sense * tip.travel.slope + 0j, because("cam_slope"))
    along = board.turn("FP", slope, back.point, because("cam_back"))
    point = board.lay_off("P", foot, along, because("cam_touches"))
    return _made(start, point, board.turn("n", back, 1j, because("cam_face_normal")))


def _rocking_face(start: Start) -> Inversion:
    """Turn the face with its pivot, and drop a perpendicular on it from the relative instant centre."""
    board, centre, back, tip = start
    turned, follower = _pivot(start), tip.cam.follower
    level = board.given("u", arm(tip.cam, tip.travel.s), because("cam_rocker"))
    along = board.turn("u'", level, back.point, because("cam_back"))
    normal = board.turn("n", along, 1j * tip.cam.rising, because("cam_face_normal"))
    foot = board.lay_off(
        "F", turned, board.turn("O1F", normal, follower.face, because("cam_face")), because("cam_face")
    )
    face = board.parallel("f", foot, along, because("cam_face"))
    lead = FaceTouch(tip).lead
    share = np.where(lead == 0, np.nan, 1 - 1 / np.where(lead == 0, 1.0, lead))
    line = board.join("OO1'", centre, turned, because("cam_centres"))
    pole = board.lay_off("C", centre, board.turn("OC", line, share, because("cam_pole")), because("cam_pole"))
    square = board.square("CP", pole, along, because("cam_touches"))
    return _made(start, board.meet("P", face, square, why=because("cam_touches")), normal)


def _shifted(start: Start) -> Inversion:
    """Shift the follower against the cam's own travel."""
    board, _, _, tip = start
    place = board.given("K", tip.orders[0], because("cam_divisions"))
    shift = board.given("x", tip.cam.sense * tip.turned + 0j, because("cam_shift"))
    point = board.lay_off("P", place, shift, because("cam_shifted"))
    slope = board.given("KD", 1j * tip.cam.sense * tip.orders[1], because("cam_slope"))
    unit = board.given("H", 1j, because("cam_far"))
    end = board.lay_off("D", unit, slope, because("cam_slope"))
    return _made(start, point, board.join("OD", start.centre, end, because("cam_normal")))


def _normal(start: Start, point: Mark, slope: Mark) -> Mark:
    """Lay KD off from the point; OD stands along the normal."""
    end = start.board.lay_off("D", point, slope, because("cam_slope"))
    return start.board.join("OD", start.centre, end, because("cam_normal"))


def curvature(tip: Tip) -> Floats:
    """Give how the tip's curve bends, 1/m: above 0 where it is convex, infinite at a cusp."""
    first, second, _ = tip.trail
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(-tip.cam.sense * (np.conj(first) * second).imag / np.abs(first) ** 3)


def curvature_slope(tip: Tip) -> Floats:
    """Give its derivative by the turn."""
    first, second, third = tip.trail
    size = np.abs(first)
    across, turn = np.conj(first) * second, np.conj(first) * third
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(-tip.cam.sense * (turn.imag - 3 * across.imag * across.real / size**2) / size**3)


def radius(tip: Tip) -> Floats:
    """Give the radius of curvature, m: below 0 where the curve is hollow, infinite where it is straight."""
    if tip.cam.flat:
        return FaceTouch(tip).radius
    with np.errstate(divide="ignore"):
        return 1 / curvature(tip)


class OutlineSpot(NamedTuple):
    """Points of an outline in the cam, (N,): m, the unit tangent there, how fast the outline runs along it, m/rad.

    The tangent is that of the pitch curve, or lies in the flat face: where the outline turns back on itself, on a loop,
    it runs against it.
    """

    at: Points
    tangent: Points
    speed: Floats


@dataclass(frozen=True)
class CamOutline:
    """The outline that lies `away` m from the pitch curve, outward: minus the roller's radius for the profile."""

    course: FollowerCourse
    sizes: CamSizes
    away: float = 0.0

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.course.cam

    def at(self, turned: Floats, before: bool = False) -> OutlineSpot:
        """Give points at turns of the cam, (N,) rad; at a joint after it, or before it."""
        tip = Tip(self.course, self.sizes, np.asarray(turned, dtype=float), before)
        if self.cam.flat:
            touch = FaceTouch(tip)
            return self._spot(tip, touch.contact, touch.normal, touch.sweep)
        normal, speed = tip.lever / np.abs(tip.lever), np.abs(tip.lever)
        return self._spot(tip, tip.orders[0] + self.away * normal, normal, speed * (1 + self.away * curvature(tip)))

    def _spot(self, tip: Tip, place: Points, normal: Points, speed: Floats) -> OutlineSpot:
        tangent = -1j * self.cam.sense * normal * np.exp(-1j * tip.turns * tip.turned)
        return OutlineSpot(tip.on_cam(place), np.asarray(tangent), speed)

    def tip(self, turned: float) -> complex:
        """Give the place of the follower's tip in the cam at one turn, m."""
        tip = Tip(self.course, self.sizes, np.array([turned]))
        return complex(tip.on_cam(tip.orders[0])[0])


OF_RADIUS: Final = 0.7  # of the least radius of curvature: the profile does not cross itself
OF_BASE: Final = 0.4  # of the least radius R0: the roller wears as the cam does
CURVATURE, HOLLOW, WEAR, GIVEN = "curvature", "hollow", "wear", "given"


class Roller(NamedTuple):
    """A roller: its radius m, and what it was taken by."""

    radius: float
    rule: str


def roller_of(given: float | None, sharpest: float | None, base: float, hollow: float | None = None) -> Roller:
    """Take the roller that is given, or the largest that all rules allow (5.30); in a groove a hollow bounds it too.

    >>> roller_of(None, 0.02960986148, 0.03266494437).rule
    'wear'
    """
    if given is not None:
        return Roller(given, GIVEN)
    rules = [Roller(OF_RADIUS * sharpest, CURVATURE)] if sharpest is not None else []
    rules += [Roller(OF_RADIUS * hollow, HOLLOW)] if hollow is not None else []
    rules += [Roller(OF_BASE * base, WEAR)] if base > 0 else []
    return min(rules, default=Roller(0.0, CURVATURE))


def working(turned: Inversion, radius: float) -> Mark:
    """Find where the roller touches the cam: its circle is cut by the normal, on the side of the cam."""
    return _touch(turned, radius, "Q", -1.0)


def outer(turned: Inversion, radius: float) -> Mark:
    """Find where it touches the outer side of a groove."""
    return _touch(turned, radius, "Q'", 1.0)


def _touch(turned: Inversion, radius: float, name: str, side: float) -> Mark:
    board, point = turned.board, turned.point
    if radius == 0:
        return point
    if "n" not in board:
        unit = board.turn("n", turned.normal, 1 / np.abs(turned.normal.point) + 0j, because("cam_unit"))
        board.parallel("Pn", point, unit, because("cam_normal_there"))
        board.arc("r", point, radius, because("cam_roller"))
    return board.meet(name, board["Pn"], board["r"], side, because("cam_roller_touches"))


@dataclass(frozen=True)
class Profile:
    """The profile by points, with the board that they were found on."""

    contour: Contour
    drawing: Inversion


def profile(course: FollowerCourse, sizes: CamSizes, roller: float, turned: Floats, before: bool = False) -> Profile:
    """Draw the theoretical and the working profile at turns of the cam, rad, (N,), with a roller m or none."""
    tip = Tip(course, sizes, np.asarray(turned, dtype=float), before)
    drawing = inversion(tip)
    return Profile(_contour(tip, drawing, roller), drawing)


def _contour(tip: Tip, drawing: Inversion, roller: float) -> Contour:
    cam, pitch = tip.cam, _all(tip, drawing.point.point)
    lever = _all(tip, drawing.normal.point * np.conj(drawing.back))
    return Contour(
        turned=tip.turned,
        travel=tip.travel,
        tip=_all(tip, drawing.board["K"].point) if "K" in drawing.board else np.asarray(pitch * np.conj(drawing.back)),
        lever=lever,
        pitch=pitch,
        profile=_all(tip, working(drawing, roller).point),
        pressure=FaceTouch(tip).pressure if cam.flat else cam.sense * np.angle(lever / tip.heading),
        radius=radius(tip),
        sliding=np.abs(FaceTouch(tip).slip if cam.flat else slip(tip, lever, roller)),
        outer=_all(tip, outer(drawing, roller).point) if cam.closure == GROOVE and not cam.flat else None,
    )


def _all(tip: Tip, points: Vectors) -> Points:
    """Give one value a position, also where all are alike."""
    return np.broadcast_to(np.asarray(points, dtype=complex), tip.turned.shape)


def slip(tip: Tip, lever: Points, roller: float) -> Floats:
    """Give how fast the follower's surface slips on the cam, m/rad; a roller as if it were stuck on its pin."""
    turning = abs(tip.turns) - _turns_with(tip.cam) * tip.travel.slope
    return np.abs(lever) - roller * turning


def slip_slope(tip: Tip, roller: float) -> Floats:
    """Give its derivative by the turn."""
    first, second, _ = tip.trail
    along = (np.conj(first) * second).real / np.abs(first)
    return np.asarray(along + roller * _turns_with(tip.cam) * tip.travel.bend)


def _turns_with(cam: Cam) -> int:
    """Give the sense in which a roller's pin turns on the rise against the cam's: 0 of a follower that translates."""
    return cam.follower.sense if cam.rocks else 0
