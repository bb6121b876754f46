"""Generation by a rack: where its flank and the corner of its tip touch the wheel, position by position (огибание)."""

from __future__ import annotations

import cmath
import math
from typing import Final, NamedTuple

import numpy as np

from geometry.board import Board, Mark
from plans.involute.action import string
from plans.involute.limits import lowest
from plans.model.involute import HALVINGS, GearWheel
from plans.model.motion import Complexes, Floats
from plans.words.words import because

GENERATION: Final = "generation"  # the board and the plan, m: the wheel's centre is the origin


class Generated(NamedTuple):
    """The right side of a space as the rack leaves it, its middle above the wheel's centre, m.

    The points go from the root circle over the fillet to the involute, and on to the tip circle.
    """

    fillet: Mark
    involute: Mark

    @property
    def points(self) -> Complexes:
        """All points from the root to the tip."""
        return np.concatenate([np.atleast_1d(self.fillet.point), np.atleast_1d(self.involute.point)[1:]])


def generated(wheel: GearWheel, tip: float, count: int, board: Board) -> Generated:
    """Let the rack roll on the wheel, and mark where it touches: on the normal through the pole P_0."""
    rack, m = wheel.rack, wheel.rack.module
    pole = board.given("P_0", 1j * wheel.radius, because("involute_machine_pole"))
    lean, depth = _joined(wheel)
    highest = wheel.radius * math.sin(rack.angle) - math.sqrt(tip**2 - wheel.base**2)
    normal = complex(math.cos(rack.angle), -math.sin(rack.angle))
    strings = np.linspace(depth, highest, count)
    half = math.pi * m / 4 * normal.real + wheel.shift * m * normal.imag  # to the flank of a rack in the middle
    rolled = (strings - half) / normal.real
    along = board.given("n", normal, because("involute_machine_normal"))
    line = board.parallel("P_0n", pole, along, because("involute_machine_line"))
    place = board.given("A", 1j * (wheel.radius + wheel.shift * m) + math.pi * m / 4 + rolled, because("involute_rack"))
    flank = board.square("rack", place, along, because("involute_rack_flank"))
    touch = board.meet("T", line, flank, why=because("involute_rack_touches"))
    return Generated(_fillet(board, wheel, pole, lean, count), _back(board, "profile", touch, rolled / wheel.radius))


def _joined(wheel: GearWheel) -> tuple[float, float]:
    """Give the corner's normal, and how far from P_0 the flank touches, where the fillet ends: undercut, it crosses."""
    rack, m, r = wheel.rack, wheel.rack.module, wheel.radius
    leg, sine, slant = (rack.straight - wheel.shift) * m, math.sin(rack.angle), cmath.exp(-1j * rack.angle)
    low, high, far = rack.angle, math.pi / 2, leg / sine
    for _ in range(HALVINGS if far > r * sine else 0):
        lean = (low + high) / 2
        centre = (leg - rack.rounding * m * sine) / math.sin(lean)
        spot = 1j * r + (centre + rack.rounding * m) * cmath.exp(-1j * lean)
        long = math.sqrt(max(abs(spot) ** 2 - wheel.base**2, 0.0))
        rolled = r * sine - long - math.pi * m / 4 * slant.real - wheel.shift * m * slant.imag
        flank = (1j * r + (r * sine - long) * slant) * cmath.exp(1j * rolled / slant.real / r)
        spot *= cmath.exp(1j * (centre * math.cos(lean) - rack.land * m) / r)
        low, high = (lean, high) if long and cmath.phase(spot / flank) > 0 else (low, lean)
        far = r * sine - long
    return low, far


def _fillet(board: Board, wheel: GearWheel, pole: Mark, last: float, count: int) -> Mark:
    """Mark where the rounded corner touches: on the line from P_0 through its centre."""
    rack, m = wheel.rack, wheel.rack.module
    normals = np.exp(-1j * np.linspace(math.pi / 2, last, count))
    high = wheel.radius + (wheel.shift - rack.straight + rack.rounding * math.sin(rack.angle)) * m
    along = board.given("n_c", normals, because("involute_corner_normal"))
    path = board.parallel("c", board.given("c_0", 1j * high, because("involute_corner")), board.given("x", 1 + 0j))
    centre = board.meet("C", board.parallel("P_0C", pole, along), path, why=because("involute_corner_place"))
    arm = board.turn("CT", along, rack.rounding * m, because("involute_corner_radius"))
    touch = board.lay_off("T_c", centre, arm, because("involute_rack_touches"))
    rolled = np.asarray(centre.point).real - rack.land * m
    return _back(board, "fillet", touch, rolled / wheel.radius)


def _back(board: Board, name: str, touch: Mark, turned: Floats) -> Mark:
    """Turn places back with the wheel: it has turned clockwise as far as the rack has rolled."""
    arm = board.join(f"{name}:a", board.given(f"{name}:O", 0j), touch)
    return board.turn(name, arm, np.exp(1j * turned), because("involute_turned_back"))


def ring(wheel: GearWheel, half: float, radii: tuple[float, float], count: int) -> Complexes:
    """Give the right side of a space of an internal wheel, from the root to the tip, unrolled off its base circle, m.

    A corner of the tool lies at the end of its flank: the string to its centre is shorter by its radius.
    """
    tip, root = radii
    corner = wheel.corner(root)
    start = 1j * cmath.exp(-1j * half) * wheel.base
    last = lowest(wheel, root) / wheel.base
    slopes = np.linspace(last, string(wheel, tip), count)
    flank = start * np.exp(1j * slopes) * (1 - 1j * slopes)
    arm = start * cmath.exp(1j * last)
    centre = arm * (1 - 1j * (last - corner / wheel.base))
    sweep = cmath.phase(-1j * arm / centre)
    arc = centre + corner * centre / abs(centre) * np.exp(1j * sweep * np.linspace(0, 1, count))
    return np.concatenate([arc, flank[1:]])
