"""What must stand on the sheets of a balanced mechanism, by the analysis alone (лист 5)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import NamedTuple

import numpy as np

from drawings.balance.report import TELLING
from drawings.checks.expected import KNOWN, Cell, Expected, cells, course, phrases
from drawings.forces.due_acting import diagrams
from drawings.forces.report import drafting_of_forces
from drawings.lettering.words import CENTRE, FORCE, MOMENT, RESULT, counterweight, with_index
from drawings.page.page import Drafting
from drawings.paper.strokes import Kind, Leaf
from plans.analytic.balance.mass_centre import bodies, vectors
from plans.analytic.points import placed
from plans.balance.quantities import BalanceComparison
from plans.balance.study import BalanceStudy
from plans.balance.weights import line_of
from plans.forces.cut import indices
from plans.forces.drive import BALANCING
from plans.model.balance.linkage import DISC, Balance, Choice, Counterweight, State
from plans.model.machine import Body
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import NOTHING as VANISHING
from plans.model.motion import Motion
from plans.study import Study

BEFORE, AFTER = "before", "after"  # the states of a machine
ROOMY, FEW = 36, 12  # positions that all have room in a graph; about so many of more are told
APART = 1e-3  # of its link: a mass centre nearer to a point than this bears no letter of its own


def places(mechanism: Mechanism, bodies: Mapping[int, Body], motion: Motion, k: int) -> dict[str, complex]:
    """Place the points of all links, the fixed ones among them, and mass centres that no point names."""
    fixed = mechanism.links[FRAME].points
    found = dict(fixed) | {name: complex(point.r[k]) for name, point in motion.points.items() if name not in fixed}
    for link, body in bodies.items():
        sizes = [abs(place - body.centre) for place in mechanism.links[link].points.values()]
        if f"S{link}" not in found and min(sizes) > APART * max(sizes):
            found[f"S{link}"] = complex(placed(mechanism, motion, link, body.centre)[k])
    return {name: spot for name, spot in found.items() if cmath.isfinite(spot)}


class Negligible(NamedTuple):
    """The force N, the moment N*m about the shaft and the way m that are no more than rounding."""

    force: float
    moment: float
    way: float


@dataclass(frozen=True)
class Balanced:
    """A mechanism balanced by analysis, in one position of the scene."""

    study: BalanceStudy
    comparison: BalanceComparison
    drafting: Drafting
    shown: int

    @property
    def balance(self) -> Balance:
        """All of it."""
        return self.comparison.analysis

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism."""
        return self.study.linkage.mechanism

    @cached_property
    def states(self) -> dict[str, State]:
        """The states that a sheet shows."""
        before, after = self.balance.before, self.balance.loaded
        return {BEFORE: before} if after is None else {BEFORE: before, AFTER: after}

    @property
    def whole(self) -> bool:
        """Whether the crank turns fully: else nothing is drawn between the positions."""
        return self.balance.before.whole

    @cached_property
    def stated(self) -> frozenset[int]:
        """The positions that the graphs must tell."""
        count = len(self.balance.before.centre.phi)
        every = 1 if count <= ROOMY else math.ceil(count / FEW)
        return frozenset({*range(0, count, every), self.shown})

    @cached_property
    def none(self) -> Negligible:
        """What is nothing on the sheets."""
        largest = max(state.forces.largest for state in self.states.values())
        return Negligible(VANISHING * largest, VANISHING * largest * self.reach, VANISHING * self.reach)

    @cached_property
    def reach(self) -> float:
        """How far points come from the shaft of the crank, m."""
        rows = [np.abs(point.r) for point in self.comparison.motion.analysis.points.values()]
        return float(np.nanmax(rows))

    def weights(self, state: str) -> list[Counterweight]:
        """List the counterweights that are on in a state."""
        return [weight for weight in self.balance.counterweights if weight.needed] if state == AFTER else []

    def solid(self, state: str) -> list[Body]:
        """List what has mass in a state, each counterweight by itself."""
        return bodies(self.study.machine, self.weights(state))

    def at(self, link: int, spot: complex) -> complex:
        """Place a spot of a link, or of the frame, in the shown position."""
        if link == FRAME:
            return spot
        return complex(placed(self.mechanism, self.comparison.motion.analysis, link, spot)[self.shown])

    @cached_property
    def points(self) -> dict[str, complex]:
        """The places of points and mass centres in the shown position."""
        return places(self.mechanism, self.study.machine.bodies, self.comparison.motion.analysis, self.shown)

    def centre(self, state: str) -> complex:
        """Place the common mass centre."""
        return complex(self.states[state].centre.r[self.shown])

    def vectors(self, state: str) -> Mapping[int, complex]:
        """Give the vectors of main points, m in the links' own frames."""
        return vectors(self.solid(state), self.study.tree.stems)

    def chain(self, state: str) -> Iterator[tuple[str, complex]]:
        """Give the main-point vectors by their names: of the frame's hinges, of the links, along guides."""
        return ((name, value) for name, value in self._sides(state) if abs(value) > KNOWN * self.reach)

    def _sides(self, state: str) -> Iterator[tuple[str, complex]]:
        solid, tree, motion = self.solid(state), self.study.tree, self.comparison.motion.analysis
        mass = sum(body.mass for body in solid)
        behind = {stem.link: sum(b.mass for b in solid if b.link in set(tree.behind(stem.link))) for stem in tree.stems}
        yield "h_0", sum((behind[stem.link] * stem.at for stem in tree.rooted), 0j) / mass
        for link, vector in self.vectors(state).items():
            yield f"h_{link}", vector * cmath.exp(1j * float(motion.links[link].angle[self.shown]))
        for stem in tree.variable:
            along = self.at(stem.link, stem.origin) - self.at(stem.parent, stem.at)
            yield f"u_{stem.link}", behind[stem.link] * along / mass

    def moments(self) -> Iterator[tuple[str, complex]]:
        """Give the static moments kg*m of the links by their names."""
        bodies = {body.link: body for body in self.solid(BEFORE)}
        for link in (stem.link for stem in self.study.tree.stems if stem.link in bodies):
            yield f"m_{link}r_S{link}", bodies[link].mass * self.at(link, bodies[link].centre)

    def slack(self, name: str, plan: str = "centre", position: int | None = None) -> float:
        """Give twice what the two roads may differ by in a quantity, in a position or in any."""
        rows = [quantity.allowed for quantity in self.comparison.of(plan) if quantity.name == name]
        peaks = [float(np.nanmax(row)) if position is None else float(row[min(position, len(row) - 1)]) for row in rows]
        return 2 * max(peaks, default=0.0)


