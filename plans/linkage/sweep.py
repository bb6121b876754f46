"""The sweep round a turn: where the mechanism cannot be assembled or changes, its pressure angles (проход).

A group's margin is the squared sine of its crossing angle: it falls to zero where the group comes to a dead centre, and
beyond it there is no meeting. A margin that only touches zero is a change point: the mechanism may go on in two ways.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
import numpy.typing as npt

from geometry.branch import AssemblyBranch, Side
from geometry.meet import UNBORNE
from geometry.three_leads import BodyPose
from plans.linkage.assembly import SAME, Barrier, BarrierEdge, margins, meeting, met_at, of_arcs
from plans.linkage.dyads import KINDS
from plans.linkage.motion_plans import UNIT, PlanTemplate, accelerations, positions, resting, velocities
from plans.linkage.plan import Plan, angle, rate
from plans.linkage.primary import CrankPositions
from plans.model.dyad import Assur
from plans.model.mechanism import Mechanism
from plans.model.motion import CHANGE_POINT, OUT_OF_REACH, PARALLEL_GUIDES, Floats, LinkMotion, Motion, PointMotion

FULL = 2 * np.pi


class Passed(NamedTuple):
    """A change point that a group is carried through: the group's place in solving order, and the crank angle, rad."""

    group: int
    phi: float


def carried(sides: Sequence[Side], passed: Sequence[Passed], phi: Floats, home: float) -> list[Side]:
    """Give each group's side over crank angles, rad: every change point on the way from home turns it over.

    The way is the shorter one; half a turn off, that counter-clockwise.
    """
    ahead = np.mod(phi - home, FULL)
    found: list[Side] = [
        side if isinstance(side, BodyPose | AssemblyBranch) else np.full(np.shape(phi), side) for side in sides
    ]
    for group, at in passed:
        on = float(np.mod(at - home, FULL))
        over = np.where(ahead <= np.pi, on < ahead, on > ahead)
        found[group] = np.where(over, -1.0, 1.0) * np.asarray(found[group])
    return found


class RedrawnPlans:
    """Plans up to an order, drawn anew wherever they are asked for: no pattern fits sides that change."""

    def __init__(self, positions: Callable[[CrankPositions], Plan], groups: Sequence[Assur], order: int) -> None:
        self._positions, self.groups, self.order = positions, groups, order

    def follow(self, turn: CrankPositions) -> list[Plan]:
        """Draw the plans at some crank positions."""
        plans = [self._positions(turn)]
        for draw in (velocities, accelerations)[: self.order]:
            plans.append(draw(plans[-1], self.groups, turn.rates))
        return plans

    def clear(self, plans: Sequence[Plan]) -> bool:
        """Tell whether no meeting of the plans is near a miss or a dead centre."""
        return all(plan.board.clear for plan in plans)

    def plans_of(self, plans: list[Plan]) -> list[Plan]:
        """Give the plans themselves."""
        return plans

    def read(self, plans: Sequence[Plan], turn: CrankPositions) -> Motion:
        """Read all named points and moving links off the plans."""
        links = plans[0].mechanism.links
        letters = sorted({point for link in links.values() for point in link.points})
        count = len(turn)
        points = {letter: PointMotion(_row(plan.point(letter).point, count) for plan in plans) for letter in letters}
        moving = [link for link, image in sorted(plans[0].images.items()) if image.arm]
        turned = {
            link: LinkMotion(
                _row(row, len(turn)) for row in (angle(plans[0], link), *(rate(plan, link) for plan in plans[1:]))
            )
            for link in moving
        }
        return Motion("construction", turn.phi, points, turned, ())


def _row(values: Any, count: int) -> npt.NDArray[Any]:
    row = np.asarray(values)
    return resting(row.reshape(1), count) if row.size == 1 else row


NODES = 720  # crank angles of a sweep: half a degree
NODE_ANGLES = 2 * np.pi * np.arange(NODES) / NODES
FAN = 129  # angles of one closer look between two nodes
LOOKS = 8  # 64**8 of half a degree is below the rounding of an angle
# A lowest margin is looked at more closely where it may hide a touch: between nodes half a degree apart a margin may
# fall from the sine squared of a 45 degree notch; among the angles of a closer look, from that of a 6 degree one.
DEEP, SHALLOW = 0.5, 0.01


def at_angles(phi: Floats) -> CrankPositions:
    """Take any crank angles, rad, for a turn."""
    return CrankPositions(phi, np.exp(1j * phi))


def changes_of_sign(height: Callable[[Floats], Floats], low: Floats, high: Floats) -> Floats:
    """Close in on one change of sign between each two crank angles, rad, by fans of angles, all of them together."""
    for _ in range(LOOKS if low.size else 0):
        fan: Floats = np.linspace(low, high, FAN)
        above = height(fan.ravel()).reshape(fan.shape) >= 0
        changed = above != above[0]
        change = np.where(changed.any(axis=0), np.argmax(changed, axis=0), FAN - 1)
        each = np.arange(len(low))
        low, high = fan[change - 1, each], fan[change, each]
    return np.asarray((low + high) / 2)


