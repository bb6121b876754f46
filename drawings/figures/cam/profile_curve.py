"""The profile of a cam as a stroke that can be measured: arcs and cubics, and how far they are off (профиль)."""

from __future__ import annotations

import cmath
import math

from drawings.figures.cam.profile_view import QUANTITY, UNIT
from drawings.layout.place import Place
from drawings.paper.strokes import Curve, Group, LineStyle, numeral, stated
from drawings.symbols.dashes import fit_dashes
from plans.cam.path import ProfilePath

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
