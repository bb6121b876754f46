"""The bench of motion: its truth by closed forms, its roads and its peers, and a hand that slips."""

from __future__ import annotations

import importlib.util
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

from geometry.errors import DraftError
from geometry.meet import EPS
from plans.bench import peers as module
from plans.bench.error import Errors, errors, sizes
from plans.bench.peers import MECHANISM, NOT_FOUR_BAR, NOT_INSTALLED, PYLINKAGE, four_bar, peers
from plans.bench.roads import (
    CONSTRUCTION,
    REPLAY,
    ROUNDING,
    TOLERANCES,
    Ground,
    compared,
    ground,
    newton,
    prepared,
    roads,
)
from plans.bench.trial import Road, timed
from plans.bench.truth import Exact, NotInstalled, replay, values
from plans.linkage.plan_template import PlanTemplate
from plans.linkage.study import LinkageStudy
from plans.scene.scene import read_scene
from tests.parts import first, some
from tests.plans import linkages
from tests.plans.studies import study_of

MP = mpmath.mp.clone()
MP.dps = 40
A, OMEGA, EPSILON = 0.1, 7.0, -3.0


def whole(exact: Exact, column: int) -> Any:
    """Put a true value together again from what float64 holds and the rest."""
    return MP.mpc(complex(exact.near[column])) + MP.mpc(complex(exact.rest[column]))


def crank(study: LinkageStudy) -> tuple[Any, ...]:
    """Give place, velocity and acceleration of the crank's end at position 1 of 12, from position 0 at 0 degrees."""
    end = MP.mpf(A) * MP.expjpi(MP.mpf(study.sense) / 6)
    return end, 1j * OMEGA * end, (1j * EPSILON - MP.mpf(OMEGA) ** 2) * end


def test_the_truth_is_the_closed_form_of_the_crank_to_thirty_digits() -> None:
    study = study_of(linkages.slider_crank(A, 0.4, omega=OMEGA, epsilon=EPSILON))
    truth = replay(study, [1]).truth()
    for kind, true in zip("rva", crank(study), strict=True):
        assert abs(whole(truth.values[kind, "A"], 0) - true) < 1e-30 * abs(true)


def test_the_truth_of_a_slider_is_its_closed_form() -> None:
    """x = a cos + sqrt(b2 - a2 sin2) for a central slider-crank, at 30 degrees."""
    truth = replay(study_of(linkages.slider_crank(A, 0.4)), [1]).truth()
    a, b, angle = MP.mpf(A), MP.mpf(0.4), MP.pi / 6
    assert (
        abs(whole(truth.values["r", "B"], 0) - (a * MP.cos(angle) + MP.sqrt(b**2 - (a * MP.sin(angle)) ** 2))) < 1e-30
    )


def bar(count: int = 12) -> LinkageStudy:
    return study_of(linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}), 0, count)


def judged(spoil: Any) -> Errors:
    """Judge the construction after something was done to its motion."""
    study = bar()
    truth, largest = replay(study, range(12)).truth(), sizes(bar(360))
    motion = study.motion(2)
    spoil(motion)
    return errors(values(motion, truth), truth, largest)


def test_a_planted_error_is_counted_in_shares_of_the_plans_largest_and_named() -> None:
    largest = sizes(bar(360))

    def spoil(motion: Any) -> None:
        motion.points["B"].v[5] += 1e-6j * largest["v"]

    found = judged(spoil)
    assert found.largest == pytest.approx(1e-6)
    assert found.worst == "v_B"
    assert found.kinds["v"] == found.largest
    assert found.kinds["a"] < 8 * EPS


def test_without_mpmath_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "mpmath", None)
    with pytest.raises(NotInstalled, match=r"Fix: python -m pip install '\.\[bench\]'"):
        replay(bar(), [0]).truth()


GALLERY = Path(__file__).parent.parent.parent / "drawings/gallery"
SCENES = ("crank-rocker", "shaper", "slider-crank")
GOAL = 8.0  # eps: 4 of a point's own row, and as much again for the rates read off vectors
NEWTON_GOAL = 64.0  # eps: two linear systems on top of the closed loops, each of a condition near ten


