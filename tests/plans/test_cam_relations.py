"""What must hold of any cam: mirror, scale, phase shift, reversal; the envelope in 50 digits; the record replayed."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from geometry.meet import EPS
from geometry.precision import errors
from geometry.replay import exact
from plans.analytic.cam.contour import contour
from plans.analytic.cam.findings import cam_found as analysed
from plans.cam.course import FollowerCourse, positions
from plans.cam.profile.findings import cam_found
from plans.cam.profile.profile import profile
from plans.cam.profile.resting import resting
from plans.cam.profile.touch import Stretches
from plans.model.cam import FLAT, LAWS, RETURN, RISE, ROLLER, Cam, Follower
from plans.model.cam_motion import CamSizes, Contour
from tests.parts import examples
from tests.plans.textbook_cams import FLAT_BASE, LENGTH, LIFT, SWING, cam, offset_sizes, phases, pivot, rocker

MP = mpmath.mp.clone()
MP.dps = 50
RADIUS = 0.008
SMOOTH = [name for name in LAWS if name != "constant velocity"]


@st.composite
def cams(draw) -> tuple[Cam, CamSizes]:
    """Give cams whose followers all can follow: lifts that are small beside the base."""
    up, dwell, down = (draw(st.integers(*ends)) for ends in ((60, 130), (0, 50), (60, 130)))
    rocks, flat = draw(st.booleans()), draw(st.booleans())
    lift = (SWING if rocks else LIFT) * draw(st.floats(0.1, 0.4 if flat else 1.0))
    laws = draw(st.sampled_from(SMOOTH)), draw(st.sampled_from(SMOOTH))
    middle = [("dwell", dwell, 0.0, "")] if dwell else []
    parts = phases((RISE, up, lift, laws[0]), *middle, (RETURN, down, -lift, laws[1]))
    sense, turns = draw(st.sampled_from([1, -1])), draw(st.sampled_from([1, -1]))
    end = FLAT if flat else ROLLER
    if not rocks:
        made = cam(parts, end, sense)
        return made, CamSizes(0.09) if flat else offset_sizes(draw(st.floats(-0.03, 0.03)), 0.07)
    follower = Follower("rocking", end, LENGTH, turns, draw(st.floats(-0.01, 0.01)) if flat else 0.0)
    made = cam(parts, end, sense, follower=follower)
    return made, pivot(made, complex(0.16, -0.2) if flat else complex(0.12, -0.09))


def drawn_by(own: Cam, sizes: CamSizes, turned) -> Contour:
    return profile(FollowerCourse(own), sizes, RADIUS if own.follower.end == ROLLER else 0.0, turned).contour


def turns(own: Cam) -> np.ndarray:
    """Give turns that are on no joint: there the sides may be taken otherwise by a rounding."""
    return np.linspace(0.0007, own.turn - 0.0011, 97)


@given(cams())
@examples(2)
def test_mirror(case):
    """A cam that turns clockwise is the mirror image, its rocker rising the other way in the frame (H16)."""
    own, sizes = case
    other = replace(own, sense=-own.sense)
    mirrored = sizes._replace(pivot=-sizes.pivot.conjugate())
    one, two = drawn_by(own, sizes, turns(own)), drawn_by(other, mirrored, turns(own))
    for name in ("tip", "pitch", "profile", "lever", "outer"):
        first, second = getattr(one, name), getattr(two, name)
        if first is not None:
            assert np.abs(first + np.conj(second)).max() <= 64 * EPS
    for name in ("pressure", "radius", "sliding"):
        assert getattr(one, name) == pytest.approx(getattr(two, name), rel=1e-9, abs=1e-12)


@given(cams(), st.floats(0.1, 10))
@examples(2)
def test_scale(case, times):
    """All lengths times as large: so are points, radii, slips; angles stay."""
    own, sizes = case
    larger = sizes._replace(**{name: getattr(sizes, name) * times for name in ("base", "offset", "centre", "pivot")})
    follower = own.follower._replace(length=LENGTH * times, face=own.follower.face * times)
    parts = own.phases
    if not own.rocks:
        parts = tuple(one._replace(level=one.level * times, change=one.change * times) for one in parts)
    other = replace(own, follower=follower, phases=parts)
    turned, radius = turns(own), RADIUS if own.follower.end == ROLLER else 0.0
    one = profile(FollowerCourse(own), sizes, radius, turned).contour
    two = profile(FollowerCourse(other), larger, radius * times, turned).contour
    assert np.abs(one.profile * times - two.profile).max() <= 256 * EPS * times
    assert one.pressure == pytest.approx(two.pressure, abs=1e-12)
    assert 1 / one.radius == pytest.approx(times / two.radius, rel=1e-9, abs=1e-9)
    assert one.sliding * times == pytest.approx(two.sliding, rel=1e-11)


@given(cams(), st.floats(0.1, 2.5))
@examples(2)
def test_phase_shift(case, later):
    """What happens later by an angle is the same cam turned against its rotation by it."""
    own, sizes = case
    *moving, last = own.phases
    later = min(later, last.angle * 0.9)
    first = last._replace(start=0.0, angle=later, level=0.0, change=0.0, law=None)
    moved = [one._replace(start=one.start + later) for one in moving]
    other = replace(own, phases=(first, *moved, last._replace(start=last.start + later, angle=last.angle - later)))
    turned = turns(own)[turns(own) < last.start]
    one, two = drawn_by(own, sizes, turned), drawn_by(other, sizes, turned + later)
    assert np.abs(one.profile * np.exp(-1j * own.sense * later) - two.profile).max() <= 1e-13
    assert one.pressure == pytest.approx(two.pressure, abs=1e-11)


@given(cams())
@examples(2)
def test_reversal(case):
    """The cam run backwards gives its follower the laws backwards; the profile is the same curve, the other way."""
    own, sizes = case
    parts = [
        one._replace(start=own.turn - one.end, level=one.level + one.change, change=-one.change)
        for one in reversed(own.phases)
    ]
    follower = own.follower._replace(sense=-own.follower.sense)
    other = replace(own, sense=-own.sense, phases=tuple(parts), follower=follower)
    back = sizes._replace(offset=-sizes.offset)
    turned = turns(own)
    one, two = drawn_by(own, sizes, turned), drawn_by(other, back, own.turn - turned)
    assert np.abs(one.profile - two.profile).max() <= 1e-13
    assert np.abs(one.pitch - two.pitch).max() <= 1e-13
    assert 1 / one.radius == pytest.approx(1 / two.radius, rel=1e-7, abs=1e-7)
    assert one.pressure == pytest.approx(-two.pressure, abs=1e-11)
    assert one.sliding == pytest.approx(two.sliding, rel=1e-10)


def law(phi):
    """Give S, S' of M2.7 in 50 digits, for a lift of 1."""
    up, down = 2 * MP.pi / 3, MP.pi / 2
    if phi < up:
        k = phi / up
        return k - MP.sin(2 * MP.pi * k) / (2 * MP.pi), (1 - MP.cos(2 * MP.pi * k)) / up
    if phi < up + MP.pi / 6:
        return MP.mpf(1), MP.mpf(0)
    k = (phi - up - MP.pi / 6) / down
    if k > 1:
        return MP.mpf(0), MP.mpf(0)
    return 1 - k**3 * (10 - 15 * k + 6 * k**2), -30 * k**2 * (1 - k) ** 2 / down


