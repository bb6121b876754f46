"""Tests over many rows in one item: a thousand items of one line each cost more than what they test."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from inspect import signature
from typing import Any

import pytest

SEEN = (Exception, pytest.fail.Exception)


def over(names: str, rows: Iterable[Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Run a test for every row, in one item; all rows that fail are told, each with what it is.

    Names are one or several with commas, as of `pytest.mark.parametrize`; fixtures are shared by the rows.
    """
    rows, keys = list(rows), names.split(", ")

    def decorate(test: Callable[..., None]) -> Callable[..., None]:
        def loop(**fixtures: Any) -> None:
            failures = []
            for row in rows:
                given = dict(zip(keys, row if len(keys) > 1 else (row,), strict=True))
                try:
                    test(**fixtures, **given)
                except SEEN as failure:
                    failure.add_note("the row: " + ", ".join(f"{key} = {str(given[key])[:200]}" for key in keys))
                    failures.append(failure)
            assert rows
            if failures:
                raise failures[0] if len(failures) == 1 else BaseExceptionGroup("rows that fail", failures)

        form = signature(test)
        left = [parameter for name, parameter in form.parameters.items() if name not in keys]
        loop.__name__, loop.__doc__, loop.__module__ = test.__name__, test.__doc__, test.__module__
        loop.__signature__ = form.replace(parameters=left)  # type: ignore[attr-defined]
        return loop

    return decorate
