"""The loop of a machine's motion: where a tangent touches and ends, what of a segment or of rounding is told."""

from __future__ import annotations

from functools import cache

from drawings.dynamics.sheet import Machine, sheets
from drawings.paper.walk import groups, texts
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.dynamics_scenes import text


@cache
def study() -> Study:
    return Study(parse_scene(text(asked='fluctuation = "1/25"\nflywheel = { diameter = 0.9 }')))


def test_rounding_is_not_told_in_digits() -> None:
    """What vanishes but for rounding is 0 in the table, not a number of twenty digits."""
    own = study().comparison("dynamics").exact
    (leaf,) = sheets(study().scene, Machine(study()["dynamics"].task, own, own))
    cells = [one.plain for group in groups(leaf.groups) if group.name == "positions-1" for one in texts((group,))]
    assert len(cells) > 100 and max(map(len, cells)) <= 10
