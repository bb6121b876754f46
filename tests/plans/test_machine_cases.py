"""A machine's motion by construction: worked values, odd and extreme cases (catalogue I), what stops or cannot turn."""

from __future__ import annotations

import json

import numpy as np
import pytest

from plans.analytic.dynamics.speeds import Stall, Swing
from plans.dynamics.numbers import NoPace, numbers
from plans.dynamics.quantities import DynamicsComparison
from plans.dynamics.reduction import Reducing
from plans.dynamics.study import NoCycle, NoInertia
from plans.scene.notes import notes_of
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import some
from tests.plans.dynamics_scenes import PLANING, PUSHED, study, text

ASKED = 'fluctuation = "1/25"'


def compared(loads: str = PLANING, drive: str = "positions = 24", asked: str = ASKED) -> DynamicsComparison:
    found = study(loads, drive, asked).comparison("dynamics")
    assert found.agrees, found.apart
    return found


def test_no_load_at_all() -> None:
    """I1: nothing to even out but the links' own inertia; the drive gives nothing, and nothing is divided by it."""
    found = compared(loads="")
    assert found.construction.cycle.driving == 0
    assert found.construction.cycle.surplus == pytest.approx(np.zeros(25), abs=0)
    varying = np.ptp(found.construction.cycle.inertia)
    assert found.construction.flywheel.whole == pytest.approx(varying * (1 - 0.02) ** 2 / 0.08, rel=2e-2)


@pytest.mark.parametrize("delta", some([0.2, 0.04, 0.0125, 0.002], 2))
def test_flywheel_keeps_the_fluctuation_that_was_asked(delta: float) -> None:
    """From 1/5 to 1/500: put back into the exact motion the exact flywheel gives the asked fluctuation."""
    found = compared(asked=f"fluctuation = {delta}")
    assert found.exact.speeds.delta == pytest.approx(delta, rel=1e-9)


def test_machine_heavy_enough() -> None:
    """I8: a motor's rotor behind a gear holds more than a flywheel would: none is needed, and delta is better."""
    found = compared(asked=f"{ASKED}\nmotor = {{ rotor = 0.5, ratio = 14 }}")
    assert found.construction.flywheel.needed < 0
    assert found.construction.flywheel.inertia == 0
    assert found.exact.speeds.delta < 0.04
    assert found.construction.speeds.mean == pytest.approx(120 * np.pi / 30, rel=1e-12)


def test_shafts_are_reduced_by_the_square_of_their_ratios() -> None:
    """(6.4), M4.3: 0.05*14^2 of the rotor and 0.4 of a gear on the crank's own shaft."""
    shafts = "motor = { rotor = 0.05, ratio = 14 }\nshafts = [{ inertia = 0.4 }, { inertia = 0.1, ratio = -2 }]"
    assert compared(asked=f"{ASKED}\n{shafts}").construction.flywheel.present == pytest.approx(0.05 * 196 + 0.4 + 0.4)


def test_machine_that_would_stop_without_a_flywheel() -> None:
    """I12: the links alone have too little energy for a cut of 2000 N."""
    found = compared()
    assert isinstance(found.before, Stall)
    assert found.construction.before is None
    assert isinstance(found.after, Swing)


