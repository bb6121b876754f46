"""A diagram to be integrated or differentiated: its axes, pole and curve, and why each step is drawn (диаграмма)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Board, Mark
from geometry.meet import UNBORNE
from geometry.strips import Floats

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


class Axes(NamedTuple):
    """The axes of a diagram and the pole on the left of them: the origin, the direction of x, the y axis (полюс)."""

    origin: Mark
    x: Mark
    y: Mark
    pole: Mark


def axes_of(board: Board, name: str, distance: float, why: Reasons) -> Axes:
    """Put the axes down with the pole on the left of them, so that a positive ordinate rises."""
    if not 0 < distance < np.inf:
        raise ValueError(f"the pole distance must be more than 0, found {distance}")
    origin = board.given(f"{name}:O", 0j, why.axes)
    x = board.given(f"{name}:x", 1 + 0j, why.axes)
    y = board.square(f"{name}:y", origin, x, why.axes)
    return Axes(origin, x, y, board.given(f"{name}:P", complex(-distance), why.pole))


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
    return np.array([complex(one.point).imag for one in points])
