"""Pressure angles of groups and their interval over the turn (угол давления, угол передачи; M1.3)."""

from __future__ import annotations

from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np

from plans.linkage.assembly_limits import FAN, LOOKS, NODES, Sweep
from plans.linkage.dyads import KINDS
from plans.linkage.plan import Plan
from plans.model.dyad import Group
from plans.model.motion import Floats


class PressureInterval(NamedTuple):
    """The interval of a group's pressure angle over the turn, rad, and the crank angles of its ends."""

    low: float
    high: float
    at_low: float
    at_high: float


# The intervals of a sweep's groups over the nodes last asked for: the sheet and the report both tell them.
_FOUND: WeakKeyDictionary[Sweep, tuple[Floats | None, list[PressureInterval]]] = WeakKeyDictionary()


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside
def pressure(plan: Plan, group: Group) -> Floats:
    """Read off the plan of positions a group's signed pressure angle, rad, at every position (угол давления, M1.3).

    It stands between the force on the driven link and the velocity of its point over what guides it.
    """
    return KINDS[group.kind].pressure(plan, group)


def interval(sweep: Sweep, group: Group, nodes: Floats | None = None) -> PressureInterval:
    """Find the interval of a group's pressure angle (M1.3) over crank angles close to each other, or over a turn."""
    known = _FOUND.get(sweep)
    if known is None or known[0] is not nodes:
        phi = np.linspace(0.0, 2 * np.pi, NODES + 1) if nodes is None else nodes
        known = _FOUND[sweep] = nodes, _intervals(sweep, phi)
    return known[1][sweep.groups.index(group)]


def _intervals(sweep: Sweep, nodes: Floats) -> list[PressureInterval]:
    """Find the intervals of all groups at once: each look draws one plan of positions for all their ends."""

    def seen(angles: Floats) -> Floats:
        plan = sweep.plan(angles)
        found = [np.broadcast_to(pressure(plan, group), angles.shape) for group in sweep.groups]
        return np.asarray(np.repeat(found, 2, axis=0) * np.tile((1.0, -1.0), len(found))[:, None])

    if not nodes.size:
        return [PressureInterval(*4 * (float("nan"),))] * len(sweep.groups)
    ends = [_Least(nodes, values) for values in seen(nodes)]
    for _ in range(LOOKS):
        fans = np.array([np.linspace(end.low, end.high, FAN) for end in ends])
        values = seen(fans.ravel()).reshape(len(ends), len(ends), FAN)
        for k, end in enumerate(ends):
            end.look(fans[k], values[k, k])
    return [
        PressureInterval(low.least, -high.least, low.where, high.where)
        for low, high in zip(ends[::2], ends[1::2], strict=True)
    ]


class _Least:
    """The least of some values over crank angles, sought at nodes and then between the neighbours of the least one."""

    def __init__(self, nodes: Floats, values: Floats) -> None:
        self.low, self.high = float(nodes[0]), float(nodes[-1])
        self.least = self.where = float("nan")
        self.look(nodes, values)

    def look(self, angles: Floats, values: Floats) -> None:
        """Look at some angles, and close in on the least."""
        if np.isnan(values).all():
            return
        best = int(np.nanargmin(values))
        if not values[best] >= self.least:
            self.least, self.where = float(values[best]), float(angles[best])
        self.low, self.high = float(angles[max(best - 1, 0)]), float(angles[min(best + 1, len(angles) - 1)])
