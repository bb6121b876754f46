"""The blocks of the equations, and how sharply each meets: the analysis' own view of what the textbook calls groups."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from geometry.precision import condition
from plans.analytic.ends import least, sharpness
from plans.analytic.kinematics import Analysis
from plans.linkage.assembly_limits import Sweep, at_angles
from plans.linkage.margin import meeting
from plans.linkage.sketch import assembly
from plans.model.dyad import decompose
from plans.model.mechanism import Mechanism
from tests.plans import linkages

FOUR_BAR = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j})
PHI = np.linspace(0.1, 6.2, 9)


@pytest.mark.parametrize("make", [lambda: FOUR_BAR, lambda: linkages.slider_crank(0.1, 0.3), linkages.shaper])
def test_a_block_is_as_sharp_as_the_notch_of_its_group(make: Callable[[], Mechanism]) -> None:
    """Two measures found in two ways: the sine of the crossing loci, and what a length out by one unit moves."""
    mechanism = make()
    groups = decompose(mechanism)
    chosen = assembly(mechanism, groups, at_angles(PHI[:1]), at_angles(PHI))
    plan = Sweep(mechanism, groups, chosen.sides).plan(PHI)
    road = Analysis(mechanism)
    poses = road.poses(road.motion(PHI, 0))
    for block, group in zip(road.shape.blocks[1:], groups, strict=True):
        notch = 1.0 / np.broadcast_to(condition(meeting(plan, group)), PHI.shape)
        assert sharpness(block, poses) == pytest.approx(notch, rel=1e-9)
    jacobian = road.constraints.jacobian(road.constraints.place(poses))
    assert (least(road.shape.blocks, jacobian, poses) > 0.01).all()
