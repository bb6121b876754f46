"""Strips of a diagram's axis: equal, with an edge on every jump, and none too short to be drawn."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from geometry.strips import SLIVER, departure, middles, pieces, strips
from tests.parts import examples

axes = st.tuples(st.floats(-1e3, 1e3), st.floats(1e-3, 1e3)).map(lambda pair: (pair[0], pair[0] + pair[1]))


@examples(6)
@given(axes, st.integers(1, 64), st.lists(st.floats(0, 1), max_size=6))
def test_every_break_is_an_edge_or_as_good_as_on_one_and_no_strip_is_a_sliver(
    axis: tuple[float, float], count: int, shares: list[float]
) -> None:
    start, end = axis
    breaks = [min(start + share * (end - start), end) for share in shares]
    edges = strips(start, end, count, breaks)
    near = SLIVER * (end - start) / count
    rounding = 4 * np.finfo(float).eps * max(abs(start), abs(end))
    assert (edges[0], edges[-1]) == (start, end)
    assert np.diff(edges).min() > near - rounding
    assert all(np.abs(edges - one).min() <= near for one in breaks)
    # The equal edges keep their places, or lie where a break almost is.
    assert all(np.abs(edges - one).min() <= near + rounding for one in np.linspace(start, end, count + 1))


def test_an_edge_that_a_break_nearly_touches_is_the_break() -> None:
    close = 1 + 1e-12
    assert strips(0, 4, 4, [close]).tolist() == [0, close, 2, 3, 4]
    assert strips(0, 4, 4, [1.01]).tolist() == [0, 1, 1.01, 2, 3, 4]


def test_one_break_found_twice_is_one_and_the_ends_hold() -> None:
    assert strips(0, 4, 2, [1.5, 1.5 + 1e-12, 1e-12, 4 - 1e-12, 0, 4]).tolist() == [0, 1.5, 2, 4]


@pytest.mark.parametrize("one", [-0.1, 4.1, math.nan])
def test_a_break_outside_the_axis_is_refused(one: float) -> None:
    with pytest.raises(ValueError, match="outside the axis"):
        strips(0, 4, 4, [one])


@pytest.mark.parametrize(("start", "end", "count"), [(0, 1, 0), (1, 1, 4), (2, 1, 4), (0, math.nan, 3)])
def test_no_strips_and_no_axis_are_refused(start: float, end: float, count: int) -> None:
    with pytest.raises(ValueError, match="at least one strip"):
        strips(start, end, count)


def test_a_middle_lies_within_its_strip_however_short() -> None:
    edges = strips(6, 7, 8, [6.3, 6.3 + 2 * SLIVER / 8])
    assert np.all((edges[:-1] < middles(edges)) & (middles(edges) < edges[1:]))


def test_pieces_lie_between_breaks_and_the_ends_of_the_axis() -> None:
    assert pieces([0, 1, 2, 3], []) == (slice(0, 3),)
    assert pieces([0, 1, 2, 3], [0, 2, 3]) == (slice(0, 2), slice(2, 3))


def test_the_true_error_is_told_where_it_is_largest() -> None:
    found = departure([1.0, 2.5, -8.25], [1.0, 2.0, -8.0])
    assert (found.size, found.share, found.at) == (0.5, 0.0625, 1)


def test_what_is_unknown_is_infinitely_out_and_nothing_of_nothing_is_not() -> None:
    assert departure([0.0, math.nan], [0.0, 1.0]) == (math.inf, math.inf, 1)
    assert departure([0.0, 0.0], [0.0, 0.0]) == (0.0, 0.0, 0)
    assert departure([0.0, 1.0], [0.0, 0.0]).share == math.inf
