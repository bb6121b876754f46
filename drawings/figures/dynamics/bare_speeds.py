"""The speeds of a machine without its flywheel, over the turn from zero on (угловая скорость без маховика)."""

from __future__ import annotations

import numpy as np

from drawings.figures.dynamics import quantities
from drawings.figures.dynamics.curves import dense
from drawings.figures.dynamics.rays import strips
from drawings.figures.graphs.curve_graph import GraphCurve
from drawings.page.drafting import Drafting
from plans.model.account import Account
from plans.model.dynamics import Task

NUMBERED = 36  # positions: of more the curve alone is drawn


def bare_speeds(task: Task, account: Account, drafting: Drafting) -> GraphCurve | None:
    """Give the curve of the speeds without the flywheel; None where there is none, or it stands beside the others."""
    cycle, before, after = account.cycle, account.before, account.speeds
    if cycle is None or before is None:
        return None
    if after is not None and (after.inertia == before.inertia or quantities.beside(after, before)):
        return None
    shown = dense(cycle)
    steps = strips(cycle, task.divisions).steps[:-1]
    own = np.flatnonzero(~np.isnan(steps) & (task.divisions <= NUMBERED))
    omega = quantities.omega(cycle, shown, before)
    stations, ordinates = np.degrees(cycle.turned[own]), before.omega[own]
    title = drafting.word("speed without flywheel")
    return GraphCurve(
        "ω_0", "rad/s", np.degrees(shown.turned), omega, stations, ordinates, title, task.divisions, states="ω_0"
    )
