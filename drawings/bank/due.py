"""What must stand on the sheet of a bank, by the analysis alone: star, shaft, polygons, tables, notes (лист блока)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain
from typing import NamedTuple

import numpy as np

from drawings.balance.due import places
from drawings.bank.report import crank_of
from drawings.checks.expected import KNOWN, Expected, by_hand, cells, course, measured
from drawings.lettering.words import lowered_bank
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.analytic.points import placed
from plans.balance.quantities import BalanceComparison
from plans.bank.harmonics import COMPENSATORS, FORCE, HARMONICS, MOMENT, SINGLE, couple_letters, letters
from plans.bank.quantities import bank_by_hand
from plans.bank.study import BankStudy
from plans.forces.statics import Statics
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.balance.bank import BankBalance, BankTask, Compensator, Harmonic, Member
from plans.model.motion import Complexes
from plans.quantity import Comparison, Quantity
from plans.study import Study

PAPER = 1e-6  # of a vector: so much of 100 mm is the last digit of a written place
DOUBTFUL = 4.0  # each road has its own bound of rounding: so near to one what is seen may be, or be left out
LINE = 1e-9  # of a unit direction: a sine that is less is of an angle that was rounded
SEEN = 1 / 1000  # of the largest order of one mechanism: less is no longer than a line is wide, and bears no figure
WHOLE, LEFT, WHOLE_MOMENT = "ΣF", "ΣF'", "ΣM"  # the findings over the turn


class OrderPolygon(NamedTuple):
    """What a polygon must show: which order, its vectors by their names, its sum, each with what it may be off by."""

    kind: str
    signed: int
    sides: Mapping[str, complex]
    name: str
    whole: complex
    side_slack: Mapping[str, float]
    slack: float
    rounding: float  # of the sum by the analysis alone

    @property
    def closed(self) -> bool:
        """Whether no more than rounding is left of the sum for certain."""
        return abs(self.whole) <= self.rounding / DOUBTFUL

    @property
    def open(self) -> bool:
        """Whether more than rounding is left of the sum for certain; of what is neither both may be seen."""
        return abs(self.whole) > self.rounding * DOUBTFUL


class CompensatorBody(NamedTuple):
    """A mass of a compensator: its letter, its place from its shaft m or direction, and how fast it turns."""

    name: str
    moment: float  # kg*m
    way: complex  # direction on the sheet
    turns: int
    coupled: bool = False

    @property
    def speed(self) -> str:
        """How fast its shaft turns in terms of the crank, as it is written: against it with a minus."""
        times = abs(self.turns)
        return f"{'−' if self.turns < 0 else ''}{times if times > 1 else ''}ω"


@dataclass(frozen=True)
class Bank:
    """A bank by the analysis, with what the two roads may differ by."""

    task: BankTask
    comparison: Comparison
    crank: float = 0.0

    @property
    def analysis(self) -> BankBalance:
        """What the analysis found."""
        found: BankBalance = self.comparison.analysis
        return found

    @cached_property
    def allowed(self) -> Mapping[str, float]:
        """What each finding may differ by."""
        return {finding.name: float(finding.allowed[0]) for finding in self.comparison.findings}

    @property
    def turn(self) -> complex:
        """The direction of the reference guide on the sheet."""
        return cmath.rect(1.0, self.task.axis)

    @property
    def members(self) -> tuple[Member, ...]:
        """The mechanisms."""
        return self.task.members

    @cached_property
    def axes(self) -> list[complex]:
        """The directions of the guides, from the reference guide."""
        return [cmath.rect(1.0, math.radians(float(member.axis % 360))) for member in self.members]

    @property
    def flat(self) -> bool:
        """Whether all guides lie in one plane with the shaft."""
        return all(abs(axis.imag) <= LINE for axis in self.axes)

    def alone(self, order: int) -> bool:
        """Tell whether the vectors of an order that turn with the crank stand for their mirror images too."""
        single = self.analysis.single[order]
        apart = abs(single.ahead - single.back.conjugate())
        return self.flat and apart <= max(PAPER * abs(single.back), single.slack)

    def straight(self, name: str) -> bool:
        """Tell whether what is followed over the turn can be shown by its share along the reference guide alone."""
        force = (self.analysis.force, self.analysis.left)
        rows = force if name != WHOLE_MOMENT else (self.analysis.moment,)
        return all(bool(np.abs(row.imag).max() <= PAPER * np.abs(rows[0]).max()) for row in rows)

    @cached_property
    def largest(self) -> float:
        """The largest force of an order of one mechanism, N."""
        return max(abs(harmonic.ahead) + abs(harmonic.back) for harmonic in self.analysis.single.values())

    def slight(self, order: int) -> bool:
        """Tell whether an order is there, but is not to be drawn beside the largest: none asks for compensators."""
        single, bank = self.analysis.single[order], self.analysis.forces[order]
        asked = order in [compensator.order for compensator in self.task.asked]
        least = SEEN * self.largest
        most = max(abs(harmonic.ahead) + abs(harmonic.back) for harmonic in (single, bank))
        return not (asked or single.vanishes or most >= least)

    @property
    def drawn_orders(self) -> Mapping[int, Harmonic]:
        """The orders of one mechanism that are to be drawn."""
        return {order: harmonic for order, harmonic in self.analysis.single.items() if not self.slight(order)}

    def polygons(self) -> Iterator[OrderPolygon]:
        """Give the polygons of several vectors: with the crank, and against it where that is no mirror image."""
        for order, single in self.drawn_orders.items():
            for kind in (FORCE, MOMENT):
                for signed in (order, -order):
                    alone = signed < 0 and self.alone(order)
                    found = self._polygon(kind, signed, single)
                    if len(found.sides) > 1 and not alone:
                        yield found

    def _polygon(self, kind: str, signed: int, single: Harmonic) -> OrderPolygon:
        vector = single.ahead if signed > 0 else single.back
        whole = (self.analysis.forces if kind == FORCE else self.analysis.moments)[single.order]
        sides = {} if abs(vector) <= single.slack else dict(self._sides(kind, signed, vector))
        name = letters(kind, signed)
        arms = {letters(kind, signed, member.name): abs(self.arm(kind, member)) for member in self.members}
        slacks = {key: self.allowed[letters(SINGLE, signed)] * arm for key, arm in arms.items()}
        value = (whole.ahead if signed > 0 else whole.back) * self.turn
        return OrderPolygon(kind, signed, sides, name, value, slacks, self.allowed[name], whole.slack)

    def _sides(self, kind: str, signed: int, vector: complex) -> Iterator[tuple[str, complex]]:
        for member, axis in zip(self.members, self.axes, strict=True):
            turned = cmath.rect(1.0, math.radians(float(signed * (member.crank - member.axis) % 360)))
            if self.arm(kind, member):
                yield letters(kind, signed, member.name), vector * turned * axis * self.turn * self.arm(kind, member)

    @staticmethod
    def arm(kind: str, member: Member) -> float:
        """Give what a force is multiplied by: 1, or its place m of a moment."""
        return 1.0 if kind == FORCE else float(member.place)

    def crank_at(self, member: Member) -> complex:
        """Give the direction of a crank on the sheet at phi = 0."""
        return cmath.rect(1.0, math.radians(float(member.crank % 360)) + self.task.axis)

    def force_of(self, name: str) -> Complexes:
        """Give what is followed over the turn, as the shaft turns, by the name of its finding."""
        rows = {WHOLE: self.analysis.force, LEFT: self.analysis.left, WHOLE_MOMENT: self.analysis.moment}
        row = rows[name] if self.task.speed > 0 else rows[name][::-1]
        return np.asarray(row if self.straight(name) else row * self.turn)

    @cached_property
    def compensated(self) -> bool:
        """Whether some compensator has a mass."""
        return any(any(self.bodies(compensator)) for compensator in self.analysis.compensators)

    def acts(self, name: str, drawn: bool) -> bool:
        """Whether more than rounding is left of what is followed over the turn, and is seen or must be."""
        analysis = self.analysis
        slacks = {WHOLE: analysis.force_slack, LEFT: analysis.left_slack, WHOLE_MOMENT: analysis.moment_slack}
        return self.most(name) > (slacks[name] / DOUBTFUL if drawn else slacks[name] * DOUBTFUL)

    def most(self, name: str) -> float:
        """Give the largest of what is followed over the turn."""
        return float(np.abs(self.force_of(name)).max())

    def faint(self, name: str) -> bool:
        """Whether what is followed over the turn is not to be drawn by itself, being slight."""
        arm = max(abs(float(member.place)) for member in self.members) if name == WHOLE_MOMENT else 1.0
        shown = {WHOLE: not self.compensated, LEFT: self.compensated}.get(name, True)
        return shown and self.most(name) < SEEN * self.largest * arm

    def bodies(self, compensator: Compensator) -> Iterator[CompensatorBody]:
        """Give the masses of a compensator at phi = 0."""
        order = compensator.asked.order
        for signed, moment, angle in compensator.masses:
            yield CompensatorBody(letters("m", signed), moment, cmath.rect(1.0, angle) * self.turn, signed)
        if compensator.couple_angle is not None and compensator.couple is not None:
            name, way = couple_letters(order).replace("mr", "m"), cmath.rect(1.0, compensator.couple_angle) * self.turn
            yield CompensatorBody(name, compensator.couple, way, order, True)
            yield CompensatorBody(f"{name}'", compensator.couple, -way, order, True)

    def line(self, compensator: Compensator) -> complex:
        """Give the line of the largest force of an order on the sheet, towards where the reference guide goes."""
        if compensator.with_angle is None or compensator.against_angle is None:
            return self.turn
        along = cmath.rect(1.0, (compensator.with_angle + compensator.against_angle) / 2)
        towards = along.real if abs(along.real) > LINE else along.imag
        return along * self.turn * math.copysign(1.0, towards)

    def slack_of(self, compensator: Compensator) -> float:
        """Give how far the static moment of a mass may be off, kg*m."""
        return self.allowed[letters("mr", compensator.asked.order)]


STAR, SHAFT, ORDERS, RESULTS = "star", "shaft", "orders", "results"
GRAPHS = {"bank_force": "force_graph", "left_force": "force_graph", "bank_moment": "moment_graph"}
FOLLOWED = {"bank_force": WHOLE, "left_force": LEFT, "bank_moment": WHOLE_MOMENT}
MANY = 40  # vectors of a polygon that are told apart
STATIONS, TURN, DIGITS = 12, 360.0, 5
FAR = 1e-9  # of a place: both roads take it from one length and one angle


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's bank."""
    task, comparison = study.of(BankStudy).task, study.comparison("bank")
    sheet = _BankSheet(task, comparison, crank_of(study), drafting=drafting_of(study.scene))
    scales: Mapping[str, float] = next((leaf.metadata["scales"] for leaf in leaves), {})
    yield from chain(sheet.vectors(), sheet.views(), sheet.courses(), sheet.orders(), sheet.compensators())
    slips, polygons = bank_by_hand(comparison.findings, scales), any(name.startswith("order_") for name in scales)
    yield from sheet.results(slips, polygons)
    if task.unit is None:
        yield from _linkage(study, leaves[0].metadata["position"])


