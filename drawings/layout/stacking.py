"""The ways to stack figures in columns, their order kept (варианты столбцов)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, product
from typing import TypeVar

FEW = 4  # loose pictures that are stacked in every way; more of them only in columns of about equal numbers

T = TypeVar("T")


def even(units: Sequence[T]) -> list[tuple[tuple[T, ...], ...]]:
    """List the ways to stack units in columns of about equal numbers, their order kept.

    >>> [[len(column) for column in way] for way in even("abcde")]
    [[1, 1, 1, 1, 1], [2, 2, 1], [3, 2], [5]]
    """
    count = len(units)
    highs = sorted({-(-count // columns) for columns in range(1, count + 1)})
    return [tuple(tuple(units[k : k + high]) for k in range(0, count, high)) for high in highs] or [()]


def stacks(loose: Sequence[T]) -> list[tuple[tuple[T, ...], ...]]:
    """List the ways to stack pictures in columns, their order kept.

    >>> [[len(column) for column in way] for way in stacks("abc")]
    [[3], [2, 1], [1, 2], [1, 1, 1]]
    """
    count = len(loose)
    if count > FEW:
        return even(loose)
    ways = []
    for broken in product((False, True), repeat=max(count - 1, 0)):
        cuts = [0, *(k + 1 for k, cut in enumerate(broken) if cut), count]
        ways.append(tuple(tuple(loose[a:b]) for a, b in pairwise(cuts) if b > a))
    return sorted(ways, key=len)
