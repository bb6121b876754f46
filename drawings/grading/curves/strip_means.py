"""The mean ordinates of the strips under a curve that a student drew otherwise at their edges (средние ординаты)."""

from __future__ import annotations

import numpy as np

from drawings.grading.curves.asked_figure import Sizes
from plans.model.dynamics import settled

ALIKE = 0.05  # by how much the factors at both edges of a strip may differ that are taken for one: a fair hand's do


def moved_means(drawn: Sizes, after: Sizes, before: Sizes, means: Sizes) -> Sizes:
    """Give the means of the strips by the values behind their edges, where the true ones are known.

    A strip whose edges are out by one factor is out by it, any other by how far both are; a jump keeps its share.

    >>> true = np.array([0.0, 2.0, 4.0])
    >>> moved_means(2 * true, true, true, np.array([1.1, 3.1])).tolist()
    [2.2, 6.2]
    >>> moved_means(true + 1, true, true, np.array([1.1, 3.1])).round(3).tolist()
    [2.1, 4.1]
    """
    after, before = (settled(row, float(np.abs(after).max())) for row in (after, before))
    end, jumps = before[1:], settled(before[1:] - after[1:], float(np.abs(after).max())) != 0
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        first = drawn[:-1] / after[:-1]
        last = np.where(jumps, first, drawn[1:] / end)
        first = np.where((after[:-1] == 0) & (drawn[:-1] == 0), last, first)
        last = np.where((end == 0) & (drawn[1:] == 0) & ~jumps, first, last)
        right = np.where(jumps, end * first, drawn[1:])
        one = np.abs(first - last) <= ALIKE
        moved = (drawn[:-1] - after[:-1] + right - end) / 2
    moved = np.where(np.isfinite(moved), moved, drawn[:-1] - after[:-1])
    factor = np.where(one, first, 0.0) / 2 + np.where(one, last, 0.0) / 2
    return np.where(one, means * factor, means + moved)
