"""Curves as lines on paper: which of them goes through given places, and how high it is over others (линия графика)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from drawings.grading.curves.asked_figure import Sizes, Values
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Curve, Polyline, Stroke
from drawings.paper.walk import flat
from plans.checks.hand.quantity import SLIP

# mm: a curve goes through a place if a hand that slips by four times a fair one's has drawn it so.
THROUGH = 2 * np.sqrt(2) * 4 * SLIP
PLACED = 0.7  # mm: what begins, or ends, at a place does so if a fair hand may have pricked it there
SHARES = np.linspace(0.0, 1.0, 9)  # of a piece of a curve, between which it is straight enough


class Frame(NamedTuple):
    """The axes of a graph on paper: their origin, mm, and the ways along which places and values go."""

    origin: complex
    along: complex
    rise: complex

    def seen(self, spots: Values) -> Values:
        """Give places on paper in these axes: along, then up, mm."""
        apart = spots - self.origin
        across = self.along.real * self.rise.imag - self.along.imag * self.rise.real
        own = (apart.real * self.rise.imag - apart.imag * self.rise.real) / across
        high = (self.along.real * apart.imag - self.along.imag * apart.real) / across
        return np.asarray(own + 1j * high)


def chains(strokes: Iterable[Stroke]) -> Iterator[Values]:
    """Give the lines that may be curves: chains of three corners or more, and curves in short chords."""
    for one in flat(strokes):
        if isinstance(one, Polyline) and len(one.points) > 2:
            yield np.array(one.points)
        elif isinstance(one, Curve):
            yield np.array([piece.at(float(share)) for piece in one.pieces for share in SHARES])


def through(strokes: Iterable[Stroke], frame: Frame, ends: Values) -> Values | None:
    """Give the curve through most of some places, in the axes of a graph; None where none goes through half of them."""
    own = [frame.seen(one) for one in chains(strokes)]
    best = max(own, key=lambda one: hits(one, ends), default=None)
    return best if best is not None and 2 * hits(best, ends) > len(ends) else None


def hits(curve: Values, ends: Values) -> int:
    """Count the places that a curve goes through."""
    return int((away(curve, ends) <= THROUGH).sum())


def foot(lines: tuple[Values, ...], spot: complex) -> complex:
    """Give the place on some lines that is nearest to a spot.

    >>> foot((np.array([0j, 4 + 0j]), np.array([5j, 4 + 5j])), 1 + 2j)
    (1+0j)
    """
    return min((_foot(one, spot) for one in lines), key=lambda one: abs(one - spot))


def _foot(line: Values, spot: complex) -> complex:
    run = np.diff(line)
    long = np.maximum(np.abs(run) ** 2, np.finfo(float).tiny)
    share = np.clip(((spot - line[:-1]) * run.conj()).real / long, 0.0, 1.0)
    feet = line[:-1] + share * run
    return complex(feet[int(np.abs(feet - spot).argmin())])


def away(curve: Values, ends: Values) -> Sizes:
    """Give how far places are from a curve, mm.

    >>> away(np.array([0j, 1 + 0j, 1 + 2j]), np.array([0.5 + 0.1j, 1 + 1j, 3 + 2j])).tolist()
    [0.1, 0.0, 2.0]
    """
    run = np.diff(curve)
    apart = ends[:, None] - curve[:-1]
    long = np.maximum(np.abs(run) ** 2, np.finfo(float).tiny)
    share = np.clip((apart * run.conj()).real / long, 0.0, 1.0)
    return np.asarray(np.abs(apart - share * run).min(axis=1))


def heights(curve: Values, places: Sizes) -> Sizes:
    """Give how high a curve is over some places, mm, behind a jump; NaN where it does not reach.

    >>> heights(np.array([0j, 1 + 1j, 1 + 3j, 2 + 3j]), np.array([0.5, 1.0, 2.0, 4.0])).tolist()
    [0.5, 3.0, 3.0, nan]
    """
    start, end = curve[:-1], curve[1:]
    turned = end.real < start.real
    low, high = np.where(turned, end, start), np.where(turned, start, end)
    found = [_height(low, high, float(place)) for place in places]
    return np.array(found, dtype=np.float64)


def _height(low: Values, high: Values, place: float) -> float:
    """Give the height over one place: of the segment that begins there or goes over it, else of one that ends there."""
    over = np.flatnonzero((low.real <= place + 2 * QUANTUM) & (high.real > place + 2 * QUANTUM))
    ends = np.flatnonzero(np.abs(high.real - place) <= PLACED) if not over.size else over
    if not ends.size:
        return float("nan")
    k = int(ends[-1])
    wide = high[k].real - low[k].real
    share = min(max((place - low[k].real) / wide, 0.0), 1.0) if wide else 1.0
    return float(low[k].imag + share * (high[k].imag - low[k].imag))
