"""The motor: four laws of its moment over its speed, what bears a moment, and what a scene may say of it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.dynamics.form import DynamicsForm, motor_of, run_task
from plans.dynamics.reading import notes_of
from plans.linkage.reading.linkage import mechanism_of
from plans.model.motor import Constant, Kloss, Law, Linear, Motor, Tabled
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from tests.parts import examples
from tests.plans.dynamics_scenes import text

POINTS = Tabled((0.0, 50.0, 100.0, 150.0), (40.0, 30.0, 60.0, 10.0))
LAWS: list[Law] = [Linear(60.0, 20.0), Kloss(60.0, 0.2, 157.0), Kloss(60.0, 1.5, 157.0), POINTS]


def test_kloss_has_its_greatest_moment_at_the_critical_slip_and_none_at_the_synchronous_speed() -> None:
    motor = Kloss(60.0, 0.2, 100.0)
    assert motor.moment(80.0) == pytest.approx(60.0, rel=1e-15)
    assert motor.moment(100.0) == 0.0
    assert motor.moment(0.0) == pytest.approx(2 * 60 / (1 / 0.2 + 0.2), rel=1e-15)
    assert motor.moment(60.0) == pytest.approx(2 * 60 / (2 + 0.5), rel=1e-15)
    assert motor.moment(120.0) == pytest.approx(-60.0, rel=1e-15)


@pytest.mark.parametrize("law", LAWS)
def test_a_slope_is_that_of_the_moment(law: Law) -> None:
    for speed in (3.0, 17.0, 61.0, 120.0, 149.0):
        chord = (law.moment(speed + 1e-4) - law.moment(speed - 1e-4)) / 2e-4
        assert law.slope(speed) == pytest.approx(chord, rel=1e-6, abs=1e-9)
        assert -law.slope(speed) <= law.steepness * (1 + 1e-15)


@pytest.mark.parametrize("law", LAWS)
@examples(6)
@given(moment=st.floats(0.0, 59.0))
def test_the_speed_that_bears_a_moment_has_it_and_is_stable_and_the_greatest(law: Law, moment: float) -> None:
    speed = law.speed(moment)
    assert speed is not None
    assert law.moment(speed) == pytest.approx(moment, rel=1e-12, abs=1e-10)
    assert law.slope(speed - 1e-9) < 0
    assert all(law.moment(speed + more) < moment + 1e-9 for more in (0.1, 1.0, 5.0))


def test_a_table_is_straight_between_its_points_and_goes_on_beyond_them() -> None:
    assert [POINTS.moment(speed) for speed in (25.0, 50.0, 75.0, 160.0)] == [35.0, 30.0, 45.0, 0.0]
    assert POINTS.steepness == 1.0


@pytest.mark.parametrize("ratio", [12.5, -12.5])
def test_a_motor_is_brought_to_the_crank_by_its_ratio_once_for_the_moment_and_once_for_the_speed(ratio: float) -> None:
    motor = Motor(Linear(60.0, 250.0), ratio)
    assert motor.moment(10.0) == 12.5 * 60 * (1 - 125 / 250)
    assert motor.slope(10.0) == pytest.approx(-(12.5**2) * 60 / 250)
    assert motor.steepness == pytest.approx(12.5**2 * 60 / 250)
    assert motor.speed(375.0) == pytest.approx(10.0)


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
def test_a_scene_gives_one_of_four_laws(motor: str, law: Law) -> None:
    scene = parse_scene(scene_text(motor, '[dynamics.run]\nstep = "5 ms"\nturns = 3\nbrake = 7\nresistance = "start"'))
    form = scene.of(DynamicsForm).dynamics
    assert form.motor is not None
    assert form.motor.law == law
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
