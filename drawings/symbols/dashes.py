"""Dashes: a broken line begins and ends with a dash; its dashes are equal and as long as the standard lets them be.

GOST 2.303-68: dashes of 2 to 8 mm in a dashed line, of 5 to 30 mm in a dash-dot line (штриховая, штрихпунктирная).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

from drawings.lettering.extent import GRAIN
from drawings.paper.strokes import Arc, Curve, Line, LineStyle, Polyline, Stroke, numeral
from drawings.paper.ties import tied
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