class Sweep:
    """A mechanism with its chosen sides, looked at over any crank angles."""

    def __init__(
        self,
        mechanism: Mechanism,
        groups: Sequence[Assur],
        sides: Sequence[Side],
        home: float = 0.0,
        passed: tuple[Passed, ...] = (),
    ) -> None:
        self.mechanism, self.groups, self.sides = mechanism, groups, sides
        self.home, self.passed = home, passed  # crank angle, rad, of the sketch; change points that are carried through
        self._patterns: dict[tuple[int, bool], PlanTemplate] = {}

    def over(self, mechanism: Mechanism) -> Sweep:
        """Give the sweep of the same mechanism driven in another way."""
        return Sweep(mechanism, self.groups, self.sides, self.home, self.passed)

    def through(self) -> Sweep:
        """Give the sweep that is carried through all change points; group after group, for one moves the next."""
        sweep = self
        while True:
            met = [Passed(b.group, b.middle) for b in sweep.barriers if b.kind == CHANGE_POINT]
            new = [point for point in met if not any(_alike(point, other) for other in sweep.passed)]
            if not new:
                return sweep
            first = [point for point in new if point.group == min(new).group]
            kept = [point for point in sweep.passed if point.group < first[0].group]
            sweep = Sweep(self.mechanism, self.groups, self.sides, self.home, (*kept, *first))

    @cached_property
    def pinned(self) -> bool:
        """Tell whether a pin comes to its own slot's pivot, or all but: the slot has any direction there."""
        slotted = [group for group in self.groups if KINDS[group.kind].pivoted]
        marks = [meeting(self.plan(NODE_ANGLES), group) for group in slotted]
        ends = [tuple(np.asarray(end.point) for end in mark.step.inputs) for mark in marks]
        return any(bool((np.abs(pivot - pin) <= np.abs(pin).max() / NODES * 8).any()) for pivot, pin in ends)

    @cached_property
    def barred(self) -> tuple[Barrier, ...]:
        """What bars the crank though the linkage is carried through its change points."""
        return tuple(b for b in self.barriers if not self.passes(b))

    def passes(self, barrier: Barrier) -> bool:
        """Tell whether a barrier is a change point that the linkage is carried through."""
        here = Passed(barrier.group, barrier.middle)
        return barrier.kind == CHANGE_POINT and any(_alike(here, other) for other in self.passed)

    def pattern(self, order: int, varied: bool = False) -> PlanTemplate | RedrawnPlans:
        """Give the pattern of the plans up to an order: 0 positions, 1 velocities, 2 accelerations.

        `varied`: of positions each of which has rates of its own.
        """
        if self.passed:
            return RedrawnPlans(self.positions, self.groups, order)
        if (order, varied) not in self._patterns:
            rates = UNIT if varied else None
            plans = [self.plan(np.zeros(1))]
            if order > 0:
                plans.append(velocities(plans[0], self.groups, rates))
            if order > 1:
                plans.append(accelerations(plans[1], self.groups, rates))
            self._patterns[order, varied] = PlanTemplate(plans)
        return self._patterns[order, varied]

    def plan(self, phi: Floats) -> Plan:
        """Draw the plan of positions at some crank angles."""
        return self.positions(at_angles(phi))

    def motion(self, turn: CrankPositions, order: int) -> Motion:
        """Give the motion at the crank positions of a turn, reached or not, by the pattern of an order of plans."""
        pattern = self.pattern(order)
        return pattern.read(pattern.follow(turn), turn)

    def positions(self, turn: CrankPositions) -> Plan:
        """Draw the plan of positions at the crank positions of a turn."""
        sides = carried(self.sides, self.passed, turn.phi, self.home) if self.passed else self.sides
        return positions(self.mechanism, self.groups, sides, turn)

    def margins(self, phi: Floats) -> Floats:
        """Give every group's margin at some crank angles."""
        return margins(self.plan(phi), self.groups, self.sides)[0]

    @cached_property
    def barriers(self) -> tuple[Barrier, ...]:
        """All that bars a full turn of the crank."""
        if not self.groups:
            return ()
        nodes = NODE_ANGLES
        field = self.margins(nodes)
        with np.errstate(invalid="ignore"):
            free = np.asarray((field > 0).all(axis=0))
        if not free.any():
            return (self._barrier((0.0, 0.0), (2 * np.pi, 2 * np.pi), np.linspace(0, 2 * np.pi, FAN)),)
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
            with np.errstate(invalid="ignore"):
                low = (margin <= before) & (margin < after) & (margin < DEEP)
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
            field = self.margins(fan)
            lowest = np.where(np.isnan(field), -1.0, field).min(axis=0)  # NaN: a group before misses there
            at = int(np.argmin(lowest))
            if not lowest[at] > 0:
                left, right = self._edge(low, fan[at]), self._edge(high, fan[at])
                return self._barrier(left, right, np.linspace(left[0], right[0], FAN))
            if lowest[at] > SHALLOW and 0 < at < FAN - 1 and _least(*lowest[at - 1 : at + 2]) > lowest[at] / 2:
                return None
            low, high = fan[max(at - 1, 0)], fan[min(at + 1, FAN - 1)]
        return None

    def _edge(self, free: float, barred: float) -> tuple[float, float]:
        """Find the last free angle towards a barred one, and the first barred angle after it."""
        for _ in range(LOOKS):
            fan = np.linspace(free, barred, FAN)
            with np.errstate(invalid="ignore"):
                open_ = (self.margins(fan) > 0).all(axis=0)
            last = int(np.argmin(open_)) if not open_.all() else FAN - 1
            free, barred = float(fan[max(last - 1, 0)]), float(fan[max(last, 1)])
        return free, barred

    def _barrier(self, start: tuple[float, float], end: tuple[float, float], nodes: Floats) -> Barrier:
        """Name a barrier by the groups that fail at its edges; one where no group misses is a change point."""
        field, marks = margins(self.plan(np.concatenate((nodes, (start[1], end[1])))), self.groups, self.sides)
        with np.errstate(invalid="ignore"):
            missing = (field < 0).any(axis=1)
            failing = ~(field > UNBORNE)  # with a pin that runs to infinity, groups that hang on it fail as well
        if not missing.any():
            group = int(np.nanargmin(np.nanmin(field, axis=1)))
            ends = [BarrierEdge(phi, beyond, CHANGE_POINT, group, met_at(marks[group])) for phi, beyond in (start, end)]
            return Barrier((ends[0], ends[1]), 0.0)
        groups = [int(np.argmax(failing[:, k] if failing[:, k].any() else missing)) for k in (-2, -1)]
        kinds = [OUT_OF_REACH if of_arcs(marks[group]) else PARALLEL_GUIDES for group in groups]
        edges = zip((start, end), kinds, groups, strict=True)
        ends = [BarrierEdge(*edge, kind, group, met_at(marks[group])) for edge, kind, group in edges]
        misses = [float(np.nanmax(np.asarray(marks[g].miss, dtype=float))) for g in set(groups) if of_arcs(marks[g])]
        return Barrier((ends[0], ends[1]), max(misses, default=0.0))


