"""What must stand on force sheets, by the analysis alone: polygons, schemes, equations, tables (силовой лист)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

import numpy as np

from drawings.checks.expected import NOTES, Expected, by_hand, by_roads, course, phrases
from drawings.checks.hold import stated_keys
from drawings.forces.due_acting import ExpectedArm, ExpectedForces, diagrams, named
from drawings.forces.due_lever import lever
from drawings.lettering.words import word
from drawings.linkage.due import of_plans
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Key, Kind, Leaf, Text
from drawings.symbols.figure import plain_name
from plans.analytic.kinetostatics import kinetostatics
from plans.forces.bill import ActingForce, Bearing, ForceBill
from plans.forces.cut import CutGroup, MomentEquation, indices
from plans.forces.drive import balancing_quantity
from plans.forces.marks import forces_by_hand
from plans.forces.quantities import ForceComparison
from plans.forces.statics import Statics
from plans.linkage import ram
from plans.model.motion import NOTHING, Floats
from plans.study import Study

BALANCING = "balancing"
TURN, STEPS = 360.0, 720  # degrees; places of a curve
FAR, FAINT = 1e-9, 0.01  # of the greatest: no road is further off; a smaller ordinate may be a point


def curves(statics: Statics, comparison: ForceComparison, shown: Sequence[int]) -> Iterator[Expected]:
    """Give the graph of what balances the drive, and the hodographs of the reactions that are asked for."""
    found = _Curves(statics, comparison, shown)
    yield from (*found.ordinates(), found.graph())
    for key in statics.form.sheet.hodographs:
        yield from found.hodograph(key)


@dataclass(frozen=True)
class _Curves:
    """The forces of a machine over its positions."""

    statics: Statics
    comparison: ForceComparison
    shown: Sequence[int]

    @cached_property
    def slack(self) -> float:
        """What the two roads may differ by in what balances the drive."""
        name, _, share = balancing_quantity(self.statics.study.mechanism.drive)
        found = self.comparison.analysis
        balancing = [force for force in self.comparison.of("forces") if force.name.startswith(name)]
        bounds = [found.counted(force.allowed) for force in balancing]
        return 2 * float(max(map(np.nanmax, bounds))) + max(share * found.nothing[1], found.nothing[0])

    @cached_property
    def sizes(self) -> Floats:
        """What balances the drive in the positions."""
        found, motion = self.comparison.analysis, self.comparison.motion
        given = self.statics.given(found, motion.analysis, self.statics.over(motion.road.extremes))
        return np.asarray(found.counted(given))

    def ordinates(self) -> Iterator[Expected]:
        """Give the ordinates of the positions; where numbers have no room, or beside a jam, some have none."""
        faint = self.slack + FAINT * float(np.nanmax(np.abs([*self.sizes, *self.turned[1]])))
        for k, size in enumerate(self.sizes):
            if np.isfinite(size):
                lost = k not in self.shown or abs(size) <= faint
                yield Expected(Kind.VECTOR, BALANCING, str(k), 1j * float(size), self.slack, k, may_lack=lost)

    @cached_property
    def turned(self) -> tuple[Floats, Floats]:
        """The abscissas of a whole turn, degrees, or of a stroke, m, and what balances the drive there, if any."""
        study, road = self.statics.study, self.comparison.motion.road
        if study.mechanism.drive.turns and road.whole is None:
            return np.array([0.0, TURN]), np.full(2, math.nan)
        first, last = study.turn.phi[0], study.turn.phi[-1]
        whole = study.sense * math.tau if study.mechanism.drive.turns else last - first
        phi = first + whole * np.arange(STEPS + 1) / STEPS
        motion, strokes = road.around(phi), self.statics.over(road.extremes)
        with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
            loads = self.statics.loading_over(motion, strokes)
            found = kinetostatics(road, self.statics.machine, motion, loads, self.statics.pairs)
            given = self.statics.given(found, motion, strokes)
        ways = ram.ways(study.mechanism, phi)
        along = np.arange(STEPS + 1) * TURN / STEPS if ways is None else np.abs(ways - ways[0])
        return along, np.asarray(given)

    def graph(self) -> Expected:
        """Give the graph; over less than a turn its positions alone hold it."""
        x, y = self.turned
        allowed = math.inf if np.isnan(y).any() else self.slack + FAR * float(np.ptp(y))
        name = balancing_quantity(self.statics.study.mechanism.drive).name
        return Expected(Kind.CURVE, BALANCING, name, course(x, y), allowed, ends=(0.0, float(x[-1])))

    def hodograph(self, key: str) -> Iterator[Expected]:
        """Give the points of the positions and the vectors of the shown ones."""
        plan, reaction = f"hodograph-{key}", self.comparison.analysis.reactions[key]
        bounds = [np.nanmax(row.allowed) for row in self.comparison.of("forces") if row.unit == "N"]
        slack = 2 * float(np.nanmax(bounds))
        for k, value in enumerate(reaction.force):
            if np.isfinite(value):
                yield Expected(Kind.POINT, plan, str(k), complex(value), slack, k, may_lack=True)
        for k in self.shown:
            acting = ExpectedForces(self.statics, self.comparison, k)
            name = f"R_{indices(reaction.giver, reaction.taker)}"
            value, letter = complex(reaction.force[k]), acting.letter(name)
            yield Expected(Kind.VECTOR, plan, acting.name(name), value, slack, k, may_lack=True, letter=letter)


def notes(comparison: ForceComparison, shown: Sequence[int]) -> Iterator[Expected]:
    """Give the powers and the efficiency in the shown positions, the efficiency over the cycle, the shares of wear."""
    if comparison.friction is None:
        return
    found, slack = comparison.friction[1], {quantity.name: quantity.allowed for quantity in comparison.of("friction")}
    pairs = {key: indices(*map(int, key.split("-"))) for key in found.powers}
    none = NOTHING * max(float(np.nanmax(np.abs(row), initial=0.0)) for row in (found.lost, found.useful))
    for k in (k for k in shown if np.isfinite(found.lost[k])):
        off = none + sum(float(slack[f"N_{index}"][k]) for index in pairs.values())
        useful = f"useful index {k}", float(found.useful[k]), none + float(slack["N_us"][k])
        rows = [(f"friction index {k}", float(found.lost[k]), off), useful]
        yield from phrases(NOTES, rows if "η" in slack else rows[:1], 4)
        for off in slack.get("η", [])[k : k + 1]:
            share = float(found.efficiency[k])
            yield from phrases(NOTES, [(f"η {k}", share, float(off))], 3, may_lack=not math.isfinite(share))
    whole = {"η": found.cycle} | {f"wear {key}": 100 * share for key, share in found.wear.items()}
    names = {"η": "η cycle"} | {f"wear {key}": f"wear {pairs.get(key, key)}" for key in found.wear}
    for name, value in whole.items():
        bound = slack.get(names[name], np.array([math.inf]))
        if value is not None:
            yield from phrases(NOTES, [(name, value, float(bound[0]) * (1 if name == "η" else 100))], 3, may_lack=True)


TABLE, MM, DIGITS = "values", 1000.0, 5
LEAST = 0.5  # mm: a shorter arm, or distance along a guide, is a point on paper
TURNED = 1e-9  # rad: of an arrow on paper, by its coordinates alone


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the force sheets of a scene."""
    comparison, statics = study.of(ForceComparison), study.of(Statics)
    shown = tuple(dict.fromkeys(int(leaf.metadata["position"]) for leaf in leaves))
    for k in shown:
        drawn = [leaf for leaf in leaves if int(leaf.metadata["position"]) == k]
        scales, keys = drawn[0].metadata["scales"], [stated_keys(leaf) for leaf in drawn]
        sheet = _Sheet(ExpectedForces(statics, comparison, k), scales, frozenset(chain(*keys)))
        yield from chain(sheet.polygons(), sheet.schemes(), sheet.equations(), sheet.terms(), sheet.table())
        yield from lever(sheet.acting, scales, keys)
        yield from of_plans(study, drawn)
    yield from curves(statics, comparison, shown)
    yield from diagrams(statics.machine.loads, statics.over(comparison.motion.road.extremes))
    yield from notes(comparison, shown)


