"""Laws of motion on both roads: worked values of M2.2, tables and shapes by points, relations, shocks of M2.5."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.analytic.cam import laws as seams
from plans.analytic.cam.laws import limits, travel
from plans.cam.course import FollowerCourse, law_of
from plans.model.cam import DWELL, LAWS, RETURN, RISE, Cam, Law
from plans.model.cam_motion import Shock
from tests.parts import some
from tests.plans.digits import printed
from tests.plans.law_cams import BLOCKS, EVERY, LIFT, RISING, RULER, SMOOTH, SPEED, law_cam, usual

ROADS = ("construction", "analysis")
WORKED = {
    "constant velocity": (0.3, 1.0, 0.0),
    "constant acceleration": (0.18, 1.2, 4.0),
    "cosine": (0.2061073739, 1.270800923, 2.900603956),
    "sine": (0.1486346543, 1.309016994, 5.975664329),
    "3-4-5": (0.16308, 1.323, 5.04),
    "4-5-6-7": (0.126036, 1.29654, 7.4088),
    "trapezoid": (0.1538888889, 1.266666667, 5.333333333),
    "modified trapezoid": (0.1605903487, 1.244406188, 4.888123763),
    "modified sine": (0.1778877626, 1.322954207, 4.108072692),
}
LARGEST = {
    "constant acceleration": (2.0, 4.0),
    "cosine": (1.570796327, 4.934802201),
    "sine": (2.0, 6.283185307),
    "3-4-5": (1.875, 5.773502692),
    "4-5-6-7": (2.1875, 7.513188404),
    "trapezoid": (2.0, 5.333333333),
    "modified trapezoid": (2.0, 4.888123763),
    "modified sine": (1.759603386, 5.527957071),
}
JERKS = {
    "sine": 39.4784176,
    "3-4-5": 60.0,
    "4-5-6-7": 52.5,
    "trapezoid": 42.66666667,
    "modified trapezoid": 61.42597481,
    "modified sine": 69.46635729,
}
AGREED = 2e-14  # of the largest value; a ruler's points are solved for, on springs worse
SOLVED = {id(RULER): 1e-13, id(SMOOTH): 1e-11}


def share(law: Law, k: float, order: int, road: str, before: bool = False) -> float:
    if road == "analysis":
        return limits(law, k, order, before)
    return float(law_of(law).at(np.array([k]), order, before)[0])


def moved(cam: Cam, phi: np.ndarray, road: str, before: bool = False) -> np.ndarray:
    return np.array(travel(cam, phi, before) if road == "analysis" else FollowerCourse(cam).at(phi, before))


def shocks(cam: Cam, road: str) -> tuple[Shock, ...]:
    return seams.shocks(cam) if road == "analysis" else FollowerCourse(cam).shocks


def titled(law: Law) -> str:
    return f"{law.name}-{law.through}-{law.first}-{law.tolerance}"


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("name", LAWS)
def test_worked_values_at_three_tenths(name: str, road: str) -> None:
    """M2.2 of the digest: s, s', s'' at k = 0.3, and s(1) = 1, to all printed digits."""
    found = [share(Law(name), 0.3, order, road) for order in range(3)]
    assert printed(*found) == pytest.approx(WORKED[name], rel=1e-15)
    assert share(Law(name), 1.0, 0, road) == pytest.approx(1.0, abs=1e-15)


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("name", LARGEST)
def test_worked_maxima(name: str, road: str) -> None:
    """Of s' at mid-phase; of s'' where its slope vanishes, or along a flat."""
    where = {"3-4-5": (1 - 1 / math.sqrt(3)) / 2, "4-5-6-7": (1 - math.sqrt(0.2)) / 2, "cosine": 0.0, "sine": 0.25}
    at = where.get(name, {"modified sine": 0.125}.get(name, 0.25))
    assert printed(share(Law(name), 0.5, 1, road), share(Law(name), at, 2, road)) == pytest.approx(LARGEST[name])
    k = np.linspace(0, 1, 2001)
    law = law_of(Law(name))
    assert law.at(k, 1).max() <= LARGEST[name][0] + 1e-9 and np.abs(law.at(k, 2)).max() <= LARGEST[name][1] + 1e-9


@pytest.mark.parametrize("name", JERKS)
def test_worked_jerks(name: str) -> None:
    """The largest is at an end, at a joint or in the middle of the law."""
    law, joints = law_of(Law(name)), np.array([*law_of(Law(name)).starts, 0.5])
    found = max(np.abs(law.at(joints, 3, before)).max() for before in (False, True))
    assert found == pytest.approx(JERKS[name], rel=1e-9)


