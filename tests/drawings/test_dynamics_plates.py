"""The loop of a machine's motion: where a tangent touches and ends, what of a segment or of rounding is told."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from drawings.dynamics.graphs import dense, strips
from drawings.dynamics.loop import Loop, Tangent
from drawings.dynamics.sheet import Machine, results, sheets
from drawings.kinds.axes import BEYOND, Axes
from drawings.page.scale import Scale, drafting_of
from drawings.paper.strokes import Line
from drawings.paper.walk import groups, texts
from plans.model.dynamics import TURN
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.dynamics_scenes import text


@cache
def study() -> Study:
    return Study(parse_scene(text(asked='fluctuation = "1/25"\nflywheel = { diameter = 0.9 }')))


def test_a_tangent_that_touches_the_end_of_the_turn_touches_its_beginning() -> None:
    """Both are one point of the loop: rounding alone decides which of them is touched first."""
    own = study()["dynamics"]
    wheel = own.account.flywheel
    ends = tuple(one._replace(turned=TURN) for one in wheel.touches)
    assert Loop(own.cycle, dense(own.cycle), strips(own.cycle, 24), replace(wheel, touches=ends)).touches == (0, 0)


@pytest.mark.parametrize("steep", [0.1, 0.4, 2.0, 20.0])
def test_a_tangent_with_its_angle_ends_below_the_title_of_its_loop(steep: float) -> None:
    wheel, hand = study()["dynamics"].account.flywheel, drafting_of(study().scene).hand
    inertia = Scale(steep / wheel.slopes[1], "J", "kg*m2")
    shown = Tangent((0.0, 60 * inertia.mu), 30.0, wheel, Axes(0j, inertia, Scale(1.0, "T", "J")), hand, 1)
    assert shown.slope == pytest.approx(steep)
    assert max(one.end.imag for one in shown.lines if isinstance(one, Line)) <= 30 + BEYOND + 1e-9
    assert shown.end.imag >= 30 - 1e-9 or shown.end.real >= 60


def test_the_difference_of_a_segment_is_told_of_both() -> None:
    """A tangent that goes all but through o1 cuts off next to nothing: a share of that would say nothing."""
    account = study().comparison("dynamics").exact
    drawn = replace(account, flywheel=replace(account.flywheel, cuts=(-2e-9, 20.1)))
    exact = replace(account, flywheel=replace(account.flywheel, cuts=(-1e-9, 20.0)))
    lines = results(drawn, exact, None, drafting_of(study().scene)).lines
    found = {line.name: line.cells[-1] for line in lines}
    assert (found["o_1k·μ_T, J"], found["o_1l·μ_T, J"]) == ("0.500", "0.000")


def test_rounding_is_not_told_in_digits() -> None:
    """What vanishes but for rounding is 0 in the table, not a number of twenty digits."""
    own = study().comparison("dynamics").exact
    (leaf,) = sheets(study().scene, Machine(study()["dynamics"].task, own, own))
    cells = [one.plain for group in groups(leaf.groups) if group.name == "positions-1" for one in texts((group,))]
    assert len(cells) > 100 and max(map(len, cells)) <= 10
