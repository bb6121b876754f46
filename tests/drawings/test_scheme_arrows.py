"""Arrows that are not to scale: how far each may be turned is told by what a hand may slip by."""

from __future__ import annotations

import cmath
from types import MappingProxyType

import pytest

from drawings.grading.allowance import Allowance, Allowances
from drawings.grading.asked import PlanAsked
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.onlooker import segments
from drawings.grading.scheme_arrows import arrow_verdicts
from drawings.paper.strokes import Group, Leaf, Line
from drawings.pens.svg import svg
from drawings.reading.sheet import see

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
