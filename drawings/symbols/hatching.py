"""Hatching of a cut: thin parallel lines at 45 degrees within an outline (штриховка сечения; GOST 2.306-68)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from drawings.paper.hand import Hand
from drawings.paper.strokes import Line
from drawings.symbols.symbols import HATCH_STEP

LEAN = 1 + 1j  # along the lines


def hatching(outline: Sequence[complex], hand: Hand) -> Iterator[Line]:
    """Hatch the inside of a closed outline on paper; lines of neighbouring parts of one body meet."""
    turned = [corner / LEAN for corner in outline]  # the lines lie level
    apart = HATCH_STEP * hand.symbol / abs(LEAN)
    first, last = min(corner.imag for corner in turned), max(corner.imag for corner in turned)
    for k in range(math.floor(first / apart) + 1, math.ceil(last / apart)):
        for start, end in _inside(turned, k * apart):
            yield Line(start * LEAN, end * LEAN, hand.drafted)


def _inside(outline: Sequence[complex], level: float) -> Iterator[tuple[complex, complex]]:
    """Give the pieces of a level line that lie within an outline."""
    ends = np.array(outline)
    starts = np.roll(ends, 1)
    cut = (starts.imag > level) != (ends.imag > level)
    before, after = starts[cut], ends[cut]
    share = (level - before.imag) / (after.imag - before.imag)
    places = np.sort(before.real + share * (after.real - before.real))
    pieces = list(pairwise(places.tolist()))[::2]
    yield from ((complex(start, level), complex(end, level)) for start, end in pieces if end > start)
