"""Speeds without the flywheel drawn on from other energies: their mean stays the one asked for, however they swing."""

from __future__ import annotations

import numpy as np
import pytest

from drawings.dynamics.due_graphs import INERTIA, SURPLUS
from drawings.grading.curves.run_figures import Bare
from plans.model.dynamics import ANALYSIS, Speeds
from plans.model.motion import Floats

TURNED = np.linspace(0.0, 2 * np.pi, 73)
MASSES = 1.0 + 0.4 * np.cos(2 * TURNED)  # kg*m2


def swinging(delta: float) -> tuple[Speeds, Floats]:
    """Give a motion of mean speed 1 rad/s that swings by delta, and the surplus energy that it is of."""
    omega = 1.0 + delta / 2 * np.sin(TURNED)
    kinetic = MASSES * omega**2 / 2
    growth = np.zeros((len(TURNED) - 1, 2))
    extremes = float(omega.min()), float(omega.max())
    return Speeds(ANALYSIS, TURNED, omega, growth, extremes, MASSES[0], kinetic[0]), kinetic - kinetic[0]


def drawn_on(true: Speeds, surplus: Floats) -> Floats:
    own = {SURPLUS: np.asarray(1j * surplus), INERTIA: (MASSES - true.inertia).astype(np.complex128)}
    return Bare(true)(own).imag


@pytest.mark.parametrize("delta", [0.1, 1.0, 1.5, 1.9])
def test_speeds_follow_from_the_energies_that_are_drawn(delta: float) -> None:
    true, surplus = swinging(delta)
    assert drawn_on(true, surplus) == pytest.approx(true.omega, rel=1e-9)
    other = drawn_on(true, 0.98 * surplus)
    assert (other.min() + other.max()) / 2 == pytest.approx(1.0, rel=1e-9)
    kinetic = MASSES * other**2 / 2
    assert kinetic - kinetic[0] == pytest.approx(0.98 * surplus, abs=1e-9)


def test_nothing_follows_from_energies_at_which_the_machine_would_stop() -> None:
    true, surplus = swinging(1.9)
    assert np.isnan(drawn_on(true, 3 * surplus)).all()
