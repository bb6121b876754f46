"""An arrow that leaves the paper is told by either of its ends."""

from __future__ import annotations

import pytest

from drawings.grading import verdict
from drawings.grading.asked import PlanAsked
from drawings.grading.drawing_faults import drawing_faults
from drawings.grading.drawn_plan import Arrow, DrawnPlan
from drawings.paper.strokes import Leaf

# mm on a paper of 200 by 200: the pole of positions, b and c lie off.
SPOTS = {"": -50j, "p": 10 + 10j, "a": 190 + 10j, "b": 210 + 10j, "c": 10 - 5j}


@pytest.mark.parametrize(
    ("arrows", "off"),
    [
        (["p a"], []),
        (["p b"], ["b"]),
        (["b a"], ["b"]),
        (["b c", "p b"], ["b", "c"]),
        ([" a"], []),  # a point of the plan of positions, whose pole nobody draws
        ([" b"], ["b"]),
    ],
)
def test_an_end_off_the_paper_is_told_once(arrows: list[str], off: list[str]) -> None:
    asked = PlanAsked("velocities", 2, "kinematics", "m/s", (), {})
    ends = [(start, end) for start, _, end in (one.rpartition(" ") for one in arrows)]
    drawn = {(start, end): Arrow(SPOTS[start], SPOTS[end]) for start, end in ends}
    plan = DrawnPlan(asked, drawn, 1.0, SPOTS, True)
    said = [one for one in drawing_faults(Leaf(200.0, 200.0, ()), {}, plan) if one.kind == verdict.OUTSIDE]
    assert sorted(one.name for one in said) == off


def test_a_free_vector_is_told_by_its_own_letter() -> None:
    asked = PlanAsked("forces", 2, "forces", "N", (), {})
    plan = DrawnPlan(asked, {("", "R_12"): Arrow(-5 + 10j, 50 + 10j)}, 1.0, {}, True)
    said = [one for one in drawing_faults(Leaf(200.0, 200.0, ()), {}, plan) if one.kind == verdict.OUTSIDE]
    assert [one.name for one in said] == ["R_12"]