SCHEME, MOMENTS, SHAKING, ROCKING, SHARES = "scheme-", "static-moments", "shaking", "rocking", "shares"
WEIGHTS, COSTS = "counterweights", "costs"
PRIMES = {BEFORE: "", AFTER: "'"}  # behind the names of what is compared
MILLIMETRES, TURN, DIGITS = 1000.0, 360.0, 5
CHANGE = 0.05000001  # per cent: changes are told to a tenth


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's balanced mechanism."""
    balance, comparison = study.of(BalanceStudy), study.of(BalanceComparison)
    for leaf in leaves[:1]:
        sheet = _BalanceSheet(balance, comparison, drafting_of_forces(balance.statics), leaf.metadata["position"])
        yield from chain(sheet.schemes(), sheet.polygon(), sheet.shaking(), sheet.rocking())
        yield from chain(sheet.shares(), sheet.weight_rows(), sheet.costs())
        if not TELLING & {*study.techniques}:
            strokes = balance.statics.over(comparison.motion.road.extremes)
            yield from diagrams((force for force in balance.machine.forces if force.diagram), strokes)


@dataclass(frozen=True)
class _BalanceSheet(Balanced):
    """What the analysis gives to a sheet of balancing; what is too short to be seen may lack."""

    def schemes(self) -> Iterator[Expected]:
        """Give the points, the counterweights, the mass centre and the main-point vectors of each scheme."""
        k = self.shown
        for state in self.states:
            plan, slack = SCHEME + state, self.slack(f"r_S{PRIMES[state]}", position=k) + KNOWN * self.reach
            places = {name: spot for name, spot in self.points.items() if name != self.mechanism.drive.pivot}
            places |= {f"m_cw{weight.link}": self.at(weight.link, weight.centre) for weight in self.weights(state)}
            places[CENTRE] = self.centre(state)
            yield from (Expected(Kind.POINT, plan, name, place, slack, k) for name, place in places.items())
            yield from (Expected(Kind.VECTOR, plan, name, value, slack, k, True) for name, value in self.chain(state))

    def polygon(self) -> Iterator[Expected]:
        """Give the static moments and their sum, but for what is nothing beside all of them."""
        sides = list(self.moments())
        size, mass = sum(abs(value) for _, value in sides), self.balance.before.centre.mass
        slack = self.slack("Σmr/m", position=self.shown) * mass + KNOWN * size
        for name, value in (*sides, (RESULT, sum(value for _, value in sides))):
            if abs(value) > KNOWN * size:
                yield Expected(Kind.VECTOR, MOMENTS, name, value, slack, self.shown)

    def shaking(self) -> Iterator[Expected]:
        """Give the main vectors: their ends at all positions, and themselves in the one shown."""
        largest = max(machine.shaking for machine in self.states.values())
        slack = max(self.slack(f"{FORCE}{prime}") for prime in PRIMES.values()) + KNOWN * largest
        for state, machine in self.states.items():
            if machine.shaking > self.none.force:
                known = ((k, complex(value)) for k, value in enumerate(machine.centre.force) if cmath.isfinite(value))
                for k, value in known:
                    lacks = k not in self.stated or _spread(machine) < largest
                    yield Expected(Kind.POINT, SHAKING, f"{state} {k}", value, slack, k, lacks)
                value = complex(machine.centre.force[self.shown])
                if cmath.isfinite(value):
                    name = f"{FORCE}{PRIMES[state]}"
                    yield Expected(Kind.VECTOR, SHAKING, name, value, slack, self.shown, abs(value) < 0.1 * largest)

    def rocking(self) -> Iterator[Expected]:
        """Give the ordinates of the main moment at the positions, those of the state that is told last."""
        largest = max(state.rocking for state in self.states.values())
        slack = max(self.slack(f"M_Φ{prime}") for prime in PRIMES.values()) + KNOWN * largest
        values = list(self.states.values())[-1].centre.moment
        for k, value in enumerate(np.where(np.abs(values) <= self.none.moment, 0.0, values).tolist()):
            yield Expected(Kind.VECTOR, ROCKING, str(k), 1j * value, slack, k, may_lack=True)
        names = ("last, before", "last") if len(self.states) > 1 else ("last",)
        for name, state in zip(names, self.states.values(), strict=True):
            around = state.around
            if self.whole and not np.isnan(around.moment).any():
                moments = np.where(np.abs(around.moment) <= self.none.moment, 0.0, around.moment)
                points = course(np.degrees(self.study.linkage.sense * (around.phi - around.phi[0])), moments)
                loose = max(self.slack(f"M_Φ{prime}", COSTS) for prime in PRIMES.values()) + KNOWN * largest
                yield Expected(Kind.CURVE, ROCKING, name, points, loose, ends=(0.0, TURN), may_lack=True)

    def shares(self) -> Iterator[Expected]:
        """Give the least values of the choice, and both curves of it."""
        found = self.balance.shares
        if found is None:
            return
        best = {"force": found.least_force, "reaction": found.least_reaction}
        for kind, choice in best.items():
            value = _value(choice, kind)
            yield Expected(Kind.VECTOR, SHARES, kind, 1j * value, KNOWN * value, may_lack=True)
            row = sorted((each.share, _value(each, kind)) for each in (*found.curve, *best.values()))
            x, y = np.array([share for share, _ in row]), np.array([value for _, value in row])
            points = course(x, y)
            yield Expected(Kind.CURVE, SHARES, kind, points, KNOWN * float(y.max()), ends=(float(x[0]), float(x[-1])))
            shares = (f"least {kind}", value, KNOWN * value), (f"share {kind}", choice.share, KNOWN * abs(choice.share))
            yield from phrases(SHARES, shares, digits=4)

    def weight_rows(self) -> Iterator[Expected]:
        """Give the cells of the table of counterweights."""
        for weight in self.balance.counterweights:
            row = counterweight(weight.link, self.drafting.language)
            values = self._weight_row(weight) if weight.needed else ["0", "0", *[None] * 6]
            yield from cells(WEIGHTS, row, values, digits=DIGITS)

    def _weight_row(self, weight: Counterweight) -> Sequence[Cell]:
        word = self.drafting.word
        slacks = [self.slack(f"{letter}{weight.link}", WEIGHTS) for letter in ("U_", "m_cw", "r_cw")]
        turned = weight.moment / line_of(self.mechanism, weight.link, weight.begin)
        loose = math.degrees(slacks[0] / abs(weight.moment) + KNOWN)
        sector = self.drafting.number(math.degrees(2 * weight.place.half_angle))
        outer = MILLIMETRES * weight.outer
        return [
            (abs(weight.moment), slacks[0]), (weight.mass, slacks[1]), with_index(weight.begin),
            (MILLIMETRES * weight.distance, MILLIMETRES * slacks[2]), (math.degrees(cmath.phase(turned)), loose, TURN),
            word("disc") if weight.place.shape == DISC else word("sector", angle=sector),
            (outer, outer * slacks[1] / weight.mass), (MILLIMETRES * weight.place.thickness, 0.0),
        ]  # fmt: skip

    def costs(self) -> Iterator[Expected]:
        """Give the cells of the table of what is largest before and after, with its change in per cent."""
        was = dict(self._largest(self.balance.before))
        now = dict(self._largest(self.states[AFTER])) if AFTER in self.states else {}
        for row, value in was.items():
            both = [value, now[row]] if row in now else [value]
            change = [(100 * (now[row] / value - 1), CHANGE) if value else None] if row in now else []
            *rest, last = cells(COSTS, row, [*((value, KNOWN * abs(value)) for value in both), *change], digits=DIGITS)
            yield from (*rest, last._replace(digits=3 if change else DIGITS))

    def _largest(self, state: State) -> Iterator[tuple[str, float]]:
        """Give what is largest of a state by the names of the rows; what is nothing is 0."""
        word, none = self.drafting.word, self.none
        yield word("path of S", unit=word("mm")), MILLIMETRES * _rounded(state.path, none.way)
        yield f"{FORCE}, {word('N')}", _rounded(state.shaking, none.force)
        shaft = self.mechanism.drive.pivot
        yield word("moment about", letter=MOMENT, point=shaft, unit=word("N*m")), _rounded(state.rocking, none.moment)
        for key, reaction in state.forces.reactions.items():
            index = indices(reaction.giver, reaction.taker)
            letter = self.drafting.letter(with_index(f"{self.drafting.reactions}_{index}"))
            yield f"{letter}, {word('N')}", _rounded(state.reactions[key], none.force)
        balancing = self.drafting.letter(with_index(BALANCING))
        yield f"{balancing}, {word('N*m')}", _rounded(state.balancing, none.moment)
        yield word("moving mass", unit=word("kg")), state.centre.mass


def _value(choice: Choice, kind: str) -> float:
    return choice.force if kind == "force" else choice.reaction


def _rounded(value: float, none: float) -> float:
    return 0.0 if abs(value) <= none else value


def _spread(state: State) -> float:
    """Give how far the hodograph of a state reaches, N: the larger side of the box about it."""
    known = state.around.force[np.isfinite(state.around.force)]
    return max((float(np.ptp(row)) for row in (known.real, known.imag) if row.size), default=0.0)
