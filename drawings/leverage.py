"""Leverage: the arms of the forces in a cut's equations of moments, by their letters and true lengths (плечи сил)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.vector_plan import written
from geometry.board import Mark, at
from plans.cut import Cut, Equation
from plans.force import ForcePlan

# Share of a cut's largest force, or of its size: what is smaller is rounding of numbers that a scene gives with twelve
# digits, and no force, or no arm, on any paper.
NOTHING = 1e-9


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
    """Give the arms of all forces in a cut's equations, the force that each gives last; forces without moment have none.

    Letters h are numbered through the cuts of the plan, so that a sheet has each of them once; forces on one line of
    action have one arm.
    """
    found: list[Leverage] = []
    start = 0
    for one in plan.cuts:
        found = list(_of(plan, one, column, start))
        if one is cut:
            break
        start += len({arm.letter for arm in found if arm.dimensioned})
    return tuple(found)


def largest(cut: Cut, column: int) -> float:
    """Give the largest force of a cut, N."""
    forces = [load.force for load in cut.loads] + [support.force for support in cut.supports]
    return max((abs(at(force.point, column)) for force in forces), default=0.0)


def _of(plan: ForcePlan, cut: Cut, column: int, start: int) -> Iterator[Leverage]:
    known: list[Leverage] = []
    for equation in cut.equations:
        for name, spot, force, lead in _terms(equation):
            value = at(force.point, column)
            if abs(value) <= NOTHING * largest(cut, column):
                continue
            pivot, place = at(equation.about.point, column), at(spot.point, column)
            bare = Leverage(name, equation.about.name, "", 0.0, 1, pivot, place, value / abs(value))
            moment = ((place - pivot).conjugate() * bare.direction).imag
            if abs(moment) <= NOTHING * abs(place - pivot):
                continue
            sense, letter = (1 if moment > 0 else -1), _letter(bare, known, start, _lead(plan, equation, spot, lead))
            known.append(bare._replace(letter=letter, length=abs(moment), sense=sense))
    yield from known


def _lead(plan: ForcePlan, equation: Equation, spot: Mark, lead: str) -> str:
    """Give the letters of the line from the point of moments to a named point: as its link has them, if it does."""
    ends = equation.about.name + spot.name
    return "" if not lead or spot.name not in plan.positions.letters else lead if sorted(lead) == sorted(ends) else ends


def _terms(equation: Equation) -> Iterator[tuple[str, Mark, Mark, str]]:
    """Give the forces of an equation: name, point, vector, and of the found one the lead that is its arm."""
    for load in equation.loads:
        yield load.name, load.at, load.force, ""
    if equation.line is not None:
        start, lead = equation.line.step.inputs[:2]
        yield equation.found.name, start, equation.found, lead.name


def _letter(bare: Leverage, known: list[Leverage], start: int, lead: str) -> str:
    """Letter an arm: the found force's by its lead, every other by a number, those on one line of action alike."""
    arm = bare.at - bare.pivot
    if lead and abs((arm * bare.direction.conjugate()).real) <= NOTHING * abs(arm):
        return f"l_{{{lead}}}"
    same = (other for other in known if _one_line(other, bare))
    number = start + len({other.letter for other in known if other.dimensioned}) + 1
    return next((other.letter for other in same), written(f"h_{number}"))


def _one_line(one: Leverage, other: Leverage) -> bool:
    """Tell whether two forces have one line of action and one point of moments."""
    near = NOTHING * abs(one.at - one.pivot)
    return one.about == other.about and abs(one.foot - other.foot) <= near and one.dimensioned

