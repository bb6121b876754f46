"""The motor (двигатель): its moment over its angular speed by one of four laws, brought to the crank's shaft.

Speeds are rad/s, moments N*m; both are positive in the sense in which the motor drives.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from itertools import pairwise
from typing import NamedTuple, Protocol


class MotorLaw(Protocol):
    """The moment of a motor over its speed (механическая характеристика)."""

    def moment(self, speed: float) -> float:
        """Give the moment at a speed."""

    def slope(self, speed: float) -> float:
        """Give the derivative of the moment by the speed, N*m*s."""

    def speed(self, moment: float) -> float | None:
        """Give the greatest speed at which a moment is borne and the motor is stable there; None where there is none.

        A constant moment has no speed of its own.
        """

    @property
    def steepness(self) -> float:
        """The steepest fall of the moment by the speed, N*m*s, not negative (жёсткость характеристики)."""


class Constant(NamedTuple):
    """A moment that does not depend on the speed."""

    value: float

    def moment(self, speed: float) -> float:
        """Give the moment at a speed."""
        return self.value

    def slope(self, speed: float) -> float:
        """Give the derivative of the moment by the speed."""
        return 0.0

    def speed(self, moment: float) -> float | None:
        """Give no speed: any one will do, or none."""
        return None

    @property
    def steepness(self) -> float:
        """No fall."""
        return 0.0


class Linear(NamedTuple):
    """A straight line from the starting moment to the synchronous speed: M = M_0 (1 - omega/omega_s).

    >>> Linear(60.0, 20.0).moment(5.0), Linear(60.0, 20.0).speed(15.0)
    (45.0, 15.0)
    """

    starting: float
    synchronous: float

    def moment(self, speed: float) -> float:
        """Give the moment at a speed."""
        return self.starting * (self.synchronous - speed) / self.synchronous

    def slope(self, speed: float) -> float:
        """Give the derivative of the moment by the speed."""
        return -self.steepness

    def speed(self, moment: float) -> float | None:
        """Give the speed at which a moment is borne; None where even the starting moment is too small."""
        return self.synchronous * (1 - moment / self.starting) if moment <= self.starting else None

    @property
    def steepness(self) -> float:
        """The fall, the same at any speed."""
        return self.starting / self.synchronous


class Kloss(NamedTuple):
    """An induction motor by Kloss' formula (формула Клосса): M = 2 M_k/(s/s_k + s_k/s), slip s = 1 - omega/omega_s.

    `breakdown` is the greatest moment M_k (критический момент), `slip` the slip s_k at which it is.

    >>> Kloss(60.0, 0.2, 100.0).moment(80.0), Kloss(60.0, 0.2, 100.0).moment(100.0)
    (60.0, 0.0)
    """

    breakdown: float
    slip: float
    synchronous: float

    def moment(self, speed: float) -> float:
        """Give the moment at a speed; the formula is written so that no slip, too, has its moment."""
        s, most = self._slip(speed), self.slip
        return 2 * self.breakdown * s * most / (s * s + most * most)

    def slope(self, speed: float) -> float:
        """Give the derivative of the moment by the speed."""
        s, most = self._slip(speed), self.slip
        by_slip = 2 * self.breakdown * most * (most * most - s * s) / (s * s + most * most) ** 2
        return -by_slip / self.synchronous

    def speed(self, moment: float) -> float | None:
        """Give the speed on the stable branch at which a moment is borne; None above the breakdown moment."""
        if abs(moment) > self.breakdown:
            return None
        if moment == 0.0:
            return self.synchronous
        over = self.breakdown / moment
        far = math.sqrt((over - 1) * (over + 1))
        return self.synchronous * (1 - self.slip / (over + math.copysign(far, over)))

    @property
    def steepness(self) -> float:
        """The fall at the synchronous speed."""
        return 2 * self.breakdown / (self.slip * self.synchronous)

    def _slip(self, speed: float) -> float:
        return (self.synchronous - speed) / self.synchronous


class Tabled(NamedTuple):
    """A law by points, straight between them; beyond the last point, and below the first, its nearest line goes on.

    >>> Tabled((0.0, 10.0, 20.0), (40.0, 60.0, 10.0)).moment(15.0)
    35.0
    >>> Tabled((0.0, 10.0, 20.0), (40.0, 60.0, 10.0)).speed(0.0)
    22.0
    """

    speeds: tuple[float, ...]  # rising
    moments: tuple[float, ...]

    def moment(self, speed: float) -> float:
        """Give the moment at a speed."""
        k = self._line(speed)
        return self.moments[k] + self._slope(k) * (speed - self.speeds[k])

    def slope(self, speed: float) -> float:
        """Give the derivative of the moment by the speed; at a point, that of the line after it."""
        return self._slope(self._line(speed))

    def speed(self, moment: float) -> float | None:
        """Give the greatest speed at which a line that falls bears a moment; None where none does."""
        lines = len(self.speeds) - 1
        for k in reversed(range(lines)):
            if self._slope(k) < 0:
                found = self.speeds[k] + (moment - self.moments[k]) / self._slope(k)
                if self.speeds[k] <= found and (k == lines - 1 or found <= self.speeds[k + 1]):
                    return found
        return None

    @property
    def steepness(self) -> float:
        """The steepest line that falls."""
        return max(0.0, *(-self._slope(k) for k, _ in enumerate(pairwise(self.speeds))))

    def _line(self, speed: float) -> int:
        return min(max(bisect_right(self.speeds, speed) - 1, 0), len(self.speeds) - 2)

    def _slope(self, k: int) -> float:
        return (self.moments[k + 1] - self.moments[k]) / (self.speeds[k + 1] - self.speeds[k])


class Motor(NamedTuple):
    """A motor that turns the crank: its law, and its turns for one turn of the crank, in whichever sense.

    The moment at the crank's shaft is U*M(U*omega) (приведение к главному валу).

    >>> Motor(Linear(60.0, 20.0), 2.0).moment(5.0)
    60.0
    """

    law: MotorLaw
    ratio: float = 1.0

    def moment(self, omega: float) -> float:
        """Give the moment at the crank's shaft at its speed."""
        turns = abs(self.ratio)
        return turns * self.law.moment(turns * omega)

    def slope(self, omega: float) -> float:
        """Give the derivative of that moment by the crank's speed, N*m*s."""
        turns = abs(self.ratio)
        return turns * turns * self.law.slope(turns * omega)

    def speed(self, moment: float) -> float | None:
        """Give the crank's speed at which the motor bears a moment at the crank's shaft, and is stable."""
        turns = abs(self.ratio)
        found = self.law.speed(moment / turns)
        return None if found is None else found / turns

    @property
    def steepness(self) -> float:
        """The steepest fall of the moment at the crank's shaft by its speed, N*m*s."""
        return self.ratio * self.ratio * self.law.steepness
