"""The truth of a bench: the construction's record carried out in 50 digits at exact crank angles (эталон)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from importlib.util import find_spec
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from geometry.board import Mark
from geometry.errors import DraftError
from geometry.replay import digits as fifty_digits
from geometry.replay import exact
from plans.forces.cut import ForcePlan
from plans.forces.statics import ForceDrafts, Statics
from plans.forces.stroke import Stroke
from plans.linkage.drafts import Drafts
from plans.linkage.plan import Plan
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.machine import Force, Machine, Spring, Track
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import LINK_ORDERS, ORDERS, POINT_ORDERS, Complexes, Floats, Motion

Key: TypeAlias = tuple[str, str]  # kind of quantity and its point or link: ("v", "B"), ("omega", "3")
Values: TypeAlias = Mapping[Key, Complexes | Floats]

FORCE_KINDS = REACTION, MOMENT = "R", "M"  # of the pairs, and what the drive gives: M_bal, and the force R_bal
KINDS = (*POINT_ORDERS, *LINK_ORDERS, *FORCE_KINDS)
BALANCING = "bal"


class NotInstalled(DraftError):  # noqa: N818  (the message's own word)
    """A library that this part of the bench needs is not there."""

    exit_code = 7


@dataclass(frozen=True)
class Exact:
    """True values over some positions: `near` in float64, and the `rest` that float64 has no room for.

    >>> third = Exact(np.array([1 / 3]), np.array([1.850371707708594e-17]))
    >>> float(third.off(np.array([0.25]))[0])
    0.08333333333333333
    """

    near: Any
    rest: Any

    def off(self, values: Complexes | Floats) -> Floats:
        """Give how far values are from the true ones; near values lose nothing in the difference."""
        return np.asarray(np.abs((values - self.near) - self.rest))


@dataclass(frozen=True)
class Truth:
    """The true values at some positions of a study."""

    positions: tuple[int, ...]
    values: Mapping[Key, Exact]

    def at(self, positions: Sequence[int]) -> Truth:
        """Give the truth at some of its positions."""
        return Truth(tuple(positions), {key: self.of(key, positions) for key in self.values})

    def of(self, key: Key, positions: Sequence[int]) -> Exact:
        """Give the truth of one quantity at some of the positions."""
        places, exact = [self.positions.index(k) for k in positions], self.values[key]
        return Exact(exact.near[places], exact.rest[places])


@dataclass(frozen=True)
class Replay:
    """The marks whose values are wanted, drawn at some positions and ready to be carried out in 50 digits."""

    study: LinkageStudy
    positions: tuple[int, ...]
    points: Mapping[Key, Mark]
    arms: Mapping[str, tuple[Mark, complex]]  # a link's vector on the plan of positions, and in its own frame
    rates: Mapping[Key, tuple[Mark, Mark]]
    wanted: list[Mark]
    crank: Mark
    forces: Mapping[Key, tuple[Mark, float]] = field(default_factory=dict)  # with the sense in which they are told
    loads: TrueLoads | None = None
    loaded: Sequence[Mark] = ()  # the given marks of the loads

    @property
    def only_forces(self) -> Replay:
        """This replay with nothing read off it but the forces."""
        wanted = [mark for mark, _ in self.forces.values()]
        return replace(self, points={}, arms={}, rates={}, wanted=wanted)

    def truth(self) -> Truth:
        """Carry the record out, position by position."""
        columns = [self._column(column, position) for column, position in enumerate(self.positions)]
        plain = {key: complex if key[0] in (*POINT_ORDERS, REACTION) else float for key in columns[0]}
        return Truth(self.positions, {key: split([one[key] for one in columns], plain[key]) for key in plain})

    def _column(self, column: int, position: int) -> dict[Key, Any]:
        """Give the true values of one position as numbers of 50 digits."""
        mp = digits()
        true = exact(self.wanted, column, {self.crank: crank_direction(mp, self.study, position)})
        found = {key: true[mark] for key, mark in self.points.items()}
        found |= {("angle", link): mp.arg(true[arm] / mp.mpc(span)) for link, (arm, span) in self.arms.items()}
        for key, (arm, turning) in self.rates.items():
            found[key] = (mp.conj(true[arm]) * true[turning]).imag / abs(true[arm]) ** 2
        if self.loads is None:
            return found
        loads = dict(zip(self.loaded, self.loads.at(mp, column, found), strict=True))
        true = exact([mark for mark, _ in self.forces.values()], column, true | loads)
        told = {key: sense * true[mark] for key, (mark, sense) in self.forces.items()}
        return found | {key: mp.re(value) if key[0] == MOMENT else value for key, value in told.items()}


def replay(study: LinkageStudy, positions: Sequence[int], statics: Statics | None = None) -> Replay:
    """Draw the three plans at some positions of a study, to be replayed; with its statics the force plan as well."""
    drafts = Drafts(study, study.turn.part(list(positions)))
    if statics is None:
        return _of_motion(study, positions, [drafts.plan(order) for order in range(len(ORDERS))])
    drawn = ForceDrafts(statics, drafts)
    plan = drawn.plans.plan
    machine, mechanism = statics.machine, study.mechanism
    return replace(
        _of_motion(study, positions, [plan.positions, plan.velocities, plan.accelerations]),
        forces=dict(_of_forces(plan)),
        loads=TrueLoads(machine, mechanism, statics.strokes, drawn.loading, drafts.turn.phi),
        loaded=plan.given,
    )


def _of_forces(plan: ForcePlan) -> Iterator[tuple[Key, tuple[Mark, float]]]:
    """Name the reactions, the moments of the sliding pairs, and what the drive gives."""
    for support in (support for cut in plan.cuts for support in cut.reactions):
        ends, sense = sorted((support.giver, support.taker)), 1.0 if support.giver < support.taker else -1.0
        key = "-".join(map(str, ends))
        yield (REACTION, key), (support.force, sense)
        if support.moment is not None:
            yield (MOMENT, key), (support.moment, sense)
    yield (MOMENT, BALANCING), (plan.balancing, 1.0)
    if plan.drive is not None:
        yield (REACTION, BALANCING), (plan.drive, 1.0)


def _of_motion(study: LinkageStudy, positions: Sequence[int], plans: Sequence[Plan]) -> Replay:
    """Name what the three plans tell of points and links."""
    links = {number: link for number, link in study.mechanism.links.items() if number != FRAME}
    fixed = study.mechanism.links[FRAME].points
    letters = sorted({name for link in links.values() for name in link.points} - set(fixed))
    points = {(kind, name): plans[order.number].point(name) for kind, order in POINT_ORDERS.items() for name in letters}
    arms: dict[str, tuple[Mark, complex]] = {}
    rates: dict[Key, tuple[Mark, Mark]] = {}
    for number in links:
        arms[str(number)] = (plans[0].arm(number), plans[0].images[number].span)
        for order, plan in zip(ORDERS[1:], plans[1:], strict=True):
            if number in plan.readings:  # a link that does not turn has no rate that could be wrong
                rates[order.link.key, str(number)] = plan.readings[number]
    wanted = [*points.values(), *(arm for arm, _ in arms.values()), *(mark for pair in rates.values() for mark in pair)]
    return Replay(study, tuple(positions), points, arms, rates, wanted, plans[0].board["φ"])


def values(motion: Motion, truth: Truth) -> dict[Key, Any]:
    """Read off a motion what the truth knows and the motion gives, at the truth's positions."""
    own = {**motion.points, **{str(number): link for number, link in motion.links.items()}}
    numbers = {kind: order.number for kind, order in {**POINT_ORDERS, **LINK_ORDERS}.items()}
    keys = [(kind, name) for kind, name in truth.values if numbers.get(kind, np.inf) < len(own.get(name, ()))]
    return {(kind, name): own[name][numbers[kind]][list(truth.positions)] for kind, name in keys}


