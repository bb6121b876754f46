"""The rim of a flywheel: its mass and its section give back the inertia that was asked for."""

from __future__ import annotations

import math

import pytest

from plans.model.dynamics import Rim
from plans.model.flywheel_rim import THICKEST, FlywheelRim, rim_of


def test_a_textbook_flywheel_and_the_same_on_a_faster_shaft() -> None:
    """M4.11: J = 11.8, D = 0.9 m; the same on a shaft of 14 turns, D = 0.3 m."""
    slow, fast = (rim_of(11.8, Rim(ratio, diameter)) for ratio, diameter in ((1.0, 0.9), (-14.0, 0.3)))
    assert slow is not None and fast is not None
    assert slow.mass == pytest.approx(58.27160494, rel=1e-9)
    assert fast.inertia == pytest.approx(0.06020408163, rel=1e-9)
    assert fast.mass == pytest.approx(2.675736961, rel=1e-9)


@pytest.mark.parametrize("shape", [0.5, 1.0, 1.5, 3.0])
def test_the_ring_of_the_section_has_the_mass_and_the_inertia(shape: float) -> None:
    """The ring's volume by Guldin, and its inertia as the difference of two discs."""
    rim = FlywheelRim(36.70337073, 1.2, 7200.0, shape)
    outer, inner = (rim.diameter + rim.thickness) / 2, (rim.diameter - rim.thickness) / 2
    mass = rim.density * math.pi * (outer**2 - inner**2) * rim.breadth
    disc = rim.density * math.pi * rim.breadth * (outer**4 - inner**4) / 2
    assert mass == pytest.approx(rim.mass, rel=1e-12)
    assert disc == pytest.approx(rim.inertia * (1 + rim.added), rel=1e-12)
    assert rim.breadth == pytest.approx(shape * rim.thickness, rel=1e-15)


def test_the_least_diameter_is_just_wide_enough() -> None:
    heavy = FlywheelRim(1e4, 0.5, 7200.0, 1.5)
    assert not heavy.fits
    least = heavy._replace(diameter=heavy.least_diameter)
    assert least.thickness / least.diameter == pytest.approx(THICKEST, rel=1e-12)


def test_no_rim_without_a_diameter_or_without_a_flywheel() -> None:
    assert rim_of(1.0, Rim()) is None
    assert rim_of(0.0, Rim(diameter=0.5)) is None


def test_the_speed_of_the_mean_circle() -> None:
    assert FlywheelRim(1.0, 0.8, 7200.0, 1.5).at_speed(-10.0) == 4.0
