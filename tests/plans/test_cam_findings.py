"""Extremes, flaws and forces of a cam: both roads find the same, and what is wrong is told from where to where."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import pytest

from plans.analytic.cam.findings import cam_found as analysed
from plans.cam.course import FollowerCourse, positions
from plans.cam.profile.findings import cam_found
from plans.model.cam import FORCE, RETURN, RISE, FollowerLoad, Limits
from plans.model.cam_motion import CamFound, CamSizes, Extreme
from tests.parts import some
from tests.plans.textbook_cams import FLAT_BASE, LIFT, START, cam, offset_sizes, phases, pivot, rocker

FACE = complex(0.1, -0.2)  # far enough aside for the pivot to stand clear of the cam
STEADY = (RISE, 120, LIFT, "constant velocity"), ("dwell", 30, 0.0, ""), (RETURN, 90, -LIFT, "cosine")
LOAD = FollowerLoad(2.0, 100.0, 50.0, 2000.0)
ALL = {
    "groove": (cam(end="roller"), offset_sizes()),
    "clockwise": (cam(end="roller", sense=-1), offset_sizes(-0.012, START)),
    "undercut everywhere": (cam(end="roller", roller=0.035), offset_sizes()),
    "undercut once": (cam(end="roller", roller=0.0301, closure=FORCE), offset_sizes()),
    "corner": (cam(phases(*STEADY), end="roller", roller=0.01), offset_sizes()),
    "corners of acceleration": (
        cam(phases((RISE, 90, LIFT, "modified trapezoid"), (RETURN, 120, -LIFT, "constant acceleration"))),
        offset_sizes(0.01, 0.03),
    ),
    "limits": (cam(end="roller", roller=0.01, limits=Limits(0.4, 0.3)), offset_sizes()),
    "loaded": (cam(end="roller", roller=0.01, closure=FORCE, speed=60.0, load=LOAD), offset_sizes()),
    "rocker": (rocker("roller"), pivot(rocker())),
    "rocker loaded": (
        rocker("roller", roller=0.01, closure=FORCE, speed=20.0, load=FollowerLoad(0.02, 3.0, 1.0, 2.0)),
        pivot(rocker()),
    ),
    "rocker against": (rocker("roller", -1, -1), pivot(rocker("roller", -1, -1), complex(0.12, -0.07))),
    "rocker undercut": (rocker("roller", roller=0.04, closure=FORCE), pivot(rocker())),
    "hollow": (rocker("roller", roller=0.019), pivot(rocker())),
    "flat": (cam(end="flat", closure=FORCE), CamSizes(FLAT_BASE)),
    "flat hollow": (cam(end="flat", sense=-1, closure=FORCE), CamSizes(0.03)),
    "flat rocker": (rocker("flat", face=0.005, closure=FORCE), pivot(rocker("flat"), FACE)),
    "flat rocker hollow": (rocker("flat", face=0.005, closure=FORCE), pivot(rocker("flat"), complex(0.12, -0.2))),
    "flat rocker loaded": (
        rocker("flat", -1, face=0.004, closure=FORCE, speed=20.0, load=FollowerLoad(0.01, 2.0, 1.0, 3.0)),
        pivot(rocker("flat", -1), FACE),
    ),
}


@cache
def draw(own, sizes) -> CamFound:
    return cam_found(FollowerCourse(own), sizes, positions(own))


@cache
def analyse(own, sizes) -> CamFound:
    return analysed(own, sizes, positions(own))


BOTH = pytest.mark.parametrize("road", [draw, analyse])
# The everyday run asks the construction; that the analysis finds the same has a test of its own.
ROADS = pytest.mark.parametrize("road", some([draw, analyse], 2))


def near(one: Extreme | None, other: Extreme | None, place: float) -> bool:
    """Tell whether two extremes are one: to 1e-12 of the value, and to where roundings leave the place."""
    if one is None or other is None:
        return one is other
    return math.isclose(one.value, other.value, rel_tol=1e-12, abs_tol=1e-14) and abs(one.turned - other.turned) < place


@pytest.mark.parametrize("name", some(list(ALL), 3))
def test_both_roads_find_the_same(name):
    one, other = draw(*ALL[name]), analyse(*ALL[name])
    assert (one.rule, one.pressure.keys()) == (other.rule, other.pressure.keys())
    assert one.roller == pytest.approx(other.roller, rel=1e-12)
    assert all(near(one.pressure[kind], other.pressure[kind], 1e-10) for kind in one.pressure)
    assert near(one.sharpest, other.sharpest, 1e-10) and near(one.hollow, other.hollow, 1e-10)
    assert one.face == pytest.approx(other.face, rel=1e-13, abs=1e-16)
    assert [flaw.kind for flaw in one.flaws] == [flaw.kind for flaw in other.flaws]
    for first, second in zip(one.flaws, other.flaws, strict=True):
        assert (first.start, first.end) == pytest.approx((second.start, second.end), abs=1e-10)
        assert first.worst.value == pytest.approx(second.worst.value, rel=1e-9, abs=1e-12)
    assert (one.pressing is None) == (other.pressing is None)
    if one.pressing and other.pressing:
        assert all(near(a, b, 1e-9) for a, b in zip(one.pressing[:3], other.pressing[:3], strict=True))
        assert one.pressing.preload == pytest.approx(other.pressing.preload, rel=1e-13)


@BOTH
def test_textbook_extremes_of_the_pressure_angle(road):
    """M2.7 and M2.9: the limits are just reached, where the tangents touch."""
    found = road(*ALL["groove"]).pressure
    assert [round(math.degrees(found[kind].value), 10) for kind in (RISE, RETURN)] == [30.0, -40.0]
    places = [math.degrees(found[kind].turned) for kind in (RISE, RETURN)]
    assert places == pytest.approx([52.7377369, 150 + 52.22304067], abs=5e-9)
    found = road(*ALL["rocker"]).pressure
    assert [round(math.degrees(found[kind].value), 10) for kind in (RISE, RETURN)] == [45.0, -45.0]
    places = [math.degrees(found[kind].turned) for kind in (RISE, RETURN)]
    assert places == pytest.approx([42.66108814, 150 + 49.83080671], abs=5e-9)


@BOTH
def test_textbook_least_radius_and_roller(road):
    """M2.13, M2.14."""
    found = road(*ALL["groove"])
    assert found.sharpest is not None
    assert found.sharpest.value == pytest.approx(0.02960986148, abs=5e-12)
    assert math.degrees(found.sharpest.turned) - 150 == pytest.approx(18.93694533, abs=5e-9)
    assert found.roller == pytest.approx(0.01306597775, abs=5e-12) and found.rule == "wear"
    assert found.flaws == ()


@BOTH
def test_textbook_undercut(road):
    """M2.14: a roller of 35 mm undercuts; every sharp part is told with its least radius, the dwell's over the turn."""
    flaws = road(*ALL["undercut everywhere"]).flaws
    worst = [one.worst.value for one in flaws if one.kind == "undercut"]
    assert worst == pytest.approx([0.03481075801, 0.02960986148, 0.03266494437], abs=5e-12)
    last = [one for one in flaws if one.kind == "undercut"][-1]
    assert last.start > last.end