def stood(name: str, count: int) -> Ground:
    scene = read_scene(GALLERY / f"{name}.toml")
    return ground(scene, count, 12, sizes(prepared(scene, 360)))


def judged_by_road(found: Ground) -> dict[str, Errors]:
    """Judge the techniques of the motion; the forces of a loaded scene are judged by themselves."""
    motion = roads(replace(found, statics=None))
    return {name: judge(road.run()) for road in motion for name, judge in road.judged.items()}


@pytest.mark.parametrize("count", some([360, 12, 10_000], 3))
@pytest.mark.parametrize("name", SCENES)
def test_construction_is_exact_to_a_few_roundings(name: str, count: int) -> None:
    found = judged_by_road(stood(name, count))
    for order, technique in enumerate(CONSTRUCTION):
        assert 0 < found[technique].largest <= GOAL * EPS
        assert len(found[technique].kinds) == 2 * (order + 1)  # a point's and a link's, for each order


@pytest.mark.parametrize("name", first(SCENES))
def test_newtons_error_falls_with_its_tolerance(name: str) -> None:
    found = judged_by_road(stood(name, 360))
    errors = [found[technique].largest for technique in (*map(newton, TOLERANCES), ROUNDING)]
    assert errors[0] > 10 * max(errors[1:])  # a step of a millionth squares to rounding already, or nearly
    for tolerance, error in zip(TOLERANCES, errors, strict=False):
        assert error < tolerance
    assert errors[-1] <= NEWTON_GOAL * EPS


def test_the_truth_has_no_error_of_its_own() -> None:
    assert judged_by_road(stood("shaper", 12))[REPLAY] == Errors({})


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


EXACT = {PYLINKAGE: 1e-10, MECHANISM: 1e-8}  # pylinkage adds steps of the crank up, fsolve stops at 1.5e-8


def test_the_crank_rocker_is_a_four_bar_with_its_coupler_point() -> None:
    found = four_bar(prepared(read_scene(GALLERY / "crank-rocker.toml"), 12))
    assert found is not None
    assert (found.letters, found.links) == (("O", "A", "B", "C"), (1, 2, 3))
    assert [abs(side) for side in (found.crank, found.coupler, found.rocker, found.base)] == [0.1, 0.4, 0.3, 0.35]
    assert abs(found.points["E"]) == pytest.approx(math.hypot(0.200, 0.093))
    assert np.degrees(np.angle(found.points["E"])) == pytest.approx(math.degrees(math.atan2(93, 200)))


@pytest.mark.parametrize("name", ["shaper", "slider-crank"])
def test_other_mechanisms_are_left_out_and_it_is_said_why(name: str) -> None:
    ready, out = peers(prepared(read_scene(GALLERY / f"{name}.toml"), 12))
    assert ready == []
    assert out == {PYLINKAGE: NOT_FOUR_BAR, MECHANISM: NOT_FOUR_BAR}


def test_peers_that_are_not_installed_are_told_with_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "find_spec", lambda library: None)
    ready, out = peers(prepared(read_scene(GALLERY / "crank-rocker.toml"), 12))
    assert ready == []
    assert out == {PYLINKAGE: NOT_INSTALLED, MECHANISM: NOT_INSTALLED}
    assert "pip install" in NOT_INSTALLED


@pytest.mark.parametrize("name", [PYLINKAGE, MECHANISM])
@pytest.mark.parametrize("clockwise", [False, True])
def test_an_installed_peer_gives_the_same_motion(name: str, clockwise: bool, tmp_path: Path) -> None:
    if not all(importlib.util.find_spec(library) for library in module.NEEDED[name]):
        pytest.skip(f"{name} is not installed")
    text = (GALLERY / "crank-rocker.toml").read_text("utf-8")
    file = tmp_path / "scene.toml"
    file.write_text(text.replace('"10 rad/s"', '"-10 rad/s"') if clockwise else text, "utf-8")
    scene = read_scene(file)
    ways, _ = compared(ground(scene, 36, 12, sizes(prepared(scene, 360))))
    road = next(way for way in ways if name in way.judged)
    found = road.judged[name](road.run())
    assert found.largest < EXACT[name]
    assert set(found.kinds) >= {"r", "v", "a"}
