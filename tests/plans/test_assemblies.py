"""Assemblies: chosen once and kept; it is told where a mechanism may go on in two ways, or in none, or turns back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import hypot, pi

import numpy as np
import pytest

from geometry.precision import condition
from plans.analytic.ends import least, sharpness
from plans.analytic.kinematics import Analysis, solve
from plans.linkage.assembly import SketchError, assembly, meeting
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import Sweep, at_angles
from plans.linkage.travel import ExtremePositions
from plans.model.decomposition import decompose
from plans.model.mechanism import Mechanism, StructureError
from plans.scene.scene import parse_scene
from plans.study import Study
from tests import parts
from tests.plans import linkages
from tests.plans.digits import printed
from tests.plans.dynamics_scenes import text
from tests.plans.scenes import scene
from tests.plans.studies import driven, shown, study_of

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


@pytest.mark.parametrize(
    ("start", "tilt", "left"),
    [
        (0, 0, 0.02),
        (30, 0, 0.02),
        (180, 0, 0.02),
        (45, 0, 0.02),
        (0, 30, 0.02),
        (90, 30, 0.02),
        (0, 90, 0),
        (30, 90, 0),
    ],
)
def test_a_pin_in_a_slot_of_the_crank_and_on_a_guide_is_where_they_cross(start: int, tilt: int, left: float) -> None:
    """Nowhere where the crank goes along the guide, which no start is possible at, and not beyond."""
    told = scene(
        frame="O = [0, 0]", links="OA B B", lengths="OA = 0.1",
        slides=['link = 2; along = "OA"', f"link = 3; along = {{ through = [{left}, 0.3], angle = {tilt} }}"],
        drive=f"link = 1; speed = 5; start = {start}; positions = 12",
    )  # fmt: skip
    study = LinkageStudy(parse_scene(told))
    roads, parallel = (
        [solve(study.mechanism, study.turn.phi)],
        {k for k in range(12) if not (start + 30 * k - tilt) % 180},
    )
    if 0 in parallel:
        with pytest.raises(SketchError, match=r"no one place at the first position.*start from another crank angle"):
            study.motion()
    else:
        roads.append(study.motion())
    for motion in roads:
        lost = {gap.position: gap.reason for gap in motion.gaps}
        assert {k for k, reason in lost.items() if reason == "parallel guides"} == parallel
        assert len(lost) == 5 + len(parallel) + (start == 45)
        crank, guide = np.exp(1j * motion.phi), np.exp(1j * np.radians(tilt))
        for k in set(range(12)) - set(lost):
            crossing = crank[k] * ((left + 0.3j) / guide).imag / (crank[k] / guide).imag
            assert motion.points["B"].r[k] == pytest.approx(crossing, abs=1e-12)


@pytest.mark.parametrize("numbers", [(53, 40, 55, 21, 3), (5, 4, 3, 2, 1), (1, 2, 3, 4, 5)])
def test_a_hinge_of_three_links_is_where_the_sketch_has_it_however_they_are_numbered(numbers: tuple[int, ...]) -> None:
    """A slider-crank with a triangle on its rod: four assemblies. Sketched within 3 mm, by either road it is so."""
    crank, rod, stone, first, second = numbers
    told = scene(
        frame="O = [-0.059, -0.084]; A = [-0.14, -0.038]; B = [-0.16, -0.027]",
        links=f'{crank} = "OC"; {rod} = "CD"; {stone} = ["D"]; {first} = "EC"; {second} = "DE"',
        lengths="CO = 0.0078; DC = 0.061; CE = 0.031; DE = 0.052", slides=[f'link = {stone}; along = ["A", "B"]'],
        sketch="D = [-0.12, -0.051]; E = [-0.068, -0.046]",
        masses=f"{first} = {{ mass = 2, centre = [0.01, 0] }}; {second} = {{ mass = 3, centre = [0.02, 0] }}",
        loads="gravity = 9.81", drive=f"link = {crank}; speed = 1.1; positions = 4; start = 140",
    )  # fmt: skip
    study = Study.of_all(parse_scene(told))
    for by in ("construction", "analysis"):
        points = study.numbers("linkage", by).plain()["points"]
        C, D, E = (complex(*points[name]["r"][0]) for name in "CDE")
        assert abs(D + 0.12 + 0.051j) < 3e-3 > abs(E + 0.068 + 0.046j)
        assert (abs(C - D), abs(C - E), abs(D - E)) == pytest.approx((0.061, 0.031, 0.052), abs=1e-12)
    assert study.comparison("forces").agrees


@pytest.mark.parametrize("by", ["construction", "analysis"])
def test_numbers_of_two_assemblies_are_refused(monkeypatch: pytest.MonkeyPatch, by: str) -> None:
    def other(study: LinkageStudy) -> Analysis:
        return Analysis(replace(study.mechanism, sketch={"B": -0.3 + 0j}))

    monkeypatch.setattr("plans.linkage.quantities.road_of", other)
    with pytest.raises(SketchError, match=r"mechanism in two ways \(they differ in B\); show more points"):
        Study(parse_scene(text()), ["positions"]).numbers("linkage", by)
