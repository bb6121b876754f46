"""Drafts: the plans over some positions of a study, and why in some there are none (планы положений, разрывы)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from geometry.board import Arc, Mark, at, between
from geometry.meet import EPS, UNBORNE
from plans.linkage.assembly import Assembly, Barrier, BarrierEdge, bounding, crossing, margins, met_at, undefined
from plans.linkage.dyads import KINDS
from plans.linkage.motion_plans import PlanTemplate, accelerations, velocities
from plans.linkage.plan import Plan
from plans.linkage.primary import CrankPositions
from plans.linkage.sweep import RedrawnPlans, Sweep
from plans.linkage.triads import spans
from plans.model.dyad import Assur
from plans.model.motion import (
    BEYOND_CHANGE_POINT,
    CHANGE_POINT,
    DEAD_CENTRE,
    NOT_REACHABLE,
    ORDERS,
    OUT_OF_REACH,
    PARALLEL_GUIDES,
    POSITIONS,
    VELOCITIES,
    Flags,
    Floats,
    Gap,
    Motion,
)
from plans.model.triad import Triad
from plans.words.words import Message, message

# A position this near to a barrier's edge, rad, whose group is exactly at its dead centre, is the limit itself: half
# the digits of an angle, for near a dead centre a margin is known to all digits but its angle to half of them.
LIMIT = 1e-7
# A position so near to a barrier, rad, is told by its angle from it, others by how sharply their groups meet.
BESIDE = 2.0**-20
# So near to a change point, rad, that a position is that of the change point: two ways part there by as much, and
# places are known to eps over it.
AT_CHANGE = 2.0**-23
ROUNDING = 8.0 * EPS  # rad: an edge is reached, whichever turn its angle is counted in

BARS = CHANGE_POINT, OUT_OF_REACH, PARALLEL_GUIDES


def lost(sweep: Sweep, plan: Plan, turn: CrankPositions, home: float, barriers: Sequence[Barrier]) -> Flags:
    """Tell the positions that are not reached from `home`, or in which a group has no one place; limits are reached."""
    gone = ~reached(turn.phi, home, barriers) | near_edge(turn.phi, barriers, (PARALLEL_GUIDES,), UNBORNE)
    if not sweep.groups or (plan.board.clear and not gone.any() and not sweep.pinned):
        return gone
    field, _ = margins(plan, sweep.groups, sweep.sides)
    nowhere = undefined(plan, sweep.groups).any(axis=0)
    with np.errstate(invalid="ignore"):
        limit = (field == 0).any(axis=0) & (field >= 0).all(axis=0) & _near(turn.phi, _ends(home, barriers), LIMIT)
    return np.asarray((gone & ~limit) | nowhere)


def reached(phi: Floats, home: float, barriers: Sequence[Barrier]) -> Flags:
    """Tell which crank angles are reached from home, rad, in either sense, without passing a barrier.

    An angle within a change point's own rounding is reached: the mechanism gets there, but no further.
    """
    if not barriers:
        return np.ones(len(phi), dtype=bool)
    turn = 2 * np.pi
    ahead = np.mod(phi - home, turn)
    on = min(float(np.mod(edges(b)[0] - home, turn)) + _blur(b.edges[0]) for b in barriers)
    back = min(float(np.mod(home - edges(b)[1], turn)) + _blur(b.edges[1]) for b in barriers)
    return np.asarray((ahead <= on) | (np.mod(turn - ahead, turn) <= back))


def edges(barrier: Barrier) -> tuple[float, float]:
    """Give the two edges of a barrier, rad; a change point is one angle, unless links stay in one line for a while."""
    if barrier.kind == CHANGE_POINT and barrier.end - barrier.start < BESIDE:
        return (barrier.middle, barrier.middle)
    return (barrier.start, barrier.end)


def _blur(edge: BarrierEdge) -> float:
    return AT_CHANGE if edge.kind == CHANGE_POINT else ROUNDING


def _ends(home: float, barriers: Sequence[Barrier]) -> list[float]:
    """Give the two angles, rad, that bound the way of the crank from home."""
    if not barriers:
        return []
    turn = 2 * np.pi
    firsts, lasts = ([edges(b)[side] for b in barriers] for side in (0, 1))
    return [min(firsts, key=lambda e: float(np.mod(e - home, turn))), min(lasts, key=lambda e: np.mod(home - e, turn))]


def _near(phi: Floats, angles: Sequence[float], within: float) -> Flags:
    near = np.zeros(len(phi), dtype=bool)
    for angle in angles:
        near |= np.abs(np.angle(np.exp(1j * (phi - angle)))) < within
    return near


def near_edge(phi: Floats, barriers: Sequence[Barrier], kinds: Sequence[str] = BARS, within: float = LIMIT) -> Flags:
    """Tell which crank angles lie at the edge of a barrier that is of one of some kinds there, rad."""
    both = (zip(edges(barrier), barrier.edges, strict=True) for barrier in barriers)
    return _near(phi, [angle for pair in both for angle, edge in pair if edge.kind in kinds], within)


def unborne(sweep: Sweep, plan: Plan, turn: CrankPositions) -> Flags:
    """Tell the positions whose velocities the condition does not bear.

    A dead centre is told by the crank's angle from it; elsewhere a group must not meet too bluntly.
    """
    if not sweep.groups or plan.board.clear:
        return np.zeros(len(turn), dtype=bool)
    field, _ = margins(plan, sweep.groups, sweep.sides)
    near = near_edge(turn.phi, sweep.barriers, (OUT_OF_REACH, PARALLEL_GUIDES), BESIDE)
    blunt = (field < UNBORNE).any(axis=0) & ~near
    dead = near_edge(turn.phi, sweep.barriers, (OUT_OF_REACH,), UNBORNE)
    return np.asarray(blunt | dead | near_edge(turn.phi, sweep.barriers, (CHANGE_POINT,), AT_CHANGE))


def gaps_of(
    sweep: Sweep, turn: CrankPositions, positions: Sequence[int], home: float | None, barriers: Sequence[Barrier]
) -> list[Gap]:
    """Say why some positions are lost, and what would mend them; `turn` holds those positions alone."""
    if not positions:
        return []
    plan = sweep.positions(turn)
    field, marks = margins(plan, sweep.groups, sweep.sides)
    nowhere = undefined(plan, sweep.groups)
    misses = [np.broadcast_to(0.0 if mark.miss is None else mark.miss, len(turn)) for mark in marks]
    near = np.ones(len(turn), dtype=bool) if home is None else reached(turn.phi, home, barriers)
    branched = any(KINDS[group.kind].branched for group in sweep.groups)
    found = []
    for k, position in enumerate(positions):
        phi, missed = float(turn.phi[k]), [float(miss[k]) for miss in misses]
        edge = None if home is None else bounding(phi, home, barriers)
        # Beyond a change point or parallel guides it does not matter whether the links would meet.
        met = edge is None or edge.kind == OUT_OF_REACH or near[k]
        unplaced = _unplaced(sweep.groups, field[:, k], nowhere[:, k], marks, missed, k, position, phi) if met else None
        if home is None and unplaced is None:  # the links meet, but not as the sketch shows them
            unplaced = Gap(position, phi, POSITIONS.plan, OUT_OF_REACH, "", 0.0, message("gap.sketch"))
        found.append(unplaced or _beyond(position, phi, edge, branched))
    return found


def _unplaced(
    groups: Sequence[Assur], margin: Floats, none: Flags, marks: Sequence[Mark], misses: Sequence[float],
    k: int, position: int, phi: float,
) -> Gap | None:  # fmt: skip
    """Name the first meeting that fails at the k-th position drawn; None: all of them are found."""
    for group, share, nowhere, mark, miss in zip(groups, margin, none, marks, misses, strict=True):
        if share < 0 and crossing(mark) is None:
            return Gap(position, phi, POSITIONS.plan, OUT_OF_REACH, met_at(mark), miss, _reach(group, mark, miss, k))
        if nowhere and crossing(mark) is None:
            advice = message("gap.one_line", point=met_at(mark))
            return Gap(position, phi, POSITIONS.plan, DEAD_CENTRE, met_at(mark), 0.0, advice)
    return None


def _beyond(position: int, phi: float, edge: BarrierEdge | None, branched: bool) -> Gap:
    """Name a position that could be assembled, but not without passing a barrier; of a branch nobody can say so."""
    reason, advice = NOT_REACHABLE, message("gap.barred")
    if edge is not None and edge.kind == OUT_OF_REACH and branched:
        return Gap(position, phi, POSITIONS.plan, OUT_OF_REACH, edge.where, 0.0, advice)
    if edge is not None and edge.kind == CHANGE_POINT:
        reason, advice = BEYOND_CHANGE_POINT, message("gap.change_point")
    elif edge is not None and edge.kind == PARALLEL_GUIDES and _near(np.array([phi]), [edge.phi], UNBORNE).any():
        reason, advice = PARALLEL_GUIDES, message("gap.parallel", point=edge.where)
    elif edge is not None and edge.kind == PARALLEL_GUIDES:
        advice = message("gap.guides", point=edge.where)
    return Gap(position, phi, POSITIONS.plan, reason, edge.where if edge else "", 0.0, advice)


def _reach(group: Assur, mark: Mark, miss: float, k: int) -> Message:
    """Say how far apart two loci are, and how far they reach."""
    if isinstance(group, Triad) and mark.step.settling is not None:
        rods = tuple(message("gap.rod", line=line, **_written(sizes)) for line, sizes in spans(group, mark, k).items())
        never = miss >= mark.step.settling.body.size
        key = "gap.rods" if rods else "gap.leads_never" if never else "gap.leads"
        return message(key, point=mark.name, miss=f"{miss:.6g}", rods=rods)
    first, second = mark.step.inputs
    if mark.step.op == "tangent":
        apart = abs(at(between(first, second), k))
        return message("gap.slot", first=first.name, second=second.name, apart=f"{apart:.6g}", miss=f"{miss:.6g}")
    ends = tuple(locus.step.inputs[0].name for locus in (first, second))
    radii = [at(locus.value.radius, k).real for locus in (first, second) if isinstance(locus.value, Arc)]
    apart = abs(at(between(first.step.inputs[0], second.step.inputs[0]), k))
    if len(radii) == 1:
        sizes = {"size": radii[0], "miss": miss, "least": radii[0] + miss}
        return message("gap.guide", line=second.name, point=first.name.rpartition(" ")[2], **_written(sizes))
    low, high = abs(radii[0] - radii[1]), sum(radii)
    sizes = {"apart": apart, "near": radii[0], "far": radii[1], "low": low, "high": high}
    names = {"start": ends[0], "end": ends[1], "first": first.name, "second": second.name}
    return message("gap.reach" if apart > high else "gap.fold", **names, **_written(sizes))


def _written(sizes: Mapping[str, float]) -> dict[str, str]:
    return {name: f"{size:.6g}" for name, size in sizes.items()}


def without_velocity(
    drawn: Motion, gone: npt.NDArray[np.bool_], blunt: npt.NDArray[np.bool_], barriers: Sequence[Barrier]
) -> list[Gap]:
    """Name the positions that are assembled but have no velocities, and leave none there for any point or link."""
    if drawn.order < VELOCITIES.number:
        return []
    letters = list(drawn.points)
    none = np.isnan(np.array([drawn.points[name].v for name in letters]))
    dead = (none.any(axis=0) | blunt) & ~gone
    forget(drawn, dead)
    change = near_edge(drawn.phi, barriers, (CHANGE_POINT,), BESIDE)
    advice = message("gap.no_velocity")
    return [
        Gap(
            int(k), float(drawn.phi[k]), VELOCITIES.plan, CHANGE_POINT if change[k] else DEAD_CENTRE,
            letters[int(np.argmax(none[:, k]))], 0.0, advice,
        )
        for k in np.flatnonzero(dead)
    ]  # fmt: skip


def forget(drawn: Motion, positions: npt.NDArray[np.bool_]) -> None:
    """Leave no velocity and no acceleration where the mechanism as a whole has none."""
    for rows in (*drawn.points.values(), *drawn.links.values()):
        for row in rows[1:]:
            row[positions] = np.nan


class Drawable(Protocol):
    """What plans are drawn of: a mechanism with its assembly; a study of it, or what answers as one."""

    made: dict[str, None]

    @property
    def sweep(self) -> Sweep:
        """The mechanism with its chosen assembly."""

    @property
    def groups(self) -> tuple[Assur, ...]:
        """Its structural groups."""

    @property
    def assembly(self) -> Assembly:
        """The assembly that the sketch chooses."""

    @property
    def barriers(self) -> tuple[Barrier, ...]:
        """What bars a full turn of the crank."""


class Drafts:
    """The plans over some positions of a study: their pattern is followed, and marks are made when they are looked at.

    The record of an order of plans holds those below it; what is asked for later is drawn over what is there.
    """

    def __init__(self, study: Drawable, turn: CrankPositions) -> None:
        self.study, self.turn = study, turn
        self._plans: list[Plan] = []
        self._record: tuple[PlanTemplate | RedrawnPlans, list[Any]] | None = None

    def follow(self, order: int) -> tuple[PlanTemplate | RedrawnPlans, list[Any]]:
        """Work out the numbers of the plans up to an order by their pattern."""
        for asked in ORDERS[: order + 1]:
            self.study.made.setdefault(asked.plan)
        pattern = self.study.sweep.pattern(order, varied=self.turn.rates is not None)
        self._record = pattern, pattern.follow(self.turn)
        return self._record

    @property
    def clear(self) -> bool:
        """Whether no meeting of the plans followed last has a miss, a dead centre or anything unknown."""
        pattern, numbers = self._record or self.follow(0)
        return pattern.clear(numbers)

    @property
    def free(self) -> bool:
        """Whether nothing bars the crank, and there can be no gap."""
        study = self.study
        return not study.barriers and study.assembly.phi is not None and not study.sweep.pinned and self.clear

    def motion(self, order: int) -> Motion:
        """Read all named points and moving links off the plans up to an order, whatever is not reached."""
        pattern, numbers = self.follow(order)
        return pattern.read(numbers, self.turn)

    def plan(self, order: int) -> Plan:
        """The plan of an order: 0 positions, 1 velocities, 2 accelerations."""
        if not self._plans:
            pattern, numbers = self._record or self.follow(order)
            self._plans = pattern.plans_of(numbers)
        for asked in ORDERS[len(self._plans) : order + 1]:
            self.study.made.setdefault(asked.plan)
            draw = velocities if asked is VELOCITIES else accelerations
            self._plans.append(draw(self._plans[-1], self.study.groups, self.turn.rates))
        return self._plans[order]

    @property
    def positions(self) -> Plan:
        """The plan of positions."""
        return self.plan(0)

    @property
    def velocities(self) -> Plan:
        """The velocity plan."""
        return self.plan(1)

    @property
    def accelerations(self) -> Plan:
        """The acceleration plan."""
        return self.plan(2)

    @cached_property
    def lost(self) -> npt.NDArray[np.bool_]:
        """Positions that the mechanism does not reach, or in which it has no one place."""
        study = self.study
        if study.assembly.phi is None:
            return np.ones(len(self.turn), dtype=bool)
        if self.free:
            return np.zeros(len(self.turn), dtype=bool)
        return lost(study.sweep, self.positions, self.turn, study.assembly.phi, study.barriers)

    @cached_property
    def unborne(self) -> npt.NDArray[np.bool_]:
        """Positions whose velocities the condition does not bear."""
        if self.free or self.study.assembly.phi is None:
            return np.zeros(len(self.turn), dtype=bool)
        return unborne(self.study.sweep, self.positions, self.turn)