@pytest.mark.parametrize("by", some(["construction", "analysis"], 2))
def test_the_run_is_told_as_plain_numbers(by: str) -> None:
    """Works and energies of each stage close; the rows end at rest, where the brake has stopped the machine."""
    motor = f"{ASKED}\nmotor = {{ starting = 300, synchronous = 14 }}\nrun = {{ turns = 1, brake = 300 }}"
    found = numbers(Study(parse_scene(text(asked=motor)), ["run"]), by)
    (told,) = json.loads(json.dumps(found.plain(), allow_nan=False))["dynamics"].items()
    run = told[1]
    assert (told[0], run["failure"]) == ("run", None)
    drawn = numbers(Study(parse_scene(text(asked=motor)), ["flywheel"]), "construction").plain()["dynamics"]["flywheel"]
    assert run["flywheel"] == {"inertia": drawn["inertia"], "reduced_to": "crank", "by": "construction"}
    assert [stage["name"] for stage in run["stages"]] == ["run_up", "steady", "run_down"]
    for stage in run["stages"]:
        works, (first, last) = stage["works"], stage["energies"]
        gained = works["driving"] - works["useful"] - works["braking"] + works["weights"]
        assert last - first - gained == pytest.approx(stage["closing"], abs=1e-9 * max(first, last))
    assert run["stages"][-1]["t"][1] == run["t"][-1] > run["t"][0] == 0
    assert len(run["t"]) == len(run["turned"]) == len(run["omega"]) == len(run["epsilon"])
    assert run["omega"][-1] == pytest.approx(0, abs=1e-9)
    assert run["steady"]["extremes"][0] < run["steady"]["mean"] < run["steady"]["extremes"][1]


@pytest.mark.parametrize(("by", "off"), [("construction", 0.04), ("analysis", 1e-7)])
def test_weights_of_a_run_work_by_how_far_they_fall_and_use_nothing(by: str, off: float) -> None:
    """Mass centres lie 0.04 and 0.0625 sin(phi) high; the cut takes 2000 N over 0.9 of 0.2 m a turn."""
    motor = f"{ASKED}\nmotor = {{ starting = 300, synchronous = 14 }}\nrun = {{ turns = 1, brake = 300 }}"
    falling = PLANING.replace("[[loads.forces]]", "[loads]\ngravity = 9.81\n[[loads.forces]]", 1)
    run = numbers(Study(parse_scene(text(falling, asked=motor)), ["run"]), by).plain()["dynamics"]["run"]
    most = 9.81 * (3 * 0.04 + 4 * 0.0625)
    for stage in run["stages"]:
        begun, ended = most * np.sin(np.interp(stage["t"], run["t"], run["turned"]))
        assert stage["works"]["weights"] == pytest.approx(begun - ended, abs=off * most)
    up, down = run["stages"][0], run["stages"][-1]
    assert abs(up["works"]["weights"]) > 0.1 * most
    assert abs(down["works"]["weights"]) > 0.1 * most
    assert up["works"]["useful"] == down["works"]["useful"] == 0
    assert run["steady"]["works"]["useful"] == pytest.approx(360, rel=off)


@pytest.mark.parametrize("by", ["construction", "analysis"])
def test_a_motor_that_cannot_lift_the_weights_at_the_start_is_told_their_moment(by: str) -> None:
    motor = f"{ASKED}\nmotor = {{ starting = 3, synchronous = 14 }}\nrun = {{ turns = 1 }}"
    told = numbers(Study(parse_scene(text("[loads]\ngravity = 9.81\n", asked=motor)), ["run"]), by).plain()
    failure = told["dynamics"]["run"]["failure"]
    assert (failure["reason"], failure["limit"]) == (
        "too_weak",
        pytest.approx(9.81 * (3 * 0.04 + 4 * 0.0625), rel=1e-6),
    )


def test_machine_that_drives() -> None:
    """I4: a force along the motion gives more than it takes: the moment that keeps the motion steady is a brake's."""
    pushed = PLANING.replace("value = 2000", "value = -2000")
    assert compared(pushed).construction.cycle.driving < 0


def test_crank_that_cannot_turn_fully() -> None:
    asked = text().replace("AB = 0.4", "AB = 0.09")
    machine = Study(parse_scene(asked.replace(PLANING, "")))["dynamics"]
    with pytest.raises(NoCycle, match="the crank does not turn fully"):
        machine.construct(("works",))


def test_plans_at_the_machines_true_speed() -> None:
    """speed_from: omega and epsilon of each position are those of the exact steady motion, and forces follow them."""
    scene = parse_scene(text(drive='positions = 24\nspeed_from = "dynamics"').replace('["dynamics"]', '["forces"]'))
    paced = Study(scene)
    omega, epsilon = (paced["linkage"].motion(2).links[1][order] for order in (1, 2))
    after = paced["dynamics"].linkage.turn.phi
    exact = compared().after
    assert isinstance(exact, Swing)
    assert omega == pytest.approx(exact.omega(after), rel=1e-12)
    assert epsilon == pytest.approx(exact.epsilon(after), rel=1e-9)
    assert paced.comparison("forces").agrees


