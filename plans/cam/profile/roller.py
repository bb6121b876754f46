"""The roller: its radius by rule, and the working profile that it leaves (ролик, практический профиль, 5.9.5)."""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from geometry.board import Mark
from plans.cam.profile.inversion import Inversion
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
