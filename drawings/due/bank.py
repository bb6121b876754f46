"""What must stand on the sheets of a bank of equal mechanisms: polygons, star, shaft, courses, tables (лист блока)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

import numpy as np

from drawings.checks.expected import NOTHING, Expected, by_hand, course
from drawings.due.shaken_bank import LEFT, WHOLE, WHOLE_MOMENT, Bank, Body, Polygon
from drawings.layout.table import cell_name
from drawings.lettering.bank_letters import lowered
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.statement import Kind
from drawings.paper.strokes import Leaf
from drawings.report.balance.bank_notes import crank_of
from plans.bank.compensators import COMPENSATORS
from plans.bank.harmonics import HARMONICS
from plans.bank.letters import FORCE, MOMENT, SINGLE, letters
from plans.checks.comparison import Finding
from plans.checks.hand.bank import bank_by_hand
from plans.model.balance.bank import Compensator, Harmonic
from plans.study import Study

STAR, SHAFT, ORDERS, RESULTS = "star", "shaft", "orders", "results"
GRAPHS = {"bank_force": "force_graph", "left_force": "force_graph", "bank_moment": "moment_graph"}
FOLLOWED = {"bank_force": WHOLE, "left_force": LEFT, "bank_moment": WHOLE_MOMENT}
MANY = 40  # vectors of a polygon that are told apart
STATIONS, TURN, DIGITS = 12, 360.0, 5
FAR = 1e-9  # of a place: both roads take it from one length and one angle


def due(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's bank (row of the table of sheets)."""
    bank = study["bank"]
    own = _Sheet(Bank(bank.task, study.comparison("bank"), crank_of(study)), drafting_of(study.scene))
    scales: Mapping[str, float] = next((leaf.metadata["scales"] for leaf in leaves), {})
    yield from chain(own.polygons(), own.views(), own.courses(), own.orders(), own.compensators())
    yield from own.results(bank_by_hand(bank, scales), any(name.startswith("order_") for name in scales))


