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

At = Callable[[complex], tuple[float, float]]  # of a point of the sheet to SVG's own


def svg(leaf: Leaf) -> bytes:
    """Draw a sheet, its lettering as strokes of our alphabet."""
    size = (f"{leaf.width}mm", f"{leaf.height}mm")
    drawing = svgwrite.Drawing(size=size, viewBox=f"0 0 {leaf.width} {leaf.height}")

    def at(point: complex) -> tuple[float, float]:
        return point.real, leaf.height - point.imag

    for group in leaf.groups:
        drawing.add(_group(drawing, group, at))
    return bytes(drawing.tostring(), "utf-8")


def _group(drawing: Any, group: Group, at: At) -> Any:
    found = drawing.g(id=group.name) if group.name else drawing.g()
    for stroke in group.strokes:
        found.add(_element(drawing, stroke, at))
    return found


def _element(drawing: Any, stroke: Stroke, at: At) -> Any:
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
            return drawing.path(["M", *at(stroke.at(0)), *_halves(stroke, at)], **_style(stroke.style))
        case Curve(pieces, _, style):
            ways = (word for piece in pieces for word in _piece(piece, at))
            return drawing.path(["M", *at(pieces[0].start), *ways], **_style(style))
        case Text():
            return _group(drawing, Group(outline(stroke)), at)
        case Group():
            return _group(drawing, stroke, at)


def _piece(piece: Piece, at: At) -> list[Any]:
    if isinstance(piece, CubicPiece):
        return ["C", *at(piece.first), *at(piece.second), *at(piece.end)]
    return _halves(piece, at, int(piece.sweep < 0))


def _halves(arc: Any, at: At, swept: int = 0) -> list[Any]:
    """Give an arc as two halves: a whole circle has no other way to be one."""
    flags = (arc.radius, arc.radius, 0, 0, swept)
    return ["A", *flags, *at(arc.at(0.5)), "A", *flags, *at(arc.at(1))]


def _style(style: LineStyle) -> dict[str, Any]:
    width = {"stroke_width": style.width} if style.colour != "none" else {}
    dash = {"stroke_dasharray": ",".join(map(str, style.dash))} if style.dash else {}
    return {"fill": style.fill, "stroke": style.colour, **width, **dash}
