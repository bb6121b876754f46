"""The equation of motion of the reduced link (уравнение движения звена приведения), and its solution piece by piece.

J d(omega)/dt = M - omega^2/2 dJ/dphi (6.8). Beside the angle turned and the speed the state holds the works, J, of the
drive, the resistance, the brake and the weights, so that the account of energy is a check on all of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from plans.model.dynamics import TURN
from plans.model.motion import Floats
from plans.model.motor import Motor
from plans.model.run import ReducedLink, Works, before, beyond

EXPLICIT, IMPLICIT = "DOP853", "LSODA"
COMMON = "RK45"  # what is taken without a choice: never chosen, but measured against
# Shares of rounding that a step is allowed: the multistep method cannot be asked for the last digits.
TOLERANCES = {EXPLICIT: 1e-12, IMPLICIT: 1e-10, COMMON: 1e-10}
# For every time over that a change of speed dies away in a turn, e-fold, the explicit method needs some 40 evaluations,
# to more figures; the implicit one 1000 to 2700 in all for a turn between two breaks, however steep the motor is.
STIFF = 50.0  # times over in a turn
ANGLE, SPEED, STOP = "angle", "speed", "stop"  # what a leg ends with
SIZE = 6  # of the state
CLOSE = 4  # rows to the longest step
SPEED_AXIS: Floats = np.eye(1, SIZE, 1)[0]
EPS = 2.0**-52


@dataclass(frozen=True)
class Equation:
    """What acts in a stage: the drive or none, the resistance or none, a brake N*m."""

    link: ReducedLink
    motor: Motor | None
    loaded: bool = False
    brake: float = 0.0
    base: float = 0.0  # rad/s: what the speed of a state is counted from, so that an approach to it keeps its digits
    piece: tuple[float, float] = (-math.inf, math.inf)  # rad: between two breaks; beyond them its moment goes on

    def moments(self, turned: float, omega: float) -> tuple[float, float, float, float]:
        """Give the moments N*m of the drive, the resistance, the brake and the weights, positive in the motion."""
        driving = self.motor.moment(omega) if self.motor else 0.0
        resisting = self.link.resistance(min(max(turned, self.piece[0]), self.piece[1])) if self.loaded else 0.0
        return driving, resisting, -self.brake, self.link.weight(turned)

    def epsilon(self, turned: float, omega: float) -> float:
        """Give the acceleration rad/s2 (6.8)."""
        moment = sum(self.moments(turned, omega))
        return (moment - omega * omega / 2 * self.link.slope(turned)) / self.link.inertia(turned)

    def place(self, state: Floats) -> tuple[float, float]:
        """Give the angle turned and the speed of a state."""
        return float(state[0]), self.base + float(state[1])

    def counted(self, values: Floats, sense: int = 1) -> Floats:
        """Give a state with its speed counted from the base, or in the sense -1 again from rest."""
        shift: Floats = sense * self.base * SPEED_AXIS
        return values - shift

    def rates(self, _: float, state: Floats) -> list[float]:
        """Give the derivatives of the state by time: rad/s, rad/s2, and powers W."""
        turned, omega = self.place(state)
        moments = self.moments(turned, omega)
        epsilon = sum(moments) - omega * omega / 2 * self.link.slope(turned)
        return [omega, epsilon / self.link.inertia(turned), *(moment * omega for moment in moments)]

    def jacobian(self, _: float, state: Floats) -> Floats:
        """Give the derivatives of the rates by the speed: those by the angle are not stiff, and are left out."""
        turned, omega = self.place(state)
        moments, steep = self.moments(turned, omega), self.motor.slope(omega) if self.motor else 0.0
        found = np.zeros((SIZE, SIZE))
        found[0, 1] = 1.0
        found[1, 1] = (steep - omega * self.link.slope(turned)) / self.link.inertia(turned)
        found[2:, 1] = moments
        found[2, 1] += steep * omega
        return found

    def between(self, turned: float, end: float | None) -> Equation:
        """Give the equation for the piece that begins at an angle and ends at a break."""
        return self if end is None else replace(self, piece=(beyond(turned), before(end)))


class RunState(NamedTuple):
    """Where a motion is: time s; angle turned, speed and the four works since rest."""

    t: float
    values: Floats  # (6,)

    @property
    def turned(self) -> float:
        """The angle turned, rad."""
        return float(self.values[0])

    @property
    def omega(self) -> float:
        """The speed, rad/s."""
        return float(self.values[1])

    def works(self, since: RunState) -> Works:
        """Give the works since an earlier state."""
        driving, resisting, braking, weights = (self.values[2:] - since.values[2:]).tolist()
        return Works(driving, 0.0 - resisting, 0.0 - braking, weights)


AT_REST = RunState(0.0, np.zeros(SIZE))


class Leg(NamedTuple):
    """A part of a motion: rows (n, 4) of time, angle, speed, acceleration; speeds at extremes; and its end."""

    rows: Floats
    turning: Floats  # (m,) rad/s: where the acceleration vanishes
    end: RunState
    reason: str


class LegEnds(NamedTuple):
    """With what a leg is to end, whichever comes first: an angle rad, a speed rad/s above it."""

    angle: float
    speed: float | None = None


@dataclass(frozen=True)
class Solver:
    """The solver that a problem calls for: its name, and the sizes of angle, speed and works that its errors share."""

    name: str
    sizes: Floats  # (6,)
    longest: float = math.inf  # s: of a step

    @property
    def tolerance(self) -> float:
        """The error that a step is allowed, in shares of the state."""
        return TOLERANCES[self.name]

    def leg(self, equation: Equation, start: RunState, ends: LegEnds) -> Leg:
        """Follow a motion to its end, starting anew at every break; one that never comes to a speed is left earlier."""
        parts, state, going = [], start, True
        while going:
            edge = equation.link.following(state.turned) if equation.loaded else None
            stop = ends.angle if edge is None else min(edge, ends.angle)
            parts.append(self._piece(equation.between(state.turned, edge), state, LegEnds(stop, ends.speed)))
            state = parts[-1].end
            going = parts[-1].reason == ANGLE and stop < ends.angle
            if ends.speed is not None and crawls(parts, equation.link.breaks):
                break
        rows, turning = (np.concatenate([part[k] for part in parts]) for k in range(2))
        return Leg(rows, turning, parts[-1].end, parts[-1].reason)

    def _piece(self, equation: Equation, start: RunState, ends: LegEnds) -> Leg:
        """Follow a motion without jumps of the forces; its end is refined by Newton's rule from a step of its own."""
        watched = _events(equation, ends)
        found = self._solved(equation, start, events=list(watched.values()))
        if found.status != 1:
            raise ArithmeticError(found.message)
        reason = next(name for name, times in zip(watched, found.t_events, strict=True) if name and len(times))
        near = self._solved(equation, RunState(found.t[-2], equation.counted(found.y[:, -2], -1)), found.t[-1])
        end = _refined(equation, float(near.t[-1]), near.y[:, -1], reason, ends)
        at = self._kept(found.t)
        rows = np.array([found.t[at], found.y[0, at], equation.base + found.y[1, at], np.zeros(len(at))]).T
        rows[-1, :3] = end.t, *end.values[:2]
        rows[:, 3] = [equation.epsilon(*place) for place in rows[:, 1:3].tolist()]
        return Leg(rows, np.array([equation.place(state)[1] for state in found.y_events[0]]), end, reason)

    def _kept(self, t: Floats) -> npt.NDArray[np.intp]:
        """Choose the steps that become rows, the first and the last among them: no more than a drawing needs."""
        if math.isinf(self.longest):
            return np.arange(len(t))
        part = np.floor((t - t[0]) / self.longest * CLOSE)
        return np.flatnonzero(np.diff(part, prepend=-1.0, append=-1.0)[:-1] + (t == t[-1]))

    def _solved(self, equation: Equation, start: RunState, end: float = math.inf, **more: Any) -> Any:
        from scipy.integrate import solve_ivp  # noqa: PLC0415  (only a run needs it)

        if self.name == IMPLICIT:
            more["jac"] = equation.jacobian
        least = self.tolerance * self.sizes + (EPS - self.tolerance) * self.sizes * SPEED_AXIS
        limit = {"rtol": self.tolerance, "atol": least, "max_step": self.longest}
        return solve_ivp(equation.rates, (start.t, end), equation.counted(start.values), self.name, **limit, **more)


