"""Main sizes of cams: worked examples to the printed digits, both roads, mirrors, scales, limits that are kept."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.analytic.cam.laws import travel
from plans.analytic.cam.pressure import extreme, pressure
from plans.analytic.cam.sizes import sizes
from plans.cam.centre.place import Sizing
from plans.cam.centre.sizes import sizing
from plans.cam.course import Course
from plans.model.cam import FLAT, FORCE, NO_LIMITS, RETURN, RISE, ROCKING, Cam, Follower, GivenSizes, Limits
from plans.model.cam_motion import CamError, Sizes
from tests.parts import examples
from tests.plans.textbook_cams import LENGTH, LIFT, rocker, usual
from tests.plans.textbook_cams import cam as cam_of
from tests.rows import over

EXACT = 1e-13  # of the size: two roads, each a root and a few roundings of its own
BOTH = (1, -1)


def degrees(rise: float | None = None, back: float | None = None, curvature: float = 0.0) -> Limits:
    """Give limits in degrees, and m."""
    return Limits(*(None if one is None else math.radians(one) for one in (rise, back)), curvature)


def translating(sense: int = 1, **more: Any) -> Cam:
    return cam_of(sense=sense, **{"limits": degrees(30, 40), **more})


def rocking(sense: int = 1, turns: int = 1, **more: Any) -> Cam:
    return rocker(sense=sense, turns=turns, **{"limits": degrees(45, 45), **more})


def flat(sense: int = 1, **more: Any) -> Cam:
    return cam_of(end=FLAT, sense=sense, **{"limits": degrees(curvature=0.005), **more})


def flat_rocker(sense: int = 1, turns: int = 1, face: float = 0.005, swing: float = 15, **more: Any) -> Cam:
    follower = Follower(ROCKING, FLAT, 0.1, turns, face)
    return flat(sense, parts=usual(math.radians(swing)), follower=follower, **more)


def construction(cam: Cam) -> Sizing:
    return sizing(Course(cam))


def printed(value: float, digits: str) -> bool:
    """Tell whether a value is a printed number to all of its digits."""
    places = len(digits.partition(".")[2])
    return f"{value:.{places}f}" == digits or f"{value:.{places}f}" == digits + "0" * (places - len(digits))


def same(one: Sizes, other: Sizes, slack: float = EXACT) -> bool:
    return all(abs(a - b) <= slack for a, b in zip(one, other, strict=True))


def turned_at(sizing: Sizing, kind: str) -> float:
    """Give where the ruler of a phase touches, in degrees of that phase."""
    (found,) = (one.touch for one in sizing.tangents if one.touch.stretch.phase.kind == kind)
    return math.degrees(found.turned - found.stretch.phase.start)


# The numbers of the book's examples, each found with 30 digits in two ways.
def test_pressure_angle_of_a_given_cam() -> None:
    cam = translating(given=GivenSizes(0.05, 0.012))
    at = travel(cam, np.radians([50.0]))
    assert printed(float(at.s[0]), "0.01011267585") and printed(float(at.slope[0]), "0.02672884503")
    assert printed(math.degrees(pressure(cam, sizes(cam), np.radians([50.0]))[0]), "14.09692312")


@over("sense", BOTH)
def test_groove_by_two_tangents(sense: int) -> None:
    cam = translating(sense)
    found = construction(cam)
    own = found.sizes
    assert printed(own.base, "0.03266494437") and printed(own.offset, "0.002220357697")
    centre = complex(found.centre.point) if found.centre else 0
    assert printed(-sense * centre.real, "0.002220357697") and printed(-centre.imag, "0.03258939402")
    assert printed(turned_at(found, RISE), "52.7377369") and printed(turned_at(found, RETURN), "52.22304067")
    ends = [complex(one.point.point) for one in found.tangents]
    assert printed(-sense * ends[0].real, "0.02762475084") and printed(ends[0].imag, "0.01141230563")
    assert printed(sense * ends[1].real, "0.03398841416") and printed(ends[1].imag, "0.01056253993")
    assert same(own, sizes(cam))


@over("sense", BOTH)
def test_radial_follower(sense: int) -> None:
    cam = translating(sense, given=GivenSizes(offset=0.0))
    assert printed(construction(cam).sizes.base, "0.03643516636")
    assert same(construction(cam).sizes, sizes(cam))


@over("cam, most", [(translating(limits=NO_LIMITS), 30), (rocking(limits=NO_LIMITS), 45)])
def test_without_limits_those_of_the_book_are_kept(cam: Cam, most: int) -> None:
    """5.9.3: 30 degrees of a follower that translates, 45 of one that rocks."""
    for own in (construction(cam).sizes, sizes(cam)):
        assert abs(extreme(cam, own, RISE, 1).value - math.radians(most)) < 1e-12
        assert abs(extreme(cam, own, RETURN, -1).value + math.radians(most)) < 1e-12


def test_beside_a_loose_limit_the_other_alone_binds() -> None:
    """O is the foot of the perpendicular from A on the line S0 tan α + e = Q: R0 = Q cos α, Q by a dense look."""
    cam, limit = translating(limits=degrees(60, 80)), math.radians(60)
    at = travel(cam, np.linspace(0, cam.phases[0].angle, 20001))
    least = float((at.slope - at.s * math.tan(limit)).max()) * math.cos(limit)
    assert all(abs(own.base - least) < 1e-9 for own in (construction(cam).sizes, sizes(cam)))


@over("sense, offset", product(BOTH, (0.009, -0.004)))
def test_with_a_given_offset_one_limit_is_reached_and_the_other_kept(sense: int, offset: float) -> None:
    cam = translating(sense, given=GivenSizes(offset=offset))
    own = construction(cam).sizes
    assert own.offset == offset and held(cam, own)
    rise, back = extreme(cam, own, RISE, 1).value, -extreme(cam, own, RETURN, -1).value
    assert abs(max(rise / math.radians(30), back / math.radians(40)) - 1) < 1e-12


@over("sense", BOTH)
def test_force_closure_by_a_ray_through_the_start(sense: int) -> None:
    cam = translating(sense, closure=FORCE, limits=degrees(30))
    found = construction(cam)
    assert printed(found.sizes.base, "0.02103585311") and printed(found.sizes.offset, "0.01051792655")
    assert complex(found.tangents[1].point.point) == 0  # the second line goes through A
    assert same(found.sizes, sizes(cam))
    assert f"{math.degrees(extreme(cam, found.sizes, RETURN, -1).value):.4f}" == "-57.8345"


@over("sense", BOTH)
def test_rocker_by_a_limiting_line_of_each_position(sense: int) -> None:
    cam = rocking(sense)
    found = construction(cam)
    own = found.sizes
    assert printed(own.base, "0.03692159408") and printed(own.centre, "0.1363651929")
    assert printed(math.degrees(own.initial), "14.86559732")
    assert printed(-sense * own.pivot.real, "0.1211047752") and printed(own.pivot.imag, "0.06268252757")
    assert printed(turned_at(found, RISE), "42.66108814") and printed(turned_at(found, RETURN), "49.83080671")
    assert same(own, sizes(cam))
    assert printed(math.degrees(pressure(cam, own, np.radians([50.0]))[0]), "43.90567147")


def test_rocker_by_the_chord() -> None:
    found = construction(rocking()).chord
    assert found is not None
    centre = complex(found.centre.point)
    assert printed(centre.real, "0.1296025795") and printed(centre.imag, "-0.06170273191")
    start = LENGTH * np.exp(-1j * math.radians(12.5))
    assert printed(abs(centre - start), "0.03783596984") and printed(abs(centre), "0.1435411291")
    given_ = GivenSizes(base=abs(centre - start), centre=abs(centre))
    cam = rocking(given=given_)
    own = sizes(cam)
    assert printed(math.degrees(extreme(cam, own, RISE, 1).value), "50.9042332136")
    assert f"{math.degrees(extreme(cam, own, RETURN, -1).value):.4f}" == "-41.1389"


def test_points_of_the_rocker_diagram_by_both_senses() -> None:
    ends = []
    for sense in BOTH:
        cam = rocking(sense, sense, divisions=12)  # the rocker rises counter-clockwise in either
        found = construction(cam)
        assert found.end is not None
        ends.append(complex(np.asarray(found.end.point)[5]))  # 50 degrees of 120
    assert printed(ends[0].real, "0.07316413205") and printed(ends[0].imag, "-0.005209521395")
    assert printed(ends[1].real, "0.1662297838") and printed(ends[1].imag, "-0.01183609497")


@over("sense", BOTH)
def test_flat_face_by_convexity(sense: int) -> None:
    cam = flat(sense)
    found = construction(cam)
    assert printed(found.sizes.base, "0.04734155077")
    assert printed(turned_at(found, RETURN), "19.99470798")
    least = found.tangents[0].touch
    assert printed(-least.beyond, "-0.04234155077")
    assert same(found.sizes, sizes(cam))


# Both roads, whatever is given.
FREE, ALL = GivenSizes(), [GivenSizes(), GivenSizes(offset=0.0), GivenSizes(offset=0.009), GivenSizes(base=0.06)]
ROCKED = [GivenSizes(), GivenSizes(centre=0.14), GivenSizes(base=0.05), GivenSizes(base=0.05, centre=0.14)]
CASES = [
    *(translating(s, given=g) for s, g in product(BOTH, ALL)),
    *(translating(s, closure=FORCE, given=g) for s, g in product(BOTH, [*ALL, GivenSizes(offset=-0.004)])),
    *(translating(limits=one) for one in (NO_LIMITS, degrees(70, 60), degrees(20, 75), degrees(75, 20))),
    *(rocking(s, t, given=g) for s, t, g in product(BOTH, BOTH, ROCKED)),
    *(rocking(s, t, closure=FORCE, given=g) for s, t, g in product(BOTH, BOTH, ROCKED[:2])),
    *(rocking(limits=degrees(60, 60), turns=t) for t in BOTH),
    *(flat_rocker(s, t, f, given=GivenSizes(centre=0.12)) for s, t, f in product(BOTH, BOTH, (0.005, -0.01))),
    flat_rocker(given=GivenSizes(base=0.05, centre=0.12)),
    flat(given=GivenSizes(base=0.06)),
]


@over("cam", CASES[::5])
def test_both_roads_find_the_same_sizes(cam: Cam) -> None:
    assert same(construction(cam).sizes, sizes(cam))


LAWS = ("constant velocity", "constant acceleration", "cosine", "trapezoid", "modified trapezoid", "modified sine")


# What sizes must do, whoever found them.
def held(cam: Cam, own: Sizes) -> bool:
    """Tell whether a dense scan of the pressure angle keeps to the limits."""
    angles = pressure(cam, own, np.linspace(0, 2 * math.pi, 2001))
    return bool(
        angles.max() <= cam.limits.rise + 1e-12 and angles.min() >= -(cam.limits.back or cam.limits.rise) - 1e-12
    )


def test_the_least_radius_is_least_curvature_under_a_rocking_face() -> None:
    """The profile's radius of curvature by differences of its contact points reaches the least one, and no less."""
    for sense, turns in ((1, 1), (-1, -1)):
        cam = flat_rocker(sense, turns, given=GivenSizes(centre=0.12))
        own = sizes(cam)
        assert abs(_least_radius(cam, own) - 0.005) < 1e-6


