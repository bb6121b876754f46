"""A plan of vectors from a pole: lines of known direction, the letters of its images (план векторов)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence

from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import Segment
from drawings.layout.picture import Place
from drawings.lettering.lettering import text_width
from drawings.lettering.words import with_index
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke, Text

BEYOND = 9.0  # mm a line of known direction is drawn past the meeting
LEAST = 0.05  # mm: a shorter vector is a point; the finest line is five times as wide
SAME = 0.5  # mm: images nearer than this are one
BESIDE = 1.6  # mm from an image to its letter


def directions(rays: Iterable[Segment], place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw lines of known direction, by their true ends, from a little before these to a little past them."""
    for start, end in rays:
        first, last = place.on(start), place.on(end)
        if abs(last - first) >= LEAST:
            along = (last - first) / abs(last - first) * BEYOND * hand.symbol
            yield Line(first - along / 2, last + along, hand.drafted)


def letter_images(
    images: Iterable[tuple[complex, Sequence[str]]], size: float, labels: Labels, pole: float = BESIDE
) -> Iterator[Stroke]:
    """Letter each image on paper once, outward; those on one place share it. The pole, so many mm off, comes first."""
    names: dict[complex, dict[str, None]] = {}
    for spot, letters in images:
        same = next((known for known in names if abs(known - spot) < SAME), spot)
        names.setdefault(same, {}).update(dict.fromkeys(letters))
    middle, rows = sum(names, 0j) / len(names), list[tuple[complex, float]]()
    for k, (spot, shared) in enumerate(names.items()):
        prefer = cmath.phase(spot - middle) if abs(spot - middle) > SAME else math.pi / 4
        text = ", ".join(map(with_index, shared))
        reach = text_width(Text(0j, text, size)) if len(shared) > 1 else 0.0
        beside = (far for at, far in rows if abs(spot.imag - at.imag) < size and abs(spot.real - at.real) < reach + far)
        if reach and any(beside):
            prefer = -math.pi / 2  # two rows of letters at one level would read as one
        rows += [(spot, reach)] if reach else []
        others = [(far, far) for far in names if far is not spot]
        yield labels.beside(spot, text, size, BESIDE if k else pole, prefer, others)
