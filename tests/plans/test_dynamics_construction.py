"""A machine's motion by construction: published values of methods 4.2-4.12, orders of the chords, and relations."""

from __future__ import annotations

import numpy as np
import pytest

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
