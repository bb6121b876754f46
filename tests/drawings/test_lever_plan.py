"""Zhukovsky's lever: the turned velocity plan with the forces at the images, checked with ruler and set square."""

from __future__ import annotations

import cmath
from math import radians

import pytest

from drawings.forces.letters import BALANCE, LOAD, PAIR
from drawings.forces.lever_plan import Hanging, balance, hanging
from drawings.layout.picture import LetteredFigure
from drawings.page.scale import Drafting
from drawings.paper.hand import hand_of
from drawings.paper.statement import Kind
from drawings.paper.strokes import Line
from drawings.paper.walk import flat, stated
from geometry.board import at
from tests.drawings.force_cases import CASES, forced, hung
from tests.parts import some

A1 = hand_of("A1")


def shown(name: str, k: int = 0) -> Hanging:
    return hanging(forced(name).plan, forced(name).lever, k)


def test_the_lever_of_the_worked_example_needs_its_gear_force() -> None:
    """M5.8: the other forces have -2850.376673 W, and the gear force of 1685.170833 N balances them."""
    pushes = shown("shaper at 60").forces
    (gear,) = (one for one in pushes if one.kind == BALANCE)
    assert abs(abs(gear.value) - 1685.170833) < 1e-6
    assert abs(gear.moment - 2850.376673) < 1e-6
    loads = sum(one.moment for one in pushes if one.kind == LOAD)
    couples = [one for one in pushes if one.kind == PAIR]  # two forces each
    assert abs(loads + sum(one.moment for one in couples) + gear.moment) < 1e-6
    assert list(dict.fromkeys(one.name for one in couples)) == ["M^Φ_1/OA", "M^Φ_3/CA", "M^Φ_4/BD"]


@pytest.mark.parametrize("name", some(sorted(CASES), 4))
def test_forces_by_their_arms_on_paper_balance_about_the_pole(name: str) -> None:
    """Each force, read off its arrow's direction, times the distance of its line from the pole; couples are pairs."""
    for k in range(0, len(forced(name).study.turn), 5):
        drawn, place = hung(forced(name), k, A1)
        pole, mu = place.on(0j), place.scale.mu
        left = shafts(drawn)
        total, greatest = 0.0, 0.0
        for one in shown(name, k).forces:
            arrow = next(a for a in left if abs(way(a) - one.direction) < 1e-9 and on_line(place.on(one.at), a))
            left.remove(arrow)
            reach = ((arrow.start - pole).conjugate() * way(arrow)).imag * mu
            total += abs(one.value) * reach
            greatest = max(greatest, abs(one.value * reach))
        assert left == []
        assert abs(total) <= 1e-9 * greatest


def shafts(drawn: LetteredFigure) -> list[Line]:
    """Read the shafts of the forces off the lever."""
    groups = (one for one in stated(drawn.lines) if one.states is not None and one.states.kind == Kind.DIRECTION)
    return [next(stroke for stroke in flat([one]) if isinstance(stroke, Line)) for one in groups]


def way(arrow: Line) -> complex:
    return (arrow.end - arrow.start) / abs(arrow.end - arrow.start)


def on_line(spot: complex, arrow: Line) -> bool:
    return abs(((spot - arrow.start) * way(arrow).conjugate()).imag) < 1e-9


def test_a_force_square_to_its_ray_has_the_ray_for_its_arm() -> None:
    """The crank's balancing force is square to the crank, so its arm on the lever is pa itself."""
    (term,) = (one for one in balance(shown("four-bar", 2), Drafting(A1)) if one.force == "P_bal")
    assert term.arm == "pa"
    assert not term.dimensioned


def test_a_couple_is_two_opposite_forces_square_to_its_link_and_none_is_at_the_hinge() -> None:
    pushes = [one for one in shown("shaper at 60").forces if one.kind == PAIR]
    first, other = (one for one in pushes if one.name == "M^Φ_4/BD")
    assert first.value == -other.value
    plan = forced("shaper at 60").plan.positions
    rod = at(plan.point("D").point, 0) - at(plan.point("B").point, 0)
    assert abs(abs(cmath.phase(first.value / rod)) - radians(90)) < 1e-9
    assert all(one.at != 0 for one in pushes)
