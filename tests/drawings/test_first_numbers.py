"""The numbers said first of a scene: stroke, time ratio, greatest velocity, acceleration and balancing moment."""

from __future__ import annotations

import re

import numpy as np
import pytest

from drawings.linkage.notes import greatest
from drawings.report.report import headlines
from tests.drawings.test_linkage_note import study


def said(name: str, *changes: tuple[str, str]) -> str:
    """Say first what a scene of the gallery is told by, with parts of it changed."""
    return "\n".join(headlines(study(name, *changes)))


def number(text: str, letter: str) -> tuple[float, int]:
    """Read a greatest number and its position."""
    found = re.search(rf"\|{letter}\|max = ([\d.]+) \S+ \(position (\d+)\)", text)
    assert found is not None
    return float(found[1]), int(found[2])


def test_the_greatest_balancing_moment_is_that_of_the_energy() -> None:
    """M ω is what yoke and block gain of energy, and what the load takes on the stroke to the right."""
    phi, omega, crank = np.radians(30.0 * np.arange(12)), 4 * np.pi, 0.06
    speed, rate = -crank * omega * np.sin(phi), -crank * omega**2 * np.cos(phi)
    load = np.where(speed > 0, 400 * speed, 0.0)
    moment = (4 * rate * speed + 0.3 * 9.81 * crank * omega * np.cos(phi) + load) / omega
    where = int(np.argmax(np.abs(moment)))
    out = '[output]\nlink = 3\nworking = "right"\n\n[masses]'
    assert number(said("scotch-yoke", ("[masses]", out)), "M_bal") == (
        pytest.approx(np.abs(moment[where]), rel=5e-5),
        where,
    )


def test_a_rocker_swings_and_has_rates_of_its_link_in_its_own_language() -> None:
    told = said("crank-rocker", ("[sheet]\n", '[sheet]\nlanguage = "ru"\n'))
    assert re.search(r"\nψ = [\d,]+°, K = 1,\d{4}, \|ω_3\|max = [\d,]+ рад/с \(положение \d+\), \|ε_3\|max", told)
    coupler = said("crank-rocker", ("[sheet]\n", '[output]\npoint = "E"\n\n[sheet]\n'))
    assert re.search(r"\nψ_2 = [\d.]+°, K = 1.\d{4}, \|v_E\|max", coupler)


def test_a_plan_of_positions_alone_says_nothing_of_strokes_and_velocities() -> None:
    told = said("crank-rocker", ("title =", 'sheets = ["positions"]\ntitle ='), ("plans = [4, 10]\n", ""))
    assert "ψ" not in told
    assert "max" not in told


def test_gaps_have_no_greatest() -> None:
    assert greatest(np.array([np.nan, np.nan])) is None


def test_a_scotch_yoke_goes_as_the_cranks_shadow() -> None:
    """Of x = r cos φ the stroke is 2r, the velocity r ω at most, and r ω² the acceleration at the ends."""
    told, omega = said("scotch-yoke"), 4 * np.pi
    assert "\nH = 0.12 m, K = 1.0000, " in told
    assert number(told, "v_B") == (pytest.approx(0.06 * omega, rel=5e-5), 3)
    assert number(told, "a_B") == (pytest.approx(0.06 * omega**2, rel=5e-5), 0)
