"""The self-check of the view of a rotor across the shaft: shaft, bearings, planes, masses, arms (вид сбоку)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from drawings.checks.graphs.figure_strokes import FLUSH, figure
from drawings.checks.line_kind import THIN, TWO_DOTS, Kind
from drawings.checks.reading import reads
from drawings.checks.rotor.rotor_bodies import BodyAtRest
from drawings.checks.rotor.rotor_seen import RotorSeen
from drawings.checks.wrong import Wrong, on
from drawings.lettering.rotor_letters import index
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Line, Text
from plans.model.rotor import Balance, Rotor
from plans.rotor.bearings import BEARINGS
from plans.rotor.letters import ALONE

ARMS = 9  # different arms: of more the table tells them
DIGITS = 4  # of a dimension
PLANE = Kind((THIN,), TWO_DOTS)  # the line of a plane that is no part of the rotor
OVER = 6.0  # mm from a dimension line up to its number
STILL = math.radians(1.0)  # by which the letter of the turning may stand off the middle of its arrow


def across(leaf: Leaf, name: str, rotor: Rotor, balance: Balance, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the view across the shaft."""
    strokes = figure(leaf, name)
    if strokes is not None:
        yield from _Across(name, strokes, rotor, balance, drafting).faults()


class _Across(RotorSeen):
    """The view across the shaft."""

    def faults(self) -> Iterator[Wrong]:
        own, plan, last = self.inventory, self.plan, self.rotor.planes[-1]
        self.headed("view across", True)
        base = self.zero + float(last.place) / self.mu
        own.circle(base, on("missing_on", plan, name="O"))
        own.letter("O", [base], on("letter", plan, name="O"))
        self.masses()
        for one in (one for one in self.bodies if one.distinct):
            foot = complex(self.spot(one).real, self.zero.imag)
            self.radius(one, foot, False)
        self._dimensions(base)
        half = self._shaft()
        self._bearings(half)
        for plane in self.rotor.planes:
            self._plane(plane.name, self.zero + float(plane.place) / self.mu)
        return own.faults()

    def _shaft(self) -> float:
        """Hold the axis, both rims past all that the shaft bears, and its ends; give half its thickness, mm."""
        places = [one.place for one in self.rotor.masses] + [one.place for one in self.rotor.planes]
        places += self.rotor.bearings
        low, high = (self.zero.real + float(end(places)) / self.mu for end in (min, max))
        long = [one for one in self.inventory.left(Line) if self._level(one) and _spans(one, low, high)]
        rims = sorted({round(abs((one.start - self.zero).imag), 6) for one in long} - {0.0})
        if len(long) != len(("axis", "rim", "rim")) or len(rims) != 1:
            self.inventory.wrong.append(on("shaft", self.plan))
            return 0.0
        self.inventory.every(Line, lambda one: one in long)
        ends = {round(end.real, 6) for one in long if abs((one.start - self.zero).imag) > FLUSH for end in _ends(one)}
        for x in ends:
            self.inventory.line(complex(x, self.zero.imag - rims[0]), complex(x, self.zero.imag + rims[0]),
                                on("shaft", self.plan))  # fmt: skip
        return rims[0]

    def _level(self, one: Line) -> bool:
        return abs((one.end - one.start).imag) <= FLUSH

    def _bearings(self, half: float) -> None:
        """Hold the shells over and under the shaft with their hatching, and their letters."""
        for name, place in zip(BEARINGS, self.rotor.bearings, strict=False):
            middle, wrong = self.zero + float(place) / self.mu, on("bearing", self.plan, name=name)
            shells = [self._shell(middle, half, side, wrong) for side in (1, -1)]
            if shells[0] != shells[1]:
                self.inventory.wrong.append(wrong)
            low = [middle - 1j * (half + gap) for gap in (2.0, 4.0, 6.0)]
            self.inventory.letter(name, low, on("letter", self.plan, name=name))

    def _shell(self, middle: complex, half: float, side: int, wrong: Wrong) -> int:
        """Tick off a shell on one side of the shaft; give how many lines of hatching it has."""

        def holds(one: Line) -> bool:
            off = (one.start + one.end) / 2 - middle
            return self._level(one) and abs(off.real) <= FLUSH and half < side * off.imag < 2 * half

        base = self.inventory.take(Line, holds, wrong)
        if base is None:
            return 0
        hatched = self.inventory.every(Line, lambda one: _hatches(one, base, side))
        return len(hatched)

    def _plane(self, name: str, spot: complex) -> None:
        """Hold the line of a plane of correction, beyond the outermost mass on both sides, and its letter."""
        far = max((abs(self.spot(one).imag - self.zero.imag) for one in self.bodies if one.known), default=0.0)

        def holds(one: Line) -> bool:
            upright = max(abs(end.real - spot.real) for end in _ends(one)) <= FLUSH
            placed = upright and self.inventory.at((one.start + one.end) / 2, spot) and abs(one.end - spot) > far
            return placed and PLANE.takes(one, self.drafting.hand)

        line = self.inventory.take(Line, holds, on("plane", self.plan, name=name))
        if name != ALONE and line is not None:
            top = max(_ends(line), key=lambda end: end.imag)
            self.inventory.letter(name, [top], on("letter", self.plan, name=name))

    def _dimensions(self, base: complex) -> None:
        """Hold the dimensions of the arms: number, both arrows, the line, what leads to it."""
        arms: dict[float, list[BodyAtRest]] = {}
        for one in self.bodies:
            if one.arm and not (one.added and one.name == self.rotor.planes[-1].name):
                arms.setdefault(one.arm, []).append(one)
        if not arms or len(arms) > ARMS:
            return
        levels = [self._arm(arm, own, base) for arm, own in arms.items()]
        self._extension(base.real, min(levels), on("size", self.plan, name="h"))

    def _arm(self, arm: float, own: list[BodyAtRest], base: complex) -> float:
        """Hold a dimension; give the height of its line."""
        names = " = ".join(f"h{index(one.name, self.drafting.language)}" for one in own)
        wrong, across = on("size", self.plan, name=names), base.real + arm / self.mu
        start = f"{names} = "
        told = self.inventory.take(Text, lambda one: one.plain.startswith(start) and reads(
            one.plain[len(start):], 1000 * abs(arm), 0.0, DIGITS), wrong)  # fmt: skip
        if told is None:
            return base.imag
        line = self.inventory.take(Line, lambda one: self._level(one) and 0 < told.at.imag - one.start.imag < OVER
                                   and _between(one, told.at.real), wrong)  # fmt: skip
        if line is None:
            return base.imag
        level = line.start.imag
        sides = {side: self._tip(complex(x, level)) for side, x in (("base", base.real), ("far", across))}
        outward = math.copysign(1.0, arm)
        if sides not in ({"base": -outward, "far": outward}, {"base": outward, "far": -outward}):
            self.inventory.wrong.append(wrong)
        self._extension(across, level, wrong)
        return level

    def _tip(self, spot: complex) -> float:
        """Tick off the arrowhead at one end of a dimension; give its sense, 0 where there is none."""
        ways = (way for way in (1.0, -1.0) if self.inventory.head(spot, complex(way)) is not None)
        return next(ways, 0.0)

    def _extension(self, x: float, level: float, wrong: Wrong) -> None:
        """Hold the upright line that leads down to a dimension, a little past it."""

        def holds(one: Line) -> bool:
            low, high = sorted(end.imag for end in _ends(one))
            return max(abs(end.real - x) for end in _ends(one)) <= FLUSH and low < level < high and low > level - OVER

        self.inventory.take(Line, holds, wrong)


def _ends(one: Line) -> tuple[complex, complex]:
    return one.start, one.end


def _spans(one: Line, low: float, high: float) -> bool:
    left, right = sorted(end.real for end in _ends(one))
    return left < low - FLUSH and right > high + FLUSH


def _between(one: Line, x: float) -> bool:
    left, right = sorted(end.real for end in _ends(one))
    return left - OVER <= x <= right + OVER


def _hatches(one: Line, base: Line, side: int) -> bool:
    """Tell whether a slanting line ends on a shell, beyond it."""
    for foot, far in (_ends(one), _ends(one)[::-1]):
        level = abs((foot - base.start).imag) <= FLUSH and side * (far - foot).imag > FLUSH
        if level and _between(base, foot.real) and abs(cmath.phase((far - foot) ** 4 / -1)) <= STILL:
            left, right = sorted(end.real for end in _ends(base))
            return left - FLUSH <= foot.real <= right + FLUSH
    return False
