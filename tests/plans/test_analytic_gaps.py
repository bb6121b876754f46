"""The analytic road's gaps, told and not guessed, and the assembly that the sketch chooses."""

from __future__ import annotations

from dataclasses import replace
from math import hypot, pi

import numpy as np
import pytest

from plans.analytic.kinematics import solve
from plans.model.mechanism import StructureError
from tests.plans import linkages

CRANK_ROCKER = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j})


EPS = float(np.finfo(float).eps)
TURN = np.arange(12) * (pi / 6)
# Where the mechanism stops


def test_a_parallelogram_at_its_change_point_has_its_place():
    flat = solve(linkages.parallelogram(0.1, 0.3), TURN + pi / 6).points["B"].r[5]
    assert flat == pytest.approx(0.2, abs=100 * EPS**0.75)  # Taylor's remainder where the Jacobian is no help


# The assembly


def test_one_drive_needs_mobility_one():
    frame = {"O": 0j, "C": 0.35 + 0j, "D": 0.5 + 0j}
    links = {**CRANK_ROCKER.links, 0: CRANK_ROCKER.links[0]._replace(points=frame)}
    links[4] = links[3]._replace(number=4, points={"D": 0j, "B": complex(hypot(0.2, 0.3))})
    with pytest.raises(StructureError):
        solve(replace(CRANK_ROCKER, links=links), TURN)
