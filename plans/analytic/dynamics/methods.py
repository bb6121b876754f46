"""Other classical methods for the flywheel, with exact extremes (методы Мерцалова и Гутьяра; M4.10)."""

from __future__ import annotations

from plans.analytic.dynamics.flywheel import Exact, book_slopes, flywheel
from plans.model.dynamics import TURN, Task
from plans.model.flywheel_methods import Methods
from plans.model.run import OfTurn, ReducedLink


def reduced_link(found: Exact, constant: float) -> ReducedLink:
    """Give the reduced link of a machine; `constant`: inertia kg*m2 of shafts and flywheel."""
    breaks = sorted({float(place) % TURN for place in found.breaks})
    inertia = _raised(found.mass.one, constant)
    return ReducedLink(inertia, found.growth.one, found.load.one, breaks=tuple(breaks))


def _raised(curve: OfTurn, constant: float) -> OfTurn:
    return lambda turned: curve(turned) + constant


def methods(found: Exact, task: Task) -> Methods | None:
    """Find J0 by each method; None where no fluctuation is asked for.

    Mertsalov takes the energy of the varying inertia at the mean speed throughout; Gutyar at the greatest where he
    seeks the greatest energy of the rest, at the least where he seeks the least. Both divide by omega_m^2 delta.
    """
    if not task.delta:
        return None
    even = task.speed**2 * task.delta
    mean = task.speed**2 / 2.0
    level = flywheel(found, task, (mean, mean))
    exact = flywheel(found, task)
    return Methods(
        book=flywheel(found, task, book_slopes(task)).whole,
        mertsalov=(level.cuts[1] - level.cuts[0]) / even,
        gutyar=(exact.cuts[1] - exact.cuts[0]) / even,
        height=level.cuts[1] - level.cuts[0],
        touches=level.touches,
    )