@pytest.mark.parametrize("slides", [False, True])
@pytest.mark.parametrize("law", EVERY, ids=titled)
def test_both_roads_give_one_motion(law: Law, slides: bool) -> None:
    cam = usual(law, translates=slides)
    joints = np.array(FollowerCourse(cam).joints)
    phi = np.linspace(0.0, cam.turn, 721)
    phi = np.concatenate([phi[np.abs(phi[:, None] - joints).min(axis=1) > 1e-9], joints])
    for before in (False, True):
        own, other = (moved(cam, phi, road, before) for road in ROADS)
        off = np.abs(own - other).max(axis=1) / np.maximum(np.abs(other).max(axis=1), 1e-300)
        assert off.max() <= SOLVED.get(id(law), AGREED)


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("law", some(EVERY, 3), ids=titled)
def test_a_return_is_a_rise_turned_over(law: Law, road: str) -> None:
    """S = h(1 - s) over the return: with the rise of the same law and angle the sum is the lift."""
    cam = law_cam((RISE, 110, law), (RETURN, 110, law), (DWELL, 140, None))
    phi = np.linspace(0.01, 1.9, 37)
    rise, back = (moved(cam, phi + start, road) for start in (0.0, cam.phases[1].start))
    assert rise[0] + back[0] == pytest.approx(np.full(37, LIFT), abs=1e-13)
    assert back[1:] == pytest.approx(-rise[1:], abs=1e-10)


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize(
    ("name", "orders", "sizes"),
    [
        ("constant velocity", (1, 1), (0.45, -0.45)),
        ("constant acceleration", (2, 2, 2), (27.0, -54.0, 27.0)),
        ("cosine", (2, 2), (33.30991485, 33.30991485)),
        ("sine", (), ()),
        ("3-4-5", (), ()),
        ("modified sine", (), ()),
    ],
)
def test_worked_shocks(name: str, orders: tuple[int, ...], sizes: tuple[float, ...], road: str) -> None:
    """M2.5: h = 0.03 m, 120 degrees, 300 rpm; m/s of a hard shock, m/s2 of a soft one."""
    cam = law_cam((RISE, 120, Law(name)), (DWELL, 120, None), (RETURN, 120, Law("sine")))
    found = shocks(cam, road)
    assert tuple(one.order for one in found) == orders
    assert printed(*(one.jump * SPEED**one.order for one in found)) == pytest.approx(sizes, rel=1e-12)
    assert [one.turned for one in found] == pytest.approx(np.linspace(0, RISING, len(found)).tolist())


@pytest.mark.parametrize("road", ROADS)
def test_worked_peaks(road: str) -> None:
    peak = moved(law_cam((RISE, 120, Law("sine")), (DWELL, 240, None)), np.array([RISING / 4]), road)[2, 0]
    assert printed(peak * SPEED**2) == (42.41150082,)
    fastest = moved(law_cam((RISE, 120, Law("cosine")), (DWELL, 240, None)), np.array([RISING / 2]), road)[1, 0]
    assert printed(fastest * SPEED) == (0.7068583471,)


@pytest.mark.parametrize("slides", [False, True])
@pytest.mark.parametrize("law", some(EVERY, 3), ids=titled)
def test_both_roads_find_the_same_shocks(law: Law, slides: bool) -> None:
    own, other = (shocks(usual(law, translates=slides), road) for road in ROADS)
    assert [(one.turned, one.order) for one in own] == [(one.turned, one.order) for one in other]
    assert [one.jump for one in own] == pytest.approx([one.jump for one in other], rel=1e-9)


@pytest.mark.parametrize("road", ROADS)
def test_a_shape_is_scaled_to_the_lift_and_stops(road: str) -> None:
    """Its areas cancel: 0.7 up, 0.7 down; between two points it is straight, at one share it jumps."""
    scale = share(BLOCKS, 0.2, 2, road) / 2
    assert share(BLOCKS, 1.0, 0, road) == pytest.approx(1.0)
    assert share(BLOCKS, 1.0, 1, road, before=True) == pytest.approx(0, abs=1e-14)
    expected = [1.0, 2.0, 2.0, -1.0, -2.0, -3.0]
    at = [(0.05, False), (0.4, True), (0.3, False), (0.4, False), (0.95, False), (1.0, True)]
    assert [share(BLOCKS, k, 2, road, before) / scale for k, before in at] == pytest.approx(expected)
    assert scale == pytest.approx(1 / 0.36)  # two integrations by hand
