"""The record of the compensators of a bank: how the arm of each mass lies on its shaft (компенсаторы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from drawings.bank.compensators import COMPENSATOR
from drawings.bank.due import Bank, Body
from drawings.checks.letters import NEAREST, labels_of, off
from drawings.grading import verdict
from drawings.grading.curves.drawn_figure import PLACED, DrawnFigure, scales_on
from drawings.grading.curves.figure_records import (
    BEARINGS,
    POINTS,
    PRICKED,
    FigureAsked,
    Item,
    Mistake,
    OwnSheet,
    Values,
)
from drawings.grading.drawn_plan import Arrow
from drawings.lettering.vector_letters import lowered_bank
from drawings.paper.strokes import Circle, Leaf, Line, Text
from drawings.paper.walk import flat, group_named
from drawings.reading.sheet import SeenSheet
from plans.bank.harmonics import FORCE, letters
from plans.model.balance.bank import Compensator
from plans.study import Study
from plans.words.words import because

HOLLOW = ("", "none", "#ffffff")  # what fills a circle that is no mass


def written(name: str) -> str:
    """Give the letter of a mass as it is read."""
    return Text(0j, lowered_bank(name)).plain


def from_arms(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    """Give the arms of a figure by the letters of their masses; None where none is found."""
    found = {k: arm_at(seen.leaf, asked.plan, letter) for k, letter in enumerate(asked.arms)}
    arrows = {k: Arrow(*arm) for k, arm in found.items() if arm is not None}
    if not arrows:
        return None
    scale, is_written = scales_on(asked, seen)
    values, turn = np.full(len(asked.true), complex(np.nan, np.nan)), seen.measured.moved.p
    for k, arrow in arrows.items():
        own = arrow.vector / turn * (1.0 if asked.on_paper else scale["l"])
        values[k] = own * abs(asked.true[k]) / abs(own) if asked.kind == BEARINGS and own else own
    return DrawnFigure(asked, values, arrows, is_written, free=True)


def arm_at(leaf: Leaf, plan: str, letter: str) -> tuple[complex, complex] | None:
    """Give the ends of the arm of the mass that bears a letter, in its figure or where that is lost anywhere."""
    group = group_named(leaf.groups, plan)
    strokes = leaf.groups if group is None else (group,)
    masses = [one.centre for one in flat(strokes) if isinstance(one, Circle) and one.style.fill not in HOLLOW]
    places = [label.place for label in labels_of(strokes).get(letter, ())]
    near = [(off(spot, place), spot) for spot in masses for place in places]
    far, mass = min(near, key=lambda one: one[0], default=(NEAREST, 0j))
    if far >= NEAREST:
        return None
    lines = [one for one in flat(strokes) if isinstance(one, Line)]
    both = [ends for one in lines for ends in ((one.start, one.end), (one.end, one.start))]
    arms = [ends for ends in both if abs(ends[1] - mass) <= PLACED]
    return max(arms, key=lambda ends: abs(ends[1] - ends[0]), default=None)


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
            self.plan + part, self.plan, self.own.name, "m" if scaled else "mm", {"l": scales["l"]},
            tuple(Item(body.name, None, k, body.name) for k, body in enumerate(shown)), true, np.zeros(len(true)),
            np.full(len(true), PRICKED), POINTS if scaled else BEARINGS, why=because("compensator_arm"),
            on_paper=not scaled, arms=tuple(written(body.name) for body in shown),
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