def test_plans_at_the_true_speed_of_a_machine_with_its_motor() -> None:
    """speed_from: the motor drives the steady turn, so omega keeps below its synchronous speed, and the works close."""
    motor = f"{ASKED}\nmotor = {{ starting = 400, synchronous = 14 }}\nrun = {{ turns = 3 }}"
    drive = 'positions = 720\nspeed_from = "dynamics"'
    paced = Study(parse_scene(text(asked=motor, drive=drive).replace('["dynamics"]', '["kinematics"]')))
    omega, epsilon = (paced["linkage"].motion(2).links[1][order] for order in (1, 2))
    assert 0 < omega.max() < 14
    given = 400 * (1 - omega / 14)
    assert given.mean() * 2 * np.pi == pytest.approx(compared().exact.cycle.driving * 2 * np.pi, rel=1e-3)
    risen = (np.roll(omega, -1) - np.roll(omega, 1)) / (2 * 2 * np.pi / 720)
    smooth = np.abs(np.roll(epsilon, -1) - np.roll(epsilon, 1)) < 0.05 * np.abs(epsilon).max()
    assert smooth.sum() > 650
    assert (omega * risen)[smooth] == pytest.approx(epsilon[smooth], abs=1e-3 * np.abs(epsilon).max())


def test_true_speed_of_a_machine_that_stops() -> None:
    drive = 'positions = 24\nspeed_from = "dynamics"'
    scene = parse_scene(text(drive=drive, asked="").replace('["dynamics"]', '["kinematics"]'))
    with pytest.raises(NoPace, match="does not come to a steady motion"):
        Study(scene)["linkage"]


def test_large_fluctuation_is_noted() -> None:
    """I2: a third is taken, by the exact formula, and told to be large."""
    notes = [note.worded("en") for note in notes_of(parse_scene(text(asked='fluctuation = "1/3"')))]
    assert len(notes) == 1
    assert "is a large fluctuation" in notes[0]


def test_machine_that_runs_without_a_flywheel() -> None:
    """A lighter cut: both roads find the motion of the machine as it is, and the same."""
    light = compared(PLANING.replace("value = 2000", "value = 20"))
    assert light.construction.before is not None
    assert light.construction.before.mean == pytest.approx(120 * np.pi / 30, rel=1e-12)
    assert light.analysis.before.extremes == pytest.approx(light.construction.before.extremes, rel=1e-12)


def test_machine_without_any_inertia_in_a_position() -> None:
    """A slider alone stands still at its dead centres: no motor runs that up."""
    alone = text(asked="motor = { starting = 20, synchronous = 200 }").split("[masses]")
    bare = alone[0] + "[masses]\n3 = { mass = 8 }\n" + alone[1][alone[1].index("[[loads") :]
    with pytest.raises(NoInertia, match="0 degrees after position 0"):
        Study(parse_scene(bare))["dynamics"].construct(("run",))


@pytest.mark.parametrize(
    ("speed", "told"), [("8 rpm", True), ("30 rpm", False), ("120 rad/s", True), ("-90 rpm", False)]
)
def test_a_speed_far_from_that_of_the_drive_is_noted(speed: str, told: bool) -> None:
    """The drive is at 120 rpm: another mean speed may be asked for, but hardly a tenth of it."""
    notes = [note.worded("en") for note in notes_of(parse_scene(text(asked=f'{ASKED}\nspeed = "{speed}"')))]
    assert ["beside the 12.566 rad/s of the drive" in note for note in notes] == [True] * told


def test_reduction_that_is_asked_for_alone() -> None:
    """Theme 7: the masses reduced at one angle, and no steady turn."""
    found = compared(drive="positions = [60]", asked="reduction = true")
    assert found.construction.cycle is None
    assert f"{found.construction.reduced.inertia[0]:.10f}" == "0.1289878783"


