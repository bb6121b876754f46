"""Positions in which a mechanism has no forces: said, and never a number beyond all bounds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene
from tests import parts
from tests.parts import first
from tests.plans.force_cases import compared
from tests.plans.scenes import scene

PARALLELOGRAM = scene(
    'title = "Parallelogram"; sheets = ["forces"]', frame="O = [0, 0]; C = [0.3, 0]", links="OA AB CB",
    lengths="OA = 0.1; AB = 0.3; CB = 0.1", sketch="B = [0.35, 0.087]",
    drive="link = 1; speed = 10; start = 60; positions = 12",
    masses='2 = { mass = 3, inertia = 0.01, centre = "middle" }', loads="gravity = 9.81",
)  # fmt: skip

# The pins A and C are 0.5 m apart where the crank stands at 90 degrees: rod and rocker, 0.2 and 0.3, lie in one line.
DEAD = scene(
    'title = "Dead centre"; sheets = ["forces"]', frame="O = [0, 0]; C = [0.4, 0]", links="OA AB CB",
    lengths="OA = 0.3; AB = 0.2; CB = 0.3", sketch="B = [0.34, 0.29]",
    drive="link = 1; speed = 1; positions = [60, 90]", points="S = { on = 2, at = [0.1, 0] }",
    forces=['on = 2; point = "S"; value = [0, -10]'],
)  # fmt: skip


def of(text: str) -> Statics:
    return Statics(LinkageStudy(parse_scene(text)))


def test_a_parallelogram_in_one_line_is_statically_indeterminate_and_says_so() -> None:
    """The rods share forces along their common line in any way; the equations leave one of them open."""
    statics = of(PARALLELOGRAM)
    found = statics.forces
    flat = [gap for gap in found.gaps if gap.plan == "forces"]
    assert [gap.position for gap in flat] == [4, 10]  # 180 and 360 degrees
    assert {gap.reason for gap in flat} == {"statically indeterminate"}
    assert all("share forces in many ways" in str(gap.advice) for gap in flat)
    assert np.isnan(found.balancing.moment[[4, 10]]).all()
    assert np.isfinite(found.balancing.moment[:4]).all()


def test_a_dead_centre_has_no_reactions_and_says_so() -> None:
    statics = of(DEAD)
    found = statics.forces
    (gap,) = (gap for gap in found.gaps if gap.plan == "forces")
    assert (gap.position, gap.reason) == (1, "dead centre")
    assert "beyond all bounds" in str(gap.advice)
    for reaction in found.reactions.values():
        assert np.isnan(reaction.force[1])
        assert np.isfinite(reaction.force[0])


@pytest.mark.parametrize("near", [1e-3, 1e-6])
def test_near_a_dead_centre_reactions_grow_as_kappa_and_both_roads_agree(near: float) -> None:
    """A static load: kappa is one over the angle between rod and rocker, the root of the crank's distance."""
    comparison = compared(DEAD.replace("[60, 90]", f"[60, {90 - near:.12g}]"))
    force = abs(comparison.construction.reactions["2-3"].force)
    assert 1e-3 < force[1] * np.sqrt(np.radians(near)) / force[0] < 1e3
    assert comparison.agrees


BESIDE = (1e-8, 1e-11, 1e-12, 2e-13, 1e-13, 1e-15, 0.0)


@pytest.mark.part
@pytest.mark.parametrize("near", first(BESIDE if parts.whole else BESIDE[::4]))
def test_right_beside_a_dead_centre_both_roads_tell_forces_or_name_the_same_gap(near: float) -> None:
    """Where the condition bears velocities, it bears forces: half of the digits are left at 1000 roundings beside."""
    comparison = compared(DEAD.replace("[60, 90]", f"[60, {float(90 - np.degrees(near))!r}]"))
    assert [
        {gap.position: gap.reason for gap in road.unanswered} for road in (comparison.construction, comparison.analysis)
    ] == 2 * [{1: "dead centre"} if near < 1000 * np.finfo(float).eps else {}]
    assert comparison.agrees


def test_what_both_roads_give_up_is_counted_and_what_one_gives_up_alone_is_a_disagreement() -> None:
    comparison = compared(PARALLELOGRAM)
    assert comparison.agrees
    assert comparison.left_out["forces"] == [4, 10]
    theirs = comparison.analysis
    others = tuple(gap for gap in theirs.gaps if gap.position != 4)
    for told in (others, (*others, theirs.gaps[0]._replace(position=4, plan="forces", reason="dead centre"))):
        apart = replace(comparison, analysis=replace(theirs, gaps=told))
        assert {(gap.position, gap.plan) for _, gap in apart.alone} == {(4, "forces")}
        assert not apart.agrees


# Machines on which little acts

SLOTTED = scene(
    'title = "Unloaded slotted link"; sheets = ["forces"]', frame="O = [0, 0]; B = [0.4, -0.19]",
    links="OA A BC", lengths="OA = 0.1; BC = 0.28", slides=['link = 2; along = "BC"; offset = 0.2'],
    sketch="C = [0.2, 0.0]", drive="link = 1; speed = 10; positions = 12",
    forces=['on = 2; point = "A"; value = [30, 40]'],
)  # fmt: skip

YOKE = scene(
    'title = "A couple alone"; sheets = ["forces"]', frame="O = [0, 0]", links="OA A BC",
    lengths="OA = 0.06; BC = 0.16",
    slides=['link = 2; along = "BC"', "link = 3; along = { through = [0, -0.08], angle = 0 }; angle = 90"],
    sketch="B = [0.06, -0.08]", drive="link = 1; speed = 10; positions = 12", moments=["on = 3; value = 5"],
)  # fmt: skip


def test_a_slide_that_bears_a_moment_alone_has_no_arm_and_one_that_bears_nothing_none() -> None:
    """A yoke twisted in its guide: the guide answers with a couple, and the stone is not pressed at all."""
    found = of(YOKE).forces
    assert found.reactions["0-3"].moment == pytest.approx(np.full(12, -5.0))
    arms = found.arm("0-3")
    assert arms is not None
    assert np.isnan(arms).all()
    stone = found.arm("2-3")
    assert stone is not None
    assert (stone == 0).all()
    assert abs(found.balancing.moment).max() <= found.nothing[1]


def test_what_is_but_rounding_is_no_force_beside_the_largest() -> None:
    force, moment = of(SLOTTED).forces.nothing
    assert force == pytest.approx(5e-8, rel=0.5)  # 1e-9 of some 50 N
    assert 0 < moment < force
