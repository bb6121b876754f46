"""Leverage: the arms of the forces in a cut's equations of moments, by their letters and true lengths (плечи сил)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.linkage.masses import is_centre
from geometry.board import Mark, at
from plans.forces.cut import Cut, Equation
from plans.forces.force import ForcePlan
from plans.model.kinetostatics import NOTHING


class Leverage(NamedTuple):
    """A force's arm about a point, m, in true units; the sense of its moment is +1 counter-clockwise, -1 clockwise.

    The letter is "h_{2}", or "l_{BD}" where the perpendicular is the line between the two named points itself.
    """

    name: str
    about: str
    letter: str
    length: float
    sense: int
    pivot: complex
    at: complex  # where the force acts
    direction: complex  # its unit direction

    @property
    def foot(self) -> complex:
        """The foot of the perpendicular on the line of action."""
        return self.at + self.direction * ((self.pivot - self.at) * self.direction.conjugate()).real

    @property
    def dimensioned(self) -> bool:
        """Whether the scheme draws it: what is a distance between named points has no arm of its own."""
        return self.letter.startswith("h")


def leverages(plan: ForcePlan, cut: Cut, column: int) -> tuple[Leverage, ...]:
    """Give the arms of all forces in a cut's equations, the force that each gives last; one without moment has none.

    Letters h are numbered through the cuts of the plan, so that a sheet has each of them once; forces on one line of
    action have one arm.
    """
    arms: list[Leverage] = []
    start = 0
    for one in plan.cuts:
        arms = list(_of(plan, one, column, start))
        if one is cut:
            break
        start += len({arm.letter for arm in arms if arm.dimensioned})
    return tuple(arms)


def largest(plan: ForcePlan, column: int) -> float:
    """Give the largest force of all cuts of a plan, N: what is but rounding beside it is none on any of them."""
    forces = [load.force for cut in plan.cuts for load in cut.loads]
    forces += [support.force for cut in plan.cuts for support in cut.supports]
    return max((abs(at(force.point, column)) for force in forces), default=0.0)


def _of(plan: ForcePlan, cut: Cut, column: int, start: int) -> Iterator[Leverage]:
    known: list[Leverage] = []
    least = NOTHING * largest(plan, column)
    letters = {mark: name for name, mark in plan.positions.letters.items()}
    for equation in cut.equations:
        about = letters.get(equation.about, equation.about.name)
        for name, spot, force in _terms(equation):
            value = at(force.point, column)
            if not abs(value) > least:
                continue
            pivot, place = at(equation.about.point, column), at(spot.point, column)
            bare = Leverage(name, about, "", 0.0, 1, pivot, place, value / abs(value))
            moment = ((place - pivot).conjugate() * bare.direction).imag
            if abs(moment) <= NOTHING * abs(place - pivot):
                continue
            letter = _lead(plan, equation, spot, bare) or _number(bare, known, start)
            known.append(bare._replace(letter=letter, length=abs(moment), sense=1 if moment > 0 else -1))
    yield from known


def _terms(equation: Equation) -> Iterator[tuple[str, Mark, Mark]]:
    """Give the forces of an equation, the one that it finds last: name, point, vector."""
    for load in equation.loads:
        yield load.name, load.at, load.force
    if equation.line is not None:
        yield equation.found.name, equation.line.step.inputs[0], equation.found


def _lead(plan: ForcePlan, equation: Equation, spot: Mark, bare: Leverage) -> str:
    """Letter an arm that is the line between two named points, as the lead there is lettered; "" where it is not."""
    arm = bare.at - bare.pivot
    square = abs((arm * bare.direction.conjugate()).real) <= NOTHING * abs(arm)
    names = {mark: name for name, mark in plan.positions.letters.items() if not is_centre(name)}
    if not square or spot not in names:
        return ""
    ends = bare.about + names[spot]
    lines = (equation.line.step.inputs if equation.line is not None else ())[1:]
    return f"l_{{{next((line.name for line in lines if sorted(line.name) == sorted(ends)), ends)}}}"


def _number(bare: Leverage, known: list[Leverage], start: int) -> str:
    """Letter an arm by a number: forces on one line of action have one."""
    same = next((other.letter for other in known if _one_line(other, bare)), "")
    return same or f"h_{{{start + len({other.letter for other in known if other.dimensioned}) + 1}}}"


def _one_line(one: Leverage, other: Leverage) -> bool:
    """Tell whether two forces have one line of action and one point of moments."""
    near = NOTHING * abs(one.at - one.pivot)
    return one.about == other.about and abs(one.foot - other.foot) <= near and one.dimensioned