def envelope(own: Cam, sizes: CamSizes, phi, radius):
    """Give the working profile in 50 digits, from the family of circles, or of lines, that it is the envelope of."""
    s, slope = (MP.mpf(own.lift) * one for one in law(phi))
    back = MP.expj(-own.sense * phi)
    if own.flat:
        return back * (own.sense * slope + 1j * (MP.mpf(sizes.base) + s))
    if own.rocks:
        arm = own.rising * LENGTH * MP.expj(own.rising * (s - MP.mpf(own.lift) / 2))
        tip, rate = MP.mpc(sizes.pivot) + arm, 1j * own.rising * slope * arm
    else:
        start = MP.sqrt(MP.mpf(sizes.base) ** 2 - MP.mpf(sizes.offset) ** 2)
        tip, rate = own.sense * MP.mpf(sizes.offset) + 1j * (start + s), 1j * slope
    along = rate - 1j * own.sense * tip
    return back * (tip - radius * 1j * own.sense * along / abs(along))


ENVELOPES = {
    "translating": (cam(end=ROLLER), offset_sizes(-0.012, 0.04)),
    "clockwise": (cam(end=ROLLER, sense=-1), offset_sizes(0.012, 0.04)),
    "flat": (cam(end=FLAT, sense=-1), CamSizes(FLAT_BASE)),
    "rocker": (rocker(ROLLER), pivot(rocker(ROLLER))),
    "rocker against": (rocker(ROLLER, 1, -1), pivot(rocker(ROLLER, 1, -1), complex(0.12, -0.08))),
}


