"""The loading scheme: what a strict eye looks for when it checks the forces on a cut group with a ruler."""

from __future__ import annotations

import math
from functools import cache

import pytest

from drawings.forces.loading_scheme import leverages, scheme
from drawings.forces.scheme import LONG, SHORT, lengths
from geometry.board import at
from plans.forces.cut import PART, Cut, ForcePlan
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene
from tests import parts
from tests.gallery import GALLERY
from tests.plans.force_cases import text_of
from tests.rows import over

LOADED = ("shaper-loaded", "slider-crank", "slotted-lever", "slotter", "rocking-pump", "tangent", "tailgate")
# The ram's mass centre is off its pin.
ASIDE = ("5 = { mass = 25 }", "5 = { mass = 25, inertia = 0.3, centre = [0.03, 0.02] }")


@cache
def plan_of(text: str) -> ForcePlan:
    return Statics(LinkageStudy(parse_scene(text))).drafts().plans.plan


def gallery(name: str) -> str:
    return (GALLERY / f"{name}.toml").read_text("utf-8")


def value(plan: ForcePlan, cut: Cut, column: int, name: str) -> complex:
    """Give a force as the force plan has it."""
    known = {load.name: load.force for load in cut.loads}
    known |= {mark.name: mark for support in cut.supports for mark in (support.force, *support.parts)}
    known |= {"P_bal": plan.drive} if plan.drive is not None else {}
    return at(known[name].point, column)


@pytest.mark.part
@over("name", LOADED if parts.whole else LOADED[:2])
def test_the_equations_of_moments_hold_with_the_arms_of_the_drawing(name: str) -> None:
    """Sum of sense times force times arm, and the couples: zero, as the book writes it."""
    plan, column = plan_of(gallery(name)), 0
    for cut in plan.cuts:
        arms = {arm.name: arm for arm in leverages(plan, cut, column)}
        for equation in cut.equations:
            names = [load.name for load in equation.loads if load.kind != PART]
            couples = sum(at(couple.moment.point, column).real for couple in equation.couples)
            terms = [
                arms[one].sense * abs(value(plan, cut, column, one)) * arms[one].length for one in names if one in arms
            ]
            last = arms.get(equation.found.name) if equation.line is not None else None
            answer = at(equation.found.point, column).real if equation.line is None else 0.0
            if last is not None:
                answer = last.sense * abs(value(plan, cut, column, last.name)) * last.length
            size = max(map(abs, [*terms, couples, answer, 1e-12]))
            assert abs(sum(terms) + couples + answer) < 1e-7 * size, equation.found.name


def test_the_arms_of_the_worked_example_are_lettered_through_its_groups() -> None:
    """M5.7: letters h go on from group to group, the leads keep their own; the gear's arm is its base radius."""
    plan = plan_of(text_of("shaper"))
    arms = [leverages(plan, cut, 0) for cut in plan.cuts]
    assert [[arm.letter for arm in own] for own in arms] == [
        ["h_{1}", "h_{2}", "l_{BD}"],
        ["h_{3}", "h_{4}", "h_{5}", "l_{CA}"],
        ["h_{6}", "h_{7}"],
    ]
    (gear,) = (arm for arm in arms[-1] if arm.name == "P_bal")
    assert gear.length == pytest.approx(0.18 * math.cos(math.radians(20)), rel=1e-12)


def test_a_guide_presses_where_the_moments_about_the_pin_balance() -> None:
    plan = plan_of(text_of("shaper", ASIDE))
    cut = plan.cuts[0]
    pin = at(plan.positions.point("D").point, 0)
    places = ((at(one.at.point, 0) - pin, at(one.force.point, 0)) for one in cut.loads if one.link == 5)
    moments = sum((arm.conjugate() * force).imag for arm, force in places)
    press = next(force for force in scheme(plan, cut, 0).acting.forces if force.name == "R_05")
    assert (press.at - pin).imag == pytest.approx(0, abs=1e-12)  # along the guide
    assert (press.at - pin).real * press.value.imag == pytest.approx(-moments, rel=1e-9)


def test_larger_forces_have_longer_arrows_within_bounds() -> None:
    found = lengths([0.5, 3.0, 40.0, 5000.0])
    assert found == sorted(found) and found[0] == SHORT and found[-1] == LONG
