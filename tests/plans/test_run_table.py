"""Runs by a table of steps, as by hand, the motors that drive them, and the rim of their flywheel."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.analytic.dynamics.flywheel import wheel
from plans.analytic.dynamics.run import run as solved
from plans.dynamics.cycle import rim_of
from plans.dynamics.form import DynamicsForm, motor_of, run_task
from plans.dynamics.loop import ANGLE, ROWS_MOST, STOP, Acting, Ends, by_acceleration, by_energy
from plans.dynamics.reading import notes_of
from plans.dynamics.run import run, step_of
from plans.dynamics.study import curve
from plans.linkage.reading.linkage import mechanism_of
from plans.model.dynamics import THICKEST, TURN, Rim, Wheel
from plans.model.motor import Constant, Kloss, Linear, Motor, MotorLaw, Tabled
from plans.model.run import RUN_UP, STALLED, STEADY, TOO_MANY_ROWS, TOO_WEAK, ReducedLink, RunTask
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from tests.parts import some
from tests.plans.dynamics_scenes import text
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


@pytest.mark.parametrize("motor", some([Motor(Linear(600.0, 20.0)), Motor(Constant(100.0)), MOTOR], 3))
def test_the_table_is_of_the_first_order(motor: Motor) -> None:
    link, task = slider_crank(4.0), RunTask(12.0, turns=0)
    steps = [step_of(link, motor, task) / 2**k for k in range(5)]
    times = [run(link, motor, task._replace(step=step)).ends(RUN_UP)[1] for step in steps]
    errors = [abs(time - solved(link, motor, task).ends(RUN_UP)[1]) for time in times]
    assert errors == sorted(errors, reverse=True)
    assert math.log2(errors[-2] / errors[-1]) == pytest.approx(1.0, abs=0.1)


def test_a_drifting_speed_is_what_the_inertia_gives() -> None:
    """A heavy machine is not steady after one turn under load; what the drive lacks over it, its inertia gives."""
    heavy, motor = slider_crank(400.0, force=2000.0), Motor(Linear(600.0, 20.0))
    found = run(heavy, motor, RunTask(12.0, turns=1))
    turn, drift = found.steady, found.drift
    assert turn is not None and drift < 0
    assert heavy.inertia(0.0) * (turn.start + drift / 2) * drift == pytest.approx(turn.works.gained, rel=1e-9)
    assert run(slider_crank(4.0, force=2000.0), motor, RunTask(12.0, turns=8, brake=200.0)).drift == 0.0


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


POINTS = Tabled((0.0, 50.0, 100.0, 150.0), (40.0, 30.0, 60.0, 10.0))
LAWS: list[MotorLaw] = [Linear(60.0, 20.0), Kloss(60.0, 0.2, 157.0), Kloss(60.0, 1.5, 157.0), POINTS]


def test_kloss_has_its_greatest_moment_at_the_critical_slip_and_none_at_the_synchronous_speed() -> None:
    motor = Kloss(60.0, 0.2, 100.0)
    told = {80.0: 60.0, 100.0: 0.0, 0.0: 2 * 60 / (1 / 0.2 + 0.2), 60.0: 2 * 60 / (2 + 0.5), 120.0: -60.0}
    assert [motor.moment(speed) for speed in told] == pytest.approx([*told.values()], rel=1e-15)


@pytest.mark.parametrize("law", LAWS)
def test_a_slope_is_that_of_the_moment(law: MotorLaw) -> None:
    for speed in (3.0, 17.0, 61.0, 120.0, 149.0):
        chord = (law.moment(speed + 1e-4) - law.moment(speed - 1e-4)) / 2e-4
        assert law.slope(speed) == pytest.approx(chord, rel=1e-6, abs=1e-9)
        assert -law.slope(speed) <= law.steepness * (1 + 1e-15)


def test_a_table_is_straight_between_its_points_and_goes_on_beyond_them() -> None:
    assert [POINTS.moment(speed) for speed in (25.0, 50.0, 75.0, 160.0)] == [35.0, 30.0, 45.0, 0.0]
    assert POINTS.steepness == 1.0


@pytest.mark.parametrize("ratio", [12.5, -12.5])
def test_a_motor_is_brought_to_the_crank_by_its_ratio_once_for_the_moment_and_once_for_the_speed(ratio: float) -> None:
    motor = Motor(Linear(60.0, 250.0), ratio)
    assert motor.moment(10.0) == 12.5 * 60 * (1 - 125 / 250)
    steep = 12.5**2 * 60 / 250
    assert (motor.slope(10.0), motor.steepness, motor.speed(375.0)) == pytest.approx((-steep, steep, 10.0))


def scene_text(motor: str, run: str = "") -> str:
    return text(asked=f'fluctuation = "1/25"\n[dynamics.motor]\n{motor}\n{run}')


@pytest.mark.parametrize(
    ("motor", "law"),
    [
        ('starting = "60 N*m"\nsynchronous = 20', Linear(60.0, 20.0)),
        ("breakdown = 60\nslip = 0.2\nsynchronous = 20", Kloss(60.0, 0.2, 20.0)),
        ("speeds = [0, 10, 20]\nmoments = [40, 60, 0]", Tabled((0.0, 10.0, 20.0), (40.0, 60.0, 0.0))),
        ("moment = 57.5", Constant(57.5)),
    ],
)
def test_a_scene_gives_one_of_four_laws(motor: str, law: MotorLaw) -> None:
    scene = parse_scene(scene_text(motor, '[dynamics.run]\nstep = "5 ms"\nturns = 3\nbrake = 7\nresistance = "start"'))
    form = scene.of(DynamicsForm).dynamics
    assert form.motor is not None and form.motor.law == law
    assert motor_of(form.motor) == Motor(law)
    assert run_task(form.run, 12.0) == (12.0, 3, 7.0, True, 0.005)


@pytest.mark.parametrize(
    ("motor", "kinds"),
    [
        ("starting = 60", ["missing"]),
        ("synchronous = 60", ["missing"]),
        ("breakdown = 60\nsynchronous = 20", ["missing"]),
        ("speeds = [0, 1]", ["missing"]),
        ("moment = 3\nslip = 0.1", ["one_of_two"]),
        ("moment = 3\nsynchronous = 20", ["one_of_two"]),
        ("starting = 3\nbreakdown = 4\nslip = 0.1\nsynchronous = 20", ["one_of_two"]),
        ("speeds = [1, 2]\nmoments = [2, 1]", ["speeds_from_rest"]),
        ("speeds = [0]\nmoments = [2]", ["speeds_from_rest"]),
        ("speeds = [0, 20, 20]\nmoments = [3, 2, 1]", ["speeds_rise"]),
        ("speeds = [0, 20]\nmoments = [3, 2, 1]", ["as_many_moments"]),
        ("speeds = [0, 20]\nmoments = [0, -2]", ["not_positive"]),
        ("speeds = [0, 20, 30]\nmoments = [3, 2, 4]", ["moments_fall"]),
        ("speeds = [0, 20]\nmoments = [3, 2]\nratio = 12", ["speeds_end"]),
        ("moment = 0\nratio = 0\nspeeds = 4", ["not_positive", "shaft_ratio", "wrong_type"]),
        ('rotor = 1\n[dynamics.run]\nbrake = "5 N*m"', ["no_law"]),
        ("moment = 3\n[dynamics.run]\nturns = 101\nbrake = 0", ["too_many_turns", "not_positive"]),
        ('moment = 3\n[dynamics.run]\nresistance = "never"\nstep = -1', ["choice", "not_positive"]),
        ("starting = 60\n[dynamics.run]\nbrake = 5", ["missing"]),
    ],
)
def test_a_wrong_motor_is_told_with_all_its_mistakes(motor: str, kinds: list[str]) -> None:
    with pytest.raises(SceneError) as found:
        mechanism_of(parse_scene(scene_text(motor)))
    assert [fault.kind for fault in found.value.faults] == kinds
    for fault in found.value.faults:
        assert fault.line > 30
        assert all(fault.worded(language) for language in ("en", "ru"))


@pytest.mark.parametrize(("ratio", "noted"), [(12.0, []), (1.0, ["free_speed"]), (13.0, ["free_speed"])])
def test_a_motor_that_cannot_run_near_the_asked_speed_is_noted(ratio: float, noted: list[str]) -> None:
    scene = parse_scene(scene_text(f'starting = 60\nsynchronous = "1500 rpm"\nratio = {ratio}'))
    assert [note.kind for note in notes_of(scene) if note.kind == "free_speed"] == noted


def sized(inertia: float, rim: Rim) -> Wheel:
    found = rim_of(inertia, rim)
    assert found is not None
    return found


def test_a_textbook_flywheel_and_the_same_on_a_faster_shaft() -> None:
    """M4.11: J = 11.8, D = 0.9 m; the same on a shaft of 14 turns, D = 0.3 m."""
    slow, fast = (sized(11.8, Rim(ratio, diameter)) for ratio, diameter in ((1.0, 0.9), (-14.0, 0.3)))
    found = slow.mass, fast.inertia, fast.mass
    assert found == pytest.approx((58.27160494, 0.06020408163, 2.675736961), rel=1e-9)


def test_the_least_diameter_is_just_wide_enough() -> None:
    heavy = sized(1e4, Rim(1.0, 0.5))
    assert not heavy.fits
    least = sized(1e4, Rim(1.0, heavy.least_diameter))
    assert least.thickness / least.diameter == pytest.approx(THICKEST, rel=1e-12)


@pytest.mark.parametrize(("size", "less", "inertia"), [(0.16, 0.12, 0.011), (0.5, 0.4, 1.662), (1.0, 0.8, 86.62)])
def test_a_diameter_that_is_not_given_is_the_least_of_row_ra10_at_which_the_rim_is_thin(size, less, inertia) -> None:
    chosen, smaller = sized(4 * inertia, Rim(-2.0)), sized(inertia, Rim(diameter=less))
    assert wheel(4 * inertia, Rim(-2.0)) == pytest.approx(chosen, rel=1e-12)
    assert (chosen.diameter, chosen.ratio) == (pytest.approx(size), -2.0)
    assert chosen.thickness / size <= 1 / 8 < smaller.thickness / less


def test_no_rim_without_a_flywheel_and_the_speed_of_the_mean_circle() -> None:
    assert rim_of(0.0, Rim(diameter=0.5)) is None
    assert sized(1.0, Rim(1.0, 0.8)).at_speed(-10.0) == 4.0


def test_no_speed_bears_more_than_the_motor_has_and_a_constant_moment_has_none_of_its_own() -> None:
    assert [law.speed(61.0) for law in LAWS] == [None] * len(LAWS)
    assert Kloss(60.0, 0.2, 100.0).speed(60.0) == pytest.approx(80.0)
    law = Constant(5.0)
    assert (law.moment(3.0), law.slope(3.0), law.speed(5.0), law.steepness) == (5.0, 0.0, None, 0.0)
