"""The flywheel by other classical methods from the points of the drawn loop (методы Мерцалова и Гутьяра; M4.10)."""

from __future__ import annotations

import math

import numpy as np

from plans.model.dynamics import Cycle, Rim, Task, Touch
from plans.model.flywheel_methods import Methods
from plans.model.flywheel_rim import Wheel


def rim_of(inertia: float, rim: Rim) -> Wheel | None:
    """Size the rim of a flywheel of kg*m2 at the crank's shaft; None without a diameter, or without a flywheel.

    The ring is thin: J = rho pi D s (D/2)^2 of a section s, on a shaft that turns u times as fast J/u^2.
    """
    if rim.diameter is None or not inertia > 0:
        return None
    own = inertia / rim.ratio**2
    around = rim.density * math.pi * rim.diameter  # kg for a square metre of the section
    section = own / (around * (rim.diameter / 2) ** 2)
    breadth = math.sqrt(section * rim.breadth)
    return Wheel(own, rim.diameter, around * section, section / breadth, breadth)


def methods(cycle: Cycle, task: Task) -> Methods | None:
    """Find J0 by each method; None where no fluctuation is asked for.

    Mertsalov's curve is the energy of all that turns evenly, were the links to move at the mean speed. Gutyar's has
    the greatest speed in it where it is highest and the least where it is lowest. The book leaves delta^2 out.
    """
    if not task.delta:
        return None
    square, delta = task.speed**2, task.delta
    level, (top, low) = _rest(cycle, square), ((1 + s * delta / 2) ** 2 * square for s in (1, -1))
    gutyar = _rest(cycle, top).max() - _rest(cycle, low).min()
    even = (1 + delta) * square, (1 - delta) * square
    book = _rest(cycle, even[0]).max() - _rest(cycle, even[1]).min()
    touches = _touch(cycle, int(level.argmin())), _touch(cycle, int(level.argmax()))
    whole = float(np.ptp(level))
    over = square * delta
    return Methods(float(book) / over, whole / over, float(gutyar) / over, whole, touches)


def _rest(cycle: Cycle, square: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Give the change of energy of what turns evenly, J, the links at a speed whose square is given."""
    return np.asarray(cycle.surplus - cycle.varying * square / 2)


def _touch(cycle: Cycle, k: int) -> Touch:
    return Touch(float(cycle.turned[k]), float(cycle.varying[k]), float(cycle.surplus[k]))