EXACT_J0 = 36.73754573  # M4.9, ten digits
LOADED = np.radians([23.1632606, 150.3837539])  # where the cut begins and ends


def at_sixty() -> Reducing:
    return study(PUSHED, "positions = [60]")["dynamics"].reduction.own


def test_reduced_inertia_at_60_degrees() -> None:
    """M4.2: J and its derivative, every printed digit, and each link's share."""
    lever = at_sixty()
    assert f"{lever.inertia[0]:.10f}" == "0.1289878783"
    assert f"{lever.slope[0]:.11f}" == "0.07465262898"
    terms = {mark.name: mark.point.real.item() for mark in lever.moved}
    assert f"{terms['p(Q_1)'] + 0.01:.4f}" == "0.0148"
    assert f"{terms['p(Q_2)']:.11f}" == "0.03685623963"
    assert f"{terms['p(K_2)']:.13f}" == "0.0009836065574"
    assert f"{terms['p(Q_3)']:.11f}" == "0.07634803215"


def test_moments_on_either_side_of_a_jump() -> None:
    """The cut sets in at its full force: before it there is no moment, behind it 2000 N times dS/dphi."""
    cycle = study()["dynamics"].cycle
    k = int(np.argmin(np.abs(cycle.turned - LOADED[0])))
    phi = LOADED[0]
    rate = 0.1 * np.sin(phi) + 0.1**2 * np.sin(2 * phi) / 2 / np.sqrt(0.4**2 - (0.1 * np.sin(phi)) ** 2)
    assert cycle.moments[k - 1, 1] == 0
    assert cycle.moments[k, 0] == pytest.approx(-2000 * rate, rel=1e-8)


def test_work_of_the_drive_is_a_straight_line() -> None:
    """M4.7: from (0, 0) to (2 pi, 360 J), the work that the cut takes; its slope is the driving moment."""
    dynamics = study(asked="divisions = 480")["dynamics"]
    begin, end = (complex(mark.point) for mark in dynamics.works.drive.step.inputs)
    assert begin == 0
    assert end.real == pytest.approx(2 * np.pi, rel=1e-15)
    assert end.imag == pytest.approx(360, abs=0.01)  # 24 chords are 1 J off, these a four-hundredth of it
    assert end.imag / end.real == pytest.approx(dynamics.cycle.driving, rel=1e-12)


def error_of(divisions: int, asked: str = 'fluctuation = "1/25"') -> float:
    wheel = study(asked=f"{asked}\ndivisions = {divisions}")["dynamics"].flywheel
    return abs(wheel.whole / EXACT_J0 - 1)


def test_flywheel_converges_on_the_exact_one() -> None:
    """M4.9: with strips that end at the jumps the chords miss J0 by the square of a strip (order 2)."""
    errors = [error_of(count) for count in (24, 96, 384)]
    orders = np.diff(np.log(errors)) / np.log(1 / 4)
    assert orders == pytest.approx([2, 2], abs=0.1)
    assert errors[-1] < 2e-5


def test_work_closes_over_the_turn() -> None:
    cycle = study()["dynamics"].cycle
    assert cycle.surplus[-1] == pytest.approx(0, abs=1e-12 * abs(cycle.work[-1]))
    assert cycle.driving == pytest.approx(2000 * 0.9 * 0.2 / (2 * np.pi), rel=5e-3)


def test_constant_moment_on_the_crank_takes_nothing_from_the_drive_unevenly() -> None:
    """Nothing is left of the surplus but rounding, which is told as nothing; the links alone ask for a flywheel."""
    found = compared('[[loads.moments]]\non = 1\nvalue = 50\nagainst = "motion"\n')
    assert found.construction.cycle.driving == pytest.approx(50, rel=1e-14)
    assert found.construction.cycle.surplus.tolist() == [0.0] * 25
    for ours, theirs in zip(found.construction.flywheel.touches, found.analysis.flywheel.touches, strict=True):
        assert ours == pytest.approx(theirs, rel=1e-12)
