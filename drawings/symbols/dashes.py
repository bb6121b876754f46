"""Dashes and hatching fitted to a line (штрихи и штриховка)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from drawings.lettering.extent import GRAIN
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Curve, Line, LineStyle, Polyline, Stroke, numeral
from drawings.paper.walk import tied
from drawings.symbols.symbols import HATCH_STEP
from geometry.curve import sampled

DASHED, DASH_DOT = (2.0, 8.0), (5.0, 30.0)


def fit_dashes(strokes: Iterable[Stroke]) -> Iterator[Stroke]:
    """Fit the dashes of lines, chains, arcs and curves to their lengths; strokes of full lines pass."""
    for stroke in strokes:
        match stroke:
            case Line(start, end, style) if style.dash:
                yield stroke._replace(style=fit(style, abs(end - start)))
            case Arc(radius=radius, style=style) if style.dash:
                yield stroke._replace(style=fit(style, radius * stroke.sweep))
            case Polyline(points, closed, style) if style.dash:
                length = sum(abs(end - start) for start, end in pairwise((*points, points[0]) if closed else points))
                yield stroke._replace(style=fit(style, length, closed))
            case Curve(pieces, closed, style) if style.dash:
                length = sum(abs(end - start) for start, end in pairwise(sampled(pieces, GRAIN)))
                yield stroke._replace(style=fit(style, length, closed))
            case _:
                yield stroke


def fit(style: LineStyle, length: float, closed: bool = False) -> LineStyle:
    """Give a broken line's style with dashes that fill its length from end to end; a line too short for two is full.

    A closed line has a gap before its beginning: it has as many gaps as dashes.

    >>> fit(LineStyle(0.35, (4, 1.5)), 20.0).dash  # four dashes and three gaps
    (3.875, 1.5)
    >>> fit(LineStyle(0.35, (15, 1.5, 0.5, 1.5)), 9.0).dash
    ()
    """
    dash, *rest = style.dash
    between, last = sum(rest), 0 if closed else 1
    least, most = DASHED if len(rest) == 1 else DASH_DOT

    def fitting(gaps: int) -> float:
        return float(numeral((length - gaps * between) / (gaps + last)))  # of lines of one length it is one

    gaps = max(round(tied((length - last * dash) / (dash + between))), 1)
    while gaps > 1 and fitting(gaps) < least:
        gaps -= 1
    while fitting(gaps) > most:
        gaps += 1
    return style._replace(dash=(fitting(gaps), *rest) if fitting(gaps) >= least else ())


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
