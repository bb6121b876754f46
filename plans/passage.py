"""The passage round a turn: where the mechanism cannot be assembled, where it changes, and what is reached (проход).

A group's margin is the squared sine of its crossing angle: it falls to zero where the group comes to a dead centre, and
beyond it there is no meeting. A margin that only touches zero is a change point: the mechanism may go on in two ways.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from geometry.board import Mark
from plans.mechanism import Mechanism
from plans.motion import Floats
from plans.plan import Plan
from plans.position import positions
from plans.structure import Dyad
from plans.turn import Turn

NODES = 720  # crank angles of a sweep: half a degree
FAN = 17  # angles of one closer look between two nodes
LOOKS = 14  # 8**14 of half a degree is below the rounding of an angle
# A lowest margin is looked at more closely where it may hide a touch: below the sine squared of a 6 degree notch.
SHALLOW = 0.01
CHANGE, GAP = "change point", "out of reach"


@dataclass(frozen=True)
class Barrier:
    """A part of the turn that the crank cannot pass: from `start` to `end` rad counter-clockwise, and why."""

    start: float
    end: float
    kind: str  # "change point" or "out of reach"
    group: int
    where: str  # the mark whose loci miss or touch
    miss: float  # m, the largest miss seen


def margins(plan: Plan, groups: Sequence[Dyad]) -> tuple[Floats, list[Mark]]:
    """Give every group's margin over the positions, (groups, positions): above 0 assembled, 0 dead, below 0 missing.

    A miss counts as -1: only its sign is meant. NaN: a group before fails.
    """
    marks = [_deciding(plan, group) for group in groups]
    count = max(np.size(mark.point) for mark in plan.letters.values())
    rows = []
    for mark in marks:
        sharpness = np.broadcast_to(np.asarray(mark.sharpness, dtype=float), count)
        miss = np.broadcast_to(np.asarray(mark.miss, dtype=float), count)
        rows.append(np.where(miss > 0, -1.0, sharpness**2))
    return np.array(rows).reshape(len(marks), count), marks


def _deciding(plan: Plan, group: Dyad) -> Mark:
    """Give the mark of a group's own meeting on the plan of positions."""
    match group.kind:
        case "RPR":
            unit = plan.units[group.slide().slider, group.slide().owner]
            assert unit is not None  # a slot has a direction on the plan of positions
            return unit
        case "RPP":
            return plan.images[group.links[1]].origin
    return plan.letters[group.pin]