def _least(before: float, middle: float, after: float) -> float:
    """Give the least value of the parabola through three values, the middle one the least of them."""
    bend = before + after - 2 * middle
    return middle - (after - before) ** 2 / (8 * bend) if bend > 0 else middle


def _alike(first: Passed, second: Passed) -> bool:
    """Tell whether two change points are one: each is known to half the digits of an angle."""
    return first.group == second.group and abs(np.angle(np.exp(1j * (first.phi - second.phi)))) < SAME


class PressureInterval(NamedTuple):
    """The interval of a group's pressure angle over the turn, rad."""

    low: float
    high: float


# The intervals of a sweep's groups over the nodes last asked for: the sheet and the report both tell them.
_FOUND: WeakKeyDictionary[Sweep, tuple[Floats | None, list[PressureInterval]]] = WeakKeyDictionary()


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside
def pressure(plan: Plan, group: Assur) -> Floats:
    """Read off the plan of positions a group's signed pressure angle, rad, at every position (угол давления, M1.3).

    It stands between the force on the driven link and the velocity of its point over what guides it.
    """
    return KINDS[group.kind].pressure(plan, group)


def interval(sweep: Sweep, group: Assur, nodes: Floats | None = None) -> PressureInterval:
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
        return [PressureInterval(*2 * (float("nan"),))] * len(sweep.groups)
    ends = [_Lowest(nodes, values) for values in seen(nodes)]
    for _ in range(LOOKS):
        fans = np.array([np.linspace(end.low, end.high, FAN) for end in ends])
        values = seen(fans.ravel()).reshape(len(ends), len(ends), FAN)
        for k, end in enumerate(ends):
            end.look(fans[k], values[k, k])
    return [PressureInterval(low.least, -high.least) for low, high in zip(ends[::2], ends[1::2], strict=True)]


class _Lowest:
    """The least of some values over crank angles, sought at nodes and then between the neighbours of the least one."""

    def __init__(self, nodes: Floats, values: Floats) -> None:
        self.low, self.high = float(nodes[0]), float(nodes[-1])
        self.least = float("nan")
        self.look(nodes, values)

    def look(self, angles: Floats, values: Floats) -> None:
        """Look at some angles, and close in on the least."""
        if np.isnan(values).all():
            return
        best = int(np.nanargmin(values))
        if not values[best] >= self.least:
            self.least = float(values[best])
        self.low, self.high = float(angles[max(best - 1, 0)]), float(angles[min(best + 1, len(angles) - 1)])