def of_forces(forces: Kinetostatics, truth: Truth) -> dict[Key, Any]:
    """Read off forces what the truth knows, at the truth's positions."""
    chosen, told = list(truth.positions), forces.balancing
    found: dict[Key, Any] = {(REACTION, key): one.force for key, one in forces.reactions.items()}
    found |= {(MOMENT, key): one.moment for key, one in forces.reactions.items() if one.moment is not None}
    found |= {(MOMENT, BALANCING): told.moment, (REACTION, BALANCING): told.force}
    return {key: found[key][chosen] for key in truth.values if key[0] in FORCE_KINDS}


def sample(lost: npt.NDArray[np.bool_], count: int) -> list[int]:
    """Choose positions that are not lost: all where they are no more than `count`, else spread over the turn.

    The chosen ones are evenly spaced but for a jitter (seeded by their number): a step that divides the turn would
    meet the quarter turns alone, where sines and cosines are exact.
    """
    there = np.flatnonzero(~lost)
    if len(there) <= count:
        return [int(k) for k in there]
    edges = np.linspace(0, len(there), count + 1)
    chance = np.random.default_rng(len(there)).uniform(size=count)
    return [int(k) for k in there[(edges[:-1] + chance * np.diff(edges)).astype(int)]]


def digits() -> Any:
    """Give a reckoner in so many digits; the library may be missing."""
    if find_spec("mpmath") is None:
        raise NotInstalled(
            "the truth is reckoned in 50 digits by mpmath, which is not installed. "
            "Fix: python -m pip install '.[bench]'"
        )
    return fifty_digits()


