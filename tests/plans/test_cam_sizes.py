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

from plans.analytic.cam.contour import ContourValues
from plans.analytic.cam.extremes import WholeTurn
from plans.analytic.cam.sizes import sizes
from plans.cam.centre.place import Sizing
from plans.cam.centre.sizes import sizing
from plans.cam.course import FollowerCourse
from plans.model.cam import FLAT, FORCE, NO_LIMITS, RETURN, RISE, ROCKING, Cam, Follower, GivenSizes, Limits
from plans.model.cam_motion import CamError, CamSizes
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
    return sizing(FollowerCourse(cam))


def printed(value: float, digits: str) -> bool:
    """Tell whether a value is a printed number to all of its digits."""
    places = len(digits.partition(".")[2])
    return f"{value:.{places}f}" == digits or f"{value:.{places}f}" == digits + "0" * (places - len(digits))


def same(one: CamSizes, other: CamSizes, slack: float = EXACT) -> bool:
    return all(abs(a - b) <= slack for a, b in zip(one, other, strict=True))


def extreme(cam: Cam, own: CamSizes, kind: str, sign: int) -> float:
    """Give the greatest (sign +1) or the least pressure angle on a kind of phase, rad."""
    found = WholeTurn(cam, own, (kind,)).most(lambda curve: sign * curve.pressure)
    assert found is not None
    return sign * found.value


def turned_at(sizing: Sizing, kind: str) -> float:
    """Give where the ruler of a phase touches, in degrees of that phase."""
    (found,) = (one.touch for one in sizing.tangents if one.touch.stretch.phase.kind == kind)
    return math.degrees(found.turned - found.stretch.phase.start)


@over("cam, most", [(translating(limits=NO_LIMITS), 30), (rocking(limits=NO_LIMITS), 45)])
def test_without_limits_those_of_the_book_are_kept(cam: Cam, most: int) -> None:
    """5.9.3: 30 degrees of a follower that translates, 45 of one that rocks."""
    for own in (construction(cam).sizes, sizes(cam)):
        assert abs(extreme(cam, own, RISE, 1) - math.radians(most)) < 1e-12
        assert abs(extreme(cam, own, RETURN, -1) + math.radians(most)) < 1e-12


@over("sense, offset", product(BOTH, (0.009, -0.004)))
def test_with_a_given_offset_one_limit_is_reached_and_the_other_kept(sense: int, offset: float) -> None:
    cam = translating(sense, given=GivenSizes(offset=offset))
    own = construction(cam).sizes
    assert own.offset == offset and held(cam, own)
    rise, back = extreme(cam, own, RISE, 1), -extreme(cam, own, RETURN, -1)
    assert abs(max(rise / math.radians(30), back / math.radians(40)) - 1) < 1e-12


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
    assert printed(math.degrees(extreme(cam, own, RISE, 1)), "50.9042332136")
    assert f"{math.degrees(extreme(cam, own, RETURN, -1)):.4f}" == "-41.1389"


@over("sense", BOTH)
def test_flat_face_by_convexity(sense: int) -> None:
    cam = flat(sense)
    found = construction(cam)
    assert printed(found.sizes.base, "0.04734155077")
    assert printed(turned_at(found, RETURN), "19.99470798")
    least = found.tangents[0].touch
    assert printed(-least.beyond * math.sqrt(2), "-0.04234155077")  # along the axis, not square to the ruler
    assert same(found.sizes, sizes(cam))


# Both roads, whatever is given.
ALL = [GivenSizes(), GivenSizes(offset=0.0), GivenSizes(offset=0.009), GivenSizes(base=0.06)]
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


CLOSED = [(1, "groove", 0.06), (-1, "groove", 0.1), (-1, FORCE, 0.06)]


@over("cam", CASES[::5])
def test_both_roads_find_the_same_sizes(cam: Cam) -> None:
    assert same(construction(cam).sizes, sizes(cam))


EASED = [
    *(make(s, closure=c, given=GivenSizes(b)) for make in (translating, rocking) for s, c, b in CLOSED),
    rocking(turns=-1, limits=degrees(50, 30), given=GivenSizes(0.06)),
]


@over("cam", EASED)
def test_no_neighbour_at_a_given_radius_asks_for_less_of_the_limits(cam: Cam) -> None:
    own = sizes(cam)
    beside = (GivenSizes(own.base, own.offset + off, own.centre + off) for off in (0.0, -1e-4, 1e-4))
    chosen, *others = (share(cam, sizes(replace(cam, given=one))) for one in beside)
    assert chosen < min(*others, 1.0)


def share(cam: Cam, own: CamSizes) -> float:
    """Give the largest pressure angle of a dense scan, in shares of its limit; under a spring that of the rise."""
    turned = np.linspace(0, cam.phases[0].end if cam.closure == FORCE else 2 * math.pi, 2001)
    angles = ContourValues(cam, own, turned).pressure
    most = cam.limits.rise or math.nan
    return float(max(angles.max() / most, -angles.min() / (most if cam.closure == FORCE else cam.limits.back or most)))


LAWS = ("constant velocity", "constant acceleration", "cosine", "trapezoid", "modified trapezoid", "modified sine")


# What sizes must do, whoever found them.
def held(cam: Cam, own: CamSizes) -> bool:
    """Tell whether a dense scan of the pressure angle keeps to the limits."""
    angles = ContourValues(cam, own, np.linspace(0, 2 * math.pi, 2001)).pressure
    return bool(
        angles.max() <= cam.limits.rise + 1e-12 and angles.min() >= -(cam.limits.back or cam.limits.rise) - 1e-12
    )


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
