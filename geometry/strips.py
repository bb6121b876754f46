"""Strips of a diagram's axis: equal ones, with an edge on every jump; and how far an approximation is out (участки)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

# Of a strip: a jump nearer than this to an edge is on it. On paper it is under a ten-thousandth of a millimetre, and
# a chord over so short a strip would lose six of the sixteen digits of its ends. One jump found on two roads differs
# by far less.
SLIVER = 1e-6


def strips(start: float, end: float, count: int, breaks: Iterable[float] = ()) -> Floats:
    """Divide an axis into equal strips and put a further edge on each break; give the edges, (n+1,), rising.

    The equal edges stay where they are, so that positions keep their numbers. An edge that a break nearly touches is
    moved onto it; both ends hold.

    >>> strips(0, 8, 4, breaks=[5, 6]).tolist()
    [0.0, 2.0, 4.0, 5.0, 6.0, 8.0]
    """
    if count < 1 or not start < end:
        raise ValueError(f"expected at least one strip of an axis that rises, found {count} from {start} to {end}")
    near = SLIVER * (end - start) / count
    inside = list(_apart(sorted(breaks), start, end, near))
    equal = np.linspace(start, end, count + 1)
    inner = [edge for edge in equal[1:-1].tolist() if all(abs(edge - one) > near for one in inside)]
    return np.array([equal[0], *sorted([*inner, *inside]), equal[-1]])


def _apart(breaks: list[float], start: float, end: float, near: float) -> Iterator[float]:
    """Give the breaks that lie apart from the ends and from one another."""
    last = start
    for one in breaks:
        if not start <= one <= end:
            raise ValueError(f"the break at {one} lies outside the axis from {start} to {end}")
        if one - last > near and end - one > near:
            last = one
            yield one


def middles(edges: npt.ArrayLike) -> Floats:
    """Give the middle of each strip, (n,): there the mean ordinate is read, and no jump on an edge is met.

    >>> middles([0, 1, 3]).tolist()
    [0.5, 2.0]
    """
    x = np.asarray(edges, dtype=float)
    return np.asarray(x[:-1] + 0.5 * np.diff(x))


def pieces(edges: npt.ArrayLike, breaks: Iterable[float]) -> tuple[slice, ...]:
    """Part the strips at the breaks: each slice is of strips over which a curve runs smoothly.

    >>> pieces([0, 1, 2, 3], breaks=[1])
    (slice(0, 1, None), slice(1, 3, None))
    """
    x = np.asarray(edges, dtype=float)
    corners = np.flatnonzero(np.isin(x, at := sorted(set(breaks)))).tolist()
    if len(corners) != len(at):
        raise ValueError(f"every break must be an edge, found breaks {at} and edges {x.tolist()}")
    return runs(sorted({0, *corners, len(x) - 1}))


def runs(bounds: Iterable[int]) -> tuple[slice, ...]:
    """Give the runs between numbers that rise.

    >>> runs([0, 2, 3])
    (slice(0, 2, None), slice(2, 3, None))
    """
    return tuple(slice(low, high) for low, high in pairwise(bounds))


class Departure(NamedTuple):
    """The largest difference of values from exact ones, as a share of the largest exact one, and where it is."""

    size: float
    share: float
    at: int


def departure(values: npt.ArrayLike, exact: npt.ArrayLike) -> Departure:
    """Find by how much values are out; a value that is unknown is infinitely so (погрешность построения).

    >>> departure([0, 2.25, 4], [0, 2, 4])
    Departure(size=0.25, share=0.0625, at=1)
    """
    truth = np.asarray(exact, dtype=float)
    off = np.abs(np.asarray(values, dtype=float) - truth)
    off = np.where(np.isnan(off), np.inf, off)
    at, most = int(np.argmax(off)), float(np.max(np.abs(truth)))
    size = float(off[at])
    return Departure(size, size / most if most else np.inf if size else 0.0, at)