def crank_direction(mp: Any, study: LinkageStudy, position: int) -> Any:
    """Give the crank's direction in 50 digits: an exact share of the turn from the first one, or as it is listed."""
    drive = study.form.drive
    if isinstance(drive.positions, tuple):
        return turned(mp, Fraction(drive.positions[position]) / 360)
    share = Fraction(study.sense * position, drive.positions)
    if drive.first is not None:
        return turned(mp, Fraction(drive.first) / 360 + share)
    found = mp.mpc(complex(study.turn.directions[0]))  # the extreme position is a direction that was constructed
    return found / abs(found) * turned(mp, share)


def turned(mp: Any, share: Fraction) -> Any:
    """Give the direction after a share of a turn."""
    return mp.expjpi(2 * mp.mpf(share.numerator) / share.denominator)


def split(numbers: Sequence[Any], plain: type[complex] | type[float] = complex) -> Exact:
    """Split numbers of 50 digits into what float64 holds and the rest."""
    near = [plain(number) for number in numbers]
    return Exact(np.array(near), np.array([plain(number - own) for number, own in zip(numbers, near, strict=True)]))


@dataclass(frozen=True)
class TrueLoads:
    """The loads of a machine at some positions as the construction has them, to be reckoned again in `mp`'s digits."""

    machine: Machine
    mechanism: Mechanism
    strokes: Mapping[Track, Stroke]
    loading: Loading
    phi: Floats

    def at(self, mp: Any, column: int, true: Mapping[Key, Any]) -> list[Any]:
        """Give all forces, then all moments, of one position whose true motion is known."""
        constructed = iter([complex(load.force[column]) for load in self.loading.forces])
        found = [end for force in self.machine.forces for end in self._acting(mp, column, true, force, constructed)]
        found += [end for spring in self.machine.springs for end in self._ends(mp, true, spring)]
        return [*found, *(mp.mpf(float(twist.moment[column])) for twist in self.loading.moments)]

    def _acting(
        self, mp: Any, column: int, true: Mapping[Key, Any], force: Force, constructed: Iterator[complex]
    ) -> Iterator[Any]:
        """Give a force at its point, and at the other end where that moves."""
        value = self._force(mp, column, true, force, next(constructed))
        yield value
        if force.other is not None and force.other.link != FRAME:
            next(constructed)
            yield -value

    def _force(self, mp: Any, column: int, true: Mapping[Key, Any], force: Force, given: complex) -> Any:
        if given == 0:  # it rests, or is none
            return mp.mpc(0)
        size = mp.mpf(force.size)
        if force.diagram is not None:
            travel, there, back, _ = force.diagram
            stroke = self.strokes[force.stroke]
            table = there if stroke.working(self.phi[column]) else back or there
            size *= _between(self._share(mp, true, stroke), travel, table)
        if force.direction is not None:
            return size * mp.mpc(force.direction)
        ways = [size * way for way in self._ways(mp, true, force)]
        return min(ways, key=lambda way: abs(way - given))

    def _ways(self, mp: Any, true: Mapping[Key, Any], force: Force) -> list[Any]:
        """Give the unit directions that a force without a fixed one may have."""
        if force.line is not None:
            start, end = (self._place(mp, true, point) for point in force.line)
            along = (end - start) / abs(end - start)
            return [-along, along] if force.resists else [along]
        # Against the velocity; from a rest, where that has no direction, against the acceleration.
        return [-true[kind, force.point] / abs(true[kind, force.point]) for kind in ("v", "a")]

    def _share(self, mp: Any, true: Mapping[Key, Any], stroke: Stroke) -> Any:
        """Give the share of its stroke that an output has gone."""
        low, high = map(mp.mpf, stroke.reach)
        if stroke.parting is not None:
            start, end = (self._place(mp, true, name) for name in stroke.parting.line)
            away = self._place(mp, true, stroke.point) - self._place(mp, true, stroke.parting.other)
            beyond = (mp.conj(end - start) * away).real / abs(end - start) - (low + high) / 2
        elif stroke.way is None:
            beyond = true["angle", str(stroke.link)] - (low + high) / 2
            beyond -= 2 * mp.pi * mp.nint(beyond / (2 * mp.pi))
        else:
            way = mp.mpc(stroke.way.direction)
            beyond = (mp.conj(way) * (true["r", stroke.point] - mp.mpc(stroke.way.through))).real - (low + high) / 2
        return min(max(beyond / (high - low) + mp.mpf(0.5), mp.mpf(0)), mp.mpf(1))

    def _place(self, mp: Any, true: Mapping[Key, Any], point: str) -> Any:
        """Give the place of a point, m."""
        fixed = self.mechanism.links[FRAME].points
        return mp.mpc(fixed[point]) if point in fixed else true["r", point]

    def _ends(self, mp: Any, true: Mapping[Key, Any], spring: Spring) -> Iterator[Any]:
        """Give the pull at each end of a spring that moves."""
        first, second = (self._place(mp, true, name) for name in spring.points)
        apart = second - first
        pull = mp.mpf(spring.stiffness) * apart * (1 - mp.mpf(spring.free) / abs(apart) if spring.free else 1)
        yield from (way for way, link in zip((pull, -pull), spring.links, strict=True) if link != FRAME)


def _between(share: Any, travel: tuple[float, ...], table: tuple[float, ...]) -> Any:
    """Read a diagram between its points, level before the first and after the last.

    >>> _between(0.25, (0.0, 0.5, 1.0), (0.0, 8.0, 8.0)), _between(2.0, (0.0, 1.0), (3.0, 4.0))
    (4.0, 4.0)
    """
    if share <= travel[0]:
        return table[0]
    steps = zip(travel, travel[1:], table, table[1:], strict=False)
    found = ((low, high, start, end) for low, high, start, end in steps if share <= high)
    low, high, start, end = next(found, (0.0, 1.0, table[-1], table[-1]))
    return start + (share - low) / (high - low) * (end - start)
