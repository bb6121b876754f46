"""Radii of curvature of the theoretical profile: everywhere, and by the circle through three points (5.9.5)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from geometry.board import Board, Mark
from plans.cam.profile.inversion import inversion
from plans.cam.profile.tip import Tip
from plans.cam.profile.touch import Touch
from plans.model.motion import Floats
from plans.words.words import because

CIRCLE = "curvature"


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
        return Touch(tip).radius
    with np.errstate(divide="ignore"):
        return 1 / curvature(tip)


class ThreePoints(NamedTuple):
    """A circle through three points of the profile: its board, its centre, its radius m."""

    board: Board
    centre: Mark
    radius: float


def three_points(tip: Tip) -> ThreePoints:
    """Draw the circle through the points at three turns: two perpendiculars at the middles of the chords meet."""
    points = np.asarray(inversion(tip).point.point)
    board = Board(CIRCLE)
    a, b, c = (
        board.given(name, complex(point), because("cam_near_point")) for name, point in zip("abc", points, strict=True)
    )
    centre = board.meet("C", _bisector(board, a, b), _bisector(board, b, c), why=because("cam_bisectors"))
    return ThreePoints(board, centre, abs(complex(centre.point) - complex(b.point)))


def _bisector(board: Board, start: Mark, end: Mark) -> Mark:
    name = start.name + end.name
    chord = board.join(name, start, end, because("cam_chord"))
    half = board.turn(f"{name}/2", chord, 0.5, because("cam_half"))
    middle = board.lay_off(f"m{name}", start, half, because("cam_half"))
    return board.square(f"⊥{name}", middle, chord, because("cam_bisector"))
