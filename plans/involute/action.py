"""The line of action by construction: common tangent of the base circles, active part, sliding (линия зацепления)."""

from __future__ import annotations

import cmath
import math
from functools import cached_property
from typing import Final

from geometry.board import Board, Mark, Reading, between
from plans.model.involute import EPS, GearWheel, InvolutePair
from plans.words.words import because

MESH: Final = "involute"  # the board and the plan, m
TRIALS = 60  # each halves an interval: the last is one rounding


def opened(slope: float) -> float:
    """Give by how much an involute has turned away where its string is so many base radii long, rad.

    >>> round(opened(math.tan(math.radians(20))), 6)
    0.014904
    """
    return slope + cmath.phase(1 - 1j * slope)  # the string is unrolled, and the point seen from the centre


def half_at_base(wheel: GearWheel) -> float:
    """Give half the angle of a tooth, of an internal wheel's space, on the base circle, rad."""
    return wheel.width / (2 * wheel.radius) + opened(math.tan(wheel.rack.angle))


def rolled(value: float) -> float:
    """Give how many base radii the string is long of an involute that has turned away so far: found by trial.

    >>> round(math.degrees(math.atan(rolled(0.014904384))), 6)
    20.0
    """
    low, high = 0.0, 1.0
    while opened(high) < value:
        high *= 2
    for _ in range(TRIALS):
        middle = (low + high) / 2
        low, high = (middle, high) if opened(middle) < value else (low, middle)
    return (low + high) / 2


def closing(pair: InvolutePair) -> float:
    """Give by how much involutes have turned away on the operating circles where flanks touch on both sides, rad."""
    first, second = pair.wheels
    halves = half_at_base(second) * second.teeth + pair.sense * half_at_base(first) * first.teeth
    return (halves - (math.pi if pair.sense > 0 else 0.0)) / (second.teeth + pair.sense * first.teeth)


def string(wheel: GearWheel, radius: float) -> float:
    """Give how many base radii the string is long whose end is so far from the centre, m."""
    return math.sqrt(max((radius / wheel.base) ** 2 - 1, 0.0))


def apart(first: Mark, last: Mark) -> float:
    """Measure the distance of two marks, m."""
    return abs(complex(last.point) - complex(first.point))


