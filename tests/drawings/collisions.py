"""Collisions of a sheet, found with exact geometry: lettering with lines, with other lettering, with the frame."""

from __future__ import annotations

import math
from functools import cache
from typing import Literal, NamedTuple

import numpy as np
from shapely import LineString, Polygon, STRtree, linestrings, multilinestrings
from shapely.geometry.base import BaseGeometry

from drawings.lettering.lettering import outline
from drawings.paper.strokes import Arc, Circle, Curve, Fill, Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import flat
from geometry.curve import sampled

LEAST = 0.1  # mm between the ink of a letter and any other ink: what a pen of 0.2 mm leaves of a clear gap
CHORDS = 64  # of a whole circle; on 100 mm of radius the chords miss it by 0.12 mm


class Ink(NamedTuple):
    """A stroke's line, or its face, and how far its ink reaches to either side of it."""

    line: BaseGeometry
    reach: float = 0.0
    cap: Literal["round", "flat"] = "flat"

    @property
    def shape(self) -> BaseGeometry:
        """The ink as a shape."""
        return self.line.buffer(self.reach, cap_style=self.cap) if self.reach else self.line


def ink(stroke: Stroke) -> Ink:
    """Give a stroke's ink."""
    match stroke:
        case Text():
            written = outline(stroke)
            return Ink(_lines(written), written[0].style.width / 2, "round") if written else Ink(Polygon())
        case Line():
            return Ink(LineString(_pairs((stroke.start, stroke.end))), stroke.style.width / 2)
        case Polyline():
            return Ink(LineString(_pairs(stroke.points, stroke.closed)), stroke.style.width / 2)
        case Fill():
            return Ink(Polygon(_pairs(stroke.points)))
        case Curve(pieces):
            return Ink(LineString(_pairs(tuple(sampled(pieces, LEAST / 2)))), stroke.style.width / 2)
        case Circle():
            round_ = Arc(stroke.centre, stroke.radius, 0.0, 2 * math.pi, stroke.style)
            ring = LineString(_pairs(tuple(round_.at(k / CHORDS) for k in range(CHORDS + 1))))
            return Ink(Polygon(ring)) if stroke.style.colour == "none" else Ink(ring, stroke.style.width / 2, "round")
        case Arc():
            count = max(int(stroke.sweep / (2 * math.pi) * CHORDS), 4)
            points = tuple(stroke.at(k / count) for k in range(count + 1))
            return Ink(LineString(_pairs(points)), stroke.style.width / 2)
    raise TypeError(stroke)


def _lines(chains: tuple[Polyline, ...]) -> BaseGeometry:
    """Give all chains of a text at once: to make them one by one takes three times as long."""
    kept = [_pairs(chain.points, chain.closed) for chain in chains if len(chain.points) > 1]
    points = np.array([point for chain in kept for point in chain]).reshape(-1, 2)
    return multilinestrings(linestrings(points, indices=np.repeat(np.arange(len(kept)), list(map(len, kept)))))


def _pairs(points: tuple[complex, ...], closed: bool = False) -> list[tuple[float, float]]:
    return [(p.real, p.imag) for p in (points + points[:1] if closed else points)]


def collisions(leaf: Leaf) -> list[str]:
    """Name every lettering that touches other ink, but for the frame's paper and what lettering is written on."""
    parts = [stroke for stroke in flat(leaf.groups) if not _paper(stroke, leaf)]
    inks = [ink(stroke) for stroke in parts]
    shape = cache(lambda k: inks[k].shape)  # only of ink that other ink comes near: to widen a line is slow
    tree = STRtree([one.line for one in inks])
    farthest = max((one.reach for one in inks), default=0.0)
    found = []
    for k, stroke in enumerate(parts):
        if isinstance(stroke, Text):
            for other in tree.query(inks[k].line, predicate="dwithin", distance=LEAST + inks[k].reach + farthest):
                twice = other == k or (isinstance(parts[other], Text) and other < k)
                if not twice and shape(k).dwithin(shape(other), LEAST):
                    found.append(f"{stroke.plain!r} at {stroke.at:.1f} touches {_named(parts[other])}")
    return found


def _paper(stroke: Stroke, leaf: Leaf) -> bool:
    return isinstance(stroke, Polyline) and {0j, complex(leaf.width, leaf.height)} <= set(stroke.points)


def _named(stroke: Stroke) -> str:
    return repr(stroke.plain) if isinstance(stroke, Text) else repr(stroke)[:120]
