"""The characteristic positions by construction: the tool's places and the notches back from them (M2.1)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from geometry.board import Mark
from geometry.precision import errors
from plans.cyclogram import tool
from plans.cyclogram import tool as watch
from plans.cyclogram.tool import Notch, Path, ToolWatch, go_back, watch_of, way_back
from plans.linkage.plan import Plan
from plans.linkage.sweep import FAN, LOOKS, NODES, Sweep, at_angles, pressure
from plans.linkage.travel import ExtremePositions, OutputTravel
from plans.model import cyclogram as c
from plans.model.cyclogram import BESIDE, TURN, Cyclogram, CyclogramTask, Position, Stop
from plans.model.dyad import Assur
from plans.model.mechanism import Output
from plans.model.motion import Extremes, Floats


class Trial:
    """The travel of an output between its extremes; crank angles rad."""

    def __init__(self, sweep: Sweep, out: Output, extremes: Extremes) -> None:
        self.sweep, self.extremes = sweep, extremes
        self.sense = -1.0 if sweep.mechanism.drive.omega < 0 else 1.0
        drive = sweep.mechanism.drive._replace(omega=1.0, epsilon=0.0)
        self.travel = OutputTravel(sweep.over(replace(sweep.mechanism, drive=drive)), out)

    @cached_property
    def way(self) -> tuple[Stroke, Stroke]:
        """The working stroke, and the way back."""
        first, last = self.extremes.phi
        there = self.sense * ((self.sense * (last - first)) % TURN)
        return Stroke(first, there), Stroke(first + there, self.sense * TURN - there)

    def along(self, phi: Floats) -> Floats:
        """Give the share of the stroke that the output has gone at crank angles; an angle is taken as the nearer."""
        begin, end = self.extremes.reach
        off = self.travel.coordinate(at_angles(phi)) - begin
        if not self.travel.sliding:
            off -= TURN * np.round((off - (end - begin) / 2) / TURN)
        return np.asarray(off / (end - begin))

    def rate(self, phi: Floats) -> Floats:
        """Give how fast the share of the stroke grows by the crank angle, 1/rad, off the velocity plan."""
        begin, end = self.extremes.reach
        return np.asarray(self.travel.speed(at_angles(phi)) / (end - begin))

    def stops(self, asked: Sequence[Stop]) -> Floats:
        """Give the crank angles at which the output comes to places of its stroke, (N,)."""
        if not asked:
            return np.zeros(0)
        low, high = (np.array(ends) for ends in zip(*map(self._between, asked), strict=True))
        shares = np.array([stop.share for stop in asked])
        for _ in range(LOOKS):
            fan = np.linspace(low, high, FAN)
            beyond = self.along(fan.ravel()).reshape(fan.shape) >= shares
            change = np.argmax(beyond != beyond[0], axis=0)
            each = np.arange(len(asked))
            low, high = fan[np.maximum(change - 1, 0), each], fan[change, each]
        return np.asarray((low + high) / 2)

    def _between(self, stop: Stop) -> tuple[float, float]:
        """Give the neighbouring nodes of a stroke between which the output comes to a place."""
        nodes = self.way[stop.back].nodes
        shares = self.along(nodes)
        shares[[0, -1]] = (1.0, 0.0) if stop.back else (0.0, 1.0)  # the extremes are exact
        beyond = shares >= stop.share
        change = int(np.argmax(beyond != beyond[0]))
        return float(nodes[change - 1]), float(nodes[change])

    def watched(self, group: Assur) -> list[tuple[float, bool]]:
        """Give where the pressure angle of a group is extreme within a stroke, and whether on the way back."""
        found = []
        for back, stroke in enumerate(self.way):
            nodes = stroke.within(BESIDE * self.sense).nodes
            angles = np.broadcast_to(pressure(self.sweep.plan(nodes), group), nodes.shape)
            growth = np.diff(angles)
            turns = np.flatnonzero((growth[1:] >= 0) != (growth[:-1] >= 0))
            found += [(float(nodes[k + 1]), bool(back)) for k in turns.tolist()]
        return found


class Stroke(NamedTuple):
    """A stroke by the crank angle rad where it begins, and how far the crank turns over it, signed."""

    begin: float
    sweep: float

    @property
    def nodes(self) -> Floats:
        """Crank angles close to each other over the stroke, rad."""
        return np.asarray(np.linspace(self.begin, self.begin + self.sweep, NODES // 2 + 1))

    def within(self, by: float) -> Stroke:
        """Give the stroke without its ends."""
        return Stroke(self.begin + by, self.sweep - 2 * by)


TRIED = 8.0 * float(np.finfo(float).eps)  # of a whole turn: what a trial between two crank angles leaves of a root


@dataclass(frozen=True, eq=False)
class Stations:
    """The way from the tool back to the crank, for all places of the tool together."""

    sweep: Sweep
    output: Output
    reached: ExtremePositions
    task: CyclogramTask

    @cached_property
    def trial(self) -> Trial:
        """The travel between the extremes."""
        return Trial(self.sweep, self.output, self.reached.extremes)

    @cached_property
    def asked(self) -> tuple[Stop, ...]:
        """The places of the tool that are asked for."""
        return tuple(asked(self.task, self.reached.extremes.stroke))

    @cached_property
    def way(self) -> tuple[Notch, ...] | None:
        """The groups from the tool back to the crank; None where notches do not lead back."""
        if self.output.parting is not None or self.path is None:
            return None
        return way_back(self.sweep.mechanism, self.sweep.groups, self.output.link)

    @cached_property
    def watch(self) -> ToolWatch | None:
        """The group whose pressure angle is watched."""
        return watch_of(self.sweep.mechanism, self.sweep.groups)

    @cached_property
    def tried(self) -> Floats:
        """The crank angles of the tool's places by trial, (N,) rad."""
        return self.trial.stops(self.asked)

    @cached_property
    def plan(self) -> Plan | None:
        """The plan of all places of the tool; None where notches do not lead back."""
        return self.toward(slice(None))

    def toward(self, chosen: slice) -> Plan | None:
        """Draw the plan of some places of the tool with the notches from there, each point as often as places."""
        if self.way is None or self.path is None:
            return None
        plan = Plan("positions", self.sweep.mechanism)
        tool.lay_out(plan, self.output, self.path, np.array([stop.share for stop in self.asked[chosen]]))
        go_back(plan, self.way, self.sweep.plan(self.tried[chosen]))
        return plan

    @cached_property
    def path(self) -> Path | None:
        """The tool's extreme places; None where its link has no point but fixed ones."""
        name, reach = tool.point_of(self.sweep.mechanism, self.output), self.reached.extremes.reach
        if name is None:
            return None
        ends = self.sweep.plan(np.array(self.reached.extremes.phi)).point(name)
        first, last = np.broadcast_to(np.asarray(ends.point), 2).tolist()
        return Path(name, (first, last), 0.0 if self.reached.extremes.sliding else reach[1] - reach[0])

    @cached_property
    def watched(self) -> tuple[tuple[float, bool], ...]:
        """Where the pressure angle is extreme: crank angles rad by trial, and whether on the way back."""
        return tuple(self.trial.watched(self.watch.dyad)) if self.watch else ()

    @cached_property
    def watching(self) -> Plan | None:
        """The plan of the positions of extreme pressure angle; None where there are none."""
        return self.looking(slice(None)) if self.watched else None

    def looking(self, chosen: slice) -> Plan:
        """Draw the plan of some positions of extreme pressure angle."""
        assert self.watch is not None  # who asks knows of one
        plan, phi = Plan("positions", self.sweep.mechanism), [phi for phi, _ in self.watched[chosen]]
        watch.construct(plan, self.watch, self.sweep.plan(np.array(phi)))
        return plan

    @property
    def cyclogram(self) -> Cyclogram:
        """The characteristic positions in the order of the turn."""
        extremes, sense = self.reached.extremes, self.trial.sense
        begin = sense * extremes.phi[0]
        ends = map(Position, (c.BEGIN, c.END), extremes.phi, (0.0, 1.0), extremes.reach)
        found = [*ends, *self._stops(), *self._watches()]
        ordered = sorted(found, key=lambda position: (sense * position.turned - begin) % c.TURN)
        placed = tuple(position._replace(turned=c.within(sense * position.turned)) for position in ordered)
        stroke = extremes.stroke, extremes.sliding, extremes.overlap
        return Cyclogram(c.CONSTRUCTION, self.output, int(sense), *stroke, placed)

    def _stops(self) -> Iterator[Position]:
        trial = self.tried, np.full(len(self.asked), TRIED * c.TURN)
        phi, slack = trial if self.plan is None else self._read(self.plan)
        begin, end = self.reached.extremes.reach
        for k, (stop, rate) in enumerate(zip(self.asked, self.trial.rate(phi).tolist(), strict=True)):
            place, condition = begin + stop.share * (end - begin), 1 / (c.TURN * abs(rate))
            known = place, stop.back, None, condition, float(slack[k]), self.plan is not None
            yield Position(stop.role, float(phi[k]), stop.share, *known)

    def _watches(self) -> Iterator[Position]:
        if self.watching is None or self.watch is None:
            return
        phi, slack = self._read(self.watching)
        begin, end = self.reached.extremes.reach
        angles = np.broadcast_to(pressure(self.sweep.plan(phi), self.watch.dyad), phi.shape)
        for k, (share, rate) in enumerate(
            zip(self.trial.along(phi).tolist(), self.trial.rate(phi).tolist(), strict=True)
        ):
            known = begin + share * (end - begin), self.watched[k][1], float(angles[k]), 1 / (c.TURN * abs(rate))
            yield Position(c.PRESSURE, float(phi[k]), share, *known, float(slack[k]))

    def _read(self, plan: Plan) -> tuple[Floats, Floats]:
        """Read off the crank angles, rad, and how far rounding can have moved them."""
        arm = crank(plan)
        turned = np.angle(np.asarray(arm.point)), errors(arm)[arm].place / np.abs(np.asarray(arm.point))
        count = len(self.asked) if plan is self.plan else len(self.watched)
        return np.array(np.broadcast_to(turned[0], count)), np.array(np.broadcast_to(turned[1], count))


