"""The blocks of the equations, and how sharply each meets: the analysis' own view of what the textbook calls groups."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from geometry.precision import condition
from plans.analytic.blocks import triangular
from plans.analytic.ends import least, sharpness
from plans.analytic.kinematics import Analysis
from plans.analytic.points import Constraints
from plans.linkage.assembly_limits import Sweep, at_angles
from plans.linkage.margin import meeting
from plans.linkage.sketch import assembly
from plans.model.dyad import decompose
from plans.model.mechanism import Mechanism
from tests.plans import linkages

FOUR_BAR = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j})
PHI = np.linspace(0.1, 6.2, 9)


@pytest.mark.parametrize(
    ("mechanism", "links"),
    [
        (FOUR_BAR, [[1], [2, 3]]),
        (linkages.slider_crank(0.1, 0.3), [[1], [2, 3]]),
        (linkages.shaper(), [[1], [2, 3], [4, 5]]),
    ],
)
def test_the_equations_fall_into_the_crank_and_its_groups(mechanism: Mechanism, links: list[list[int]]) -> None:
    """Nobody told the analysis of structural groups: which link rests on which is in the equations."""
    constraints = Constraints.of(mechanism)
    blocks = triangular(constraints)
    assert [[constraints.numbers[place] for place in block.links] for block in blocks] == links
    rows = np.sort(np.concatenate([block.rows for block in blocks]))
    assert rows.tolist() == list(range(len(constraints.pattern)))


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


@pytest.mark.parametrize("beside", [1e-3, 1e-6, 1e-9])
def test_towards_a_dead_centre_the_sharpness_falls_as_the_root_of_the_angle(beside: float) -> None:
    mechanism = linkages.four_bar(0.3, 0.2, 0.25, 0.4, sketch={"B": 0.45 + 0.25j})
    limit = float(np.arccos((0.3**2 + 0.4**2 - 0.45**2) / (2 * 0.3 * 0.4)))
    road = Analysis(mechanism)
    poses = road.poses(road.motion(np.array([0.7, limit - beside]), 0))
    sharp = sharpness(road.shape.blocks[1], poses)[1]
    # Heron: sin(B) between 0.2 and 0.25 where the third side is short of 0.45 by its rate times the angle.
    rate = 0.3 * 0.4 * np.sin(limit) / 0.45
    assert sharp == pytest.approx(np.sqrt(2 * rate * beside * 0.45 / (0.2 * 0.25)), rel=2e-2 if beside > 1e-4 else 1e-3)


def test_a_dead_centre_is_found_to_rounding() -> None:
    """3, 4 and 5 make a right angle: the crank of 0.3 on a frame of 0.4 is stretched at exactly 90 degrees."""
    mechanism = linkages.four_bar(0.3, 0.2, 0.3, 0.4, sketch={"B": 0.15 + 0.2j})
    road = Analysis(mechanism)
    road.motion(np.array([1.4, 1.6]), 0)
    turn = road._turn
    assert turn is not None and turn.upper is not None
    assert turn.upper.reason == "dead centre"
    assert turn.upper.singular == pytest.approx(np.pi / 2, abs=8 * np.finfo(float).eps)
