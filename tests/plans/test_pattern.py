"""Plans that are followed from their pattern: the record and the numbers of plans that are drawn act by act."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
import pytest

from geometry.meet import EPS
from plans.linkage import study as studies
from plans.linkage.plan import CLOSE, RUN, heading
from plans.linkage.primary import even, listed
from plans.model.mechanism import Mechanism
from tests.plans import linkages
from tests.plans.studies import study_of

MECHANISMS = {
    "four-bar": linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, coupler={"S": 0.2 + 0.09j}),
    "slider-crank": linkages.slider_crank(0.06, 0.20, 0.02),
    "slotted link": linkages.slotted_link(0.12, 0.35, 0.70),
    "Scotch yoke": linkages.scotch_yoke(0.1),
    "shaper": linkages.shaper(),
}


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=MECHANISMS)
def test_many_positions_are_what_each_of_them_is(mechanism: Mechanism, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = study_of(mechanism, 0, 50).motion()
    monkeypatch.setattr(studies, "BLOCK", 16)
    for one, other in zip(whole.rows(), study_of(mechanism, 0, 50).motion().rows(), strict=True):
        assert other == pytest.approx(one, rel=0, abs=64 * EPS * float(np.abs(one).max()))


# Angles of positions close to each other


def turned(size: float, phi: Sequence[float] | np.ndarray) -> np.ndarray:
    return size * np.exp(1j * np.asarray(phi))


def error(phi: np.ndarray) -> float:
    """Give the largest error of the headings of vectors at some angles, against a double arctangent of each."""
    vectors = turned(0.3, phi)
    return float(np.abs(heading(vectors) - np.arctan2(vectors.imag, vectors.real)).max())


def test_headings_of_close_positions_are_those_of_each_one() -> None:
    count = 1000 * RUN
    assert error(np.linspace(-1.0, 2.0, count)) <= 2 * EPS
    assert error(CLOSE / RUN * np.arange(count)) <= 2 * EPS
    once_round = np.linspace(-3.0, 3.0 + np.pi, count)
    found = heading(turned(0.3, once_round))
    assert (found > -np.pi).all()
    assert (found <= np.pi).all()
    assert np.abs(np.exp(1j * found) - np.exp(1j * once_round)).max() <= 8 * EPS


def test_the_crank_is_told_by_its_own_angles() -> None:
    turn = listed([Fraction(k) for k in (0, 90, 180, 270, 450)])
    assert list(np.degrees(turn.headings)) == [0, 90, 180, -90, 90]
    assert list(turn.part([3, 1]).headings) == list(turn.headings[[3, 1]])
    assert list(np.degrees(even(Fraction(0), 4, -1).headings)) == [0, -90, 180, 90]


def test_headings_of_positions_in_any_order_are_measured_one_by_one() -> None:
    count = 400 * RUN
    anyhow = np.random.default_rng(5).uniform(-3, 3, count)
    assert error(anyhow) == 0
    anyhow[:RUN] = 1.0
    assert error(anyhow) == 0
    opposite = np.where(np.arange(count) % 2, 1.0, 1.0 - np.pi)
    assert error(opposite) == 0
