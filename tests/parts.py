"""Tests of which the everyday run makes a part; `python -m pytest --whole` makes these whole, and no others."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import repeat
from typing import Any

import pytest
from hypothesis import settings

whole = False  # set by tests/conftest.py before any test is imported


def some(rows: Iterable[Any], every: int, names: Iterable[str | None] = repeat(None)) -> list[Any]:
    """Keep every so many rows of a test in the everyday run, the first among them; the rest are left to `--whole`.

    What is left out is not even collected: that costs as much as many a test.
    """
    return [
        pytest.param(row, id=name, marks=pytest.mark.rest if place % every else ())
        for place, (row, name) in enumerate(zip(rows, names, strict=False))
        if whole or not place % every
    ]


def several(rows: Iterable[tuple[Any, ...]], every: int) -> list[Any]:
    """Keep every so many rows of a test of several arguments, as `some` does of a test of one."""
    return [pytest.param(*one.values[0], marks=one.marks) for one in some(rows, every)]


def first(rows: Iterable[Any], names: Iterable[str | None] = repeat(None)) -> list[Any]:
    """Keep the first row of a test in the everyday run; the rest, each of which takes long, are left to `--whole`."""
    every = list(rows)
    return some(every, len(every) or 1, names)


def examples(part: int, all_of_them: int = 100) -> Callable[[Any], Any]:
    """Give a property fewer examples in the everyday run."""

    def decorate(test: Any) -> Any:
        return pytest.mark.part(settings(max_examples=all_of_them if whole else part)(test))

    return decorate