def crawls(parts: Sequence[Leg], breaks: Sequence[float]) -> bool:
    """Tell whether a motion no longer changes from turn to turn, by the speeds at the same break."""
    if len(parts) <= len(breaks):
        return False
    now, before = parts[-1].end.omega, parts[-1 - len(breaks)].end.omega
    return abs(now - before) <= CRAWL * now


CRAWL = 1e-9  # a gain that would take a thousand million turns to count


def _events(equation: Equation, ends: LegEnds) -> dict[str, Callable[[float, Floats], float]]:
    """Give what is watched by its name; an extreme of the speed, which has none, ends nothing."""

    def stop(_: float, state: Floats) -> float:
        return equation.place(state)[1]

    def angle(_: float, state: Floats) -> float:
        return float(state[0]) - ends.angle

    def speed(_: float, state: Floats) -> float:
        return float(state[1]) - ((ends.speed or 0.0) - equation.base)

    def turning(_: float, state: Floats) -> float:
        return equation.epsilon(*equation.place(state))

    for event, direction in ((stop, -1.0), (angle, 1.0), (speed, 1.0)):
        vars(event).update(terminal=True, direction=direction)
    asked = {SPEED: speed} if ends.speed is not None else {}
    return {"": turning, STOP: stop, ANGLE: angle, **asked}


def _refined(equation: Equation, t: float, near: Floats, reason: str, ends: LegEnds) -> RunState:
    """Move a state that rounding and interpolation have left beside the end of its piece onto it."""
    rates = np.array(equation.rates(t, near))
    speed = ends.speed or 0.0
    part, wanted = {ANGLE: (0, ends.angle), SPEED: (1, speed - equation.base), STOP: (1, -equation.base)}[reason]
    late = float((wanted - near[part]) / rates[part]) if rates[part] else 0.0
    values = near + late * rates
    values[part] = wanted
    return RunState(t + late, equation.counted(values, -1))


def size_of(link: ReducedLink, speed: float) -> Floats:
    """Give what the errors of angle, speed and works are shares of: a turn, a speed, the kinetic energy at it."""
    return np.array([TURN, speed, *[link.inertia(0.0) * speed * speed / 2] * 4])
