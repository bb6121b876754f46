"""The profile as a path: on the exact envelope, its cubics within what they state, its dwells true arcs."""

from __future__ import annotations

import math

import numpy as np
import pytest

from geometry.curve import CubicPiece, RoundPiece, gaps
from plans.analytic.cam.laws import travel
from plans.cam.course import FollowerCourse
from plans.cam.path import PIECES, ProfilePath, path
from plans.cam.profile.profile import CamOutline
from plans.model.cam import DWELL, RETURN, RISE, ROLLER, TRANSLATING, Cam
from plans.model.cam_motion import CamSizes
from tests.parts import some
from tests.plans import cam_cases as cases
from tests.plans.cam_cases import Case, every, roller_of, titled

MM = 1e-3
CASES = some(every(), every=13)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("sense", [1, -1])
def test_profile_is_on_the_exact_envelope(sense: int, sign: int) -> None:
    """Laid out again by the pressure angle of (5.28): the normal leans from the follower's axis by it."""
    cam = cases.cam(TRANSLATING, ROLLER, sense)
    sizes = cases.sizes(cam, 0.012 * sign)
    turned = np.linspace(0, cam.turn, 721)
    found = travel(cam, turned)
    level = math.sqrt(sizes.base**2 - sizes.offset**2)
    alpha = np.arctan((found.slope - sizes.offset) / (found.s + level))
    normal = sense * -np.sin(alpha) + 1j * np.cos(alpha)
    tip = sense * sizes.offset + 1j * (level + found.s)
    exact = (tip - roller_of(cam) * normal) * np.exp(-1j * sense * turned)
    assert np.abs(CamOutline(FollowerCourse(cam), sizes, -roller_of(cam)).at(turned).at - exact).max() < 1e-12 * MM


@pytest.mark.parametrize("case", CASES, ids=titled)
def test_path_is_within_its_tolerance_with_no_more_than_72_pieces(case: Case) -> None:
    cam, sizes = case
    found = path(cam, sizes, -roller_of(cam))
    assert found.deviation <= cam.tolerance
    assert len(found.pieces) <= PIECES
    assert gaps(found.pieces, found.closed) < 1e-12 * MM
    assert _off(cam, sizes, found, roller_of(cam)) <= found.deviation * 1.02  # between the places of measuring


def test_dwell_ends_where_the_next_phase_begins() -> None:
    """0.1 + 0.02 is more than 0.12: what follows a dwell is not one for that."""
    rise, dwell, fall = cases.phases(((RISE, 1.0, "sine"), (DWELL, 1.0, ""), (RETURN, 1.0, "sine")), 0.03)
    slide = (rise._replace(angle=0.1), dwell._replace(angle=0.02, start=0.1), fall._replace(angle=0.07, start=0.12))
    assert slide[1].end > slide[2].start
    cam = cases.cam(end="pointed", translates=True, phases=slide)
    found = path(cam, cases.sizes(cam))
    assert _off(cam, cases.sizes(cam), found, 0.0) <= found.deviation * 1.02


@pytest.mark.parametrize("end", ["pointed", "roller", "flat"])
def test_corner_of_the_law_is_led_round(end: str) -> None:
    """A hard shock leaps the envelope: an arc about the roller's centre, or a line along the face, joins its sides."""
    listed = ((RISE, 120.0, "constant velocity"), (DWELL, 60.0, ""), (RETURN, 180.0, "sine"))
    cam = cases.cam(TRANSLATING, end, phases=cases.phases(listed, 0.03))
    found = path(cam, cases.sizes(cam), -roller_of(cam))
    assert gaps(found.pieces, found.closed) < 1e-12 * MM
    about = [piece for piece in found.pieces if isinstance(piece, RoundPiece) and piece.centre != 0]
    assert [round(piece.radius, 12) for piece in about] == ([0.01, 0.01] if end == "roller" else [])


def _off(cam: Cam, sizes: CamSizes, found: ProfilePath, roller: float) -> float:
    """Measure how far a path is off the outline by the roots of a polynomial: feet of perpendiculars on its cubics."""
    ends = [*found.starts[1:], cam.turn]
    rows = [row for row in zip(found.pieces, found.starts, ends, strict=True) if isinstance(row[0], CubicPiece)]
    shares = np.array([0.031, 0.173, 0.309, 0.457, 0.543, 0.691, 0.827, 0.969])
    spots = CamOutline(FollowerCourse(cam), sizes, -roller).at(
        np.concatenate([start + shares * (end - start) for _, start, end in rows])
    )
    return max(_foot(row[0], spot) for row, own in zip(rows, spots.at.reshape(-1, 8), strict=True) for spot in own)


def _foot(cubic: CubicPiece, spot: complex) -> float:
    a, b, c, d = cubic
    run = np.polynomial.Polynomial([a - spot, 3 * (b - a), 3 * (a - 2 * b + c), d - 3 * c + 3 * b - a])
    square = np.polynomial.Polynomial(run.coef.conj()) * run
    fall = np.polynomial.Polynomial(square.coef.real).deriv()
    feet = [root.real - fall(root.real) / fall.deriv()(root.real) for root in fall.roots() if abs(root.imag) < 1e-6]
    inside = [foot for foot in feet if 0 <= foot <= 1]
    return float(min(abs(run(share)) for share in (0.0, 1.0, *inside)))
