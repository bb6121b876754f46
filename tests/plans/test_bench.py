"""The bench's parts: clock, record in 50 digits, orders of its series. No test asks how long anything takes."""

from __future__ import annotations

import gc
import math
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest

from geometry.errors import DraftError
from geometry.meet import EPS
from geometry.strips import middles
from plans.bench import cams, motion, series, trial
from plans.bench.motion import NEWTON, PLANS, REPLAY, TOLERANCES, Replay, sample, with_positions
from plans.bench.quantities import CONSTRUCTION, apart, quantities, roads
from plans.bench.trial import Demand, Errors, Timed, Times, Timing, interleaved, order, orders, timed
from plans.cam.course import FollowerCourse
from plans.linkage.reading.form import LinkageForm
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.gallery import GALLERY
from tests.parts import some
from tests.plans import linkages
from tests.plans.dynamics_scenes import PLANING, PUSHED, study
from tests.plans.studies import study_of
from tests.plans.textbook_cams import cam, offset_sizes

GOAL = 8.0  # eps: 4 of a point's own row, and as much again for the rates read off vectors
MP = mpmath.mp.clone()
MP.dps = 40


@pytest.fixture
def ticking(monkeypatch: pytest.MonkeyPatch) -> Callable[[float], None]:
    """Replace the wall clock by one that only moves when it is told to."""
    now = [0.0]

    def pass_by(seconds: float) -> None:
        now[0] += seconds

    monkeypatch.setattr(trial, "perf_counter", lambda: now[0])
    return pass_by


def test_runs_take_turns() -> None:
    called: list[str] = []
    interleaved([lambda: called.append("A"), lambda: called.append("B"), lambda: called.append("C")], 3, 1.0)
    assert "".join(called) == "ABCABCABC"


def test_a_run_that_has_spent_its_budget_leaves_and_the_others_go_on(ticking: Callable[[float], None]) -> None:
    slow, quick, long = interleaved([lambda: ticking(3.0), lambda: ticking(0.5), lambda: ticking(100.0)], 8, 7.0)
    assert slow.seconds == (3.0, 3.0, 3.0)
    assert quick.seconds == (0.5,) * 8
    assert len(long.seconds) == trial.LEAST_ROUNDS
    assert [len(times.seconds) for times in interleaved([lambda: ticking(1.0)], 1, 9.0)] == [1]


def test_ratios_are_of_the_same_round() -> None:
    """A disturbance that doubles one round of both runs leaves the ratio as it is."""
    assert Times((3.0, 6.0, 3.0)).over(Times((1.0, 2.0, 1.0))).quartiles == (3.0, 3.0)


