"""The rim of a flywheel: its mass and its section give back the inertia that was asked for."""

from __future__ import annotations

import math

import pytest

from plans.analytic.dynamics.flywheel import wheel
from plans.dynamics.cycle import rim_of
from plans.model.dynamics import THICKEST, Rim, Wheel


def sized(inertia: float, rim: Rim) -> Wheel:
    found = rim_of(inertia, rim)
    assert found is not None
    return found


def test_a_textbook_flywheel_and_the_same_on_a_faster_shaft() -> None:
    """M4.11: J = 11.8, D = 0.9 m; the same on a shaft of 14 turns, D = 0.3 m."""
    slow, fast = (sized(11.8, Rim(ratio, diameter)) for ratio, diameter in ((1.0, 0.9), (-14.0, 0.3)))
    assert slow.mass == pytest.approx(58.27160494, rel=1e-9)
    assert fast.inertia == pytest.approx(0.06020408163, rel=1e-9)
    assert fast.mass == pytest.approx(2.675736961, rel=1e-9)


@pytest.mark.parametrize("shape", [0.5, 1.0, 1.5, 3.0])
def test_the_ring_of_the_section_has_the_mass_and_the_inertia(shape: float) -> None:
    """The ring's volume, and its inertia as the difference of two discs; both roads give it."""
    rim = Rim(2.0, 1.2, 7200.0, shape)
    found = sized(36.70337073, rim)
    mass = rim.density * math.pi * (found.outer**2 - found.inner**2) / 4 * found.breadth
    disc = rim.density * math.pi * found.breadth * (found.outer**4 - found.inner**4) / 32
    assert mass == pytest.approx(found.mass, rel=1e-12)
    assert disc == pytest.approx(36.70337073 / 4 * (1 + found.added), rel=1e-12)
    assert found.breadth == pytest.approx(shape * found.thickness, rel=1e-14)
    assert wheel(36.70337073, rim) == pytest.approx(found, rel=1e-14)


def test_the_least_diameter_is_just_wide_enough() -> None:
    heavy = sized(1e4, Rim(1.0, 0.5))
    assert not heavy.fits
    least = sized(1e4, Rim(1.0, heavy.least_diameter))
    assert least.thickness / least.diameter == pytest.approx(THICKEST, rel=1e-12)


def test_no_rim_without_a_diameter_or_without_a_flywheel() -> None:
    assert rim_of(1.0, Rim()) is None
    assert rim_of(0.0, Rim(diameter=0.5)) is None


def test_the_speed_of_the_mean_circle() -> None:
    assert sized(1.0, Rim(1.0, 0.8)).at_speed(-10.0) == 4.0
