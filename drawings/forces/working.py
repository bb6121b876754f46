"""How the forces of masses are found: Φ_2 = m_2·a_S2 with the numbers put in (силы тяжести и инерции звеньев)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.forces.letters import letter_of
from drawings.kinds.working import DIGITS, MASSES, Working
from drawings.page.drafting import Drafting
from geometry.board import at
from plans.forces.cut import INERTIA, WEIGHT, Couple, ForcePlan, Load
from plans.model.motion import NOTHING


def working(plan: ForcePlan, links: Sequence[int], position: int, name: str, drafting: Drafting) -> Working:
    """Write beside a figure how weights, inertia forces and inertia couples of some links are found."""
    lines = list(_lines(plan, links, position, drafting))
    return Working(MASSES, name, lambda spot: lines, drafting)


def _lines(plan: ForcePlan, links: Sequence[int], position: int, drafting: Drafting) -> Iterator[tuple[str, ...]]:
    loads, couples = plan.acting(*links)
    known = [one for one in loads if one.kind in (WEIGHT, INERTIA)]
    largest = max((abs(at(one.force.point, position)) for one in known), default=0.0)
    for one in known:
        size = abs(at(one.force.point, position))
        if size > NOTHING * largest:
            yield _force(plan, one, size, drafting)
    for twist in (one for one in couples if one.kind == INERTIA):
        size = abs(at(twist.moment.point, position).real)
        if size > 0:
            yield _couple(plan, twist, size, drafting)


def _force(plan: ForcePlan, one: Load, size: float, drafting: Drafting) -> tuple[str, ...]:
    """Write a weight, or an inertia force."""
    k, mass = one.link, plan.machine.bodies[one.link].mass
    by = "g" if one.kind == WEIGHT else f"a_{{S{k}}}"
    return _line(letter_of(one.name, drafting), (f"m_{{{k}}}", by), (mass, size / mass), (size, "N"), drafting)


def _couple(plan: ForcePlan, one: Couple, size: float, drafting: Drafting) -> tuple[str, ...]:
    """Write an inertia couple."""
    k, inertia = one.link, plan.machine.bodies[one.link].inertia
    letters = f"J_{{S{k}}}", f"ε_{{{k}}}"
    return _line(letter_of(one.name, drafting), letters, (inertia, size / inertia), (size, "N*m"), drafting)


def _line(
    letter: str, factors: tuple[str, str], numbers: tuple[float, float], told: tuple[float, str], drafting: Drafting
) -> tuple[str, ...]:
    first, second = (drafting.number(one, DIGITS) for one in numbers)
    size, unit = drafting.number(told[0], DIGITS), drafting.word(told[1])
    return f"{letter} = {'·'.join(factors)}", f"{first}·{second}", f"{size} {unit}"
