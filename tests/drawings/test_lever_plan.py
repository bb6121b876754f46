"""Zhukovsky's lever: the turned velocity plan with the forces at the images, checked with ruler and set square."""

from __future__ import annotations

import cmath
from math import radians

import pytest

from drawings.figures.forces.force_kinds import BALANCE, LOAD, PAIR
from drawings.figures.forces.lever_plan import Hanging, hanging
from drawings.measure.measure import check, measure
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Circle, Group, Line, Text
from drawings.paper.walk import flat
from drawings.pens.svg import svg
from drawings.symbols.arms import LEAST
from drawings.symbols.force_arrow import ForceArrow
from geometry.board import at
from tests.drawings.force_cases import CASES, Forced, forced, hung, leaf, sheet
from tests.parts import first, some

A1 = hand_of("A1")


def letters(case: Forced) -> dict[str, str]:
    plan = case.plan.velocities
    return {point: mark.name for point, mark in plan.letters.items() if mark is not plan.pole}


@pytest.mark.parametrize("name", first(sorted(CASES)))
def test_every_image_is_a_velocity_turned_clockwise_by_a_quarter(name: str) -> None:
    case = forced(name)
    for k in range(0, len(case.study.turn), 5):
        marks = measure(svg(sheet(name, k)))
        assert list(check(marks)) == []
        wanted = letters(case)
        seen = {one.name for one in marks.points if one.plan == "lever"}
        assert {mark for mark in wanted.values() if mark not in seen} == set()
        expected = case.expected(k) if name != "shaper at 60" else None
        if expected is not None:
            images = {wanted[point]: expected.image(point) for point in wanted}
            told = [one for one in marks.points if one.plan == "lever" and one.name in images]
            assert all(abs(one.value - images[one.name]) <= 1e-9 + 2 * marks.quantum * one.scale for one in told)


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
        drawn = hung(forced(name), k, A1)
        pole, mu = drawn.place.on(0j), drawn.place.scale.mu
        left = list(drawn.forces)
        total, greatest = 0.0, 0.0
        for one in shown(name, k).forces:
            arrow = next(
                a for a in left if abs(a.direction - one.direction) < 1e-9 and on_line(drawn.place.on(one.at), a)
            )
            left.remove(arrow)
            reach = ((arrow.start - pole).conjugate() * arrow.direction).imag * mu
            total += abs(one.value) * reach
            greatest = max(greatest, abs(one.value * reach))
        assert left == []
        assert abs(total) <= 1e-9 * greatest


def on_line(spot: complex, arrow: ForceArrow) -> bool:
    return abs(((spot - arrow.start) * arrow.direction.conjugate()).imag) < 1e-9


@pytest.mark.parametrize("name", some(sorted(CASES), 4))
def test_arms_are_square_to_the_forces_and_as_long_as_told(name: str) -> None:
    for k in range(0, len(forced(name).study.turn), 5):
        drawn = hung(forced(name), k, A1)
        pole, mu = drawn.place.on(0j), drawn.place.scale.mu
        told = {one.arm: one for one in drawn.terms if one.dimensioned}
        seen = {arm.letter for arm in drawn.arms}
        assert seen <= told.keys()
        assert all(one.length / mu < LEAST for letter, one in told.items() if letter not in seen), "every arm is drawn"
        for arm in drawn.arms:
            assert arm.about == pole
            assert abs(((arm.foot - pole) * arm.direction.conjugate()).real) < 1e-9
            assert abs(arm.length * mu - told[arm.letter].length) < 1e-9 * told[arm.letter].length
            start, end = arm.ends
            assert abs(end - start - (arm.foot - pole)) < 1e-9, "a dimension aside is parallel to its arm"
        moments = dict.fromkeys((one.name for one in shown(name, k).forces), 0.0)
        for one in shown(name, k).forces:
            moments[one.name] += one.moment
        for term in drawn.terms:
            assert abs(term.sense * term.size * term.length - moments[term.force]) <= 1e-9 * max(moments.values())
        assert abs(sum(one.sense * one.size * one.length for one in drawn.terms)) <= 1e-9 * max(moments.values())


def test_a_force_square_to_its_ray_has_the_ray_for_its_arm() -> None:
    """The crank's balancing force is square to the crank, so its arm on the lever is pa itself."""
    drawn = hung(forced("four-bar"), 2, A1)
    (term,) = (one for one in drawn.terms if one.force == "P_bal")
    assert term.arm == "pa"
    assert not term.dimensioned


def test_forces_are_bounded_and_start_or_end_at_their_images() -> None:
    for name in CASES:
        drawn = hung(forced(name), 0, A1)
        images = [drawn.place.on(true) for _, _, true in drawn.shown.images]
        away = 0
        for force in drawn.forces:
            assert 13 - 1e-9 <= force.length <= 26 + 1e-9
            away += min(abs(end - image) for end in (force.start, force.tip) for image in images) > 1e-6
        assert away < len(drawn.forces) / 2, name


def test_the_pole_is_a_fixed_hinge_and_its_stand_is_clear_of_the_lines() -> None:
    drawn = hung(forced("scotch yoke"), 2, A1)
    (pole,) = (group for group in drawn.lines if isinstance(group, Group) and group.data.get("kind") == "pole")
    (circle,) = pole.strokes
    assert isinstance(circle, Circle)
    feet = [
        line
        for line in flat(drawn.lines)
        if isinstance(line, Line) and line.style == A1.result and abs(line.start - circle.centre) < 2.1
    ]
    assert len(feet) >= 2


def test_images_are_joined_as_the_velocity_plan_joins_them() -> None:
    case = forced("four-bar")
    plan = case.plan.velocities
    a, b = (-1j * at(plan.point(name).point, 2) for name in "AB")
    rods = {(start, end) for (start, end), _ in shown("four-bar", 2).rods}
    assert {(0j, a), (0j, b), (a, b)} <= rods


def test_a_couple_is_two_opposite_forces_square_to_its_link_and_none_is_at_the_hinge() -> None:
    pushes = [one for one in shown("shaper at 60").forces if one.kind == PAIR]
    first, other = (one for one in pushes if one.name == "M^Φ_4/BD")
    assert first.value == -other.value
    plan = forced("shaper at 60").plan.positions
    rod = at(plan.point("D").point, 0) - at(plan.point("B").point, 0)
    assert abs(abs(cmath.phase(first.value / rod)) - radians(90)) < 1e-9
    assert all(one.at != 0 for one in pushes)


def test_the_title_and_the_letters_are_russian_on_a_russian_sheet() -> None:
    drawn = leaf([hung(forced("shaper at 60"), 0, A1, "ru")], A1)
    plain = {stroke.plain for stroke in flat(drawn.groups) if isinstance(stroke, Text)}
    assert {"Рычаг Жуковского, положение 0", "Pур", "Fп.с", "h′ур", "MΦ4/BD", "p"} <= plain
