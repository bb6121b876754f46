"""Schemes of loading: transmissions, arms of forces, arrows that a hand may turn."""

from __future__ import annotations

import cmath
import math
from functools import cache
from types import MappingProxyType

import pytest

from drawings.forces.arms import leverages
from drawings.forces.loading_scheme import SchemeLayout
from drawings.forces.scheme import LONG, SHORT, lengths, scheme
from drawings.grading.allowance import Allowance, Allowances
from drawings.grading.asked import PlanAsked
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.onlooker import segments
from drawings.grading.scheme_arrows import arrow_verdicts
from drawings.layout.picture import Place
from drawings.lettering.lettering import bounds
from drawings.page.page import Drafting, Scale
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Arc, Circle, Group, Leaf, Line
from drawings.pens.svg import svg
from drawings.reading.sheet import see
from drawings.symbols.couples import Gear, coupling, spring
from geometry.board import at
from plans.forces.cut import ForcePlan
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene, read_scene
from tests.gallery import GALLERY
from tests.plans.force_cases import text_of

HAND = hand_of("A1")


def test_a_spring_without_length_is_a_point() -> None:
    assert set(spring(5j, 5j, HAND).points) == {5j}


def test_the_plates_of_a_coupling_face_each_other_across_its_shaft() -> None:
    first, second, *shafts = coupling(50 + 50j, 1j, HAND)
    assert abs(first.start - second.start) == pytest.approx(1.6) and abs(first.end - first.start) == pytest.approx(12.0)
    assert len(shafts) == 2 and bounds(shafts[0])[3] <= bounds(shafts[1])[1]


# The ram's mass centre is off its pin.
ASIDE = ("5 = { mass = 25 }", "5 = { mass = 25, inertia = 0.3, centre = [0.03, 0.02] }")


@cache
def plan_of(text: str) -> ForcePlan:
    return Statics(LinkageStudy(parse_scene(text))).drafts().plans.plan


def test_the_arms_of_the_worked_example_are_lettered_through_its_groups() -> None:
    """M5.7: letters h go on from group to group, the leads keep their own; the gear's arm is its base radius."""
    plan = plan_of(text_of("shaper"))
    arms = [leverages(plan, cut, 0) for cut in plan.cuts]
    letters = [["h_{1}", "h_{2}", "l_{BD}"], ["h_{3}", "h_{4}", "h_{5}", "l_{CA}"], ["h_{6}", "h_{7}"]]
    assert [[arm.letter for arm in own] for own in arms] == letters
    short, long = sorted(arms[0][:2], key=lambda arm: arm.length)  # half a millimetre on paper is between them
    assert scheme(plan, plan.cuts[0], 0).faint(short.length + long.length) == [short.letter]
    (gear,) = (arm for arm in arms[-1] if arm.name == "P_bal")
    assert gear.length == pytest.approx(0.18 * math.cos(math.radians(20)), rel=1e-12)


def test_the_line_of_action_is_that_of_the_flank_that_bears() -> None:
    """It presses the wheel the way of the moment and towards its centre, and is named by the sense of the rotation."""
    plan, flanks = plan_of(text_of("shaper", ("positions = [60]", "positions = 12"))), set()
    for k in range(12):
        wheel, driving = scheme(plan, plan.cuts[-1], k).wheel, at(plan.balancing.point, k).real > 0
        pressed = wheel.action * cmath.rect(1.0, -wheel.at)
        assert pressed == pytest.approx((1j if driving else -1j) * cmath.exp(math.radians(20 if driving else -20) * 1j))
        assert wheel.flank == ("drive flank" if driving else "coast flank")
        flanks.add(wheel.flank)
    assert len(flanks) == 2


def test_a_guide_presses_where_the_moments_about_the_pin_balance() -> None:
    plan = plan_of(text_of("shaper", ASIDE))
    cut = plan.cuts[0]
    pin = at(plan.positions.point("D").point, 0)
    places = ((at(one.at.point, 0) - pin, at(one.force.point, 0)) for one in cut.loads if one.link == 5)
    moments = sum((arm.conjugate() * force).imag for arm, force in places)
    press = next(force for force in scheme(plan, cut, 0).acting.forces if force.name == "R_05")
    assert (press.at - pin).imag == pytest.approx(0, abs=1e-12)  # along the guide
    assert (press.at - pin).real * press.value.imag == pytest.approx(-moments, rel=1e-9)