@dataclass(frozen=True)
class _Sheet:
    """A bank by the analysis."""

    own: Bank
    drafting: Drafting

    def polygons(self) -> Iterator[Expected]:
        """Give the vectors of each order, with the crank and against it, and their sum where it does not vanish."""
        for one in self.own.polygons():
            plan = plan_of(one)
            sides = {} if len(one.sides) > MANY else one.sides
            for name, value in sides.items():
                yield Expected(Kind.VECTOR, plan, name, value, one.side_slack[name])
            yield Expected(Kind.VECTOR, plan, one.name, one.whole, one.slack, may_lack=not one.open)

    def views(self) -> Iterator[Expected]:
        """Give the crank pins of the star, the places along the shaft, the arms of the compensators."""
        own = self.own
        for one in own.members:
            pin, place = (own.crank or 0.0) * own.crank_at(one), complex(float(one.place))
            lacks = own.crank is None
            yield Expected(Kind.POINT, STAR, one.name, pin, FAR * abs(pin), may_lack=lacks)
            yield Expected(Kind.POINT, SHAFT, one.name, place, FAR * abs(place), may_lack=True)
        for where in {float(one.place) for one in own.members}:
            yield Expected(Kind.LENGTH, SHAFT, f"h at {1000 * where:g}", abs(where), FAR * abs(where), may_lack=True)
            far = FAR * abs(1000 * where)
            yield Expected(Kind.PHRASE, SHAFT, f"h at {1000 * where:g}", 1000 * where, far, digits=4, may_lack=True)
        for found in own.analysis.compensators:
            plan = f"compensator-{found.asked.order}"
            for body in own.bodies(found):
                yield Expected(Kind.POINT, plan, body.name, 0j, math.inf, may_lack=True)  # by its arm
                if not body.coupled and found.asked.mass:
                    arm, slack = body.moment / found.asked.mass * body.way, 2 * own.slack_of(found) / found.asked.mass
                    yield Expected(Kind.VECTOR, plan, body.name, arm, slack + FAR * abs(arm), may_lack=True)

    def courses(self) -> Iterator[Expected]:
        """Give force and moment over the turn, along the guides or by their hodographs."""
        own = self.own
        for plan, name in FOLLOWED.items():
            values, slack = own.force_of(name), own.allowed[name] + FAR * own.most(name)
            whole = len(values) - 1
            letter = {WHOLE: "F", LEFT: "F'"}.get(name, "M")
            yield Expected(Kind.VECTOR, plan, letter, complex(values[0]), slack, 0, may_lack=True)
            for k in range(0, whole + 1, whole // STATIONS):
                number = str(k * STATIONS // whole % STATIONS)
                value = complex(values[k])
                yield Expected(Kind.VECTOR, plan, number, 1j * value.real, slack, k, may_lack=True)
                yield Expected(Kind.POINT, plan, number, value, slack, int(number), may_lack=True)
            if own.straight(name):
                lacks = not own.acts(name, False) or own.faint(name) or name == LEFT
                points = course(np.linspace(0.0, TURN, len(values)), values.real)
                yield Expected(Kind.CURVE, GRAPHS[plan], plan, points, slack, may_lack=lacks, ends=(0.0, TURN))

    def orders(self) -> Iterator[Expected]:
        """Give the cells of the table of orders: of one mechanism, of the bank, what is left, the moment."""
        own = self.own
        answered = {one.asked.order for one in own.analysis.compensators}
        for order, single in own.analysis.single.items():
            force = self._size(FORCE, own.analysis.forces[order])
            cells = [self._size(SINGLE, single), force, (0.0, 0.0) if order in answered else force]
            for column, (value, slack) in enumerate([*cells, self._size(MOMENT, own.analysis.moments[order])]):
                yield Expected(Kind.NUMBER, ORDERS, cell_name(str(order), column), value, slack, digits=DIGITS)

    def _size(self, kind: str, one: Harmonic) -> tuple[float, float]:
        """Give the largest that two vectors turning against each other come to: both along one line."""
        sizes = [abs(one.ahead), abs(one.back)]
        size = 0.0 if max(sizes) <= one.slack else math.fsum(sizes)
        return size, 2 * self.own.allowed[letters(kind, one.order)] + FAR * size

    def compensators(self) -> Iterator[Expected]:
        """Give the cells of the table of compensators: of the masses of a couple the first stands for both."""
        for one in self.own.analysis.compensators:
            for body in self.own.bodies(one):
                if not body.name.endswith("'"):
                    yield from self._mass(one, body)

    def _mass(self, one: Compensator, body: Body) -> Iterator[Expected]:
        slack, mass = self.own.slack_of(one), None if body.coupled else one.asked.mass
        far = None if mass is None else (1000 * body.moment / mass, 1000 * slack / mass)
        angle = math.degrees(cmath.phase(body.way / self.own.turn))
        turned = math.degrees(2 * slack / body.moment) + FAR if body.moment > slack else math.inf
        speed = body.turns * self.own.task.speed
        cells = (body.moment, slack), None if mass is None else (mass, 0.0), far, (speed, 0.0), (angle, turned)
        for column, cell in enumerate(cells):
            name, period = cell_name(lowered(body.name), column), TURN if column == len(cells) - 1 else 0.0
            value, off = (NOTHING, 0.0) if cell is None else cell
            yield Expected(Kind.NUMBER, COMPENSATORS, name, value, off, digits=DIGITS, period=period, may_lack=True)

    def results(self, slips: Mapping[tuple[str, int], float], drawn: bool) -> Iterator[Expected]:
        """Give the cells of the table of results; where nothing is drawn no hand can err."""
        for one in filter(_is_told, self.own.comparison.findings):
            row = f"{lowered(one.name)}, {self.drafting.word(one.unit)}"
            size, slack = float(abs(one.analysis[0])), float(one.allowed[0])
            lacks = size <= 2 * slack
            for column in range(2):
                yield Expected(Kind.NUMBER, RESULTS, cell_name(row, column), size, slack, digits=DIGITS, may_lack=lacks)
            if drawn:
                most = max(size, slack * 10.0**DIGITS)
                cell = by_hand(RESULTS, cell_name(row, 2), slips.get((one.name, 0), math.nan), most)
                yield cell._replace(may_lack=True)


def plan_of(one: Polygon) -> str:
    """Name the figure of a polygon."""
    kind = "order_moments" if one.kind == MOMENT else "order_forces"
    return f"{kind}-{abs(one.signed)}{'' if one.signed > 0 else '-back'}"


def _is_told(one: Finding) -> bool:
    """Tell whether a finding stands in the table of results: a vector of the bank or a static moment."""
    told = one.plan in (HARMONICS, COMPENSATORS) and one.name.startswith(("F_", "M_", "mr_"))
    return told and bool(abs(one.analysis[0]) > one.allowed[0] / 2)