def _least_radius(cam: Cam, own: Sizes) -> float:
    """Give the least p + p'' of the face's distance p over the angle of its normal in the cam, by differences."""
    turned = np.linspace(0, 2 * math.pi, 7201)
    s = travel(cam, turned).s
    lean = cam.rising * (s - cam.lift / 2)
    normal = 1j * np.exp(1j * lean)
    distance = cam.follower.face + (own.pivot * normal.conj()).real
    angle = lean - cam.sense * turned
    slope = np.gradient(distance, angle)
    return float((distance + np.gradient(slope, angle))[4:-4].min())


@given(
    st.floats(15, 60), st.floats(15, 60), st.floats(5, 45), st.sampled_from(BOTH), st.sampled_from(LAWS), st.booleans()
)
@examples(part=2)
def test_both_roads_over_random_rockers(
    rise: float, back: float, swing: float, turns: int, law: str, force: bool
) -> None:
    limits = degrees(rise, None if force else back)
    cam = rocking(1, turns, limits=limits, parts=usual(math.radians(swing), law))
    cam = replace(cam, closure=FORCE) if force else cam
    try:
        own = construction(cam).sizes
    except CamError as error:
        with pytest.raises(CamError, match="no centre"):
            sizes(cam)
        assert "no centre" in str(error)
        return
    assert same(own, sizes(cam), 1e-11 * max(1.0, own.base / LENGTH))


