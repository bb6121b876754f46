"""The techniques of the bench: each is as exact as it says, and does its whole work every time it is timed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from geometry.errors import DraftError
from geometry.meet import EPS
from plans.bench.error import Errors, sizes
from plans.bench.roads import (
    CONSTRUCTION,
    REPLAY,
    ROUNDING,
    TOLERANCES,
    Ground,
    ground,
    newton,
    prepared,
    roads,
)
from plans.bench.trial import Road, timed
from plans.linkage.plan_template import PlanTemplate
from plans.scene.scene import read_scene
from tests.parts import first, some

GALLERY = Path(__file__).parent.parent.parent / "drawings/gallery"
SCENES = ("crank-rocker", "shaper", "slider-crank")
GOAL = 8.0  # eps: 4 of a point's own row, and as much again for the rates read off vectors
NEWTON_GOAL = 64.0  # eps: two linear systems on top of the closed loops, each of a condition near ten


def stood(name: str, count: int) -> Ground:
    scene = read_scene(GALLERY / f"{name}.toml")
    return ground(scene, count, 12, sizes(prepared(scene, 360)))


def judged(found: Ground) -> dict[str, Errors]:
    """Judge the techniques of the motion; the forces of a loaded scene are judged by themselves."""
    motion = roads(replace(found, statics=None))
    return {name: judge(road.run()) for road in motion for name, judge in road.judged.items()}


@pytest.mark.parametrize("count", some([360, 12, 10_000], 3))
@pytest.mark.parametrize("name", SCENES)
def test_construction_is_exact_to_a_few_roundings(name: str, count: int) -> None:
    found = judged(stood(name, count))
    for order, technique in enumerate(CONSTRUCTION):
        assert 0 < found[technique].largest <= GOAL * EPS
        assert len(found[technique].kinds) == 2 * (order + 1)  # a point's and a link's, for each order


@pytest.mark.parametrize("name", first(SCENES))
def test_newtons_error_falls_with_its_tolerance(name: str) -> None:
    found = judged(stood(name, 360))
    errors = [found[technique].largest for technique in (*map(newton, TOLERANCES), ROUNDING)]
    assert errors[0] > 10 * max(errors[1:])  # a step of a millionth squares to rounding already, or nearly
    for tolerance, error in zip(TOLERANCES, errors, strict=False):
        assert error < tolerance
    assert errors[-1] <= NEWTON_GOAL * EPS


def test_the_truth_has_no_error_of_its_own() -> None:
    assert judged(stood("shaper", 12))[REPLAY] == Errors({})


def test_every_run_draws_its_plans_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    """Were the numbers of the first run kept, the clock would time nothing but the reading of them."""
    found = stood("shaper", 12)
    drawn: list[int] = []
    real = PlanTemplate.follow
    monkeypatch.setattr(PlanTemplate, "follow", lambda *given: drawn.append(1) or real(*given))
    run = next(road.run for road in roads(found) if CONSTRUCTION[2] in road.judged)
    first = run()
    assert len(drawn) == 1
    second = run()
    assert len(drawn) == 2
    assert np.array_equal(first.points["D"].a, second.points["D"].a)


def test_a_road_that_refuses_says_why_and_the_others_are_timed() -> None:
    def refuse() -> None:
        raise DraftError("no room on the sheet")

    ways = [Road(refuse, 3, {"one": lambda _: Errors({}), "two": lambda _: Errors({})})]
    ways.append(Road(lambda: 5, 3, {"three": lambda result: Errors({"r": result}, "r_B")}))
    one, two, three = timed(ways, 2, 1.0)
    assert [row.note for row in (one, two)] == ["left out: no room on the sheet"] * 2
    assert one.times is None
    assert one.error is None
    assert three.error == 5
    assert three.times is not None
    assert len(three.times.seconds) == 2