class LineOfAction:
    """The line of action of a pair, on a board: P is the origin, the line of centres upright, wheel 1 below."""

    def __init__(self, pair: InvolutePair) -> None:
        self.pair, self.board = pair, Board(MESH)
        (first, second), board, sense = pair.wheels, self.board, pair.sense
        angle = math.atan(rolled(closing(pair)))  # at which flanks touch on both sides
        self.distance = distance = (second.base + sense * first.base) / math.cos(angle)
        share = first.teeth / (second.teeth + sense * first.teeth)
        down = board.given("O_1", -1j * distance * share, because("involute_centre", wheel=1))
        up = board.given("O_2", 1j * distance * (sense - share), because("involute_apart"))
        self.centres = down, up
        for wheel, centre in zip((first, second), self.centres, strict=True):
            board.arc(f"d_b{wheel.number}", centre, wheel.base, because("involute_base", wheel=wheel.number))
        offset = second.base * sense + first.base
        self.way = board.tangent("t", down, up, offset, float(sense), because("involute_tangent"))
        self.normals = tuple(
            board.turn(
                f"O_{wheel.number}N_{wheel.number}", self.way, 1j * side * wheel.base, because("involute_radius")
            )
            for wheel, side in zip((first, second), (1, -sense), strict=True)
        )
        self.ends = tuple(
            board.lay_off(f"N_{number}", centre, radius, because("involute_touch"))
            for number, (centre, radius) in enumerate(zip(self.centres, self.normals, strict=True), 1)
        )
        self.line = board.parallel("N_1N_2", self.ends[0], self.way, because("involute_line"))
        upright = board.parallel(
            "O_1O_2", down, board.join("a_w", down, up, because("involute_apart")), because("involute_axis")
        )
        self.pole = board.meet("P", upright, self.line, why=because("involute_pole"))

    @property
    def angle(self) -> float:
        """The angle of action α_w, as it is drawn, rad."""
        return cmath.phase(complex(self.way.point))

    def _to(self, end: int, mark: Mark) -> float:
        """Give how far along the line a mark is from where that touches a base circle, m."""
        off = complex(between(self.ends[end], mark)) * complex(self.way.point).conjugate()
        return off.real

    @cached_property
    def tips(self) -> tuple[float, float]:
        """The tip radii, m: each leaves the clearance to the other's root; an internal wheel clears the fillet too."""
        rack, relief = self.pair.rack, self.pair.tip_relief
        first = self.pair.wheels[0]
        head = first.radius + rack.module * (rack.head + first.shift)
        if self.pair.internal:
            return head, self.roots[0] + self.distance + rack.module * (rack.clearance + relief)
        gap = rack.module * rack.clearance
        return self.distance - self.roots[1] - gap, self.distance - self.roots[0] - gap

    @cached_property
    def roots(self) -> tuple[float, float]:
        """The root radii, m: as deep as the rack goes."""
        rack, (first, second) = self.pair.rack, self.pair.wheels
        deep = (rack.head + rack.clearance) * rack.module
        shifts = [wheel.shift * rack.module for wheel in (first, second)]
        return first.radius - deep + shifts[0], second.radius - second.inward * deep + shifts[1]

    @cached_property
    def active(self) -> tuple[Mark, Mark]:
        """B_1 and B_2: where the tip circles of wheel 2 and of wheel 1 cut the line."""
        return self._tip("B_1", 2, -self.pair.sense), self._tip("B_2", 1, 1)

    def _tip(self, name: str, number: int, side: int) -> Mark:
        centre, radius = self.centres[number - 1], self.tips[number - 1]
        tip = self.board.arc(f"d_a{number}", centre, radius, because("involute_tip", wheel=number))
        return self.board.meet(name, self.line, tip, float(side), because("involute_active", wheel=number))

    @cached_property
    def strings(self) -> tuple[float, float]:
        """How long the string is at each tip, m: from N_1 to B_2, and from N_2 to B_1."""
        start, end = self.active
        return self._to(0, end), -self.pair.sense * self._to(1, start)

    @property
    def length(self) -> float:
        """The length of the active part, measured, m."""
        return self.strings[0] - self.feet[0]

    @cached_property
    def feet(self) -> tuple[float, float]:
        """How long the string is where the other's tip meets each flank, m."""
        start, end = self.active
        return self._to(0, start), -self.pair.sense * self._to(1, end)

    @property
    def sliding(self) -> tuple[float, float]:
        """The specific sliding at the foot of each flank, by segments of the line: 1 - u N2B/N1B."""
        ratio = self.pair.teeth[0] / self.pair.teeth[1]
        return 1 - ratio * self.strings[1] / self.feet[0], 1 - self.strings[0] / (ratio * self.feet[1])

    def slid(self, end: int) -> Reading:
        """What 1 less the sliding at the foot of a flank is read from: u N2B square to the line, over N1B."""
        spot, name, board = self.active[end], f"λ_B{end + 1}", self.board
        ratio = self.pair.teeth[end] / self.pair.teeth[1 - end]
        arm = board.join(f"{name}:N", self.ends[end], spot, because("involute_curved"))
        other = board.join(f"{name}:N'", spot, self.ends[1 - end], because("involute_curved"))
        return Reading(arm, board.turn(name, other, 1j * ratio, because("involute_slides")))


# By how many roundings a size may be off: sums and roots of a few, and a meeting of a line and an arc.
ROUNDINGS = 64.0


def slack(pair: InvolutePair, angle: float) -> float:
    """Give how far rounding may move a place, m: the involute function is flat where the angle is small."""
    flat = math.sin(angle) * math.tan(angle)
    return ROUNDINGS * EPS * max(wheel.base for wheel in pair.wheels) / min(flat, 1.0)
