"""Tests of which the everyday run makes a part; `python -m pytest --whole` makes these whole, and no others."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import settings

SEEDED = "seeded"  # the profile of runs on a planted fault: properties are whole in them

whole = False  # set by tests/conftest.py before any test is imported


def examples(part: int, all_of_them: int = 100) -> Callable[[Any], Any]:
    """Give a property fewer examples in the everyday run."""

    def decorate(test: Any) -> Any:
        return pytest.mark.part(settings(max_examples=all_of_them if whole else part)(test))

    return decorate