@pytest.mark.parametrize("name", list(ENVELOPES))
@pytest.mark.parametrize("road", ["construction", "analysis"])
def test_the_working_profile_is_the_exact_envelope(name, road):
    """Within 1e-12 mm."""
    own, sizes = ENVELOPES[name]
    turned = np.linspace(0.01, 6.2, 61)
    radius = 0.0 if own.flat else 0.01
    found = profile(FollowerCourse(own), sizes, radius, turned).contour if road == "construction" else None
    points = (found or contour(own, sizes, radius, turned)).profile
    true = [envelope(own, sizes, MP.mpf(phi), MP.mpf(radius)) for phi in turned.tolist()]
    assert max(float(abs(MP.mpc(one) - exactly)) for one, exactly in zip(points.tolist(), true, strict=True)) <= 1e-15


@pytest.mark.parametrize("name", list(ENVELOPES))
def test_on_the_point_where_it_touches_the_follower_rests_as_it_should(name):
    """What rests on a corner is found by a geometry of its own; on the profile itself it gives the law back."""
    own, sizes = ENVELOPES[name]
    roller, turned = 0.0 if own.flat else 0.01, np.linspace(0.3, 4.1, 7)
    found = profile(FollowerCourse(own), sizes, roller, turned).contour
    for k, corner in enumerate(found.profile.tolist()):
        s = resting(Stretches(FollowerCourse(own), sizes), roller, corner, turned[k : k + 1])
        assert s == pytest.approx(found.travel.s[k : k + 1], abs=1e-14)


@pytest.mark.parametrize("name", list(ENVELOPES))
def test_the_record_replayed_in_50_digits_is_within_its_bounds(name):
    own, sizes = ENVELOPES[name]
    drawing = profile(FollowerCourse(own), sizes, 0.0 if own.flat else 0.01, np.linspace(0.01, 6.2, 31)).drawing
    last = drawing.board.marks[-1] if own.flat else drawing.board["Q"]
    bound = errors(drawing.point, last)
    for place in (0, 7, 19, 30):
        for mark, true in exact([drawing.point, last], place).items():
            if not isinstance(mark.value, tuple):
                limit = np.broadcast_to(bound[mark].place, (31,))[place] + EPS
                assert float(abs(MP.mpc(complex(np.broadcast_to(mark.point, (31,))[place])) - true)) <= limit, mark.name


def test_a_circle_under_a_lift_of_nothing():
    """H3."""
    own = cam(phases((RISE, 120, 0.0, "sine"), (RETURN, 90, 0.0, "3-4-5")), end=ROLLER)
    for found in (
        cam_found(FollowerCourse(own), offset_sizes(), positions(own)),
        analysed(own, offset_sizes(), positions(own)),
    ):
        assert np.abs(found.contour.pitch) == pytest.approx(offset_sizes().base)
        assert found.contour.radius == pytest.approx(offset_sizes().base)
        assert found.flaws == () and found.hollow is None
