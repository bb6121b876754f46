"""What acts in one position by the analysis: forces, arms, what is none, letters (действующие силы)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.lettering.vector_letters import with_index
from drawings.lettering.words import letter, word
from plans.forces.bill import ActingForce, ExpectedForces, ForceBill
from plans.forces.cut import Cut, Equation, indices
from plans.forces.quantities import ForceComparison
from plans.forces.statics import Statics
from plans.model.motion import NOTHING, POSITIONS, VELOCITIES
from plans.quantity import Quantity

REACTION = re.compile(r"R(?=(\^.)?_\d+(,\d+)?$)")
EPS = float(np.finfo(np.float64).eps)
ABOUT = 30.0  # times more or less: whether such a force or moment is none is decided by rounding
CENTRE = re.compile(r"S\d*'*")  # a mass centre by its letter: no arm ends there


class DueArm(NamedTuple):
    """An arm in an equation of moments: its letter, the force and the point, the foot on the line of action, m."""

    letter: str
    force: ActingForce
    about: str
    pivot: complex
    moment: float
    line: str = ""  # how it is lettered where it is the line between two points

    @property
    def foot(self) -> complex:
        """The foot of the perpendicular on the line of action."""
        way = self.force.value / abs(self.force.value)
        return self.force.at + way * ((self.pivot - self.force.at) * way.conjugate()).real

    @property
    def length(self) -> float:
        """How long it is, m."""
        return abs(self.moment / self.force.value)


@dataclass(frozen=True)
class Acting:
    """All that acts on the links in one position."""

    statics: Statics
    comparison: ForceComparison
    k: int

    @cached_property
    def expected(self) -> ExpectedForces:
        """The forces of the position."""
        study, solved, machine = self.statics.study, self.comparison.motion.analysis, self.statics.machine
        loads = self.statics.loading(solved)
        return ExpectedForces(study.mechanism, machine, solved, loads, self.comparison.analysis, self.k)

    @cached_property
    def bills(self) -> dict[str, ForceBill]:
        """What acts on each group, and on the primary link, by their links."""
        groups = self.statics.study.groups
        bills = (ForceBill(self.expected, groups, own) for own in (*groups, None))
        return {"-".join(map(str, one.links)): one for one in bills}

    @cached_property
    def slack(self) -> float:
        """What the two roads may differ by in a force, N."""
        own = (float(one.allowed[self.k]) for one in self.comparison.of("forces") if one.unit == "N")
        return 2 * max(own, default=0.0)

    @cached_property
    def none(self) -> tuple[float, float]:
        """The force N and the moment N*m below which there may be none."""
        found = self.comparison.analysis
        force, moment = found.nothing_at(self.k)
        sizes = [abs(one.value) for bill in self.bills.values() for one in forces_of(bill).values()]
        force = self.slack + max(force, NOTHING * max(sizes, default=0.0))
        return force, force * found.size + moment

    @cached_property
    def off(self) -> float:
        """What the two roads may differ by in a place, m."""
        return self._off(POSITIONS.plan)

    @cached_property
    def fast(self) -> float:
        """What the two roads may differ by in a velocity, m/s."""
        return self._off(VELOCITIES.plan)

    def _off(self, plan: str) -> float:
        return 2 * max(
            float(np.broadcast_to(one.allowed, one.analysis.shape)[self.k]) for one in self.comparison.motion.of(plan)
        )

    def letter(self, name: str) -> str:
        """Write a force or a moment as a sheet does: R^t_34, or M^Φ_4/BD."""
        return lettered(self.statics, name)

    def name(self, name: str) -> str:
        """Name a force or a moment by its letter, without braces."""
        return unbraced(self.letter(name))

    @cached_property
    def arms(self) -> dict[str, tuple[DueArm, ...]]:
        """The arms of each cut, numbered through all of them; forces on one line of action have one."""
        found, start = dict[str, tuple[DueArm, ...]](), 0
        for cut in self.statics.drafts().plans.plan.cuts:
            found[cut.label] = tuple(self._arms(cut, start))
            start += len({one.letter for one in found[cut.label] if one.letter.startswith("h")})
        return found

    def _arms(self, cut: Cut, start: int) -> Iterator[DueArm]:
        bill, known = self.bills[cut.label], list[DueArm]()
        share = 1 / ABOUT if self.doubtful else 1.0  # all that rounding may have an arm for
        for equation in cut.equations:
            for force in self._forces(bill, equation):
                pivot = bill.place(equation.about.name)
                run = force.at - pivot
                arm = DueArm("", force, equation.about.name, pivot, (run.conjugate() * force.value).imag)
                least = share * NOTHING * abs(run * force.value)
                if abs(force.value) > share * self._least and abs(arm.moment) > least:
                    arm = arm._replace(line=self._line(equation, arm))
                    known.append(arm._replace(letter=self._lettered(arm, known, start)))
        yield from known

    def lettered_arms(self, label: str) -> Iterator[DueArm]:
        """Give the arms of a cut; where rounding decides how they are lettered, with each letter that they may bear."""
        count = sum(map(len, self.arms.values())) if self.doubtful else 0
        for arm in self.arms[label]:
            yield arm
            others = (*(f"h_{{{number}}}" for number in range(1, count + 1)), *([arm.line] if arm.line else []))
            yield from (arm._replace(letter=other) for other in others if self.doubtful)

    @cached_property
    def _least(self) -> float:
        known = (one for bill in self.bills.values() for one in (*bill.known, *(own.whole for own in bill.bearings)))
        return NOTHING * max((abs(one.value) for one in known), default=0.0)

    def _forces(self, bill: ForceBill, equation: Equation) -> Iterator[ActingForce]:
        """Give the forces of an equation, the one that it finds last."""
        forces = forces_of(bill)
        names = [load.name for load in equation.loads]
        yield from (forces[name] for name in (*names, *([] if equation.line is None else [equation.found.name])))

    def _line(self, equation: Equation, arm: DueArm) -> str:
        """Letter an arm as the line to a point where its force acts, named as the lead there is; or not at all."""
        places, k = self.comparison.motion.analysis.points, self.k
        points = (arm.force.point, *self.statics.study.mechanism.links[arm.force.link].points)
        spots = (one for one in points if one in places and not CENTRE.fullmatch(one))
        near = NOTHING * abs(arm.force.at - arm.pivot)
        spot = next((one for one in spots if abs(places[one].r[k] - arm.force.at) <= near), "")
        ends, leads = arm.about + spot, () if equation.line is None else equation.line.step.inputs[1:]
        name = next((lead.name for lead in leads if sorted(lead.name) == sorted(ends)), ends)
        return f"l_{{{name}}}" if spot else ""

    def _lettered(self, arm: DueArm, known: list[DueArm], start: int) -> str:
        """Letter an arm: as the line between two points where it is one; or number it."""
        run, way = arm.force.at - arm.pivot, arm.force.value / abs(arm.force.value)
        near = NOTHING * abs(run)
        if arm.line and abs((run * way.conjugate()).real) <= near:
            return arm.line
        numbered = [one for one in known if one.letter.startswith("h")]
        same = (one.letter for one in numbered if one.about == arm.about and abs(one.foot - arm.foot) <= near)
        return next(same, f"h_{{{start + len({one.letter for one in numbered}) + 1}}}")

    @cached_property
    def doubtful(self) -> bool:
        """Whether rounding may decide which forces have arms, so how these are numbered."""
        cuts = self.statics.drafts().plans.plan.cuts
        turned = ABOUT * EPS / NOTHING * self._least / NOTHING  # the direction of a smaller force is rounding
        return any(
            _near(abs(force.value), self._least)
            or self._least < abs(force.value) < turned
            or _near(abs((run.conjugate() * force.value).imag), NOTHING * abs(run * force.value))
            for cut in cuts
            for equation in cut.equations
            for force in self._forces(self.bills[cut.label], equation)
            for run in (force.at - self.bills[cut.label].place(equation.about.name),)
        )


def _near(size: float, least: float) -> bool:
    """Tell whether a size is about the least that counts."""
    return least / ABOUT < size < least * ABOUT


def lettered(statics: Statics, name: str) -> str:
    """Write a force or a moment as the sheets of a scene do."""
    head, slash, line = name.partition("/")
    head = REACTION.sub(statics.form.sheet.reactions, head)
    return letter(statics.study.language, with_index(head)) + slash + line


def named(statics: Statics, comparison: ForceComparison) -> Iterator[tuple[str, Quantity]]:
    """Give the findings of forces, each with what its row of the table is lettered: R_34, M_bal (by lever)."""
    for one in comparison.of("forces"):
        name, _, how = one.name.partition(" ")
        by = f" ({word(statics.study.language, f'by {how}')})" if how else ""
        yield f"{lettered(statics, name)}{by}", one


def forces_of(bill: ForceBill) -> Mapping[str, ActingForce]:
    """Give every force that may be told of a cut."""
    driving = [] if bill.driving is None else [bill.driving]
    bearings = [one for own in bill.bearings for one in (own.whole, *own.parts)]
    inner = [one for own in bill.inner for one in (own.whole, opposite(own.whole))]
    return {one.name: one for one in (*bill.known, *driving, *bearings, *inner)}


def moments_of(bill: ForceBill) -> Mapping[str, float]:
    """Give every moment that may be told of a cut."""
    found = {one.name: one.moment for one in bill.couples}
    found |= {one.couple: one.moment for one in (*bill.bearings, *bill.inner)}
    return found | {opposite(one.whole).name.replace("R", "M", 1): -one.moment for one in bill.inner}


def opposite(one: ActingForce) -> ActingForce:
    """Give a reaction as the other link takes it."""
    head, index = one.name.split("_")
    giver, taker = index.split(",") if "," in index else tuple(index)
    return one._replace(name=f"{head}_{indices(int(taker), int(giver))}", value=-one.value)


def unbraced(markup: str) -> str:
    """Name a mark by its letter, without the braces of its index.

    >>> unbraced("R^t_{34}")
    'R^t_34'
    """
    return markup.replace("{", "").replace("}", "")
