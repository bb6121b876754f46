"""The profile of a cam by inversion: the textbook's values, and what holds of every profile."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.cam.course import FollowerCourse
from plans.cam.profile.contact import ProfileExtremes
from plans.cam.profile.profile import profile, roller_of
from plans.cam.profile.touch import Stretches
from plans.model.cam_motion import CamSizes
from tests.plans.digits import printed
from tests.plans.textbook_cams import FLAT_BASE, cam, offset_sizes, pivot, rocker

ROLLER = 0.01306597775


def at(own, sizes, *degrees, roller=0.0):
    return profile(FollowerCourse(own), sizes, roller, np.radians(degrees))


def test_textbook_pressure_and_sliding():
    """M2.6, (5.27), (5.28): R0 = 0.05, e = 0.012, 10 rad/s."""
    found = at(cam(), CamSizes(0.05, 0.012), 50, 0).contour
    assert printed(found.travel.s[0], found.travel.slope[0]) == (0.01011267585, 0.02672884503)
    assert printed(np.degrees(found.pressure[0]), 10 * found.sliding[0]) == (14.09692312, 0.6047244201)
    assert found.pressure[1] == pytest.approx(-math.atan(0.012 / math.sqrt(0.05**2 - 0.012**2)), abs=1e-15)


def test_textbook_rocker_pressure():
    """M2.9, the rocker of the exact method at 50 degrees, D of both senses from its pivot."""
    own = rocker()
    found = at(own, pivot(own), 50)
    assert printed(np.degrees(found.contour.pressure[0])) == (43.90567147,)
    pole = found.contour.lever[0] - pivot(own).pivot
    assert printed(pole) == (0.07316413205 - 0.005209521395j,)


def test_textbook_clockwise_rocker_lays_off_the_other_way():
    """M2.9: the cam clockwise, the rocker still rises counter-clockwise."""
    own = rocker(sense=-1, turns=-1)
    found = at(own, pivot(own), 50)
    assert printed(found.contour.lever[0] - pivot(own).pivot) == (0.1662297838 - 0.01183609497j,)


def test_textbook_flat_face():
    """M2.10: P and its radius at 50 degrees, the face to both sides."""
    own, sizes = cam(end="flat"), CamSizes(FLAT_BASE)
    found = at(own, sizes, 50).contour
    assert printed(found.profile[0], found.radius[0]) == (0.06119346145 + 0.0164553818j, 0.07894014394)
    extremes = ProfileExtremes(Stretches(FollowerCourse(own), sizes))
    low, high = extremes.face
    assert printed(high, -low) == (0.02864788976, 0.0358098622)
    assert extremes.sharpest is not None
    assert printed(extremes.sharpest.value, math.degrees(extremes.sharpest.turned) - 150) == (0.005, 19.99470798)


def test_textbook_pitch_profile_of_a_translating_follower():
    """M2.11, figure 5.53."""
    found = at(cam(), offset_sizes(), 0, 50, 190).contour
    assert printed(*found.pitch) == (
        0.002220357697 + 0.03258939402j,
        0.03413890175 + 0.02574746875j,
        -0.01098863786 - 0.04953313175j,
    )


def test_textbook_pitch_profile_of_a_rocker():
    """M2.12, figure 5.52: the pivot turned, the right notch of the ray OO1."""
    own = rocker()
    found = at(own, pivot(own), 50)
    board = found.drawing.board
    assert printed(board["O1'"].point[0]) == (-0.02982704704 + 0.1330631921j,)
    assert printed(found.contour.pitch[0]) == (0.04058382459 + 0.03589164715j,)
    assert board["P"].step.side[0] == -1


def test_textbook_radius_of_curvature():
    """M2.13, figure 5.54: the least radii with their places."""
    course, sizes = FollowerCourse(cam()), offset_sizes()
    stretches = Stretches(course, sizes)
    extremes = ProfileExtremes(stretches)
    least = extremes.sharpest
    assert least is not None
    assert printed(least.value, math.degrees(least.turned) - 150) == (0.02960986148, 18.93694533)
    rise = [one for one in extremes.bends if math.radians(80) < one.turned < math.radians(90)]
    (radius,) = at(course.cam, sizes, math.degrees(rise[0].turned)).contour.radius
    assert printed(radius, math.degrees(rise[0].turned)) == (0.03481075801, 85.04658571)


def test_textbook_roller():
    """M2.14: both rules, the working profile, its least radius, and a roller that undercuts."""
    own, sizes = cam(end="roller"), offset_sizes()
    extremes = ProfileExtremes(Stretches(FollowerCourse(own), sizes))
    assert extremes.sharpest is not None
    taken = roller_of(None, extremes.sharpest.value, sizes.base)
    assert taken.rule == "wear"
    assert printed(0.7 * extremes.sharpest.value, taken.radius) == (0.02072690303, ROLLER)
    found = at(own, sizes, 50, 49, 51, roller=taken.radius)
    assert printed(found.contour.profile[0]) == (0.02963865228 + 0.01348094808j,)
    assert printed(extremes.sharpest.value - taken.radius) == (0.01654388373,)
    assert printed(1 - 0.035 / extremes.sharpest.value) == (-0.1820386268,)
