"""The bench of chord integration: its orders, its rows and words. No test asks how long anything takes."""

from __future__ import annotations

import numpy as np
import pytest

from geometry.strips import middles
from plans.bench.chords import CONSTANT, DEFINED, DIAGRAMS, INSIDE, NOT_SO, SMOOTH, integration

BY_NAME = {one.name: one for one in DIAGRAMS}


@pytest.mark.parametrize("name", list(BY_NAME))
def test_the_integral_in_closed_form_is_that_of_the_diagram(name: str) -> None:
    """By a fine sum of rectangles, which shares nothing with the construction."""
    diagram = BY_NAME[name]
    edges = np.linspace(0, diagram.end, 100_001)
    areas = np.cumsum(diagram.ordinate(middles(edges)) * np.diff(edges))
    assert np.abs(diagram.whole(edges[1:]) - areas).max() <= 1e-4 * np.abs(areas).max()
    assert diagram.whole(np.zeros(1)) == 0


def test_a_row_stands_for_every_diagram_and_number_of_strips() -> None:
    found, words, *_ = integration(1, (12, 48))
    assert [(row.technique, row.positions) for row in found] == [(name, n) for name in BY_NAME for n in (12, 48)]
    assert all(row.times and row.error is not None for row in found)
    assert {row.note for row in found if row.technique == INSIDE} == {NOT_SO}
    assert words[0] == DEFINED
    assert "order 2.0" in next(word for word in words if SMOOTH in word)
    assert "exact" in next(word for word in words if CONSTANT in word)