def steep(most: float) -> Limits:
    """Give limits, degrees, that hardly bound anything."""
    return Limits(math.radians(most), math.radians(most))


# What cannot be.
FAULTS = [
    ("no centre keeps", rocking(parts=usual(math.radians(200)))),
    ("smaller than the least radius", translating(given=GivenSizes(0.01, 0.012))),
    ("between 70 and 170 mm", rocking(given=GivenSizes(base=0.05, centre=0.34))),
    ("L = 40 mm", rocking(given=GivenSizes(centre=0.04))),
    ("sizes.centre", flat_rocker()),
    ("base below 125 mm", flat_rocker(given=GivenSizes(base=0.3, centre=0.12))),
    ("S' falls at once", flat(parts=usual(LIFT, "constant velocity"))),
    ("as fast as the cam", flat_rocker(swing=100, given=GivenSizes(centre=0.12))),
    ("the cam vanishes", translating(limits=steep(89.9))),
    ("the cam vanishes", translating(limits=steep(89))),
    ("the cam vanishes", rocking(limits=steep(89.9))),
    ("does not move", translating(parts=(usual(LIFT)[1]._replace(angle=2 * math.pi, start=0.0, level=0.0),))),
]


@over("said, cam", FAULTS)
def test_what_cannot_be_is_said_with_advice_by_both_roads(said: str, cam: Cam) -> None:
    for road in (construction, sizes):
        with pytest.raises(CamError, match="Fix: ") as error:
            road(cam)
        assert said in str(error.value)
        assert "Исправьте: " in error.value.message.worded("ru")


def test_a_cam_that_translates_has_no_sizes_but_may_be_too_short() -> None:
    rail = usual(LIFT)[0]._replace(angle=0.05, start=0.0)
    cam = replace(translating(), phases=(rail,), translates=True)
    found = construction(cam)
    steepest = 2 * LIFT / 0.05  # of the sine law
    assert found.sizes == sizes(cam) == Sizes(0.0)
    assert abs(found.longer - steepest / math.tan(math.radians(30))) < 1e-12
    assert abs(extreme(cam, Sizes(0.0), RISE, 1).value - math.atan(steepest)) < 1e-12
