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
from plans.bench.loads import TrueLoads
from plans.forces.force import ForcePlan
from plans.forces.statics import ForceDrafts, Statics
from plans.linkage.drafts import Drafts
from plans.linkage.plan import Plan
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Kinetostatics
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats, Motion
from plans.model.order import LINK_ORDERS, ORDERS, POINT_ORDERS

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