def test_a_force_drawn_beside_its_line_turns_about_each_point_of_moments_as_in_the_equation() -> None:
    plan, turned = Statics(LinkageStudy(read_scene(GALLERY / "shaper-loaded.toml"))).drafts().plans.plan, 0
    for shown in (scheme(plan, cut, k) for k in (3, 4) for cut in plan.cuts):
        layout = SchemeLayout(shown, Place(0j, 0j, Scale(0.01, "l", "m")), Drafting(HAND), None)
        drawn = dict(zip((force.name for force in shown.acting.forces), layout.arrows, strict=True))
        for arm in (arm for arm in shown.arms if drawn[arm.name].beside):
            arrow, turned = drawn[arm.name], turned + 1
            moment = (arrow.at - layout.place.on(arm.pivot)).conjugate() * arrow.direction
            assert moment.imag * arm.sense > 0, (shown.column, arm.name)
    assert turned


def test_larger_forces_have_longer_arrows_within_bounds() -> None:
    found = lengths([0.5, 3.0, 40.0, 5000.0])
    assert found == sorted(found) and found[0] == SHORT and found[-1] == LONG


SHARE, OWN = Allowances(Allowance(share=0.02)), Allowances(named=MappingProxyType({"G": Allowance(1.0)}))


def kind(force: str, turned: float, by: Allowances) -> str:
    """Draw an arrow of 20 mm turned by an angle, rad, and give what is said of it."""
    asked = PlanAsked("scheme 2-3", 9, "forces", "N", (), {}, ways={force: -1j})
    start = 100 + 100j
    arrow = Group((Line(start, start - 20j * cmath.rect(1.0, turned)),), data={"kind": "force", "name": force})
    rod = Line(start, start + 40)
    seen = see(svg(Leaf(200.0, 200.0, (Group((rod, arrow), "scheme-2-3-9"),))))
    (said,) = arrow_verdicts(seen, DrawnPlan(asked, {}, 1.0, {}, True), by)
    return said.kind


@pytest.mark.parametrize(
    ("force", "turned", "by", "said"),
    [
        ("G_2", 0.06, Allowances(), "right"),
        ("G_2", 0.3, Allowances(), "turned"),
        ("G_2", 0.06, SHARE, "right"),  # a share of the largest vector is no angle
        ("G_2", 0.3, SHARE, "turned"),
        ("G_2", 0.3, OWN, "right"),
        ("R_12", 0.3, OWN, "turned"),
    ],
)
def test_an_arrow_may_be_turned_as_far_as_a_hand_slips(force: str, turned: float, by: Allowances, said: str) -> None:
    assert kind(force, turned, by) == said


@pytest.mark.parametrize(("kind", "sides"), [("force", 0), ("vector", 1)])
def test_an_arrow_that_is_not_to_scale_is_no_side_of_a_polygon(kind: str, sides: int) -> None:
    arrow = Group((Line(100 + 100j, 120 + 100j),), data={"kind": kind, "name": "F_s"})
    assert len(segments(Leaf(200.0, 200.0, (Group((arrow,)),)), {})) == sides


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("at", [0.0, 1.1, math.radians(210), 5.0])
def test_the_line_of_action_leaves_the_pitch_tangent_by_the_pressure_angle(at: float, sense: int) -> None:
    pressure = math.radians(20)
    action = 1j * sense * cmath.rect(1, at + sense * pressure)
    gear = Gear(100 + 100j, 60.0, at, action)
    circle, tangent, line, arc, contact = gear.draw(HAND)
    assert isinstance(circle, Arc) and circle.radius == 60.0 and circle.style.dash
    assert isinstance(contact, Circle) and abs(contact.centre - gear.centre) == pytest.approx(60.0)
    assert isinstance(arc, Arc) and arc.sweep == pytest.approx(pressure)
    for stroke in (tangent, line):
        assert isinstance(stroke, Line) and (stroke.start + stroke.end) / 2 == pytest.approx(contact.centre)
    ends = {round(cmath.phase(arc.at(k) - contact.centre), 6) for k in (0, 1)}
    assert ends == {round(cmath.phase(action), 6), round(cmath.phase(gear.tangent), 6)}
    # square to the line of action from the shaft: the base circle
    assert abs(((gear.centre - gear.contact) * action.conjugate()).imag) == pytest.approx(60 * math.cos(pressure))