def _linkage(study: Study, k: int) -> Iterator[Expected]:
    """Give the points of the linkage that the bank is of, its mass centres and counterweights, in one position."""
    mechanism, motion = study.of(LinkageStudy).mechanism, study.of(MotionComparison).analysis
    found = places(mechanism, study.of(Statics).machine.bodies, motion, k)
    reach = max(map(abs, found.values()))
    weights = study.of(BalanceComparison).analysis.counterweights if study.scene.has(("balance",)) else ()
    spots = {f"m_cw{one.link}": (one.link, one.centre) for one in weights if one.needed}
    found |= {name: complex(placed(mechanism, motion, *spot)[k]) for name, spot in spots.items()}
    for name, spot in found.items():
        if name != mechanism.drive.pivot:
            yield Expected(Kind.POINT, "scheme-alone", name, spot, KNOWN * reach, k)


@dataclass(frozen=True)
class _BankSheet(Bank):
    """A bank by the analysis."""

    drafting: Drafting = field(kw_only=True)

    def vectors(self) -> Iterator[Expected]:
        """Give the vectors of each order, with the crank and against it, and their sum where it does not vanish."""
        for polygon in self.polygons():
            plan = plan_of(polygon)
            sides = {} if len(polygon.sides) > MANY else polygon.sides
            for name, value in sides.items():
                yield Expected(Kind.VECTOR, plan, name, value, polygon.side_slack[name])
            yield Expected(Kind.VECTOR, plan, polygon.name, polygon.whole, polygon.slack, may_lack=not polygon.open)

    def views(self) -> Iterator[Expected]:
        """Give the crank pins of the star, the places along the shaft, the arms of the compensators."""
        for member in self.members:
            pin, place = self.crank * self.crank_at(member), complex(float(member.place))
            side = abs((pin / self.turn).real)  # along the reference guide
            yield Expected(Kind.POINT, STAR, member.name, pin, FAR * abs(pin))
            yield Expected(Kind.POINT, SHAFT, member.name, place, FAR * abs(place), may_lack=True)
            yield Expected(Kind.LENGTH, SHAFT, f"r {member.name}", side, FAR * abs(pin), may_lack=True)
        for where in {float(member.place) for member in self.members}:
            row = Expected(Kind.LENGTH, SHAFT, f"h at {1000 * where:g}", abs(where), FAR * abs(where), may_lack=True)
            yield from measured(row, 1000 * abs(where), digits=4)
        for found in self.analysis.compensators:
            plan = f"compensator-{found.asked.order}"
            for body in self.bodies(found):
                yield Expected(Kind.POINT, plan, body.name, 0j, math.inf, may_lack=True)  # by its arm
                if not body.coupled and found.asked.mass:
                    arm, slack = body.moment / found.asked.mass * body.way, 2 * self.slack_of(found) / found.asked.mass
                    yield Expected(Kind.VECTOR, plan, body.name, arm, slack + FAR * abs(arm), may_lack=True)

    def courses(self) -> Iterator[Expected]:
        """Give force and moment over the turn, along the guides or by their hodographs."""
        for plan, name in FOLLOWED.items():
            values, slack = self.force_of(name), self.allowed[name] + FAR * self.most(name)
            whole = len(values) - 1
            letter = {WHOLE: "F", LEFT: "F'"}.get(name, "M")
            yield Expected(Kind.VECTOR, plan, letter, complex(values[0]), slack, 0, may_lack=True)
            for k in range(0, whole + 1, whole // STATIONS):
                angle, value = k * 360 // whole, complex(values[k])
                yield Expected(Kind.VECTOR, plan, str(angle), 1j * value.real, slack, k, may_lack=True)
                number = k * STATIONS // whole % STATIONS
                yield Expected(Kind.POINT, plan, str(angle % 360), value, slack, number, may_lack=True)
            if self.straight(name):
                lacks = not self.acts(name, False) or self.faint(name) or name == LEFT
                points = course(np.linspace(0.0, TURN, len(values)), values.real)
                yield Expected(Kind.CURVE, GRAPHS[plan], plan, points, slack, may_lack=lacks, ends=(0.0, TURN))

    def orders(self) -> Iterator[Expected]:
        """Give the cells of the table of orders: of one mechanism, of the bank, what is left, the moment."""
        answered = {compensator.asked.order for compensator in self.analysis.compensators}
        for order, single in self.analysis.single.items():
            force = self._size(FORCE, self.analysis.forces[order])
            left, moment = (0.0, 0.0) if order in answered else force, self._size(MOMENT, self.analysis.moments[order])
            yield from cells(ORDERS, str(order), [self._size(SINGLE, single), force, left, moment], digits=DIGITS)

    def _size(self, kind: str, harmonic: Harmonic) -> tuple[float, float]:
        """Give the largest that two vectors turning against each other come to: both along one line."""
        sizes = [abs(harmonic.ahead), abs(harmonic.back)]
        size = 0.0 if max(sizes) <= harmonic.slack else math.fsum(sizes)
        return size, 2 * self.allowed[letters(kind, harmonic.order)] + FAR * size

    def compensators(self) -> Iterator[Expected]:
        """Give the cells of the table of compensators: of the masses of a couple the first stands for both."""
        for compensator in self.analysis.compensators:
            for body in self.bodies(compensator):
                if not body.name.endswith("'"):
                    yield from self._mass(compensator, body)

    def _mass(self, compensator: Compensator, body: CompensatorBody) -> Iterator[Expected]:
        slack, mass = self.slack_of(compensator), None if body.coupled else compensator.asked.mass
        far = None if mass is None else (1000 * body.moment / mass, 1000 * slack / mass)
        angle = math.degrees(cmath.phase(body.way / self.turn))
        turned = math.degrees(2 * slack / body.moment) + FAR if body.moment > slack else math.inf
        speed = body.turns * self.task.speed
        given = None if mass is None else (mass, 0.0)
        values = (body.moment, slack), given, far, (speed, 0.0), (angle, turned, TURN)
        yield from cells(COMPENSATORS, lowered_bank(body.name), values, digits=DIGITS, may_lack=True)

    def results(self, slips: Mapping[tuple[str, int], float], drawn: bool) -> Iterator[Expected]:
        """Give the cells of the table of results; where nothing is drawn no hand can err."""
        for finding in filter(_is_told, self.comparison.findings):
            row = f"{lowered_bank(finding.name)}, {self.drafting.word(finding.unit)}"
            size, slack = float(abs(finding.analysis[0])), float(finding.allowed[0])
            slip = by_hand(slips.get((finding.name, 0), math.nan), max(size, slack * 10.0**DIGITS))
            expected = cells(RESULTS, row, [(size, slack), (size, slack), *([slip] * drawn)], digits=DIGITS)
            for column, cell in enumerate(expected):
                yield cell._replace(may_lack=column == 2 or size <= 2 * slack)


def plan_of(polygon: OrderPolygon) -> str:
    """Name the figure of a polygon."""
    kind = "order_moments" if polygon.kind == MOMENT else "order_forces"
    return f"{kind}-{abs(polygon.signed)}{'' if polygon.signed > 0 else '-back'}"


def _is_told(quantity: Quantity) -> bool:
    """Tell whether a finding stands in the table of results: a vector of the bank or a static moment."""
    listed = quantity.plan in (HARMONICS, COMPENSATORS) and quantity.name.startswith(("F_", "M_", "mr_"))
    return listed and bool(abs(quantity.analysis[0]) > quantity.allowed[0] / 2)