def alone(stations: Stations, positions: Sequence[Position], number: int) -> Plan | None:
    """Draw the notches of one of the characteristic positions; None of an extreme, and of one found by trial."""
    position = positions[number]
    if position.role == c.PRESSURE:
        place = sum(other.role == c.PRESSURE for other in positions[:number])
        return stations.looking(slice(place, place + 1))
    stops = enumerate(stations.asked)
    found = next((k for k, stop in stops if stop == Stop(position.role, position.share, position.back)), None)
    return None if found is None else stations.toward(slice(found, found + 1))


def crank(plan: Plan) -> Mark:
    """Give the crank's vector on a plan that was notched back to it."""
    drive = plan.mechanism.drive
    image, points = plan.images[drive.link], plan.mechanism.links[drive.link].points
    lead = points[drive.end] - points[drive.pivot]
    assert image.arm is not None  # a crank turns
    return image.arm if image.span == lead else plan.board[f"{drive.pivot}{drive.end}"]


def asked(task: CyclogramTask, stroke: float) -> Sequence[Stop]:
    """Give the places of the tool: it enters and leaves the work past the overruns, and meets changes of the load."""
    before, past = (along.share(stroke) for along in task.overrun)
    found = [Stop(c.ENTRY, before), Stop(c.LEAVE, before, back=True)] if before else [Stop(c.BACK, 1 - past, back=True)]
    found += [Stop(c.EXIT, 1 - past)] if past else []
    shares = (along.share(stroke) for along in task.breaks)
    return [*found, *(Stop(c.BREAK, share) for share in shares if share not in (before, 1 - past))]
