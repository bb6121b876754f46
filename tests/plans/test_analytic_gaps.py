"""The analytic road's gaps, told and not guessed, and the assembly that the sketch chooses."""

from __future__ import annotations

import cmath
from dataclasses import replace
from math import hypot, pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.analytic.kinematics import conditions, solve
from plans.model.mechanism import Mechanism, StructureError
from plans.model.motion import Floats
from tests.parts import examples
from tests.plans import linkages

CRANK_ROCKER = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j})


EPS = float(np.finfo(float).eps)
TURN = np.arange(12) * (pi / 6)
# Where the mechanism stops


def gaps(mechanism: Mechanism, phi: Floats) -> dict[int, tuple[str, str]]:
    motion = solve(mechanism, phi)
    found = {gap.position: (gap.plan, gap.reason) for gap in motion.gaps}
    assert len(found) == len(motion.gaps)
    for name, point in motion.points.items():
        lost = [k for k, (plan, _) in found.items() if plan == "positions"]
        assert np.array_equal(np.flatnonzero(np.isnan(point.r)), lost), name
        assert np.array_equal(np.flatnonzero(np.isnan(point.v)), list(found)), name
    return found


def test_where_links_are_too_short_the_limit_is_told():
    mechanism = linkages.four_bar(0.1, 0.3, 0.145, 0.35, sketch={"B": 0.3 + 0.14j})
    (gap,) = solve(mechanism, TURN).gaps
    limit = np.degrees(np.arccos((0.1**2 + 0.35**2 - 0.445**2) / (2 * 0.1 * 0.35)))
    assert gap.phi == TURN[6]
    assert str(gap.where) in [f"the Jacobian loses rank near phi = {angle:g} deg" for angle in (limit, 360 - limit)]


def test_a_parallelogram_at_its_change_point_has_its_place():
    flat = solve(linkages.parallelogram(0.1, 0.3), TURN + pi / 6).points["B"].r[5]
    assert flat == pytest.approx(0.2, abs=100 * EPS**0.75)  # Taylor's remainder where the Jacobian is no help


def test_a_parallelogram_started_at_its_change_point():
    found = gaps(linkages.parallelogram(0.1, 0.3), TURN)
    assert found[0] == ("velocities", "change point")
    assert {found[k] for k in range(1, 12)} == {("positions", "beyond a change point")}


def test_limits_of_a_double_rocker():
    mechanism = linkages.four_bar(0.3, 0.2, 0.25, 0.4, sketch={"B": 0.45 + 0.25j})
    limit = float(np.arccos((0.3**2 + 0.4**2 - 0.45**2) / (2 * 0.3 * 0.4)))
    # 1e-12 rad inside still is assembled, 1e-6 outside is not
    found = gaps(mechanism, np.array([0.7, limit - 1e-12, limit + 1e-6, pi, -limit + 1e-12, -limit - 1e-6]))
    out = ("positions", "out of reach")
    assert found == {2: out, 3: out, 5: out}


# The assembly


@examples(3)
@given(
    share=st.floats(0, 0.6),
    way=st.floats(0, 2 * pi),
    phi=st.floats(0, 2 * pi),
    side=st.sampled_from((1, -1)),
)
def test_the_sketch_chooses_the_assembly(share, way, phi, side):
    a, b, c, d = 0.1, 0.4, 0.3, 0.35
    end = cmath.rect(a, phi)
    base = abs(d - end)
    along = (base**2 + b**2 - c**2) / (2 * base)
    up = sqrt(b**2 - along**2)
    exact = end + (d - end) / base * complex(along, side * up)
    mechanism = linkages.four_bar(a, b, c, d, sketch={"B": exact + cmath.rect(share * up, way)})
    assert solve(mechanism, np.array([phi]), 0).points["B"].r[0] == pytest.approx(exact, abs=16 * EPS)


def test_conditions_of_either_road_and_at_gaps():
    mechanism = linkages.four_bar(0.1, 0.3, 0.145, 0.35, sketch={"B": 0.3 + 0.14j})
    kappa = conditions(mechanism, solve(mechanism, TURN, 0))
    assert np.flatnonzero(np.isnan(kappa)).tolist() == [6]
    assert np.nanmin(kappa) >= 1 and np.nanmax(kappa) < 100


def test_one_drive_needs_mobility_one():
    frame = {"O": 0j, "C": 0.35 + 0j, "D": 0.5 + 0j}
    links = {**CRANK_ROCKER.links, 0: CRANK_ROCKER.links[0]._replace(points=frame)}
    links[4] = links[3]._replace(number=4, points={"D": 0j, "B": complex(hypot(0.2, 0.3))})
    with pytest.raises(StructureError):
        solve(replace(CRANK_ROCKER, links=links), TURN)
