"""Flanks unrolled off the base circles, and what is measured on them: thickness, chord, span, pins (эвольвенты)."""

from __future__ import annotations

import cmath
import math
from functools import cached_property
from typing import NamedTuple

from geometry.board import Mark
from plans.involute.action import LineOfAction, apart, half_at_base, rolled, string
from plans.involute.limits import lowest
from plans.model.involute import GearWheel
from plans.words.words import because

DIVISIONS = 6  # equal arcs of the base circle from which a flank is unrolled


class Unrolled(NamedTuple):
    """A point of a flank: where the string leaves the base circle, and its end."""

    leaves: Mark
    end: Mark


class Flanks:
    """Both flanks of the tooth of a wheel that touches in P, of an internal wheel those of the space there."""

    def __init__(self, action: LineOfAction, wheel: GearWheel) -> None:
        self.action, self.wheel, self.board = action, wheel, action.board
        k = wheel.number - 1
        self.centre, self.tip, self.root = action.centres[k], action.tips[k], action.roots[k]
        self.operating = apart(self.centre, action.pole)
        self.half = half_at_base(wheel)
        turned = cmath.exp(-1j * apart(action.ends[k], action.pole) / wheel.base)
        self.start = self.board.turn(f"O_{wheel.number}E", action.normals[k], turned, because("involute_start"))
        far = cmath.exp(2j * self.half)
        self.other = self.board.turn(f"O_{wheel.number}E'", self.start, far, because("involute_other"))

    def at(self, name: str, slope: float, side: int = 1, start: Mark | None = None) -> Unrolled:
        """Unroll a string of so many base radii: on the side of wheel 1's driving flank, or -1 on the other."""
        board, number = self.board, self.wheel.number
        begin = start or (self.start if side > 0 else self.other)
        arm = board.turn(f"{name}:r", begin, cmath.exp(1j * side * slope), because("involute_arc"))
        leaves = board.lay_off(f"{name}:K", self.centre, arm, because("involute_leaves", wheel=number))
        line = board.turn(f"{name}:s", arm, -1j * side * slope, because("involute_string"))
        return Unrolled(leaves, board.lay_off(name, leaves, line, because("involute_end")))

    def _both(self, name: str, slope: float) -> tuple[Mark, Mark]:
        """Unroll a string on either side."""
        return self.at(name, slope).end, self.at(f"{name}'", slope, -1).end

    def holds(self, long: float) -> bool:
        """Tell whether the end of a string, m, lies on the involute: between the fillet and the tip."""
        return (long - lowest(self.wheel, self.root)) * (long - self.wheel.base * string(self.wheel, self.tip)) <= 0

    @cached_property
    def points(self) -> tuple[Unrolled, ...]:
        """The points of the flank that touches in P, by equal arcs to the tip."""
        last, name = string(self.wheel, self.tip), f"E_{self.wheel.number}"
        return tuple(self.at(f"{name},{k}", last * k / DIVISIONS) for k in range(1, DIVISIONS + 1))

    def tooth(self, name: str, radius: float) -> float:
        """Measure the thickness of a tooth on a circle: of an internal wheel what the space leaves of the pitch, m."""
        ends = self._both(name, string(self.wheel, radius))
        first, last = (complex(end.point) - complex(self.centre.point) for end in ends)
        arc = radius * cmath.phase(last / first)
        return math.tau * radius / self.wheel.teeth - arc if self.wheel.internal else arc

    @property
    def has_chord(self) -> bool:
        """Whether the constant chord ends on the involute; of an internal wheel none is measured."""
        return not self.wheel.internal and self.holds(self.wheel.base * (self.half + self.wheel.rack.angle))

    @cached_property
    def chord(self) -> tuple[Mark, Mark]:
        """The ends of the constant chord: where normals through the tooth's middle on the pitch circle end."""
        return self._both(f"C_{self.wheel.number}", self.half + self.wheel.rack.angle)

    @property
    def chord_height(self) -> float:
        """The height of the constant chord under the tip, m."""
        middle = sum(complex(end.point) for end in self.chord) / 2
        return self.tip - abs(middle - complex(self.centre.point))

    @cached_property
    def span(self) -> tuple[Mark, Mark]:
        """The ends of the common normal over some teeth, of an internal wheel spaces (общая нормаль)."""
        over = self.wheel.spanned
        slope = self.half + (over - 1) * math.pi / self.wheel.teeth
        name, turned = f"W_{self.wheel.number}", cmath.exp(2j * math.pi * (over - 1) / self.wheel.teeth)
        last = self.board.turn(f"{name}:E'", self.other, turned, because("involute_over", count=over))
        return self.at(name, slope).end, self.at(f"{name}'", slope, -1, last).end

    def _free(self, pin: float) -> float:
        """Give the involute function at the centre of a pin that touches both sides of a space."""
        off = pin / 2 / self.wheel.base * self.wheel.inward
        return self.half + off - (0.0 if self.wheel.internal else math.pi / self.wheel.teeth)

    def _measures(self, pin: float) -> bool:
        """Tell whether pins touch involutes and stand over the tips."""
        base, inward, teeth = self.wheel.base, self.wheel.inward, self.wheel.teeth
        slope, across = rolled(self._free(pin)), math.cos(math.pi / 2 / teeth) if teeth % 2 else 1.0
        stands = base * math.hypot(1.0, slope) * across + inward * pin / 2
        return self._free(pin) > 0 and self.holds(base * slope - inward * pin / 2) and (stands - self.tip) * inward > 0

    @cached_property
    def pin(self) -> float:
        """The diameter of the first pins by which the wheel can be measured, m; NaN where none do."""
        return next((pin for pin in self.wheel.pins if self._measures(pin)), math.nan)

    @cached_property
    def pins(self) -> tuple[Mark, Mark]:
        """The centres of two pins that lie in spaces across the wheel, between both flanks."""
        wheel, number = self.wheel, self.wheel.number
        # The string ends in the pin's centre, longer than the flank's by its radius, or shorter within a ring's space
        off = self.pin / 2 / wheel.base * wheel.inward
        start = self.board.turn(f"M_{number}:E", self.start, cmath.exp(-1j * off), because("involute_pin"))
        first = self.at(f"M_{number}", rolled(self._free(self.pin)), 1, start).end
        across = -1 if wheel.teeth % 2 == 0 else -cmath.exp(1j * math.pi / wheel.teeth)
        arm = self.board.join(f"M_{number}:a", self.centre, first, because("involute_pin"))
        other = self.board.turn(f"M_{number}':a", arm, across, because("involute_across"))
        return first, self.board.lay_off(f"M_{number}'", self.centre, other, because("involute_across"))

    @property
    def over(self) -> float:
        """The size over the pins, of an internal wheel between them, m."""
        return math.nan if math.isnan(self.pin) else apart(*self.pins) + self.wheel.inward * self.pin
