"""A machine's motion by construction: published values of methods 4.2-4.12, orders of the chords, and relations."""

from __future__ import annotations

import numpy as np
import pytest

from plans.dynamics.loop import slopes
from plans.dynamics.reduction import Reducing
from tests.plans.dynamics_scenes import PUSHED, study

EXACT_J0, EXACT_T0 = 36.73754573, 2996.601908  # M4.9, ten digits
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


def test_reduced_moment_at_60_degrees() -> None:
    """M4.4 counts the weight of link 2 alone: the crank's, 3 kg at 0.04 m, comes to it here."""
    crank = 3 * 9.81 * 0.04 * np.cos(np.radians(60))
    assert at_sixty().moment[0] + crank == pytest.approx(-118.4552813, abs=5e-8)


def test_planing_load_begins_and_ends() -> None:
    """M4.9: the strips have an edge where the cut begins and where it ends, to all printed digits."""
    found = np.degrees(study()["dynamics"].turn.breaks)
    for place in np.degrees(LOADED):
        assert np.abs(found - place).min() < 5e-8


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


def test_flywheel_of_many_strips() -> None:
    """M4.9: J0, T0 and both segments; four thousand strips leave a ten-millionth."""
    wheel = study(asked='fluctuation = "1/25"\ndivisions = 4096')["dynamics"].flywheel
    assert wheel.whole == pytest.approx(EXACT_J0, rel=2e-7)
    assert wheel.energy == pytest.approx(EXACT_T0, rel=2e-7)
    assert wheel.cuts[1] / 4 == pytest.approx(5.316480454, rel=2e-6)
    assert wheel.cuts[0] / 4 == pytest.approx(-52.69712643, rel=2e-7)
    assert [np.degrees(one.turned) for one in wheel.touches] == pytest.approx([150.3837539, 23.1632606], abs=5e-8)
    assert wheel.inertia == pytest.approx(36.70337073, rel=2e-7)


def test_angles_of_the_tangents() -> None:
    """M4.9: with mu_T = 4 and mu_J = 0.0025 the exact angles on paper."""
    angles = [np.degrees(np.arctan(one * 0.0025 / 4)) for one in slopes(120 * np.pi / 30, 0.04)]
    assert [f"{angle:.9f}" for angle in angles] == ["2.713436623", "2.939081068"]


def test_speed_with_the_flywheel() -> None:
    """M4.8, M4.9: on the strips that it was found from, the flywheel keeps the speed within what was asked."""
    speeds = study()["dynamics"].speeds
    omega = 120 * np.pi / 30
    assert speeds.extremes == pytest.approx((omega * 0.98, omega * 1.02), rel=1e-14)
    assert speeds.delta == pytest.approx(0.04, rel=1e-12)


def test_speed_and_its_slope_at_known_angles() -> None:
    """M4.8 and M4.12: omega at 150 degrees, and its acceleration by a tangent at 120 degrees."""
    dynamics = study(asked='fluctuation = "1/25"\ndivisions = 1440')["dynamics"]
    speeds = dynamics.speeds
    at = {round(np.degrees(one), 6): k for k, one in enumerate(speeds.turned)}
    assert speeds.omega[at[150.0]] == pytest.approx(12.31527858, abs=2e-7)
    assert speeds.epsilon[at[120.0], 0] == pytest.approx(-2.350325167, abs=1e-5)
    assert speeds.epsilon[at[120.0] - 1, 1] == pytest.approx(speeds.epsilon[at[120.0], 0], rel=1e-9)


def test_work_closes_over_the_turn() -> None:
    cycle = study()["dynamics"].cycle
    assert cycle.surplus[-1] == pytest.approx(0, abs=1e-12 * abs(cycle.work[-1]))
    assert cycle.driving == pytest.approx(2000 * 0.9 * 0.2 / (2 * np.pi), rel=5e-3)
