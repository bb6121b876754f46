"""Plans drawn on a form are told by the place that it gives each of them, whatever stands nearer to them."""

from __future__ import annotations

import pytest

from drawings.grading.allowance import Allowances
from drawings.grading.form_place import FormPlace, form_places, place_of
from drawings.grading.graded import SheetTask, grade
from drawings.lettering.lettering import lettered
from drawings.paper.strokes import Text
from tests.drawings.form_students import edited, form_leaf, on_form, polygon_on_form, position_on_form
from tests.drawings.students import task
from tests.drawings.test_grading import laid
from tests.parts import some

EDITED = ["", "translate(60 -20)", "scale(0.7)", "translate(594 0) rotate(90)", "regrouped"]


@pytest.mark.parametrize("how", some(EDITED, 2))
def test_a_plan_on_a_form_is_the_one_that_its_pole_is_for_whatever_an_editor_did(how: str) -> None:
    """Each of the two plans stands nearer to the heading of the other, which is over the next place below."""
    own, leaf = task("shaper"), lettered(form_leaf("shaper"))
    plans = [plan for plan in own.plans if plan.plan == "accelerations"]
    scale = next(one.scale for one in form_places(leaf) if one.plan == plans[0].place)
    graded = grade(edited(on_form(leaf, plans, scale), how), SheetTask(own.plans), Allowances())
    said = {(one.position, one.kind) for one in graded.verdicts if one.plan == "accelerations"}
    assert said == {(2, "right"), (9, "right")}


@pytest.mark.parametrize(("moved", "wrong"), [(0j, set()), (0.05 + 0j, {"wrong"})])
def test_the_plan_of_positions_is_read_by_its_points(moved: complex, wrong: set[str]) -> None:
    own, leaf = task("shaper"), form_leaf("shaper")
    places = {one.plan for one in form_places(leaf)}
    plan = next(plan for plan in own.plans if plan.plan == "positions" and plan.place in places)
    graded = grade(position_on_form(leaf, plan, moved), SheetTask((plan,)), Allowances())
    assert {one.kind for one in graded.verdicts} == {"right", *wrong}


@pytest.mark.parametrize("share", [0.8, 1.2])
@pytest.mark.parametrize("turn", [0, 90])
def test_a_polygon_on_a_form_is_that_of_its_place_though_it_does_not_keep_within_it(share: float, turn: int) -> None:
    own, leaf = task("fan"), form_leaf("fan")
    source = laid(polygon_on_form(leaf, own.plan("couples", None), share), f"rotate({turn} 150 150)")
    graded = grade(source, SheetTask(own.plans), Allowances())
    assert {one.kind for one in graded.verdicts if one.plan == "couples"} == {"right"}
    assert {one.plan for one in graded.wrong} == {"unbalances"}  # which is not drawn


def test_of_a_form_of_several_pages_due_is_what_has_its_place_on_this_one() -> None:
    own, leaf = task("screen"), form_leaf("screen")
    placed = {one.plan: one.scale for one in form_places(leaf)}
    plans = [plan for plan in own.plans if plan.place in placed and plan.lettered]
    source = on_form(leaf, plans, placed[plans[0].place]).replace(b"</svg>", b'<text x="150" y="9">J = 2</text></svg>')
    graded = grade(source, SheetTask(own.plans), Allowances())
    assert {one.kind for one in graded.verdicts if one.plan != "positions"} == {"right", "workings"}


@pytest.mark.rest
def test_each_place_of_a_form_says_of_which_plan_and_position_it_is() -> None:
    places = {one.plan for one in form_places(form_leaf("shaper-loaded"))}
    assert {("forces-4-5", 2), ("forces-2-3", 2), ("lever", 2), ("hodograph-0-3", None)} <= places
    assert {("velocities", 2), ("accelerations", 2)} <= places


UPPER = FormPlace(("velocities", 2), 30 + 70j, 0 + 50j, 100 + 100j)
LOWER = FormPlace(("velocities", 9), 30 + 20j, 0j, 100 + 40j)


@pytest.mark.parametrize(
    ("ends", "place"),
    [
        ([30.5 + 70j, 60 + 42j, 70 + 30j], UPPER),  # begun at its pole, though most of it lies in the other
        ([50 + 30j, 60 + 20j, 70 + 45j], LOWER),
        ([150 + 30j, 160 + 20j], None),
    ],
)
def test_arrows_are_of_the_place_of_their_pole_or_else_of_the_corners_about_them(
    ends: list[complex], place: FormPlace | None
) -> None:
    assert place_of(ends, [UPPER, LOWER]) == place


def test_a_heading_is_of_the_place_that_it_stands_over() -> None:
    heading = Text(50 + 45j, "μ_v = 0.02", 5.0, "middle")
    assert LOWER.away(heading) < UPPER.away(heading)
    assert UPPER.away(Text(50 + 60j, "μ_v = 0.02", 5.0, "middle")) == 0.0
