"""The run by its differential equation: closed forms, the worked machine of methods 4.9, accounts, plain failures."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from plans.analytic.dynamics.equation import (
    ANGLE,
    AT_REST,
    EXPLICIT,
    IMPLICIT,
    SPEED,
    STOP,
    TOLERANCES,
    Equation,
    LegEnds,
    RunState,
    Solver,
    size_of,
)
from plans.analytic.dynamics.run import chosen, run
from plans.model.dynamics import TURN
from plans.model.motor import Constant, Kloss, Linear, Motor, Tabled
from plans.model.run import (
    RUN_DOWN,
    RUN_UP,
    SETTLED,
    STALLED,
    STEADY,
    TOO_WEAK,
    UNSETTLED,
    ReducedLink,
    RunTask,
    SteadyTurn,
    Works,
)
from tests.plans.reduced_links import OFF, ON, slider_crank, steady

SPEED_50HZ = 2 * math.pi * 25
STIFF = Motor(Kloss(3000.0, 0.002, SPEED_50HZ))


def explicit(link: ReducedLink, speed: float) -> Solver:
    return Solver(EXPLICIT, size_of(link, speed))


def at(omega: float) -> RunState:
    return RunState(0.0, np.array([0.0, omega, 0.0, 0.0, 0.0, 0.0]))


@pytest.mark.parametrize(("slip", "time"), [(0.2, 13.778769107388), (0.02, 66.173225390963), (0.002, 654.570807341343)])
def test_a_kloss_motor_without_load_runs_up_in_the_time_of_the_closed_form(slip: float, time: float) -> None:
    link, motor = steady(2.0), Motor(Kloss(60.0, slip, SPEED_50HZ))
    s = 1e-6
    closed = 2.0 * SPEED_50HZ / 120.0 * ((1 - s * s) / (2 * slip) + slip * math.log(1 / s))
    assert closed == pytest.approx(time, abs=1e-12 * time)
    leg = explicit(link, SPEED_50HZ).leg(
        Equation(link, motor, base=SPEED_50HZ), AT_REST, LegEnds(math.inf, SPEED_50HZ * (1 - s))
    )
    assert leg.reason == SPEED
    assert leg.end.t == pytest.approx(closed, rel=1e-10)


def test_textbook_run_up_of_the_slider_crank() -> None:
    link, motor = slider_crank(4.0), Motor(Linear(60.0, 20.0))
    leg = explicit(link, 20.0).leg(Equation(link, motor, base=20.0), AT_REST, LegEnds(math.inf, 10.44041021))
    assert leg.rows[0, 3] == pytest.approx(14.87292941, abs=5e-9)
    assert leg.end.t == pytest.approx(1.0, abs=2e-9)
    assert leg.end.turned == pytest.approx(5.839695429, abs=2e-8)


def test_textbook_steady_turn_of_the_planing_machine() -> None:
    """Methods 4.9: with the flywheel and the energy that are found there, the speed keeps between its bounds."""
    link = slider_crank(36.70337073, force=2000.0)
    start = math.sqrt(2 * 2996.601908 / 36.73754573)
    leg = explicit(link, start).leg(Equation(link, Motor(Constant(57.29577951)), True), at(start), LegEnds(TURN))
    assert leg.reason == ANGLE
    speeds = np.concatenate([leg.turning, leg.rows[:, 2]])
    assert speeds.max() == pytest.approx(12.81769803, abs=2e-8)
    assert speeds.min() == pytest.approx(12.3150432, abs=2e-7)
    assert leg.end.omega == pytest.approx(start, abs=1e-8)
    extremes = [place for place, speed in leg.rows[:, 1:3].tolist() if speed in (speeds.max(), speeds.min())]
    assert extremes == pytest.approx([ON, ON, OFF, OFF], abs=1e-12)


def test_textbook_run_down_under_a_brake() -> None:
    link = steady(5.0)
    leg = explicit(link, 12.0).leg(Equation(link, None, brake=30.0), at(12.0), LegEnds(math.inf))
    assert leg.reason == STOP
    assert (leg.end.t, leg.end.turned, leg.end.omega) == pytest.approx((2.0, 12.0, 0.0), rel=1e-12)
    half = explicit(link, 12.0).leg(Equation(link, None, brake=30.0), at(12.0), LegEnds(6.0))
    assert half.end.omega == pytest.approx(8.485281374, abs=5e-10)


def test_textbook_efficiency() -> None:
    works = Works(2400.0, 1800.0, braking=600.0)
    assert (works.efficiency, works.loss) == (0.75, 0.25)
    assert Works(2400.0).efficiency == 0.0
    assert Works().efficiency is None


MACHINES = [
    (slider_crank(4.0, force=2000.0), Motor(Linear(600.0, 20.0))),
    (slider_crank(4.0, force=2000.0), Motor(Kloss(60.0, 0.1, 160.0), 12.5)),
    (slider_crank(4.0, force=2000.0), Motor(Tabled((0.0, 80.0, 150.0), (60.0, 90.0, 0.0)), -10.0)),
    (slider_crank(0.2, force=100.0, share=0.2), STIFF),
]


@pytest.mark.parametrize(("link", "motor"), MACHINES)
def test_a_run_has_three_stages_whose_accounts_close(link: ReducedLink, motor: Motor) -> None:
    found = run(link, motor, RunTask(12.0, 2, brake=200.0))
    assert found.failure is None
    assert found.gaps == ()
    assert [stage.name for stage in found.stages] == [RUN_UP, STEADY, RUN_DOWN]
    for stage in found.stages:
        assert abs(stage.closing) <= 1e3 * TOLERANCES[found.method.name] * max(stage.energies)
    for before, after in pairwise(found.stages):
        assert before.last + 1 == after.first
        assert found.t[before.last] == found.t[after.first]
        assert before.energies[1] == after.energies[0]
    assert found.stages[0].first == 0
    assert found.stages[-1].last == len(found.t) - 1
    assert (np.diff(found.t) >= 0).all()
    assert (np.diff(found.turned) >= 0).all()
    assert found.omega[-1] == 0.0
    up = found.stage(RUN_UP)
    assert up is not None
    assert found.omega[up.last] == pytest.approx(SETTLED * float(motor.speed(0.0) or 0.0), rel=1e-12)
    assert up.works.useful == up.works.braking == 0.0


@pytest.mark.parametrize(("link", "motor"), MACHINES)
def test_a_steady_turn_repeats_itself_and_uses_all_that_it_is_given(link: ReducedLink, motor: Motor) -> None:
    found = run(link, motor, RunTask(12.0, 1)).steady
    assert found is not None
    assert abs(found.closing) <= 1e-9 * found.start
    assert found.works.efficiency == pytest.approx(1.0, abs=1e-6)
    assert found.works.useful == pytest.approx(360.0 if found.mean < 100 else 18.0, rel=1e-6)
    # Between the extremes the motor bears the mean resistance.
    bearing = motor.speed(found.works.useful / TURN)
    assert bearing is not None
    assert found.extremes[0] < bearing < found.extremes[1]


def test_the_solver_is_chosen_by_how_stiff_the_motor_is() -> None:
    link = slider_crank(0.2, force=100.0, share=0.2)
    names = [
        chosen(link, Motor(Kloss(most, slip, SPEED_50HZ)), SPEED_50HZ).name
        for slip, most in ((0.2, 60.0), (0.05, 200.0), (0.005, 1200.0), (0.002, 3000.0))
    ]
    assert names == [EXPLICIT, EXPLICIT, IMPLICIT, IMPLICIT]


def test_a_motor_that_cannot_bear_the_load_is_too_weak() -> None:
    link = slider_crank(4.0, force=2000.0)
    found = run(link, Motor(Linear(50.0, 20.0)), RunTask(12.0, loaded=True))
    assert found.failure is not None
    assert (found.failure.reason, found.failure.stage, found.stages) == (TOO_WEAK, RUN_UP, ())
    assert found.failure.limit == pytest.approx(57.29577951, abs=1e-7)
    assert [gap.reason for gap in found.gaps] == [TOO_WEAK]
    assert "57.296" in found.failure.message.worded("en")


def test_a_machine_that_stops_says_where() -> None:
    """A flywheel of constant inertia, driven by 10 N*m against 30 N*m, turns T/20 rad and stops."""
    link = steady(5.0, resistance=30.0, breaks=(1.0,))
    found = run(link, Motor(Constant(10.0)), RunTask(12.0))
    up = found.stage(RUN_UP)
    assert up is not None and found.failure is not None
    assert found.omega[up.last] == 12.0
    assert (found.failure.reason, found.failure.stage, found.failure.omega) == (STALLED, STEADY, 0.0)
    assert found.failure.turned == pytest.approx(360.0 / 10 + 360.0 / 20, rel=1e-10)
    degrees = math.degrees(54.0 % TURN)
    assert f"{degrees:.4g}".replace(".", ",") in found.failure.message.worded("ru")
    assert found.steady is None


def test_a_motor_that_creeps_has_not_settled() -> None:
    """Of its two stable speeds it reaches the lower one."""
    law = Tabled((0.0, 5.0, 10.0, 20.0), (50.0, -10.0, 50.0, 0.0))
    found = run(steady(2.0, breaks=(1.0,)), Motor(law), RunTask(15.0, loaded=True))
    assert found.failure is not None
    assert (found.failure.reason, found.failure.limit) == (UNSETTLED, pytest.approx(SETTLED * 20.0))
    assert found.failure.omega == pytest.approx(5.0 * 50 / 60, rel=1e-6)


def test_the_measures_of_a_steady_turn() -> None:
    found = SteadyTurn(10.0, (9.0, 11.0), TURN / 10.5, 0.0, Works())
    assert (found.mean, found.delta) == (10.0, 0.2)
    repeats = [replace(found, closing=change).repeats for change in (-0.03, -0.01, 0.0, 0.01, 0.03)]
    assert repeats == [False, True, True, True, False]
