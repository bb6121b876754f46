"""Balancing by both roads: every quantity of the textbook's machines agrees, and what differs is seen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from geometry.meet import EPS
from plans.analytic.balance import counterweights as by_vectors
from plans.balance.quantities import BalanceComparison, compare_balance
from plans.linkage.quantities import compare
from plans.model.balance.linkage import FULL, NONE, PARTIAL, REACTION, SECTOR, SHARE, BalanceTask, Site
from tests.parts import some
from tests.plans.balanced import ENGINE, FOUR_BAR, SHAPER, SIX_LINK, TWIN, asked, study

CASES = {
    "four-bar a": (FOUR_BAR, asked(FULL, Site(1, mass=9), Site(2, mass=6))),
    "four-bar b": (FOUR_BAR, asked(FULL, Site(3, radius=0.2), Site(1, mass=5))),
    "one of two": (FOUR_BAR, asked(FULL, Site(1, shape=SECTOR), Site(2, mass=6), Site(3, mass=8))),
    "as it is": (SIX_LINK, BalanceTask(NONE)),
    "engine in part": (ENGINE, asked(PARTIAL, Site(1, mass=2))),
    "engine in part by the rod": (ENGINE, asked(PARTIAL, Site(2, mass=10))),
    "two rods of which one carries": (TWIN, asked(PARTIAL, Site(4, mass=6), Site(2, mass=3))),
    "engine in full": (ENGINE, asked(FULL, Site(1, mass=28), Site(2, mass=16))),
    "engine in full by places": (ENGINE, asked(FULL, Site(1, at=-0.15), Site(2, at=-0.25))),
    "a share": (ENGINE, asked(SHARE, Site(1, radius=0.1), share=0.4)),
    "least force": (ENGINE, asked(SHARE, Site(1, mass=20))),
    "least reaction": (ENGINE, asked(SHARE, Site(1, shape=SECTOR), least=REACTION)),
    "shaper": (SHAPER, asked(FULL, Site(1, mass=6), Site(3, mass=160), Site(4, mass=30))),
    "shaper in part": (SHAPER, asked(PARTIAL, Site(3, mass=160), Site(1, shape=SECTOR))),
}
# Two roads of the main vector, each off by one rounding of the data, which the joints' condition kappa magnifies: both
# sum the forces of accelerations that they found by themselves, and are farthest apart where kappa is largest.
APART = 2 * EPS


def compared(text: str, task: BalanceTask) -> BalanceComparison:
    its = study(text, task)
    return compare_balance(its, compare(its.linkage))


@pytest.mark.parametrize("case", some(CASES, 2))
def test_both_roads_agree(case) -> None:
    found = compared(*CASES[case])
    assert [one.name for one in found.findings if one.excess.max() > 1] == []
    assert found.agrees
    for one in found.findings:
        if one.name.rstrip("'") in ("Φ", "ΣΦ", "ΣR_0"):
            assert np.nanmax(one.difference) <= APART * found.motion.kappa.max() * one.largest


@pytest.mark.parametrize("aim", [PARTIAL, SHARE])
def test_both_roads_give_up_on_a_mechanism_that_cannot_be_assembled(aim) -> None:
    """Its counterweights are known all the same: they ask for no position."""
    found = compared(ENGINE.replace("through = [0, 0]", "through = [0, 5]"), asked(aim, Site(1, mass=9)))
    assert found.agrees
    assert [one.moment for one in found.construction.counterweights] == [pytest.approx(-0.37)]


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


def test_of_a_massless_slider_no_share_is_better_than_none() -> None:
    """Both roads take the share 0 of a mass that is not there, and nothing shakes with it."""
    text = ENGINE.partition("2 = {{ mass")[0]
    found = compared(text, asked(SHARE, Site(1, mass=9)))
    assert found.agrees
    for road in (found.construction, found.analysis):
        assert road.shares is not None
        for best in (road.shares.least_force, road.shares.least_reaction):
            assert best.share == 0.0
            assert max(best.force, best.reaction) <= APART * found.motion.kappa.max() * road.before.shaking