@ROADS
def test_a_roller_as_large_as_the_least_radius_leaves_a_cusp(road):
    own, sizes = ALL["groove"]
    least = draw(own, sizes).sharpest
    assert least is not None
    (cusp,) = road(replace(own, roller=least.value, closure=FORCE), sizes).flaws
    assert (cusp.kind, cusp.start, cusp.end) == ("undercut", cusp.end, cusp.start)
    assert cusp.worst.value == pytest.approx(least.value)
    assert road(replace(own, roller=0.999 * least.value, closure=FORCE), sizes).flaws == ()


@ROADS
def test_the_outer_side_of_a_groove_is_undercut_in_a_hollow(road):
    own, sizes = ALL["hollow"]
    (flaw,) = (one for one in road(own, sizes).flaws if one.kind == "hollow")
    assert -0.019 < flaw.worst.value < 0
    assert not road(replace(own, closure=FORCE), sizes).flaws


@BOTH
def test_what_would_mend_a_pressure_angle_leaves_the_offset_as_it_is(road):
    limits, offset = Limits(math.radians(30), math.radians(40)), 0.03
    least = road(cam(limits=limits), offset_sizes(offset, 0.02)).mending
    most = road(cam(), CamSizes(least, offset)).pressure
    assert max(abs(most[kind].value) / limits.of(kind) for kind in most) == pytest.approx(1, abs=1e-12)


@ROADS
def test_what_would_make_the_profile_under_a_flat_face_convex(road):
    """With that R0 the least radius is just the one asked for: R0 is added to it everywhere (M2.12)."""
    own = replace(ALL["flat hollow"][0], limits=Limits(curvature=0.004))
    mending = road(own, CamSizes(0.03)).mending
    assert road(own, CamSizes(mending)).sharpest.value == pytest.approx(0.004, abs=1e-15)
    assert {one.kind for one in road(own, CamSizes(mending * 0.999)).flaws} == {"sharp"}
    assert road(cam(phases(*STEADY), end="flat", closure=FORCE), CamSizes(0.2)).mending is None
