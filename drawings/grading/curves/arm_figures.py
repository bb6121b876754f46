"""The record of the compensators of a bank: how the arm of each mass lies on its shaft (компенсаторы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from drawings.due.shaken_bank import Bank, Body
from drawings.figures.bank.compensator_layout import COMPENSATOR
from drawings.grading import verdict
from drawings.grading.curves.asked_figure import BEARINGS, POINTS, PRICKED, FigureAsked, Item, Mistake, Values
from drawings.grading.curves.drawn_arms import arm_at, written
from drawings.grading.curves.own_sheet import OwnSheet
from plans.bank.letters import FORCE, letters
from plans.model.balance.bank import Compensator
from plans.study import Study
from plans.words.words import because


def figures_of(study: Study, own: OwnSheet) -> Iterator[FigureAsked]:
    """Give the arms of a bank's compensators (row of the table of records)."""
    expected = Bank(study["bank"].task, study.comparison("bank"))
    for one in expected.analysis.compensators:
        layout = _Layout(own, f"{COMPENSATOR}-{one.asked.order}", expected, one)
        bodies = list(expected.bodies(one))
        yield from layout.arms("", [body for body in bodies if not body.coupled])
        yield from layout.arms(" couple", [body for body in bodies if body.coupled])


@dataclass(frozen=True)
class _Layout:
    """The layout of compensators of one order on our own sheet."""

    own: OwnSheet
    plan: str
    expected: Bank
    found: Compensator

    def arms(self, part: str, bodies: list[Body]) -> Iterator[FigureAsked]:
        """Give the arms of some masses: to scale where their masses are given, else by their directions."""
        drawn = {body.name: arm_at(self.own.leaf, self.plan, written(body.name)) for body in bodies}
        shown = [body for body in bodies if drawn[body.name] is not None]
        scales = self.own.scales(self.plan)
        if not shown or "l" not in scales:
            return
        scaled = not part and not self.expected.nominal(self.found, not self.own.marks(self.plan))
        true = np.array([body.way * self._long(body, drawn, scaled) for body in shown])
        names = tuple(letters(FORCE, body.turns) for body in shown)
        yield FigureAsked(
            key=self.plan + part, plan=self.plan, sheet=self.own.name, unit="m" if scaled else "mm",
            scales={"l": scales["l"]}, items=tuple(Item(body.name, None, k, body.name) for k, body in enumerate(shown)),
            true=true, slack=np.zeros(len(true)), error=np.full(len(true), PRICKED), why=because("compensator_arm"),
            kind=POINTS if scaled else BEARINGS, on_paper=not scaled, arms=tuple(written(body.name) for body in shown),
            mistakes=(Mistake(verdict.HEAVY, -true), Mistake(verdict.EXCHANGED, true[::-1])),
            behind=() if part else names, course=None if part else self._course(names, true),
        )  # fmt: skip

    def _long(self, body: Body, drawn: Mapping[str, tuple[complex, complex] | None], scaled: bool) -> float:
        """Give how long an arm is, m; of one that is not to scale, mm on our own sheet."""
        if scaled and self.found.asked.mass:
            return body.moment / self.found.asked.mass
        start, end = drawn[body.name] or (0j, 1 + 0j)
        return abs(end - start)

    def _course(self, names: tuple[str, ...], true: Values) -> Against:
        harmonic = self.expected.analysis.forces[self.found.asked.order]
        turn = self.expected.turn
        forces = np.array([(harmonic.back if "-" in name else harmonic.ahead) * turn for name in names])
        return Against(names, forces, true)


@dataclass(frozen=True)
class Against:
    """The arms of masses against the forces of an order, as these are drawn."""

    names: tuple[str, ...]
    forces: Values
    true: Values

    def __call__(self, own: Mapping[str, Values]) -> Values:
        """Lay each arm off against its force."""
        return np.asarray(self.true * np.array([own[name][0] for name in self.names]) / self.forces)
