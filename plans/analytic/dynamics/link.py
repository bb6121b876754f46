"""The reduced link to rounding (звено приведения): what a solver of its equation of motion asks for."""

from __future__ import annotations

from plans.analytic.dynamics.flywheel import Exact
from plans.model.dynamics import TURN
from plans.model.run import OfTurn, ReducedLink


def reduced_link(found: Exact, constant: float) -> ReducedLink:
    """Give the reduced link of a machine; `constant`: inertia kg*m2 of shafts and flywheel."""
    breaks = sorted({float(place) % TURN for place in found.breaks})
    inertia = _raised(found.mass.one, constant)
    return ReducedLink(inertia, found.growth.one, found.load.one, breaks=tuple(breaks))


def _raised(curve: OfTurn, constant: float) -> OfTurn:
    return lambda turned: curve(turned) + constant