class Sweep:
    """A mechanism with its chosen sides, looked at over any crank angles."""

    def __init__(self, mechanism: Mechanism, groups: Sequence[Dyad], sides: Sequence[float]) -> None:
        self.mechanism, self.groups, self.sides = mechanism, groups, sides

    def plan(self, phi: Floats) -> Plan:
        """Draw the plan of positions at some crank angles."""
        return self.drawn(Turn(phi, np.exp(1j * phi)))

    def drawn(self, turn: Turn) -> Plan:
        """Draw the plan of positions at the crank positions of a turn."""
        return positions(self.mechanism, self.groups, self.sides, turn)

    def margins(self, phi: Floats) -> Floats:
        """Give every group's margin at some crank angles."""
        return margins(self.plan(phi), self.groups)[0]

    def barriers(self) -> tuple[Barrier, ...]:
        """Find all that bars a full turn of the crank."""
        if not self.groups:
            return ()
        nodes = 2 * np.pi * np.arange(NODES) / NODES
        field = self.margins(nodes)
        with np.errstate(invalid="ignore"):
            free = np.asarray((field > 0).all(axis=0))
        if not free.any():
            return (self._barrier(0.0, 2 * np.pi, np.linspace(0, 2 * np.pi, FAN)),)
        return (*self._between(nodes, field, free), *self._runs(nodes, free))

    def _runs(self, nodes: Floats, free: npt.NDArray[np.bool_]) -> list[Barrier]:
        """Follow each run of nodes that are not free to its two edges."""
        step, found = nodes[1], []
        first = int(np.argmax(free))
        state = np.roll(free, -first)
        starts = np.flatnonzero(state[:-1] & ~state[1:])
        ends = np.flatnonzero(~state & np.roll(state, -1))
        for start, end in zip(starts, ends, strict=True):
            low, high = nodes[first] + start * step, nodes[first] + (end + 1) * step
            left = self._edge(low, low + step)
            right = self._edge(high, high - step)
            found.append(self._barrier(left, right, np.linspace(low, high, 4 * (end - start) + FAN)))
        return found

    def _between(self, nodes: Floats, field: Floats, free: npt.NDArray[np.bool_]) -> list[Barrier]:
        """Look closely wherever a margin's minimum between free nodes may touch or cross zero."""
        found = []
        for margin in field:
            before, after = np.roll(margin, 1), np.roll(margin, -1)
            with np.errstate(invalid="ignore", divide="ignore"):
                bend = before + after - 2 * margin
                dip = margin - np.where(bend > 0, (after - before) ** 2 / (8 * bend), 0.0)
                low = (margin <= before) & (margin < after) & ((margin < SHALLOW) | (dip < SHALLOW * margin))
            around = free & np.roll(free, 1) & np.roll(free, -1)
            for node in np.flatnonzero(low & around):
                barrier = self._closer(nodes[node] - nodes[1], nodes[node] + nodes[1])
                if barrier is not None and barrier not in found:
                    found.append(barrier)
        return found

    def _closer(self, low: float, high: float) -> Barrier | None:
        """Close in on the lowest margin between two free angles; a barrier where it is not above zero."""
        for _ in range(LOOKS):
            fan = np.linspace(low, high, FAN)
            lowest = self.margins(fan).min(axis=0)
            at = int(np.nanargmin(lowest)) if not np.isnan(lowest).all() else FAN // 2
            if not lowest[at] > 0:
                left, right = self._edge(low, fan[at]), self._edge(high, fan[at])
                return self._barrier(left, right, np.linspace(left, right, FAN))
            low, high = fan[max(at - 1, 0)], fan[min(at + 1, FAN - 1)]
        return None

    def _edge(self, free: float, barred: float) -> float:
        """Find the last free angle towards a barred one."""
        for _ in range(LOOKS):
            fan = np.linspace(free, barred, FAN)
            with np.errstate(invalid="ignore"):
                open_ = (self.margins(fan) > 0).all(axis=0)
            last = int(np.argmin(open_)) if not open_.all() else FAN - 1
            free, barred = float(fan[max(last - 1, 0)]), float(fan[max(last, 1)])
        return free

    def _barrier(self, start: float, end: float, seen: Floats) -> Barrier:
        plan = self.plan(seen)
        field, marks = margins(plan, self.groups)
        with np.errstate(invalid="ignore"):
            missing = (field < 0).any(axis=1)
        group = int(np.argmax(missing)) if missing.any() else int(np.nanargmin(np.nanmin(field, axis=1)))
        kind = GAP if missing.any() else CHANGE
        miss = float(np.nanmax(np.asarray(marks[group].miss, dtype=float))) if missing.any() else 0.0
        return Barrier(start, end, kind, group, marks[group].name, miss)


def reached(phi: Floats, first: float, barriers: Sequence[Barrier]) -> npt.NDArray[np.bool_]:
    """Tell which crank angles are reached from the first one, in either sense, without passing a barrier.

    An angle within a change point's own rounding is reached: the mechanism gets there, but no further.
    """
    turn = 2 * np.pi
    ahead = np.mod(phi - first, turn)
    on = min((_far_edge(b.start - first, b.end - b.start, b.kind) for b in barriers), default=turn)
    back = min((_far_edge(first - b.end, b.end - b.start, b.kind) for b in barriers), default=turn)
    return np.asarray((ahead <= on) | (np.mod(turn - ahead, turn) <= back))


def _far_edge(near: float, width: float, kind: str) -> float:
    near = float(np.mod(near, 2 * np.pi))
    return near + width if kind == CHANGE else near
