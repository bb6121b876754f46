"""Balancing by both roads: every quantity of the textbook's machines agrees, and what differs is seen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from geometry.meet import EPS
from plans.analytic.balance import counterweights as by_vectors
from plans.checks.balance.comparison import BalanceComparison, compare_balance
from plans.checks.compare import compare
from plans.model.balance.linkage import FULL, NONE, PARTIAL, REACTION, SECTOR, SHARE, Place, Task
from tests.plans.balanced import ENGINE, FOUR_BAR, SHAPER, SIX_LINK, asked, study

CASES = {
    "four-bar a": (FOUR_BAR, asked(FULL, Place(1, mass=9), Place(2, mass=6))),
    "four-bar b": (FOUR_BAR, asked(FULL, Place(3, radius=0.2), Place(1, mass=5))),
    "one of two": (FOUR_BAR, asked(FULL, Place(1, shape=SECTOR), Place(2, mass=6), Place(3, mass=8))),
    "as it is": (SIX_LINK, Task(NONE)),
    "engine in part": (ENGINE, asked(PARTIAL, Place(1, mass=2))),
    "engine in full": (ENGINE, asked(FULL, Place(1, at=-0.15), Place(2, at=-0.25))),
    "a share": (ENGINE, asked(SHARE, Place(1, radius=0.1), share=0.4)),
    "least force": (ENGINE, asked(SHARE, Place(1, mass=20))),
    "least reaction": (ENGINE, asked(SHARE, Place(1, shape=SECTOR), least=REACTION)),
    "shaper": (SHAPER, asked(FULL, Place(1, mass=6), Place(3, mass=160), Place(4, mass=30))),
    "shaper in part": (SHAPER, asked(PARTIAL, Place(3, mass=160), Place(1, shape=SECTOR))),
}
# The three roads of the main vector: main points with direct sums, the polygon of inertia forces, and what the frame
# holds; each within so many roundings of the largest.
ROADS = 8


def compared(text: str, task: Task) -> BalanceComparison:
    its = study(text, task)
    return compare_balance(its, compare(its.linkage))


@pytest.mark.parametrize("case", CASES)
def test_both_roads_agree(case) -> None:
    found = compared(*CASES[case])
    assert [one.name for one in found.findings if one.excess.max() > 1] == []
    assert found.agrees
    for one in found.findings:
        if one.name.rstrip("'") in ("Φ", "ΣΦ", "ΣR_0"):
            assert np.nanmax(one.difference) <= ROADS * EPS * one.largest


def test_what_is_compared() -> None:
    """Every number of a balance by both roads: nothing that is told goes without a road of its own."""
    found = compared(*CASES["a share"])
    names = {one.name for one in found.findings}
    told = {"h_1", "h_2", "r_S", "Φ", "M_Φ", "Σmr/m", "ΣΦ", "ΣR_0", "ΣM_0", "R_01", "R_12", "R_03", "M_bal", "M_03"}
    assert told | {f"{name}'" for name in told} <= names
    assert {
        "S'",
        "U_1",
        "m_cw1",
        "r_cw1",
        "m_B",
        "Φ(k)",
        "min Φ(k)",
        "k Φ",
        "R_01(k)",
        "min R_01(k)",
        "k R_01",
    } <= names


def test_a_wrong_counterweight_is_seen(monkeypatch) -> None:
    """Of a counterweight that is a millionth too heavy nothing after balancing agrees."""
    right = by_vectors.mass_of
    monkeypatch.setattr(by_vectors, "mass_of", lambda place, moment: right(place, moment) * (1 + 1e-6))
    found = compared(*CASES["four-bar b"])
    assert not found.agrees
    assert {"m_cw3", "r_cw3", "r_S'", "R_03'"} <= {one.name for one in found.findings if one.excess.max() > 1}


def test_a_mass_centre_that_moves_is_seen() -> None:
    """The sum that must vanish is of the construction alone."""
    its = study(*CASES["four-bar a"])
    first, second = its.counterweights
    vars(its)["counterweights"] = (first, second._replace(moment=second.moment * (1 + 1e-9)))
    found = compare_balance(its, compare(its.linkage))
    assert "S'" in {one.name for one in found.findings if one.excess.max() > 1}
    assert replace(found, findings=()).agrees
