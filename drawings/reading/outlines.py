"""Outlines: the elements of a drawing as strokes on paper (линии листа)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

from drawings.paper.limits import REACH, SheetRefused
from drawings.paper.strokes import PLAIN, Arc, Circle, Curve, Fill, Line, LineStyle, Polyline, Stroke
from drawings.reading.lettered import PenTrack, chains, tracks
from drawings.reading.marks import at
from drawings.reading.pathdata import number, numbers, pieces
from drawings.reading.transform import Affine
from geometry.curve import Piece, RoundPiece

SHAPES = frozenset(("line", "circle", "ellipse", "rect", "polyline", "polygon", "path"))
_SIZES = {
    "rect": ("x", "y", "width", "height", "rx", "ry"),
    "ellipse": ("cx", "cy", "rx", "ry"),
    "circle": ("cx", "cy", "r"),
}
# How far two centres of one arc may be apart, in its radii over the shorter of its pieces: each end is rounded.
_CENTRES = 4e-4  # mm


def outlines(tag: str, attributes: Mapping[str, str], place: Affine, style: LineStyle) -> Iterator[Stroke]:
    """Give the strokes of an element on paper."""
    if tag == "circle" and not place.stretched:
        radius = number(attributes.get("r", "0"))
        if radius > 0:
            yield Circle(_checked(place(at(attributes, "cx", "cy"))), radius * scale_of(place), style)
        return
    if tag == "line":
        start, end = place(at(attributes, "x1", "y1")), place(at(attributes, "x2", "y2"))
        yield Line(_checked(start), _checked(end), style)
        return
    plain = chains(attributes.get("d", "")) if tag == "path" else None
    if plain is None:
        yield from (stroke(track.mapped(place), style) for track in _tracks(tag, attributes))
        return
    p, q, t = place
    for points, closed in plain:
        moved = tuple([p * point + q * point.conjugate() + t for point in points])
        if not max(map(abs, moved)) <= REACH:
            moved = tuple(map(_checked, moved))
        yield _chain(moved, closed, style)


def stroke(track: PenTrack, style: LineStyle) -> Stroke:
    """Give a track on paper as the plainest stroke that it is."""
    for point in track.points:
        _checked(point)
    counts = {len(piece) for piece in track.pieces}
    if counts == {1}:
        return _chain((track.start, *(piece[0] for piece in track.pieces)), track.closed, style)
    if counts == {2} and not track.closed and (arc := _arc(track, style)) is not None:
        return arc
    return Curve(tuple(merged(pieces(_spots(track)))), track.closed, style)


def merged(pieces: Iterable[Piece]) -> Iterator[Piece]:
    """Give pieces of a curve, arcs that go on about one centre in one sense as one."""
    before: Piece | None = None
    for piece in pieces:
        if isinstance(before, RoundPiece) and isinstance(piece, RoundPiece) and _goes_on(before, piece):
            before = RoundPiece(before.start, before.centre, _on_to(before, piece))
            continue
        if before is not None:
            yield before
        before = piece
    if before is not None:
        yield before


def _on_to(before: RoundPiece, after: RoundPiece) -> float:
    """Give the sweep of an arc to the end of the one that goes on from it, so that no rounding adds up."""
    sweep = before.sweep + after.sweep
    return sweep + cmath.phase((after.end - before.centre) / (before.start - before.centre) * cmath.exp(-1j * sweep))


def _goes_on(before: RoundPiece, after: RoundPiece) -> bool:
    """Tell whether an arc goes on from another: both ends of either are rounded, which turns a short one most."""
    chord = min(abs(piece.end - piece.start) for piece in (before, after))
    off = abs(after.centre - before.centre)
    return before.sweep * after.sweep > 0 and off <= _CENTRES * (1 + before.radius / chord if chord else 1)


@lru_cache(maxsize=256)
def scale_of(place: Affine) -> float:
    """Give how many times as large all is drawn; of a stretch the mean of both ways."""
    return math.sqrt(abs(abs(place.p) ** 2 - abs(place.q) ** 2))


def _chain(points: tuple[complex, ...], closed: bool, style: LineStyle) -> Stroke:
    if style.colour == "none" and style.fill != "none":
        return Fill(points, style)
    return Line(*points, style) if len(points) == 2 and not closed else Polyline(points, closed, style)


def _arc(track: PenTrack, style: LineStyle) -> Arc | None:
    """Give arcs that go on about one centre counter-clockwise as one."""
    only, *others = merged(pieces(_spots(track)))
    if others or not isinstance(only, RoundPiece) or only.sweep <= 0:
        return None
    begin = cmath.phase(only.start - only.centre)
    return Arc(only.centre, only.radius, begin, begin + min(only.sweep, math.tau), style)


def _spots(track: PenTrack) -> Iterator[tuple[complex, ...]]:
    """Give the points of each piece with its start; a straight one is a cubic that is gone through evenly."""
    here = track.start
    for piece in track.pieces:
        if len(piece) == 1:
            yield here, here + (piece[0] - here) / 3, piece[0] - (piece[0] - here) / 3, piece[0]
        else:
            yield here, *piece
        here = piece[-1]


def _tracks(tag: str, attributes: Mapping[str, str]) -> list[PenTrack]:
    """Give what a shape other than a line or a circle goes through, in its own units."""
    match tag:
        case "path":
            return tracks(attributes.get("d", ""))
        case "polyline" | "polygon":
            flat = numbers(attributes.get("points", ""))
            points = list(map(complex, flat[::2], flat[1::2]))
            rest = tuple((point,) for point in points[1:])
            return [PenTrack(points[0], rest, tag == "polygon")] if rest else []
    return tracks(_rounded(tag, {name: number(attributes.get(name, "0")) for name in _SIZES[tag]}))


def _rounded(tag: str, sizes: Mapping[str, float]) -> str:
    if tag == "rect":
        x, y, width, height = (sizes[name] for name in ("x", "y", "width", "height"))
        if not (width > 0 and height > 0):
            return ""
        rx, ry = sizes["rx"] or sizes["ry"], sizes["ry"] or sizes["rx"]  # either alone is both
        if rx > 0 and ry > 0:
            return _round_cornered(x, y, width, height, min(rx, width / 2), min(ry, height / 2))
        return f"M{x!r} {y!r}h{width!r}v{height!r}h{-width!r}z"
    across, up = sizes.get("rx", sizes.get("r", 0.0)), sizes.get("ry", sizes.get("r", 0.0))
    if not (across > 0 and up > 0):
        return ""
    arc = f"a{across!r} {up!r} 0 0 0 "
    return f"M{sizes['cx'] - across!r} {sizes['cy']!r}{arc}{2 * across!r} 0{arc}{-2 * across!r} 0z"


def _round_cornered(x: float, y: float, width: float, height: float, rx: float, ry: float) -> str:
    across, down, arc = width - 2 * rx, height - 2 * ry, f"a{rx!r} {ry!r} 0 0 1 "
    sides = f"h{across!r}{arc}{rx!r} {ry!r}v{down!r}{arc}{-rx!r} {ry!r}h{-across!r}{arc}{-rx!r} {-ry!r}v{-down!r}{arc}"
    return f"M{x + rx!r} {y!r}{sides}{rx!r} {-ry!r}z"


def _checked(point: complex) -> complex:
    if not (abs(point.real) <= REACH and abs(point.imag) <= REACH):
        raise SheetRefused("off_paper")
    return point


def cornered(stroke: Stroke) -> Stroke:
    """Give a stroke as it is seen: of one without corners nobody sees how they would be drawn."""
    if not isinstance(stroke, Line | Arc | Circle) or stroke.style.join == PLAIN.join:
        return stroke
    return stroke._replace(style=stroke.style._replace(join=PLAIN.join))
