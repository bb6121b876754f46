"""Graphical integration and differentiation (графическое интегрирование и дифференцирование): chords, tangents, a pole.

A point of a diagram is x + iy in true units. Parallels stay parallel whatever the scales of the two axes, so that the
construction with a pole distance in units of x is the one on paper with the pole distance in mm. An ordinate of an
integral curve is the integral over the pole distance, one of a derivative curve the derivative times it; `values` are
freed of it. A line so steep that it cannot be told from an ordinate is refused: a pole farther off makes rays flatter.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from geometry.board import Board, Mark
from geometry.meet import EPS
from geometry.strips import (
    SILENT,
    Floats,
    Reasons,
    StripAxes,
    axes_of,
    curve,
    middles,
    ordinates,
    pieces,
    refuse_steep,
    rising,
    runs,
)

# What a value of n steps goes through: the difference of the edges, a product, a quotient, the start and the pole
# distance are rounded once each, and every sum once; half an eps a rounding, which leaves the other half to spare.
ROUNDINGS = 5
TINY = float(np.finfo(np.float64).tiny)  # below it a number loses digits


@dataclass(frozen=True, eq=False, repr=False)  # the record behind a mark is too long to be shown
class Integral:
    """An integral curve by chords: over n strips its points at the n+1 edges, and the rays that its chords follow.

    `ordinates` are the mean ordinates as vectors, `carried` their ends on the y axis; `distance` is the pole distance.
    """

    board: Board
    name: str
    axes: StripAxes
    distance: float
    edges: Floats  # (n+1,)
    means: Floats  # (n,)
    ordinates: tuple[Mark, ...]
    carried: tuple[Mark, ...]
    rays: tuple[Mark, ...]
    chords: tuple[Mark, ...]
    points: tuple[Mark, ...]

    @property
    def pole(self) -> Mark:
        """The pole."""
        return self.axes.pole

    @cached_property
    def values(self) -> Floats:
        """The integral at the edges, (n+1,), in units of x times units of y."""
        return ordinates(self.points) * self.distance

    @cached_property
    def slacks(self) -> Floats:
        """How far rounding can have moved each value, (n+1,): some eps for each strip, of all areas taken positive."""
        # A bound carried from step to step (geometry.precision) would grow with each crossing; ordinates only add up.
        areas = np.abs(np.concatenate([self.values[:1], self.means * np.diff(self.edges)]))
        least = TINY * max(1.0, self.distance)
        return np.asarray((np.arange(len(areas)) + ROUNDINGS) * (EPS * np.cumsum(areas) + least))


@dataclass(frozen=True, eq=False, repr=False)  # the record behind a mark is too long to be shown
class Derivative:
    """A derivative curve: its points, over the middles of the parts by chords, at the points themselves by tangents.

    `directions` are the chords or tangents, `rays` the lines through the pole along them. Within each of `pieces` the
    points can be joined smoothly; between them the curve has a corner and the derivative jumps.
    """

    board: Board
    name: str
    axes: StripAxes
    distance: float
    middles: Floats  # abscissas of the values, (n,)
    directions: tuple[Mark, ...]
    rays: tuple[Mark, ...]
    points: tuple[Mark, ...]
    pieces: tuple[slice, ...]

    @property
    def pole(self) -> Mark:
        """The pole."""
        return self.axes.pole

    @cached_property
    def values(self) -> Floats:
        """The derivative at `middles`, (n,), in units of y over units of x."""
        return ordinates(self.points) / self.distance

    @cached_property
    def slacks(self) -> Floats:
        """How far rounding can have moved each value, (n,)."""
        return np.asarray(EPS * ROUNDINGS * np.abs(self.values))


def integral(
    board: Board,
    name: str,
    edges: npt.ArrayLike,
    means: npt.ArrayLike,
    pole: float = 1.0,
    start: float = 0.0,
    why: Reasons = SILENT,
) -> Integral:
    """Integrate a diagram by chords from the mean ordinate of each strip; it is exact where the means are true.

    Each chord is parallel to the ray from the pole to the mean ordinate carried to the y axis. Jumps must lie on edges
    (`geometry.strips`): each side has its own mean ordinate.

    >>> curve = integral(Board("works"), "A", [0, 1, 3], [2, -1], pole=4.0)
    >>> curve.values.tolist(), complex(curve.points[1].point)
    ([0.0, 2.0, 0.0], (1+0.5j))
    """
    x, y = rising(edges), np.asarray(means, dtype=float)
    if len(y) != len(x) - 1:
        raise ValueError(f"expected a mean ordinate for each of {len(x) - 1} strips, found {len(y)}")
    axes = axes_of(board, name, pole, why)
    refuse_steep(y, pole)
    points = [board.given(f"{name}:0", complex(x[0], start / pole), why.start)]
    drawn = []
    for number, (width, mean) in enumerate(zip(np.diff(x).tolist(), y.tolist(), strict=True), 1):
        drawn.append(_strip(board, f"{name}:", number, axes, points[-1], (width, mean), why))
        points.append(drawn[-1][-1])
    ordinates, carried, rays, chords, _ = zip(*drawn, strict=True)
    return Integral(board, name, axes, pole, x, y, ordinates, carried, rays, chords, tuple(points))


def _strip(
    board: Board, name: str, k: int, axes: StripAxes, last: Mark, sizes: tuple[float, float], why: Reasons
) -> tuple[Mark, ...]:
    """Draw the chord of one strip: all its vectors are laid off from the last point, so that no digit is lost."""
    width, mean = sizes
    ordinate = board.given(f"{name}y_{k}", complex(0.0, mean), why.mean)
    carried = board.lay_off(f"{name}{k}'", axes.origin, ordinate, why.carried)
    ray = board.join(f"{name}P{k}'", axes.pole, carried, why.ray)
    strip = board.given(f"{name}Δx_{k}", complex(width), why.strip)
    end = board.lay_off(f"{name}{k}°", last, strip, why.edge)
    edge = board.square(f"{name}x_{k}", end, axes.x, why.edge)
    chord = board.parallel(f"{name}{k - 1}-{k}", last, ray, why.chord)
    return ordinate, carried, ray, chord, board.meet(f"{name}{k}", edge, chord, why=why.integral)


def derivative_by_chords(
    board: Board,
    name: str,
    xs: npt.ArrayLike,
    ys: npt.ArrayLike,
    pole: float = 1.0,
    breaks: Iterable[float] = (),
    why: Reasons = SILENT,
) -> Derivative:
    """Differentiate a curve by the chords of its parts: each is the mean derivative, set over the part's middle.

    A corner of the curve must be one of `xs` and is told by `breaks`: the derivative's curve is not joined across it.

    >>> curve = derivative_by_chords(Board("speeds"), "v", [0, 1, 3], [0, 2, 8])
    >>> curve.middles.tolist(), curve.values.tolist()
    ([0.5, 2.0], [2.0, 3.0])
    """
    x, smooth = rising(xs), pieces(xs, breaks)
    axes = axes_of(board, name, pole, why)
    points = curve(board, name, x, ys, why)
    refuse_steep(np.diff(ys), np.diff(x))
    rows = []
    for k, (point, other) in enumerate(pairwise(points), 1):
        chord = board.join(f"{name}:{k - 1}-{k}", point, other, why.part)
        half = board.turn(f"{name}:{k}/2", chord, 0.5, why.middle)
        middle = board.lay_off(f"{name}:{k}°", point, half, why.middle)
        rows.append(_slope(board, f"{name}:", k, axes, (chord, middle), why))
    return _derivative(board, name, axes, pole, middles(x), rows, smooth)


def derivative_by_tangents(
    board: Board,
    name: str,
    xs: npt.ArrayLike,
    ys: npt.ArrayLike,
    slopes: npt.ArrayLike,
    pole: float = 1.0,
    why: Reasons = SILENT,
) -> Derivative:
    """Differentiate a curve by its tangents at points, given by their slopes dy/dx: each value is the point's own.

    A corner stands twice in `xs`, with the tangent of either side.

    >>> curve = derivative_by_tangents(Board("speeds"), "v", [1, 2, 2], [1, 4, 4], [2, 4, -1])
    >>> curve.values.tolist(), curve.pieces
    ([2.0, 4.0, -1.0], (slice(0, 2, None), slice(2, 3, None)))
    """
    x = np.asarray(xs, dtype=float)
    axes = axes_of(board, name, pole, why)
    points = curve(board, name, x, ys, why)
    refuse_steep(slopes, 1.0)
    rows = []
    for k, (point, slope) in enumerate(zip(points, np.asarray(slopes, dtype=float).tolist(), strict=True)):
        tangent = board.given(f"{name}:τ_{k}", complex(1.0, slope), why.tangent)
        rows.append(_slope(board, f"{name}:", k, axes, (tangent, point), why))
    bounds = [0, *(np.flatnonzero(np.diff(x) == 0) + 1).tolist(), len(x)]
    return _derivative(board, name, axes, pole, x, rows, runs(bounds))


def _slope(
    board: Board, name: str, k: int, axes: StripAxes, along: tuple[Mark, Mark], why: Reasons
) -> tuple[Mark, Mark, Mark]:
    """Draw the ray along a direction, and carry what it cuts off the y axis over the place of the value."""
    direction, place = along
    ray = board.parallel(f"{name}P{k}'", axes.pole, direction, why.slope_ray)
    cut = board.meet(f"{name}{k}'", axes.y, ray, why=why.cut)
    level = board.parallel(f"{name}y_{k}", cut, axes.x, why.level)
    ordinate = board.square(f"{name}x_{k}", place, axes.x, why.middle)
    return direction, ray, board.meet(f"{name}{k}''", level, ordinate, why=why.derivative)


def _derivative(
    board: Board,
    name: str,
    axes: StripAxes,
    distance: float,
    places: Floats,
    rows: Sequence[tuple[Mark, Mark, Mark]],
    smooth: tuple[slice, ...],
) -> Derivative:
    directions, rays, points = zip(*rows, strict=True)
    return Derivative(board, name, axes, distance, places, directions, rays, points, smooth)
