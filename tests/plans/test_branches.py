"""The assembly is chosen once and kept; where the mechanism may go on in two ways, or in none, it is told."""

from __future__ import annotations

import numpy as np

from plans.analytic.kinematics import solve
from plans.model.mechanism import Mechanism
from tests.plans import linkages
from tests.plans.studies import study_of

CHANGE, BEYOND = "change point", "beyond a change point"
KITE = linkages.four_bar(0.2, 0.3, 0.3, 0.2, sketch={"B": 0.3 + 0.2j})
RHOMBUS = linkages.four_bar(0.2, 0.2, 0.2, 0.2, sketch={"B": 0.3 + 0.2j})


def gaps(mechanism: Mechanism, first: int = 0) -> dict[int, tuple[str, str]]:
    """Tell the gaps of a turn, the same by both roads; what has no value must be told, and what is told has none."""
    drawn = study_of(mechanism, first).motion()
    assert all(gap.advice for gap in drawn.gaps)
    told = []
    for motion in (drawn, solve(mechanism, drawn.phi)):
        found = {gap.position: (gap.plan, gap.reason) for gap in motion.gaps}
        assert len(found) == len(motion.gaps)
        lost = [k for k, (plan, _) in found.items() if plan == "positions"]
        for name, point in motion.points.items():
            assert np.flatnonzero(np.isnan(point.r)).tolist() == lost, name
            assert np.flatnonzero(np.isnan(point.v)).tolist() == list(found), name
            assert np.flatnonzero(np.isnan(point.a)).tolist() == list(found), name
        told.append(found)
    alone = study_of(mechanism, first).motion(0)
    assert [gap.position for gap in alone.gaps] == lost
    assert told[0] == told[1]
    return told[0]


AT_CHANGE, PAST = ("velocities", CHANGE), ("positions", BEYOND)
NOWHERE, AWAY = ("positions", "dead centre"), ("positions", "not reachable")
PARALLEL = ("positions", "parallel guides")


def test_pins_that_fall_into_one_leave_no_place():
    """The kite and the rhombus with A on C: AB may point anywhere. The crank comes there, but no further."""
    assert gaps(KITE, 30) == {11: NOWHERE}
    assert gaps(RHOMBUS, 30) == {5: AT_CHANGE, **dict.fromkeys(range(6, 11), PAST), 11: NOWHERE}


def test_guides_that_fall_parallel():
    """The tangent mechanism at 90 degrees: its pin runs to infinity, and comes back from the other end."""
    assert gaps(linkages.tangent_mechanism(0.15)) == {3: PARALLEL, 9: PARALLEL, **dict.fromkeys(range(4, 9), AWAY)}


def test_a_short_rod_stays_on_its_own_side() -> None:
    """Rod half as long as the crank: dead centres at 30, 150, 210, 330 degrees; the far ones are not limits of ours."""
    mechanism = linkages.slider_crank(1.0, 0.5)
    found = gaps(mechanism, 0)
    assert found[1] == ("velocities", "dead centre")
    assert found[5][0] == found[7][0] == "positions"
