"""Strips of an abscissa, and diagrams over them: axes, ordinates, what rises too steeply (участки, диаграмма)."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Board, Mark
from geometry.meet import UNBORNE

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
    inner = [edge for edge in equal[1:-1].tolist() if all(abs(edge - cut) > near for cut in inside)]
    return np.array([equal[0], *sorted([*inner, *inside]), equal[-1]])


def _apart(breaks: list[float], start: float, end: float, near: float) -> Iterator[float]:
    """Give the breaks that lie apart from the ends and from one another."""
    last = start
    for cut in breaks:
        if not start <= cut <= end:
            raise ValueError(f"the break at {cut} lies outside the axis from {start} to {end}")
        if cut - last > near and end - cut > near:
            last = cut
            yield cut


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


STEEPEST = 1.0 / UNBORNE  # a rise over a run: a line that is steeper no longer meets an ordinate plainly


class Reasons(NamedTuple):
    """Why each kind of step is drawn: texts, or what can be said in a language."""

    axes: object = ""
    pole: object = ""
    # of an integral
    start: object = ""
    mean: object = ""
    carried: object = ""
    ray: object = ""
    strip: object = ""
    edge: object = ""
    chord: object = ""
    integral: object = ""
    # of a derivative
    point: object = ""
    part: object = ""
    tangent: object = ""
    slope_ray: object = ""
    cut: object = ""
    level: object = ""
    middle: object = ""
    derivative: object = ""


SILENT = Reasons()


class StripAxes(NamedTuple):
    """The axes of a diagram and the pole on the left of them: the origin, the direction of x, the y axis (полюс)."""

    origin: Mark
    x: Mark
    y: Mark
    pole: Mark


def axes_of(board: Board, name: str, distance: float, why: Reasons) -> StripAxes:
    """Put the axes down with the pole on the left of them, so that a positive ordinate rises."""
    if not 0 < distance < np.inf:
        raise ValueError(f"the pole distance must be more than 0, found {distance}")
    origin = board.given(f"{name}:O", 0j, why.axes)
    x = board.given(f"{name}:x", 1 + 0j, why.axes)
    y = board.square(f"{name}:y", origin, x, why.axes)
    return StripAxes(origin, x, y, board.given(f"{name}:P", complex(-distance), why.pole))


def curve(board: Board, name: str, xs: Floats, ys: npt.ArrayLike, why: Reasons) -> list[Mark]:
    """Put the points of a curve down."""
    pairs = zip(xs.tolist(), np.asarray(ys, dtype=float).tolist(), strict=True)
    return [board.given(f"{name}:{k}", complex(x, y), why.point) for k, (x, y) in enumerate(pairs)]


def rising(edges: npt.ArrayLike) -> Floats:
    """Read the edges of strips, each beyond the last.

    >>> rising([0, 2]).tolist()
    [0.0, 2.0]
    """
    x = np.asarray(edges, dtype=float)
    if len(x) < 2 or not bool(np.all(np.diff(x) > 0)):
        raise ValueError(f"expected two edges or more, each beyond the last, found {x.tolist()}")
    return x


def refuse_steep(rises: npt.ArrayLike, runs: npt.ArrayLike) -> None:
    """Refuse a line that cannot be told from an ordinate."""
    steep = np.max(np.nan_to_num(np.abs(np.asarray(rises, dtype=float) / runs)), initial=0.0)
    if steep >= STEEPEST:
        raise ValueError(
            f"a line rises {steep:.3g} times as far as it runs, and {STEEPEST:.3g} is too steep: take the ordinates in "
            "a larger unit, or for an integral a greater pole distance"
        )


def ordinates(points: Sequence[Mark]) -> Floats:
    """Read the ordinates of points."""
    return np.array([complex(point.point).imag for point in points])
