"""The loading scheme: what a strict eye looks for when it checks the forces on a cut group with a ruler."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from drawings.forces.fan import LONG, SHORT, lengths
from drawings.forces.loading_scheme import Scheme, draw, leverages, measure, scheme
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Spot
from drawings.page.page import Field
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand, hand_of
from drawings.paper.strokes import Group, Text
from drawings.paper.walk import flat
from geometry.board import at
from plans.forces.cut import PART, Cut, ForcePlan
from plans.forces.force_template import forces
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Applied, Loading, Twist
from plans.model.machine import FORCE, GEAR, Body, Machine, Transmission
from plans.scene.scene import read_scene

pytest.importorskip("shapely")
from tests import parts
from tests.rows import over

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
ROOM = Field(10, 10, 290, 290)
TOOTHED = Transmission(GEAR, 0.18, math.radians(210), math.radians(20))


class Machinery(NamedTuple):
    scene: str
    bodies: tuple[Body, ...]
    load: Callable[[int], Loading]
    columns: tuple[int, ...]
    transmission: Transmission = Transmission()


def push(name: str, link: int, point: str, force: complex) -> Callable[[int], Loading]:
    return lambda count: Loading((Applied(name, link, point, 0j, np.full(count, force)),), ())


SHAPER = (Body(1, 6, 0.25, 0j), Body(3, 15, 0.6, 0.35 + 0j), Body(4, 3, 0.01, 0.1 + 0j), Body(5, 25, 0, 0j))
ASIDE = (*SHAPER[:3], Body(5, 25, 0.3, 0.03 + 0.02j))  # the ram's mass centre is off its pin
ROD = (Body(1, 2, 0.01, 0.04 + 0j), Body(2, 4, 0.05, 0.2 + 0.093j), Body(3, 5, 0.04, 0.12 + 0j))
PISTON = (Body(1, 3.2, 0.0045, 0j), Body(2, 0.72, 0.0028, 0.05 + 0j), Body(3, 0.55, 0, 0j))
YOKE = (Body(1, 1, 0.01, 0j), Body(2, 0.3, 0, 0j), Body(3, 4, 0.04, 0.08 + 0j))
TANGENT = (Body(1, 1, 0.01, 0.04 + 0j), Body(2, 0.3, 0.001, 0j), Body(3, 2, 0, 0j))
CYLINDER = (Body(1, 10, 0.1, 0j), Body(2, 8, 0.3, 0.3 + 0j), Body(3, 20, 0.5, 0j))
CASES = {
    "shaper": Machinery("shaper", SHAPER, push("F_us", 5, "D", 1500 + 0j), (2, 9), TOOTHED),
    "shaper by force": Machinery("shaper", SHAPER, push("F_us", 5, "D", 1500 + 0j), (4,), Transmission(FORCE)),
    "idle shaper": Machinery("shaper", SHAPER, push("F_us", 5, "D", 0j), (9,)),
    "ram aside": Machinery("shaper", ASIDE, push("F_us", 5, "D", 1500 + 0j), (1, 2)),
    "four-bar": Machinery(
        "crank-rocker", ROD, lambda count: Loading((), (Twist("M_us", 3, np.full(count, -30.0)),)), (2, 7)
    ),
    "engine": Machinery("slider-crank", PISTON, push("F_D", 3, "B", -9000j), (1, 8)),
    "yoke": Machinery("scotch-yoke", YOKE, push("F_us", 3, "B", -700 + 0j), (1, 5)),
    "tangent": Machinery("tangent", TANGENT, push("F_us", 3, "A", -20j), (2, 6)),
    "cylinder": Machinery("oscillating-cylinder", CYLINDER, lambda _: Loading((), ()), (2, 8)),
}


@cache
def plan_of(name: str) -> ForcePlan:
    case = CASES[name]
    study = LinkageStudy(read_scene(GALLERY / f"{case.scene}.toml"))
    machine = Machine({body.link: body for body in case.bodies}, -9.81j, (), (), (), case.transmission, {})
    return forces(study.drafts().accelerations, study.groups, machine, case.load(len(study.turn)))


class Drawn(NamedTuple):
    plan: ForcePlan
    cut: Cut
    column: int
    shown: Scheme
    figure: LetteredFigure
    whole: Group


SHOWN = [(name, column) for name, case in CASES.items() for column in case.columns]
SHOWN = SHOWN if parts.whole else SHOWN[::5]


@cache
def drawn(name: str, number: int, column: int, hand: Hand | None = None, language: str = "en") -> Drawn:
    plan, hand = plan_of(name), hand or hand_of("A3")
    cut = plan.cuts[number]
    shown = scheme(plan, cut, column)
    drafting = Drafting(hand, language)
    room = measure(shown, drafting)
    rung = room.ladder(ROOM.width, ROOM.height).rungs[0]
    half = complex(rung.wide, rung.high) / 2
    low, high = ROOM.centre - half, ROOM.centre + half
    spot = Spot(Field(low.real, low.imag, high.real, high.imag), rung.scale)
    found = draw(shown, room, spot, drafting)
    ink = Ink(300, 300)
    ink.draw(found.lines)
    return Drawn(plan, cut, column, shown, found, found.letter(Labels(ink, hand.other))[0])


def written(found: Drawn) -> list[str]:
    return [stroke.plain for stroke in flat(found.whole.strokes) if isinstance(stroke, Text)]


def value(plan: ForcePlan, cut: Cut, column: int, name: str) -> complex:
    """Give a force as the force plan has it."""
    known = {load.name: load.force for load in cut.loads}
    known |= {mark.name: mark for support in cut.supports for mark in (support.force, *support.parts)}
    known |= {"P_bal": plan.drive} if plan.drive is not None else {}
    return at(known[name].point, column)


def test_a_load_that_rests_on_the_idle_stroke_is_not_drawn() -> None:
    found = drawn("idle shaper", 0, 9)
    assert "Fus" not in written(found) and "Fus" in written(drawn("shaper", 0, 9))


@pytest.mark.part
@over("name, column", SHOWN)
def test_the_equations_of_moments_hold_with_the_arms_of_the_drawing(name: str, column: int) -> None:
    """Sum of sense times force times arm, and the couples: zero, as the book writes it."""
    plan = plan_of(name)
    for cut in plan.cuts:
        arms, force = leverages(plan, cut, column), partial(value, plan, cut, column)
        for equation in cut.equations:
            names = [load.name for load in equation.loads if load.kind != PART]
            couples = sum(at(couple.moment.point, column).real for couple in equation.couples)
            terms = [arm.sense * abs(force(arm.name)) * arm.length for arm in arms if arm.name in names]
            last = next((arm for arm in arms if equation.line is not None and arm.name == equation.found.name), None)
            answer = at(equation.found.point, column).real if equation.line is None else 0.0
            if last is not None:
                answer = last.sense * abs(force(last.name)) * last.length
            size = max(map(abs, [*terms, couples, answer, 1e-12]))
            assert abs(sum(terms) + couples + answer) < 1e-7 * size, equation.found.name


def test_the_arm_of_the_gears_force_is_the_base_radius() -> None:
    arms = {arm.name: arm for arm in leverages(plan_of("shaper"), plan_of("shaper").cuts[-1], 2)}
    assert arms["P_bal"].length == pytest.approx(0.18 * math.cos(math.radians(20)), rel=1e-12)


def test_letters_of_arms_go_on_from_group_to_group_and_the_leads_keep_their_own() -> None:
    plan = plan_of("shaper")
    letters = [[arm.letter for arm in leverages(plan, cut, 2)] for cut in plan.cuts]
    assert letters[0] == ["h_{1}", "h_{2}", "l_{BD}"]
    assert letters[1] == ["h_{3}", "h_{4}", "h_{5}", "l_{CA}"]
    assert letters[2] == ["h_{6}", "h_{7}"]


@pytest.mark.parametrize("column", [1, 2])
def test_a_guide_presses_where_the_moments_about_the_pin_balance(column: int) -> None:
    found = drawn("ram aside", 0, column)
    pin = at(found.plan.positions.point("D").point, column)
    ram = [load for load in found.cut.loads if load.link == 5]
    places = ((at(load.at.point, column) - pin, at(load.force.point, column)) for load in ram)
    moments = sum((arm.conjugate() * force).imag for arm, force in places)
    press = next(force for force in found.shown.acting.forces if force.name == "R_05")
    assert (press.at - pin).imag == 0  # along the guide
    assert (press.at - pin).real * press.value.imag == pytest.approx(-moments, rel=1e-9)
    assert "x05" in written(found)


def test_larger_forces_have_longer_arrows_within_bounds() -> None:
    found = lengths([0.5, 3.0, 40.0, 5000.0])
    assert found == sorted(found) and found[0] == SHORT and found[-1] == LONG
