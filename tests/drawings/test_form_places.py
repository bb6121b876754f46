"""Plans drawn on a form are told by the place that it gives each of them, whatever stands beside them."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from drawings.grading.allowance import Allowances
from drawings.grading.form_places import form_places
from drawings.grading.graded import grade
from drawings.paper.strokes import Group, Leaf, Stroke, Text
from tests.drawings.form_students import form_leaf, on_form
from tests.drawings.students import task

PLACE = re.compile(r"position (\d+)")
SCALE = 0.25  # of the shaper's acceleration plans, (m/s2)/mm, as its form states it


def exchanged(leaf: Leaf) -> Leaf:
    """Exchange the positions 2 and 9 in all that is written on a form, so that its headings are wrong."""
    other = {"2": "position 9", "9": "position 2"}

    def written(one: Stroke) -> Stroke:
        if isinstance(one, Text):
            return replace(one, content=PLACE.sub(lambda found: other[found[1]], one.plain))
        return replace(one, strokes=tuple(map(written, one.strokes))) if isinstance(one, Group) else one

    return replace(
        leaf, groups=tuple(Group(tuple(map(written, one.strokes)), one.name, one.data) for one in leaf.groups)
    )


@pytest.mark.parametrize("headings", [pytest.param("right", marks=pytest.mark.rest), "exchanged"])
def test_a_plan_on_a_form_is_the_one_that_its_pole_is_for(headings: str) -> None:
    own, leaf = task("shaper"), form_leaf("shaper")
    plans = [plan for plan in own.plans if plan.plan == "accelerations"]
    source = on_form(leaf if headings == "right" else exchanged(leaf), plans, SCALE)
    said = {
        (one.position, one.kind)
        for one in grade(source, own.plans, Allowances()).verdicts
        if one.plan == "accelerations"
    }
    assert said == {(2, "right"), (9, "right")}


@pytest.mark.rest
def test_each_place_of_a_form_says_of_which_plan_and_position_it_is() -> None:
    places = {one.plan for one in form_places(form_leaf("shaper-loaded"))}
    assert {("forces-4-5", 2), ("forces-2-3", 2), ("lever", 2), ("hodograph-0-3", None)} <= places


def test_only_a_form_has_places() -> None:
    assert form_places(task("shaper").originals.sheets[0].leaf) == ()
