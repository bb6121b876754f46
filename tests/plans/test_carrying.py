"""Linkages that something carries through their change points: a locomotive's coupling rod, and what hangs on it."""

from __future__ import annotations

import numpy as np
import pytest

from drawings.commands.draw import draw
from plans.forces.quantities import compare_forces
from plans.forces.statics import Statics
from plans.linkage.quantities import MotionComparison, compare, compare_extremes
from plans.linkage.study import LinkageStudy
from plans.scene.scene import SceneError, parse_scene
from tests.parts import some
from tests.plans.scenes import scene

COUPLING_ROD = scene(
    mechanism="{through}",
    frame="O = [0, 0]; C = [1.6, 0]",
    links="OA AB CB",
    lengths="OA = 0.3; AB = 1.6; CB = 0.3",
    sketch="B = [1.75, 0.26]",
    drive="link = 1; speed = {speed}; start = {start}; positions = 12",
    masses='2 = {{ mass = 20, inertia = 3, centre = "middle" }}',
    loads="gravity = 9.81",
    moments=["on = 3; value = -50"],
)
CROSSED = COUPLING_ROD.replace("B = [1.75, 0.26]", "B = [1.5, -0.29]")
# A slider hung on the rod: its group follows the rod through the change points and must not fold itself.
WITH_SLIDER = (
    COUPLING_ROD.replace('3 = "CB"', '3 = "CB"\n4 = "BD"\n5 = "D"')
    .replace("CB = 0.3", "CB = 0.3\nBD = 0.9")
    .replace(
        "[mechanism.sketch]", "[[mechanism.slides]]\nlink = 5\nalong = {{ through = [0, 0.1] }}\n[mechanism.sketch]"
    )
    .replace("B = [1.75, 0.26]", "B = [1.75, 0.26]\nD = [2.6, 0.1]")
)


def study(text: str, through: str = 'through = "parallel"', speed: float = 20.0, start: float = 60.0) -> LinkageStudy:
    return LinkageStudy(parse_scene(text.format(through=through, speed=speed, start=start), "rod.toml"))


def compared(one: LinkageStudy) -> MotionComparison:
    comparison = compare_extremes(one, compare(one))
    assert comparison.agrees and not comparison.alone
    return comparison


@pytest.mark.parametrize("speed", some([20.0, -20.0], 2))
@pytest.mark.parametrize("through", ["parallel", "inertia"])
def test_a_coupling_rod_stays_parallel_to_the_frame_all_the_turn(through: str, speed: float) -> None:
    comparison = compared(study(COUPLING_ROD, f'through = "{through}"', speed))
    for motion in (comparison.construction, comparison.analysis):
        rod = motion.points["B"].r - motion.points["A"].r
        assert rod == pytest.approx(np.full(12, 1.6), abs=1e-8)  # half the digits at a change point itself
        flat = [4, 10] if speed > 0 else [2, 8]
        omega, known = motion.links[3].omega, [k for k in range(12) if k not in flat]
        assert omega is not None and omega[known] == pytest.approx(speed, rel=1e-9)
        assert [(gap.position, gap.plan, gap.reason) for gap in motion.gaps] == [
            (k, "velocities", "change point") for k in flat
        ]


def test_without_a_word_the_gap_is_told_with_what_to_write() -> None:
    comparison = compared(study(COUPLING_ROD, ""))
    beyond = [gap for gap in comparison.construction.gaps if gap.reason == "beyond a change point"]
    assert [gap.position for gap in beyond] == [5, 6, 7, 8, 9]
    assert all('through = "parallel"' in str(gap.advice) for gap in beyond)


@pytest.mark.rest
def test_an_antiparallelogram_goes_on_as_one() -> None:
    """Crossed, its cranks turn against each other, and their ends are as far apart as before."""
    comparison = compared(study(CROSSED))
    motion = comparison.construction
    a, b = motion.points["A"].r, motion.points["B"].r
    assert abs(b - a) == pytest.approx(1.6, abs=1e-8)
    omega = motion.links[3].omega
    known = [k for k in range(12) if k not in (4, 10)]
    assert omega is not None and (omega[known] < 0).all()
    assert abs((b - a).imag).max() > 0.1  # the rod leans


@pytest.mark.rest
def test_a_slider_on_the_rod_follows_it_through() -> None:
    comparison = compared(study(WITH_SLIDER))
    points = comparison.construction.points
    b = points["A"].r + 1.6
    slider = b.real + np.sqrt(0.9**2 - (b.imag - 0.1) ** 2)
    assert points["D"].r == pytest.approx(slider + 0.1j, abs=1e-8)
    assert [gap.position for gap in comparison.construction.gaps] == [4, 10]


def test_forces_of_a_rod_that_is_carried_through() -> None:
    """A coupling rod translates: its inertia force is that of a mass on the crank circle, and the shafts share it."""
    one = study(COUPLING_ROD)
    statics = Statics(one)
    comparison = compare_forces(statics, compared(one))
    assert comparison.agrees
    forces = statics.forces
    assert {gap.position: gap.reason for gap in forces.gaps if gap.plan == "forces"} == {
        4: "statically indeterminate",
        10: "statically indeterminate",
    }
    crank = np.exp(1j * np.radians(60 + 30 * np.arange(12)))
    both = forces.reactions["0-1"].force + forces.reactions["0-3"].force
    known = [k for k in range(12) if k not in (4, 10)]
    inertia = 20 * 20.0**2 * 0.3 * crank
    assert both[known] == pytest.approx((20 * 9.81j - inertia)[known], rel=1e-6)
    assert forces.balancing.moment[known] == pytest.approx((50 + 20 * 9.81 * 0.3 * crank.real)[known], rel=1e-6)


@pytest.mark.rest
def test_its_sheets_are_drawn_and_verified(tmp_path) -> None:
    scene = tmp_path / "rod.toml"
    text = COUPLING_ROD.format(through='through = "parallel"', speed=20, start=60)
    scene.write_text(f'title = "Coupling rod"\nsheets = ["kinematics", "forces"]\n{text}', encoding="utf-8")
    drawn = draw(scene, tmp_path / "out")
    assert len(drawn.sheets) >= 2
    assert "carried through" in (tmp_path / "out" / "rod-report.md").read_text(encoding="utf-8")


def test_nothing_else_carries_a_linkage() -> None:
    with pytest.raises(SceneError, match="through"):
        study(COUPLING_ROD, 'through = "magic"')
