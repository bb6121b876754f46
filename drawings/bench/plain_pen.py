"""A plain pen: a sheet written as svgwrite's first pages show it, to be timed beside ours.

Its defaults: every attribute checked (debug), one element a stroke, numbers as Python prints them. Data attributes are
left out, for its checks refuse them: it writes less than our pen does.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import svgwrite

from drawings.lettering.lettering import outline
from drawings.paper.strokes import Arc, Circle, Curve, Fill, Group, Leaf, Line, LineStyle, Polyline, Stroke, Text
from geometry.curve import CubicPiece, Piece


def svg(leaf: Leaf) -> bytes:
    """Draw a sheet, its lettering as strokes of our alphabet."""
    size = (f"{leaf.width}mm", f"{leaf.height}mm")
    drawing = svgwrite.Drawing(size=size, viewBox=f"0 0 {leaf.width} {leaf.height}")
    for group in leaf.groups:
        drawing.add(_group(drawing, group, leaf))
    return bytes(drawing.tostring(), "utf-8")


def _group(drawing: Any, group: Group, leaf: Leaf) -> Any:
    found = drawing.g(id=group.name) if group.name else drawing.g()
    for stroke in group.strokes:
        found.add(_element(drawing, stroke, leaf))
    return found


def _element(drawing: Any, stroke: Stroke, leaf: Leaf) -> Any:
    def at(point: complex) -> tuple[float, float]:
        return point.real, leaf.height - point.imag

    match stroke:
        case Line(start, end, style):
            return drawing.line(at(start), at(end), **_style(style))
        case Polyline(points, closed, style):
            make = drawing.polygon if closed else drawing.polyline
            return make([at(point) for point in points], **_style(style))
        case Fill(points, style):
            return drawing.polygon([at(point) for point in points], **_style(style))
        case Circle(centre, radius, style):
            return drawing.circle(at(centre), radius, **_style(style))
        case Arc():
            return drawing.path(
                _arc(stroke, at(stroke.at(0)), at(stroke.at(0.5)), at(stroke.at(1))), **_style(stroke.style)
            )
        case Curve(pieces, _, style):
            return drawing.path(_curve(pieces, at), **_style(style))
        case Text():
            return _group(drawing, Group(outline(stroke)), leaf)
        case Group():
            return _group(drawing, stroke, leaf)


def _curve(pieces: tuple[Piece, ...], at: Callable[[complex], tuple[float, float]]) -> list[Any]:
    """Give a path of cubics and of arcs in halves."""
    found: list[Any] = ["M", *at(pieces[0].start)]
    for piece in pieces:
        if isinstance(piece, CubicPiece):
            found += ["C", *at(piece.first), *at(piece.second), *at(piece.end)]
        else:
            flags = (piece.radius, piece.radius, 0, 0, int(piece.sweep < 0))
            found += ["A", *flags, *at(piece.at(0.5)), "A", *flags, *at(piece.end)]
    return found


def _arc(arc: Arc, *ends: tuple[float, float]) -> list[Any]:
    """Give a path of two halves: a whole circle has no other way to be an arc."""
    start, middle, end = ends
    flags = (arc.radius, arc.radius, 0, 0, 0)
    return ["M", *start, "A", *flags, *middle, "A", *flags, *end]


def _style(style: LineStyle) -> dict[str, Any]:
    found: dict[str, Any] = {"fill": style.fill, "stroke": style.colour}
    if style.colour != "none":
        found["stroke_width"] = style.width
    if style.dash:
        found["stroke_dasharray"] = ",".join(map(str, style.dash))
    return found
