"""Spots: the points that say where a stroke lies, and strokes moved by a similarity of the sheet (опорные точки)."""

from __future__ import annotations

import cmath
import math

from drawings.collation.items import Ink
from drawings.measure.transform import Affine
from drawings.paper.strokes import Arc, Circle, Curve, Fill, Group, Line, Polyline, Stroke, Text
from geometry.curve import CubicPiece, Piece


def spots(stroke: Ink) -> tuple[complex, ...]:
    """Give the points of a stroke, mm, which go with it wherever it is brought; of a circle its centre alone."""
    match stroke:
        case Line(start, end):
            return start, end
        case Polyline() | Fill():
            return stroke.points
        case Arc():
            return stroke.at(0.0), stroke.at(0.5), stroke.at(1.0)
        case Circle(centre):
            return (centre,)
        case Curve():
            return tuple(spot for piece in stroke.pieces for spot in _of_piece(piece))
        case Text():
            return stroke.at, stroke.at + cmath.rect(stroke.size, math.radians(stroke.rotation))


def _of_piece(piece: Piece) -> tuple[complex, ...]:
    return tuple(piece) if isinstance(piece, CubicPiece) else (piece.at(0.0), piece.at(0.5), piece.at(1.0))


def middle(stroke: Ink) -> complex:
    """Give the middle of a stroke's points; of a circle its centre, of lettering where it begins."""
    own = spots(stroke)
    return own[0] if isinstance(stroke, Circle | Text) else sum(own) / len(own)


def brought(stroke: Stroke, by: Affine) -> Stroke:
    """Give a stroke brought elsewhere by a similarity; the widths of its lines stay."""
    size, turn = abs(by.p), cmath.phase(by.p)
    match stroke:
        case Group():
            return stroke._replace(strokes=tuple(brought(one, by) for one in stroke.strokes))
        case Line(start, end):
            return stroke._replace(start=by(start), end=by(end))
        case Polyline() | Fill():
            return stroke._replace(points=tuple(by(point) for point in stroke.points))
        case Arc(centre, radius, first, last):
            return stroke._replace(
                centre=by(centre), radius=radius * size, start_angle=first + turn, end_angle=last + turn
            )
        case Circle(centre, radius):
            return stroke._replace(centre=by(centre), radius=radius * size)
        case Curve():
            return stroke._replace(pieces=tuple(piece.placed(by.p, by.t) for piece in stroke.pieces))
        case Text():
            return stroke._replace(
                at=by(stroke.at), size=stroke.size * size, rotation=stroke.rotation + math.degrees(turn)
            )
