"""Extreme positions by notches, by the velocity plan and by analysis, and turns that start there (M1.2, M1.6, M1.7)."""

from __future__ import annotations

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis
from plans.linkage.travel import ExtremePositions
from plans.model.mechanism import Mechanism
from tests import parts
from tests.plans import linkages
from tests.plans.digits import printed
from tests.plans.studies import driven, shown, study_of

CRANK_ROCKER = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j})
SLIDER_CRANK = linkages.slider_crank(0.06, 0.20, 0.02)
SLOTTED_LINK = linkages.slotted_link(0.12, 0.35, 0.70)
AGREED = 1e-12  # of a radian or of a metre: the two roads
ALL = {
    "crank-rocker": CRANK_ROCKER,
    "crossed crank-rocker": linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.2 - 0.3j}),
    "long rocker": linkages.four_bar(0.1, 0.25, 0.45, 0.40, sketch={"B": 0.2 + 0.3j}),
    "slider-crank": SLIDER_CRANK,
    "offset below": linkages.slider_crank(0.06, 0.20, -0.05),
    "central slider-crank": linkages.slider_crank(0.1, 0.3),
    "slotted link": SLOTTED_LINK,
    "shaper": linkages.shaper(),
    "yoke": linkages.scotch_yoke(0.1),
}


def found(mechanism: Mechanism) -> ExtremePositions:
    extremes = study_of(mechanism, None).extreme_positions
    assert extremes is not None
    return extremes


def test_extremes_of_the_slider_crank():
    extremes, plan = found(SLIDER_CRANK).extremes, found(SLIDER_CRANK).notched
    assert plan is not None
    assert printed(shown(plan, "B_1"), shown(plan, "B_2")) == (0.2592296279 + 0.02j, 0.1385640646 + 0.02j)
    assert printed(*extremes.reach, extremes.stroke) == (0.2592296279, 0.1385640646, 0.1206655633)
    assert printed(np.degrees(extremes.overlap), extremes.ratio) == (3.801484916, 1.043150022)
    assert printed(extremes.ratio / (1 + extremes.ratio)) == (0.5105596803,) and extremes.sliding


@pytest.mark.parametrize("omega", [10.0, -10.0], ids=["counter-clockwise", "clockwise"])
@pytest.mark.part
@pytest.mark.parametrize("name", ALL if parts.whole else list(ALL)[::4])
def test_notches_and_analysis_agree(name, omega):
    mechanism = driven(ALL[name], omega, 0)
    study = study_of(mechanism, None)
    ours, theirs = found(mechanism).extremes, Analysis(mechanism).extremes(study.output)
    assert theirs is not None and ours.sliding == theirs.sliding
    assert ours.phi == pytest.approx(theirs.phi, abs=AGREED)
    assert ours.reach == pytest.approx(theirs.reach, abs=AGREED)
    assert (ours.overlap, ours.stroke) == pytest.approx((theirs.overlap, theirs.stroke), abs=AGREED)
    assert (found(mechanism).notched is None) == (name == "yoke")
