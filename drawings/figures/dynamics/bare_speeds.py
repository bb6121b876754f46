"""The speeds of a machine without its flywheel, over the turn from zero on (угловая скорость без маховика)."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from drawings.figures.dynamics import quantities
from drawings.figures.dynamics.rays import strips
from drawings.figures.graphs.curve_graph import GraphCurve
from drawings.page.drafting import Drafting
from plans.model.account import Account
from plans.model.dynamics import Cycle, Task
from plans.model.motion import Floats

STEPS = 360  # of a turn at least: a degree, of which no curve on paper shows the corners


class Dense(NamedTuple):
    """A turn followed densely: angles rad from 0 on, moment N*m, work J, varying inertia kg*m2; jumps are upright."""

    turned: Floats
    moment: Floats
    work: Floats
    varying: Floats


def dense(cycle: Cycle) -> Dense:
    """Join the points of a cycle smoothly, each strip on its own: loads may jump or bend at its edges."""
    shares = np.linspace(0.0, 1.0, 1 + math.ceil(STEPS / len(cycle.means)))
    slopes = _slopes(cycle.turned, cycle.varying)
    ends = np.column_stack([slopes[:-1], slopes[1:]])
    turned = cycle.turned[:-1, None] + shares * np.diff(cycle.turned)[:, None]
    rows = (
        turned,
        _parabolas(cycle.moments, cycle.means, shares),
        _cubics(cycle.turned, cycle.work, cycle.moments, shares),
        _cubics(cycle.turned, cycle.varying, ends, shares),
    )
    return Dense(*(row.ravel() for row in rows))


def _parabolas(ends: Floats, means: Floats, shares: Floats) -> Floats:
    """Follow each strip through its ordinates at both ends and in the middle, (n, shares)."""
    first, last, s = ends[:, :1], ends[:, 1:], shares
    bend = 4 * (means[:, None] - (first + last) / 2)
    return np.asarray(first + (last - first) * s + bend * s * (1 - s))


def _cubics(x: Floats, y: Floats, slopes: Floats, shares: Floats) -> Floats:
    """Follow each strip through its ends with the slopes (n, 2) that it has there, (n, shares)."""
    wide, s = np.diff(x)[:, None], shares
    first, rise = y[:-1, None], np.diff(y)[:, None]
    left, right = slopes[:, :1] * wide - rise, rise - slopes[:, 1:] * wide
    return np.asarray(first + rise * s + s * (1 - s) * (left * (1 - s) + right * s))


def _slopes(x: Floats, y: Floats) -> Floats:
    """Give the slopes of a smooth periodic curve at its points, each from the two strips beside it."""
    wide, rise = np.diff(x), np.diff(y)
    chords = rise / wide
    before, after = np.roll(wide, 1), wide
    own = (np.roll(chords, 1) * after + chords * before) / (before + after)
    return np.append(own, own[0])


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