@dataclass(frozen=True)
class _Sheet:
    """The sheets of one position: the scales of their figures, and the keys of all that sheets state."""

    acting: ExpectedForces
    scales: Mapping[str, float]
    keys: frozenset[Key]

    @property
    def k(self) -> int:
        return self.acting.k

    @cached_property
    def floor(self) -> float:
        """The force below which there may be none, N."""
        return self.acting.none[0]

    def polygons(self) -> Iterator[Expected]:
        """Give the vectors of the force plans and of their details; parts may stand for a whole reaction."""
        for label, bill in self.acting.bills.items():
            parts, plan = bill.parts, f"forces-{label}"
            details = {key[1] for key in self.keys if key[1].startswith(f"detail-{label}-")}
            for name, value in {**parts, **bill.sides}.items():
                faint = abs(value) <= SEEN * self.scales.get(plan, 0.0) + self.floor
                row = Expected(Kind.VECTOR, plan, name, value, self.acting.slack, self.k, name in parts or faint)
                row = row._replace(letter=self.acting.letter(name))
                yield row
                yield from (row._replace(figure=detail, may_lack=True) for detail in details)

    def schemes(self) -> Iterator[Expected]:
        """Give the forces, moments and arms on the loading schemes."""
        for label, bill in self.acting.bills.items():
            plan = f"scheme {label}"
            yield from (self._arrow(plan, force) for force in (*bill.known, *bill.driving))
            yield from (self._sense(plan, couple.name, couple.moment) for couple in bill.couples)
            for bearing in bill.bearings:
                yield from self._bearing(plan, bearing)
            mu = self.scales.get(f"scheme-{label}", 0.0)
            # Places of a scheme are told from its first point
            points = (self.acting.statics.study.mechanism.links[link].points for link in bill.links)
            zero = self.acting.position.place(min(chain(*points)))
            for arm in (arm for arm in self.acting.lettered_arms(label) if arm.letter.startswith("h")):
                row = self._arm(plan, arm, mu)
                off = math.inf if self.acting.doubtful else 2 * self.acting.off
                yield from (row, row._replace(kind=Kind.POINT, value=arm.pivot - zero, allowed=off))

    def _arrow(self, plan: str, force: ActingForce, lost: bool = False) -> Expected:
        """Give the direction of a force; of one that is none rounding decides."""
        size = abs(force.value)
        row = Expected(Kind.DIRECTION, plan, self.acting.name(force.name), 0j, math.inf, self.k, may_lack=True)
        if size <= self.floor:
            return row
        return row._replace(value=force.value / size, allowed=TURNED + self.acting.slack / size, may_lack=lost)

    def _sense(self, plan: str, name: str, moment: float, lost: bool = False) -> Expected:
        none = abs(moment) <= self.acting.none[1]
        allowed = math.inf if none else 0.0
        sense = math.copysign(1.0, moment)
        return Expected(Kind.DIRECTION, plan, self.acting.name(name), sense, allowed, self.k, may_lack=lost or none)

    def _bearing(self, plan: str, bearing: Bearing) -> Iterator[Expected]:
        """Give a reaction, whole or in parts, and of a guide how far it acts, or its moment."""
        whole, along, arm = bearing.whole, bearing.along, bearing.arm
        split = any(self._stands(plan, part.name) for part in bearing.parts)
        yield self._arrow(plan, whole, split)
        yield from (self._arrow(plan, part, True) for part in bearing.parts)
        if along is not None:
            pressed = max(abs((along.conjugate() * whole.value).imag), self.floor)  # none at all without any load
            off = self.acting.none[1] / pressed * (1 + abs(arm)) if math.isfinite(abs(arm)) and pressed else math.inf
            lost = not LEAST * self.scales.get(plan.replace(" ", "-"), 0.0) + off < abs(arm) < math.inf
            apart, shift = self._stands(plan, bearing.couple), self.acting.name(whole.name.replace("R", "x", 1))
            yield Expected(Kind.VECTOR, plan, shift, along * arm, off, self.k, may_lack=lost or apart)
            yield self._sense(plan, bearing.couple, bearing.moment, True)
            figure, size = f"{plan.replace('scheme ', 'equations-')}-{self.k}", MM * abs(arm)
            yield Expected(Kind.PHRASE, figure, shift, size, MM * off, may_lack=lost or apart, digits=DIGITS)

    def _stands(self, plan: str, name: str) -> bool:
        return (Kind.DIRECTION, plan, self.acting.name(name), self.k) in self.keys

    def _arm(self, plan: str, arm: ExpectedArm, mu: float) -> Expected:
        value, off = arm.foot - arm.pivot, self._off(arm)
        lost = self.acting.doubtful or arm.length <= LEAST * mu + off
        allowed = math.inf if self.acting.doubtful else off
        return Expected(Kind.VECTOR, plan, plain_name(arm.letter), value, allowed, self.k, lost, letter=arm.letter)

    def _off(self, arm: ExpectedArm) -> float:
        return self.acting.off + abs(arm.force.at - arm.pivot) * self.acting.slack / abs(arm.force.value)

    def equations(self) -> Iterator[Expected]:
        """Give the numbers of the equations beside the cuts."""
        for label, bill in self.acting.bills.items():
            row = Expected(Kind.PHRASE, f"equations-{label}-{self.k}", "", 0.0, position=None, digits=DIGITS)
            must = self._must(bill)
            for name, force in bill.forces.items():
                size, lost = abs(force.value), name not in must or abs(force.value) <= self.floor
                yield row._replace(name=name, value=size, allowed=self.floor, may_lack=lost)
            for name, moment in bill.moments.items():
                lost = name not in must or abs(moment) <= self.acting.none[1]
                yield row._replace(name=name, value=moment, allowed=self.acting.none[1], may_lack=lost)
            for arm in self.acting.lettered_arms(label):
                off = math.inf if self.acting.doubtful else MM * self._off(arm)
                yield row._replace(name=arm.letter, value=MM * arm.length, allowed=off, may_lack=self.acting.doubtful)

    def terms(self) -> Iterator[Expected]:
        """Give the terms of the equations of moments: sign, force and arm; what the equation gives stands first."""
        for cut in self.acting.statics.drafts().plans.plan.cuts:
            for equation in cut.equations:
                yield from self._terms(cut, equation)

    def _terms(self, cut: CutGroup, equation: MomentEquation) -> Iterator[Expected]:
        acting, about, found = self.acting, equation.about.name, equation.found.name
        least, moments = acting.none[1], acting.bills[cut.label].moments
        armed = {load.name for load in equation.loads} | {found}
        arms = [arm for arm in acting.arms[cut.label] if arm.about == about and arm.force.name in armed]
        terms = {arm.force.name: (arm.moment, f"{acting.letter(arm.force.name)}·{arm.letter}") for arm in arms}
        couples = (couple.name for couple in equation.couples if couple.name in moments)
        terms |= {name: (moments[name], f"|{acting.letter(name)}|") for name in couples}
        alone = all(abs(moment) <= least for name, (moment, _) in terms.items() if name != found)
        if cut.group is not None or acting.position.mechanism.drive.ram is None:
            terms = {found: (1.0, acting.letter(found))} | terms
        for name, (moment, product) in terms.items():
            sign = "− " if moment <= 0 else "" if name == next(iter(terms)) else "+ "
            lost = abs(moment) <= least or acting.doubtful
            text, key = sign + Text(0j, product).plain, f"{name} about {about} for {found}"
            figure, allowed = f"equations-{cut.label}-{self.k}", math.inf if lost else 0.0
            yield Expected(Kind.LETTER, figure, key, text, allowed, may_lack=lost or alone)

    def _must(self, bill: ForceBill) -> set[str]:
        given = {force.name for force in bill.known if force.name[0] != "R"}
        given |= {couple.name for couple in bill.couples if couple.name[1:2] == "^"}
        return given | {bearing.whole.name for bearing in bill.bearings}

    def table(self) -> Iterator[Expected]:
        """Give the cells of the table: by plan and by analysis, drawing error; what is none all the turn may lack."""
        comparison, language = self.acting.comparison, self.acting.statics.study.language
        nothing = dict(zip(("N", "N*m"), comparison.analysis.nothing_over, strict=True))
        slips = forces_by_hand(self.acting.statics, self.k, self.scales)
        for letters, quantity in named(self.acting.statics, comparison):
            head = f"{letters}, {word(language, quantity.unit)}"
            least = 2 * nothing[quantity.unit] + quantity.allowed
            lost = not np.any(np.abs(comparison.analysis.counted(quantity.analysis)) > least)
            found, slack = quantity.analysis[self.k], float(quantity.allowed[self.k])
            value = float(abs(found) if np.iscomplexobj(found) else found)
            size = (value, slack) if math.isfinite(value) else None
            error = math.nan if size is None else slips.get((quantity.name, self.k), math.nan)
            yield from by_roads(TABLE, head, size, by_hand(error, quantity.largest), self.k, self.keys, lost)