def test_the_collector_of_garbage_rests_during_a_run_and_is_woken_after_it() -> None:
    seen: list[bool] = []
    interleaved([lambda: seen.append(gc.isenabled())], 1, 1.0)
    with pytest.raises(ZeroDivisionError):
        interleaved([lambda: 1 // 0], 1, 1.0)
    assert seen == [False] and gc.isenabled()


def test_a_road_that_refuses_says_why_and_a_long_one_runs_once(ticking: Callable[[float], None]) -> None:
    def refuse() -> None:
        raise DraftError("no room on the sheet")

    ways = [Timing(refuse, 3, {"one": Errors.alone, "two": Errors.alone})]
    ways += [Timing(lambda: ticking(0.1) or 5.0, 3, {"three": Errors.alone})]
    ways += [Timing(lambda: ticking(trial.LONG + 1) or 5.0, 3, {"four": Errors.alone})]
    one, two, three, four = timed(ways, 2)
    assert [row.note for row in (one, two)] == ["left out: no room on the sheet"] * 2
    assert one.times is None and one.errors is None
    assert three.errors == Errors(5.0, 5.0) and three.times is not None and len(three.times.seconds) == 2
    assert four.times == Times((trial.LONG + 1,))


def test_orders_are_told_where_errors_fall_above_rounding() -> None:
    rows = [Timed("a", n, Errors.alone(n**-2.0)) for n in (10, 100)] + [
        Timed("b", n, Errors.alone(1e-15)) for n in (1, 2)
    ]
    assert [*orders(rows)] == ["  a: order 2.00 from 10 to 100"]


def whole(name: str, made: Any, column: int = 1) -> Any:
    return Replay.of(made, [column], 2).values()[0][name]


def test_the_replay_is_the_closed_form_of_the_crank_and_of_the_slider_to_thirty_digits() -> None:
    omega, epsilon = 7.0, -3.0
    made = study_of(linkages.slider_crank(0.1, 0.4, omega=omega, epsilon=epsilon))
    end = MP.mpf(0.1) * MP.expjpi(MP.mpf(1) / 6)
    for name, true in zip(("r_A", "v_A", "a_A"), (end, 1j * omega * end, (1j * epsilon - omega**2) * end), strict=True):
        assert abs(whole(name, made) - true) < 1e-30 * abs(true)
    assert abs(whole("r_B", made) - (end.real + MP.sqrt(MP.mpf(0.4) ** 2 - end.imag**2))) < 1e-30
    assert abs(whole("φ_1", made) - MP.pi / 6) < 1e-30
    assert abs(whole("ω_1", made) - omega) < 1e-30 and abs(whole("ε_1", made) - epsilon) < 1e-30


def test_listed_angles_and_a_clockwise_crank_have_their_truth() -> None:
    listed = study_of(linkages.slider_crank(0.1, 0.4), positions=[10, "32.5"])
    assert abs(whole("r_A", listed) - MP.mpf(0.1) * MP.expjpi(MP.mpf("32.5") / 180)) < 1e-30
    clockwise = study_of(linkages.slider_crank(0.1, 0.4, omega=-2.0), 0, 8)
    assert abs(whole("r_A", clockwise) - MP.mpf(0.1) * MP.expjpi(-MP.mpf(1) / 4)) < 1e-30


def of_gallery(name: str, count: int) -> Study:
    return Study(with_positions(read_scene(GALLERY / f"{name}.toml"), count))


@pytest.mark.parametrize("count", some([360, 12, 10_000], 3))
@pytest.mark.parametrize("name", some(["crank-rocker", "shaper", "slider-crank"], 2))
def test_the_construction_is_exact_to_a_few_roundings_at_any_number_of_positions(name: str, count: int) -> None:
    made = of_gallery(name, count)
    ways, _ = motion.roads(made, count)
    found = {name: judge(road.run()) for road in ways for name, judge in road.judged.items()}
    assert all(0 < found[road].worst <= GOAL * EPS for road in (PLANS, REPLAY))
    for tolerance in TOLERANCES:
        assert found[NEWTON.format(tolerance)].worst < tolerance
    assert found[NEWTON.format(1e-3)].worst > found[NEWTON.format(1e-6)].worst


def test_what_one_road_alone_finds_is_infinitely_wrong() -> None:
    found = list(quantities(of_gallery("shaper", 12), "linkage"))
    assert apart(found).worst < 1e-13
    lost = found[0]._replace(construction=found[0].construction * math.nan, difference=found[0].difference * math.nan)
    assert apart([lost, *found[1:]]).worst == math.inf


def test_every_run_begins_anew_over_what_its_technique_rests_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """Were the numbers of the first run kept, the clock would time nothing but the reading of them."""
    made = of_gallery("shaper-loaded", 12)
    drawn: list[str] = []
    for technique in ("linkage", "forces"):
        kind = type(made[technique])
        real = kind.construct
        monkeypatch.setattr(kind, "construct", lambda *a, t=technique, r=real: drawn.append(t) or r(*a))
    run = next(road.run for road in roads(made, "forces", 12) if CONSTRUCTION.format("forces") in road.judged)
    fresh = made.anew("forces")
    run(), run()
    assert drawn == ["forces"] * 2
    assert fresh["linkage"] is made["linkage"] and fresh["forces"] is not made["forces"]


def test_more_positions_begin_where_the_scene_begins() -> None:
    listed = (GALLERY / "crank-rocker.toml").read_text("utf-8").replace('start = "extreme"\n', "")
    listed = listed.replace("positions = 12", "positions = [15, 40, 70]").replace("plans = [4, 10]", "")
    drive = with_positions(parse_scene(listed), 5).of(LinkageForm).drive
    assert (drive.positions, drive.first) == (5, 15)


def test_few_positions_are_all_looked_at_and_many_all_over_the_turn() -> None:
    assert sample(np.zeros(12, bool)) == list(range(12))
    lost = np.arange(1000) % 10 == 0
    chosen = sample(lost)
    assert len(set(chosen)) == motion.SAMPLE and not lost[chosen].any()
    assert np.diff([*chosen, chosen[0] + 1000]).max() <= 2 * 1000 / motion.SAMPLE + 2
    assert any(k % 250 for k in chosen)  # not the quarter turns alone


@pytest.mark.parametrize("known", series.KNOWN, ids=lambda one: one.name)
def test_chords_are_of_the_order_that_is_known_of_them(known: series.KnownDiagram) -> None:
    """And the integral in closed form is that of the diagram, by a fine sum of rectangles."""
    edges = np.linspace(0, known.end, 100_001)
    areas = np.cumsum(known.ordinate(middles(edges)) * np.diff(edges))
    assert np.abs(known.whole(edges[1:]) - areas).max() <= 1e-4 * np.abs(areas).max()
    errors = [judge(road.run()).worst for road in map(known.road, (24, 384)) for judge in road.judged.values()]
    if known.note == "exact":
        assert max(errors) <= 400 * EPS
    else:
        due = 1.0 if known.note else 2.0
        assert order(errors, (24, 384)) == pytest.approx(due, abs=0.25 if known.note else 0.1)


def errors_of(ways: Any) -> dict[str, list[float]]:
    found: dict[str, list[float]] = {}
    for road in ways:
        result = road.run()
        for name, judge in road.judged.items():
            found.setdefault(name, []).append(judge(result).worst)
    return found


@pytest.mark.parametrize("loads", [PLANING, pytest.param(PUSHED, marks=pytest.mark.rest)])
def test_the_flywheel_by_chords_is_of_order_two_and_a_mean_bears_no_jump(loads: str) -> None:
    found = errors_of(series.dynamics(study(loads), Demand((12,), 1, startup=False)))
    chords = found[series.CHORDS]
    power = order(chords[1:], series.STRIPS[1:4])
    assert power > 1.8 and (loads == PUSHED or power < 2.2)
    first, *edges = found[series.EDGES]  # of the fewest strips the curve between the edges is out either way
    assert edges == sorted(edges, reverse=True) and edges[-1] < first / 10
    assert (found[series.MEAN][-1] < 1e-13) == (loads == PUSHED)


def test_the_ways_to_a_profile_are_of_their_orders() -> None:
    counts = (90, 720)
    judged = [cams.Judged(FollowerCourse(cam(end="roller")), offset_sizes(), 0.013, count) for count in counts]
    found = errors_of(road for one in judged for road in one.roads())
    for way in (name for name in (cams.INVERSION, cams.OFFSET) if name in found):
        assert order(found[way], counts) == pytest.approx(2.0, abs=0.1)
    assert max(found[cams.ENVELOPE]) < 2e-15


@pytest.mark.parametrize(
    ("name", "technique", "power"),
    [("slider-crank", series.DIAGRAMS.format("v"), 2.0), ("four-cylinder-bank", series.ORDINATES, None)],
)
def test_series_of_a_scene_fall(name: str, technique: str, power: float | None) -> None:
    make = series.diagrams if power else series.bank
    errors = errors_of(make(Study(read_scene(GALLERY / f"{name}.toml")), Demand((12,), 1, startup=False)))[technique]
    assert errors[0] > errors[1]
    assert power is None or order(errors, series.FEW) == pytest.approx(power, abs=0.15)
