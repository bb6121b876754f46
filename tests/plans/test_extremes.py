"""Extreme positions by notches, by the velocity plan and by analysis, and turns that start there (M1.2, M1.6, M1.7)."""

from __future__ import annotations

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis
from plans.linkage.study import NoExtreme
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


def test_extremes_of_the_crank_rocker():
    seen, plan = found(CRANK_ROCKER), found(CRANK_ROCKER).notched
    assert plan is not None
    assert printed(*(shown(plan, name) for name in ("B_1", "A_1", "B_2", "A_2"))) == (
        0.4035714286 + 0.2951780853j,
        0.08071428571 + 0.05903561706j,
        0.175 + 0.2436698586j,
        -0.05833333333 - 0.08122328621j,
    )
    extremes = seen.extremes
    assert printed(*np.degrees(extremes.phi)) == (36.18228722, 234.3146653)
    assert printed(np.degrees(extremes.overlap), np.degrees(extremes.stroke)) == (18.13237807, 45.97189532)
    assert printed(extremes.ratio, extremes.ratio / (1 + extremes.ratio)) == (1.224039593, 0.5503677169)
    assert not extremes.sliding


def test_extremes_of_the_slider_crank():
    extremes, plan = found(SLIDER_CRANK).extremes, found(SLIDER_CRANK).notched
    assert plan is not None
    assert printed(shown(plan, "B_1"), shown(plan, "B_2")) == (0.2592296279 + 0.02j, 0.1385640646 + 0.02j)
    assert printed(*extremes.reach, extremes.stroke) == (0.2592296279, 0.1385640646, 0.1206655633)
    assert printed(np.degrees(extremes.overlap), extremes.ratio) == (3.801484916, 1.043150022)
    assert printed(extremes.ratio / (1 + extremes.ratio)) == (0.5105596803,) and extremes.sliding


def test_extremes_of_the_slotted_link():
    extremes, plan = found(SLOTTED_LINK).extremes, found(SLOTTED_LINK).notched
    assert plan is not None
    ends = {shown(plan, "A_1"), shown(plan, "A_2")}
    assert set(printed(*ends)) == {-0.1127265067 - 0.04114285714j, 0.1127265067 - 0.04114285714j}
    assert printed(*(np.degrees(extremes.phi) - 360)) == (-20.05104257, -159.9489574)
    assert printed(np.degrees(extremes.stroke), np.degrees(extremes.overlap)) == (40.10208513, 40.10208513)
    assert printed(extremes.ratio, extremes.ratio / (1 + extremes.ratio)) == (1.573304973, 0.6113946809)
    work = (extremes.phi[1] - extremes.phi[0]) % (2 * np.pi)
    assert printed(np.degrees(work)) == (220.1020851,)


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


@pytest.mark.parametrize("omega", [10.0, -10.0], ids=["counter-clockwise", "clockwise"])
@pytest.mark.parametrize("name", ["crank-rocker", "slider-crank", "slotted link", "shaper"])
def test_a_turn_that_starts_at_an_extreme_stands_there(name, omega):
    mechanism = driven(ALL[name], omega, 0)
    study = study_of(mechanism, None, 12)
    motion, extremes = study.motion(1), found(mechanism).extremes
    assert not motion.gaps and motion.phi[0] == extremes.phi[0]
    assert np.allclose(np.diff(motion.phi), np.copysign(np.pi / 6, omega))
    speeds = motion.points["D"].v if name == "shaper" else motion.points["B"].v
    assert speeds is not None
    assert abs(speeds[0]) <= 1e-14 * np.abs(speeds).max()
    quarter = abs(speeds[3])  # the stroke that begins is the slow one
    assert quarter < abs(speeds[9])


@pytest.mark.parametrize(
    ("mechanism", "why"),
    [
        (linkages.slotted_link(0.30, 0.10, 0.50), "turns fully"),  # Whitworth's slotted link
        (linkages.four_bar(0.3, 0.2, 0.25, 0.4, sketch={"B": 0.45 + 0.25j}), "the crank does not"),  # it rocks
        (linkages.parallelogram(0.1, 0.3), "change point at B"),  # not past it without a choice
    ],
    ids=["Whitworth", "double rocker", "parallelogram"],
)
def test_an_output_without_extremes(mechanism, why):
    study = study_of(mechanism, None)
    assert study.extreme_positions is None
    with pytest.raises(NoExtreme, match=why):
        study.motion()
