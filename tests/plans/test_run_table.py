"""The run by the book's table: its printed rows, closed forms, its first order, and its failures."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.analytic.dynamics.run import run as solved
from plans.dynamics.loop import ANGLE, ROWS_MOST, STOP, Acting, Ends, by_acceleration, by_energy
from plans.dynamics.run import mean_resistance, run, step_of
from plans.dynamics.study import curve
from plans.model.dynamics import TURN
from plans.model.motor import Constant, Kloss, Linear, Motor
from plans.model.run import RUN_DOWN, RUN_UP, STALLED, STEADY, TOO_MANY_ROWS, TOO_WEAK, ReducedLink, RunTask
from tests.parts import some
from tests.plans.reduced_links import crank_inertia, slider_crank, steady

MOTOR = Motor(Linear(60.0, 20.0))
DIGITS = 6e-10  # half a unit of the tenth figure


def reached(link: ReducedLink, step: float, count: int) -> tuple[float, ...]:
    acting = Acting(link, MOTOR)
    return by_acceleration(acting, acting.row(0.0, 0.0, 0.0), step, Ends(math.inf, count + 1)).rows[-1]


def test_textbook_table() -> None:
    acting = Acting(slider_crank(4.0), MOTOR)
    part = by_acceleration(acting, acting.row(0.0, 0.0, 0.0), 0.1, Ends(math.inf, 11))
    assert part.rows[0] == pytest.approx((0.0, 0.0, 0.0, 14.87292941), rel=DIGITS)
    assert part.rows[1] == pytest.approx((0.1, 0.07436464705, 1.487292941, 13.7577863), rel=DIGITS)
    assert part.rows[2] == pytest.approx((0.2, 0.2918828726, 2.863071571, 12.6211605), rel=2e-9)
    assert part.rows[10][2] == pytest.approx(10.6461273, rel=2e-9)
    half = reached(slider_crank(4.0), 0.05, 20)
    assert half[2] == pytest.approx(10.54668599, rel=DIGITS)
    assert (part.rows[10][2] - 10.44041021) / (half[2] - 10.44041021) == pytest.approx(1.9357, abs=5e-5)


def test_textbook_run_down() -> None:
    acting = Acting(steady(5.0), None, brake=30.0)
    start = acting.row(0.0, 0.0, 12.0)
    down = by_acceleration(acting, start, 0.03, Ends(math.inf, 1000))
    assert down.reason == STOP
    assert down.rows[-1] == pytest.approx((2.0, 12.0, 0.0, -6.0), rel=1e-13)
    assert down.works.braking == pytest.approx(360.0, rel=1e-13)
    half = by_energy(acting, start, 0.03, Ends(6.0, 1000))
    assert half.reason == ANGLE
    assert half.rows[-1].omega == pytest.approx(8.485281374, abs=5e-10)
    assert by_energy(acting, start, 0.03, Ends(100.0, 1000)).rows[-1][:3] == pytest.approx((2.0, 12.0, 0.0), rel=1e-13)


def test_works_are_taken_on_either_side_of_a_jump() -> None:
    link = slider_crank(4.0, force=2000.0)
    acting = Acting(link, None, loaded=True)
    whole = sum(acting.works(acting.row(0.0, k * TURN / 720, 1.0), (k + 1) * TURN / 720).useful for k in range(720))
    assert whole == pytest.approx(360.0, rel=1e-5)
    assert mean_resistance(link) == pytest.approx(57.29577951, rel=1e-4)
    fast = acting.row(0.0, 0.3, 1.0)
    assert acting.works(fast, 0.4).useful == 0.0


def test_in_a_steady_stage_the_account_closes_whatever_the_step() -> None:
    found = run(slider_crank(4.0, force=2000.0), Motor(Linear(600.0, 20.0)), RunTask(12.0, 2, 50.0, step=0.01))
    assert [stage.name for stage in found.stages] == [RUN_UP, STEADY, RUN_DOWN]
    stage = found.stage(STEADY)
    assert stage is not None
    assert abs(stage.closing) <= 1e-12 * stage.energies[0]
    assert stage.works.useful > 700
    assert found.turned[stage.last] == pytest.approx(math.ceil(found.turned[stage.first] / TURN) * TURN + 2 * TURN)


@pytest.mark.parametrize("motor", some([Motor(Linear(600.0, 20.0)), Motor(Constant(100.0)), MOTOR], 3))
def test_the_table_is_of_the_first_order(motor: Motor) -> None:
    link, task = slider_crank(4.0), RunTask(12.0, turns=0)
    steps = [step_of(link, motor, task) / 2**k for k in range(5)]
    times = [run(link, motor, task._replace(step=step)).ends(RUN_UP)[1] for step in steps]
    errors = [abs(time - solved(link, motor, task).ends(RUN_UP)[1]) for time in times]
    assert errors == sorted(errors, reverse=True)
    assert math.log2(errors[-2] / errors[-1]) == pytest.approx(1.0, abs=0.1)


def test_the_step_is_as_asked_or_a_strip_or_a_quarter_of_what_dies_away() -> None:
    link = steady(2.0)
    assert step_of(link, MOTOR, RunTask(12.0, step=0.3)) == 0.3
    assert step_of(link, Motor(Constant(1.0)), RunTask(12.0)) == pytest.approx(TURN / 12 / 24)
    assert step_of(link, MOTOR, RunTask(12.0)) == pytest.approx(TURN / 20 / 24)
    assert step_of(link, Motor(Linear(60.0, 0.2)), RunTask(12.0)) == pytest.approx(0.25 * 2.0 * 0.2 / 60)


def test_the_tables_failures_are_plain() -> None:
    loaded = slider_crank(4.0, force=2000.0)
    weak = run(loaded, Motor(Linear(50.0, 20.0)), RunTask(12.0, loaded=True))
    assert weak.failure is not None and weak.failure.reason == TOO_WEAK
    stops = run(steady(5.0, resistance=30.0), Motor(Constant(10.0)), RunTask(12.0))
    assert stops.failure is not None
    assert (stops.failure.reason, stops.failure.stage) == (STALLED, STEADY)
    assert stops.failure.turned == pytest.approx(54.0, rel=1e-12)
    stiff = run(loaded, Motor(Kloss(3000.0, 0.002, 157.0)), RunTask(150.0))
    assert stiff.failure is not None
    assert (stiff.failure.reason, len(stiff.t)) == (TOO_MANY_ROWS, ROWS_MOST)
    for found in (weak, stops, stiff):
        assert found.failure is not None
        assert len({found.failure.message.worded(language) for language in ("en", "ru")}) == 2


def test_a_curve_goes_through_its_ordinates_and_its_slope_is_its_own() -> None:
    places = np.linspace(0.0, TURN, 25)
    values = np.array([crank_inertia(complex(place)).real for place in places])
    slopes = np.array([crank_inertia(complex(place, 1e-30)).imag / 1e-30 for place in places])
    found = curve(places, values, slopes)
    for place in (0.0, 0.3, 1.0, 4.4, 6.2, 9.0):
        assert found.value(place) == pytest.approx(crank_inertia(complex(place)).real, abs=1e-4)
        chord = (found.value(place + 1e-6) - found.value(place - 1e-6)) / 2e-6
        assert found.slope(place) == pytest.approx(chord, abs=1e-6)
    assert [found.value(place) for place in places[:-1]] == pytest.approx(values[:-1], rel=1e-15)
