"""The loading scheme: what a strict eye looks for when it checks the forces on a cut group with a ruler."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from drawings.figures.forces.force_fan import LONG, SHORT, lengths
from drawings.figures.forces.force_kinds import KNOWN
from drawings.figures.forces.loading_scheme import Scheme, SchemeFigure, draw, leverages, measure, scheme
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import Spot
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.paper.hand import Hand, hand_of
from drawings.paper.strokes import Group, Leaf, Line, Text
from drawings.paper.walk import flat
from geometry.board import at
from plans.forces.cut import PART, Cut
from plans.forces.force import ForcePlan
from plans.forces.force_template import forces
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Applied, Loading, Twist
from plans.model.machine import FORCE, GEAR, Body, Machine, Transmission
from plans.scene.scene import read_scene

pytest.importorskip("shapely")
from tests import parts
from tests.drawings.collisions import collisions
from tests.rows import over

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
ROOM = Field(10, 10, 290, 290)
TOOTHED = Transmission(GEAR, 0.18, math.radians(210), math.radians(20))
HAIR = 1e-9  # of a true value, or mm on paper: rounding


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
    figure: SchemeFigure
    whole: Group


ALL = [(name, number, column) for name, case in CASES.items() for column in case.columns for number in range(3)]
ALL = [one for one in ALL if one[1] < len(plan_of(one[0]).cuts)]
SHOWN = ALL if parts.whole else ALL[::4]


@cache
def drawn(name: str, number: int, column: int, hand: Hand | None = None, language: str = "en") -> Drawn:
    plan, hand = plan_of(name), hand or hand_of("A3")
    cut = plan.cuts[number]
    shown = scheme(plan, cut, column)
    drafting = Drafting(hand, language)
    room = measure(shown, "scheme", drafting)
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


def plain(name: str) -> str:
    return name.replace("_", "").replace("^", "")


def value(found: Drawn, name: str) -> complex:
    """Give a force as the force plan has it."""
    known = {load.name: load.force for load in found.cut.loads}
    known |= {mark.name: mark for support in found.cut.supports for mark in (support.force, *support.parts)}
    known |= {"P_bal": found.plan.drive} if found.plan.drive is not None else {}
    return at(known[name].point, found.column)


@pytest.mark.part
@over("one", SHOWN)
def test_every_arrow_points_as_its_force_does(one: tuple[str, int, int]) -> None:
    found = drawn(*one)
    for force, arrow in zip(found.shown.acting.forces, found.figure.layout.arrows, strict=True):
        true = value(found, force.name)
        run = arrow.tip - arrow.start
        assert abs(run / abs(run) - true / abs(true)) < HAIR, force.name


@pytest.mark.part
@over("one", SHOWN)
def test_every_force_acts_along_a_line_through_its_point(one: tuple[str, int, int]) -> None:
    found = drawn(*one)
    for load in found.cut.loads:
        point = found.figure.place.on(at(load.at.point, found.column))
        for force, arrow in zip(found.shown.acting.forces, found.figure.layout.arrows, strict=True):
            if force.name == load.name:
                off = (arrow.start - point) / (arrow.tip - arrow.start)
                assert abs(off.imag) < HAIR, load.name


@pytest.mark.part
@over("one", SHOWN)
def test_every_known_force_that_is_not_zero_has_one_arrow_and_one_letter(one: tuple[str, int, int]) -> None:
    found = drawn(*one)
    acting = [load.name for load in found.cut.loads if abs(at(load.force.point, found.column)) > 1e-6]
    drawn_ = [force.name for force in found.shown.acting.forces if force.kind == KNOWN]
    assert sorted(drawn_) == sorted(acting)
    letters = written(found)
    assert all(letters.count(plain(name)) == 1 for name in acting)


@pytest.mark.part
@over("one", SHOWN)
def test_every_reaction_is_unknown_and_shown_by_its_parts(one: tuple[str, int, int]) -> None:
    found = drawn(*one)
    parts = [mark.name for support in found.cut.supports for mark in support.parts or (support.force,)]
    unknown = {force.name for force in found.shown.acting.forces if force.kind != KNOWN}
    assert {name for name in parts if abs(value(found, name)) > 1e-6} == unknown - {"P_bal"}


def test_a_load_that_rests_on_the_idle_stroke_is_not_drawn() -> None:
    found = drawn("idle shaper", 0, 9)
    assert "Fus" not in written(found) and "Fus" in written(drawn("shaper", 0, 9))


@pytest.mark.part
@over("one", SHOWN)
def test_no_letter_touches_a_line_or_another_letter(one: tuple[str, int, int]) -> None:
    assert collisions(Leaf(300, 300, (drawn(*one).whole,), lettering="strokes")) == []


@pytest.mark.rest
@over("one", [one for one in ALL if one[0] in ("shaper", "four-bar")])
def test_no_letter_touches_anything_on_a_large_russian_sheet(one: tuple[str, int, int]) -> None:
    found = drawn(*one, hand_of("A1"), "ru")
    assert collisions(Leaf(300, 300, (found.whole,), lettering="strokes")) == []


@pytest.mark.part
@over("one", SHOWN)
def test_every_arm_is_square_to_its_line_of_action_and_as_long_as_it_is_stated(one: tuple[str, int, int]) -> None:
    found = drawn(*one)
    layout, stated = found.figure.layout, {arm.letter: arm for arm in found.shown.arms}
    for arm in layout.arms:
        true = stated[arm.letter]
        force = value(found, true.name)
        assert abs(((arm.foot - arm.about) * force.conjugate()).real) < HAIR * abs(force) * max(arm.length, 1)
        assert arm.length * layout.place.scale.mu == pytest.approx(true.length, rel=1e-9)
        assert written(found).count(plain(arm.letter.replace("{", "").replace("}", ""))) == 1


@pytest.mark.part
@over("one", SHOWN)
def test_the_equations_of_moments_hold_with_the_arms_of_the_drawing(one: tuple[str, int, int]) -> None:
    """Sum of sense times force times arm, and the couples: zero, as the book writes it."""
    found = drawn(*one)
    arms = leverages(found.plan, found.cut, found.column)
    for equation in found.cut.equations:
        names = [load.name for load in equation.loads if load.kind != PART]
        couples = sum(at(couple.moment.point, found.column).real for couple in equation.couples)
        terms = [arm.sense * abs(value(found, arm.name)) * arm.length for arm in arms if arm.name in names]
        last = next((arm for arm in arms if equation.line is not None and arm.name == equation.found.name), None)
        answer = at(equation.found.point, found.column).real if equation.line is None else 0.0
        if last is not None:
            answer = last.sense * abs(value(found, last.name)) * last.length
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


@pytest.mark.part
@over("one", SHOWN)
def test_every_couple_turns_as_its_moment_does(one: tuple[str, int, int]) -> None:
    found = drawn(*one)
    signs = {couple.name: at(couple.moment.point, found.column).real for couple in found.cut.couples}
    signs |= {"M_bal": at(found.plan.balancing.point, found.column).real}
    signs |= {
        support.force.name.replace("R", "M", 1): at(support.moment.point, found.column).real
        for support in found.cut.supports
        if support.moment is not None
    }
    for moment, couple in zip(found.shown.acting.moments, found.figure.layout.couples, strict=True):
        assert couple.sense == math.copysign(1, signs[moment.name])
        assert written(found).count(plain(moment.name)) == 1


@pytest.mark.part
@over("one", SHOWN)
def test_every_link_bears_its_number_and_every_point_its_letter(one: tuple[str, int, int]) -> None:
    found, letters = drawn(*one), written(drawn(*one))
    assert all(letters.count(str(link)) == 1 for link in found.cut.links)
    assert all(letters.count(plain(name)) == 1 for name in found.shown.named)


@pytest.mark.part
@over("one", SHOWN)
def test_two_arrows_of_one_line_of_action_do_not_cover_each_other(one: tuple[str, int, int]) -> None:
    arrows = list(drawn(*one).figure.layout.arrows)
    for k, first in enumerate(arrows):
        for second in arrows[:k]:
            ends = [(end - first.start) / first.direction for end in (second.start, second.tip)]
            if all(abs(end.imag) < 1e-6 for end in ends):
                low, high = sorted(end.real for end in ends)
                assert high < HAIR or low > first.length - HAIR, (first.letter, second.letter)


@pytest.mark.part
@over("one", SHOWN)
def test_every_line_stays_in_the_room_that_was_measured(one: tuple[str, int, int]) -> None:
    layout = drawn(*one).figure.layout
    box = layout.box
    assert box is not None
    for arrow in layout.arrows:
        for end in (arrow.start, arrow.tip):
            assert box.left <= end.real <= box.right and box.bottom <= end.imag <= box.top, arrow.letter


def test_larger_forces_have_longer_arrows_within_bounds() -> None:
    found = lengths([0.5, 3.0, 40.0, 5000.0])
    assert found == sorted(found) and found[0] == SHORT and found[-1] == LONG


def test_a_russian_sheet_has_its_own_words_and_letters() -> None:
    letters = written(drawn("shaper", 0, 2, hand_of("A3"), "ru"))
    assert "Схема нагружения группы 4-5, положение 2" in letters
    assert {"Rτ34", "Fп.с"} <= set(letters)
    assert any(text.endswith("силы не в масштабе") for text in letters)


def test_outer_hinges_are_open_and_only_the_crank_has_its_stand() -> None:
    def hatched(found: Drawn) -> bool:
        thin = [s for s in found.figure.layout.joints.stands() if isinstance(s, Line)]
        return bool(thin)

    assert [hatched(drawn("shaper", number, 2)) for number in range(3)] == [False, False, True]
    assert set(drawn("shaper", 0, 2).figure.layout.joints.hinges) == {"B", "D"}
