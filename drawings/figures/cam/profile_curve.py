"""The profile of a cam as a stroke that can be measured: true arcs and cubics, with their stated deviation (профиль)."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

from drawings.paper.strokes import Curve, Group, LineStyle, numeral
from plans.cam.path import ProfilePath

TOLD = 2  # digits of a stated deviation


class ProfilePlace(NamedTuple):
    """Where a cam is drawn: its centre on paper mm, m to the mm, degrees by which it is turned from its start."""

    plan: str
    centre: complex
    scale: float
    turned: float = 0.0


def profile_curve(path: ProfilePath, place: ProfilePlace, name: str, style: LineStyle) -> Group:
    """Draw a path of a cam; `name` is "profile", "pitch" or "outer"."""
    turn = cmath.exp(1j * math.radians(place.turned)) / place.scale
    pieces = tuple(piece.placed(turn, place.centre) for piece in path.pieces)
    data = {
        "kind": "profile",
        "plan": place.plan,
        "quantity": "profile",
        "name": name,
        "unit": "m",
        "scale": numeral(place.scale),
        "deviation": numeral(upward(path.deviation)),
        **({"turned": numeral(place.turned)} if place.turned else {}),
    }
    return Group((Curve(pieces, path.closed, style),), data=data)


def upward(value: float) -> float:
    """Round a deviation to a few digits, never to a lesser one.

    >>> upward(8.24e-08), upward(0.0)
    (8.3e-08, 0.0)
    """
    if value == 0:
        return 0.0
    digit = math.floor(math.log10(value)) + 1 - TOLD
    return float(f"{math.ceil(value * 10.0**-digit)}e{digit}")
