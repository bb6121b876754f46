"""The profile of a cam by inversion, at any turns of it (профилирование кулачка методом обращения движения)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from geometry.board import Board, Mark
from geometry.meet import Vectors
from plans.cam.course import Course
from plans.cam.profile.outline import Inversion, inversion, radius
from plans.cam.profile.tip import Tip
from plans.cam.profile.touch import Touch
from plans.model.cam import GROOVE, Cam
from plans.model.cam_motion import Contour, Points, Sizes
from plans.model.motion import Floats
from plans.words.words import because

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

    @property
    def boards(self) -> tuple[Board, ...]:
        """The boards in the order of drawing."""
        return (self.drawing.board,)


def profile(course: Course, sizes: Sizes, roller: float, turned: Floats, before: bool = False) -> Profile:
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
        tip=_in_frame(tip, drawing, pitch),
        lever=lever,
        pitch=pitch,
        profile=_all(tip, working(drawing, roller).point),
        pressure=Touch(tip).pressure if cam.flat else cam.sense * np.angle(lever / tip.heading),
        radius=radius(tip),
        sliding=np.abs(Touch(tip).slip if cam.flat else slip(tip, lever, roller)),
        outer=_all(tip, outer(drawing, roller).point) if cam.closure == GROOVE and not cam.flat else None,
    )


def _all(tip: Tip, points: Vectors) -> Points:
    """Give one value a position, also where all are alike."""
    return np.broadcast_to(np.asarray(points, dtype=complex), tip.turned.shape)


def _in_frame(tip: Tip, drawing: Inversion, pitch: Points) -> Points:
    """Give the tips in the frame: as they were laid off, or where a face touches, turned back."""
    return _all(tip, drawing.board["K"].point) if "K" in drawing.board else np.asarray(pitch * np.conj(drawing.back))


def slip(tip: Tip, lever: Points, roller: float) -> Floats:
    """Give how fast the follower's surface slips on the cam, m/rad; a roller as if it were stuck on its pin."""
    own = abs(tip.turns) - _turns_with(tip.cam) * tip.travel.slope
    return np.abs(lever) - roller * own


def slip_slope(tip: Tip, roller: float) -> Floats:
    """Give its derivative by the turn."""
    first, second, _ = tip.trail
    along = (np.conj(first) * second).real / np.abs(first)
    return np.asarray(along + roller * _turns_with(tip.cam) * tip.travel.bend)


def _turns_with(cam: Cam) -> int:
    """Give the sense in which a roller's pin turns on the rise against the cam's: 0 of a follower that translates."""
    return cam.follower.sense if cam.rocks else 0
