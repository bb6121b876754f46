"""Strips of a diagram's axis: equal, with an edge on every jump, and none too short to be drawn."""

from __future__ import annotations

import math

import pytest

from geometry.strips import departure, pieces, strips


@pytest.mark.parametrize("one", [-0.1, 4.1, math.nan])
def test_a_break_outside_the_axis_is_refused(one: float) -> None:
    with pytest.raises(ValueError, match="outside the axis"):
        strips(0, 4, 4, [one])


@pytest.mark.parametrize(("start", "end", "count"), [(0, 1, 0), (1, 1, 4), (2, 1, 4), (0, math.nan, 3)])
def test_no_strips_and_no_axis_are_refused(start: float, end: float, count: int) -> None:
    with pytest.raises(ValueError, match="at least one strip"):
        strips(start, end, count)


def test_pieces_lie_between_breaks_and_the_ends_of_the_axis() -> None:
    assert pieces([0, 1, 2, 3], []) == (slice(0, 3),)
    assert pieces([0, 1, 2, 3], [0, 2, 3]) == (slice(0, 2), slice(2, 3))


def test_what_is_unknown_is_infinitely_out_and_nothing_of_nothing_is_not() -> None:
    assert departure([0.0, math.nan], [0.0, 1.0]) == (math.inf, math.inf, 1)
    assert departure([0.0, 0.0], [0.0, 0.0]) == (0.0, 0.0, 0)
    assert departure([0.0, 1.0], [0.0, 0.0]).share == math.inf
