"""Curves in pieces: placed, sampled, joined."""

from __future__ import annotations

import cmath
import math

import pytest

from geometry.curve import CubicPiece, RoundPiece, sampled, straight

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
