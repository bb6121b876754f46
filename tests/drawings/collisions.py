"""Collisions of a sheet, found with exact geometry: lettering with lines, with other lettering, with the frame."""

from __future__ import annotations

import math

import numpy as np
from shapely import LineString, MultiLineString, Polygon, STRtree
from shapely.geometry.base import BaseGeometry

from drawings.lettering.lettering import outline
from drawings.paper.strokes import Arc, Circle, Fill, Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import flat

LEAST = 0.1  # mm between the ink of a letter and any other ink: what a pen of 0.2 mm leaves of a clear gap
CHORDS = 64  # of a whole circle; on 100 mm of radius the chords miss it by 0.12 mm


def shape(stroke: Stroke) -> BaseGeometry:
    """Give a stroke's ink as a shape."""
    match stroke:
        case Text():
            written = outline(stroke)
            lines = MultiLineString([_pairs(chain.points, chain.closed) for chain in written if len(chain.points) > 1])
            return lines.buffer(written[0].style.width / 2) if written else Polygon()
        case Line():
            return LineString(_pairs((stroke.start, stroke.end))).buffer(stroke.style.width / 2, cap_style="flat")
        case Polyline():
            return LineString(_pairs(stroke.points, stroke.closed)).buffer(stroke.style.width / 2, cap_style="flat")
        case Fill():
            return Polygon(_pairs(stroke.points))
        case Circle():
            round_ = Arc(stroke.centre, stroke.radius, 0.0, 2 * math.pi, stroke.style)
            ring = LineString(_pairs(tuple(round_.at(k / CHORDS) for k in range(CHORDS + 1))))
            return Polygon(ring) if stroke.style.colour == "none" else ring.buffer(stroke.style.width / 2)
        case Arc():
            count = max(int(stroke.sweep / (2 * math.pi) * CHORDS), 4)
            points = tuple(stroke.at(k / count) for k in range(count + 1))
            return LineString(_pairs(points)).buffer(stroke.style.width / 2, cap_style="flat")
    raise TypeError(stroke)


def _pairs(points: tuple[complex, ...], closed: bool = False) -> list[tuple[float, float]]:
    return [(p.real, p.imag) for p in (points + points[:1] if closed else points)]


def collisions(leaf: Leaf) -> list[str]:
    """Name every lettering that touches other ink, but for the frame's paper and what lettering is written on."""
    parts = [stroke for stroke in flat(leaf.groups) if not _paper(stroke, leaf)]
    shapes = np.array([shape(stroke) for stroke in parts], dtype=object)
    tree = STRtree(shapes)
    found = []
    for k, stroke in enumerate(parts):
        if isinstance(stroke, Text):
            for other in tree.query(shapes[k], predicate="dwithin", distance=LEAST):
                if other != k and not (isinstance(parts[other], Text) and other < k):
                    found.append(f"{stroke.plain!r} at {stroke.at:.1f} touches {_named(parts[other])}")
    return found


def _paper(stroke: Stroke, leaf: Leaf) -> bool:
    return isinstance(stroke, Polyline) and {0j, complex(leaf.width, leaf.height)} <= set(stroke.points)


def _named(stroke: Stroke) -> str:
    return repr(stroke.plain) if isinstance(stroke, Text) else repr(stroke)[:120]
