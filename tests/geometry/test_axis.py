"""Strips of a diagram's axis, and curves in pieces."""

from __future__ import annotations

import cmath
import math

import pytest

from geometry.curve import CubicPiece, RoundPiece, sampled, straight
from geometry.strips import departure, pieces, strips


@pytest.mark.parametrize("one", [-0.1, 4.1, math.nan])
def test_a_break_outside_the_axis_is_refused(one: float) -> None:
    with pytest.raises(ValueError, match="outside the axis"):
        strips(0, 4, 4, [one])


@pytest.mark.parametrize(("start", "end", "count"), [(0, 1, 0), (1, 1, 4), (2, 1, 4), (0, math.nan, 3)])
def test_no_strips_and_no_axis_are_refused(start: float, end: float, count: int) -> None:
    with pytest.raises(ValueError, match="at least one strip"):
        strips(start, end, count)


def test_pieces_lie_between_breaks_and_the_ends_of_the_axis() -> None:
    assert pieces([0, 1, 2, 3], []) == (slice(0, 3),)
    assert pieces([0, 1, 2, 3], [0, 2, 3]) == (slice(0, 2), slice(2, 3))


def test_what_is_unknown_is_infinitely_out_and_nothing_of_nothing_is_not() -> None:
    assert departure([0.0, math.nan], [0.0, 1.0]) == (math.inf, math.inf, 1)
    assert departure([0.0, 0.0], [0.0, 0.0]) == (0.0, 0.0, 0)
    assert departure([0.0, 1.0], [0.0, 0.0]).share == math.inf


PIECES = (RoundPiece(1 + 0j, 0j, math.pi / 2), CubicPiece(1j, -1 + 1j, -1 - 1j, -1j), straight(-1j, 1 + 0j))


def test_placed_pieces_go_through_the_placed_points() -> None:
    factor, shift = cmath.rect(2.5, 0.4), 3 - 1j
    for piece in PIECES:
        for share in (0.0, 0.3, 1.0):
            assert piece.placed(factor, shift).at(share) == pytest.approx(factor * piece.at(share) + shift)


@pytest.mark.parametrize("sag", [0.1, 0.01, 0.001])
def test_chain_is_nowhere_farther_off_than_its_sag(sag: float) -> None:
    shapely = pytest.importorskip("shapely")
    chain = shapely.LineString([(point.real, point.imag) for point in sampled(PIECES, sag)])
    spots = [piece.at(k / 200) for piece in PIECES for k in range(201)]
    off = max(chain.distance(shapely.Point(spot.real, spot.imag)) for spot in spots)
    assert sag / 10 < off <= sag
