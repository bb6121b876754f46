"""Slicing of a sheet: no better cut is overlooked, all stands in its room; and how bare a sheet is told to be."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as some

from drawings.layout.picture import BANDS, outline
from drawings.layout.request import fewest, partings
from drawings.layout.slicing import GAP, Cuts, Piece, Size, Slicing, Tree, pieces
from drawings.layout.standing import Occupant, Standing, bareness, natural
from drawings.page.page import Field
from tests.drawings.emptiness import largest

LARGE = (1000.0, 1000.0)
lengths = some.integers(5, 90).map(float)
units_of = some.lists(some.lists(some.tuples(lengths, lengths), min_size=1, max_size=2), min_size=1, max_size=4)


def every(units: Sequence[Sequence[Size]]) -> set[Size]:
    """All sizes of all slicings, by trying all."""
    if len(units) == 1:
        return set(units[0])
    found = set()
    for at in range(1, len(units)):
        for (w, h), (wide, high) in product(every(units[:at]), every(units[at:])):
            found |= {(w + wide + GAP, max(h, high)), (max(w, wide), h + high + GAP)}
    return found


@given(units_of)
def test_no_size_of_any_slicing_beats_those_that_are_kept(units: list[list[Size]]) -> None:
    sizes = Slicing(units, Cuts(LARGE)).run(0, len(units) - 1).sizes
    best = {a for a in every(units) if not any(b[0] <= a[0] and b[1] <= a[1] and a != b for b in every(units))}
    if len(best) <= 12:
        assert {tuple(map(float, size)) for size in sizes} == best


@given(units_of)
def test_a_tree_has_the_size_that_it_is_kept_for_and_all_units_in_order(units: list[list[Size]]) -> None:
    slicing, last = Slicing(units, Cuts(LARGE), (30.0, 20.0)), len(units) - 1
    for k, size in enumerate(slicing.sheet(0, last).sizes):
        tree = slicing.sheet(0, last).tree(k)
        chosen = {piece.unit: piece.choice for piece in pieces(tree)}
        assert list(chosen) == [*range(len(units)), len(units)]
        sizes = {unit: (30.0, 20.0) if unit > last else units[unit][choice] for unit, choice in chosen.items()}
        assert natural(tree, sizes) == pytest.approx(tuple(size))


@given(units_of, some.booleans())
def test_what_is_cut_stands_in_its_room_and_on_nothing_else(units: list[list[Size]], figures: bool) -> None:
    slicing, last = Slicing(units, Cuts(LARGE)), len(units) - 1
    tree: Tree = slicing.run(0, last).tree(0)
    sizes = {piece.unit: units[piece.unit][piece.choice] for piece in pieces(tree)}
    wide, high = natural(tree, sizes)
    room = Field(10.0, 10.0, 10.0 + 1.3 * wide, 10.0 + 1.2 * high)
    boxes = Standing({k: Occupant(size, figures) for k, size in sizes.items()}, room).boxes(tree)
    assert list(boxes) == list(range(len(units)))
    assert all(inside(box, room) for box in boxes.values())
    assert all(apart(one, other) for one, other in combinations(boxes.values(), 2))


def test_what_does_not_fit_its_room_has_no_size() -> None:
    slicing = Slicing([[(60.0, 60.0)], [(60.0, 60.0)]], Cuts((100.0, 100.0)))
    assert len(slicing.run(0, 0).sizes) == 1 and len(slicing.run(0, 1).sizes) == 0
    assert slicing.run(0, 0).tree(0) == Piece(0, 0)


@given(some.lists(some.lists(some.booleans(), min_size=5, max_size=5), min_size=1, max_size=5))
def test_the_largest_bare_rectangle_is_found(rows: list[list[bool]]) -> None:
    grid = np.array(rows)
    count, (low, high, left, right) = largest(grid)
    sides = [combinations(range(size + 1), 2) for size in grid.shape]
    found = max((b - a) * (d - c) * (not grid[a:b, c:d].any()) for (a, b), (c, d) in product(*map(list, sides)))
    assert count * grid.size == pytest.approx(found)
    assert not grid[low:high, left:right].any()


@given(some.lists(some.tuples(*[some.integers(-5, 80)] * 4), max_size=8))
def test_boxes_leave_the_same_bare_as_the_cells_that_they_take(sides: list[tuple[int, int, int, int]]) -> None:
    field, grid = Field(0.0, 0.0, 72.0, 48.0), np.zeros((48, 72), bool)
    boxes = [(*sorted((a, c)), *sorted((b, d))) for a, b, c, d in sides]
    for left, right, low, high in boxes:
        grid[max(low, 0) : max(high, 0), max(left, 0) : max(right, 0)] = True
    told = bareness([Field(left, low, right, high) for left, right, low, high in boxes], field)
    assert told == pytest.approx(largest(grid)[0])


def test_boxes_are_told_as_bare_as_they_leave_a_sheet() -> None:
    field = Field(20.0, 5.0, 415.0, 292.0)
    box = Field(20.0, 5.0, 20.0 + field.width / 3, 292.0)
    assert bareness([box], field) == pytest.approx(2 / 3, abs=0.02)
    assert bareness([field], field) == 0.0


points = some.lists(some.tuples(lengths, lengths), min_size=1, max_size=6).map(lambda own: [complex(*p) for p in own])


@given(points, some.lists(some.floats(0.0, 1.0), min_size=6, max_size=6))
def test_no_line_between_points_of_a_figure_leaves_its_outline(values: list[complex], shares: list[float]) -> None:
    left, low = min(v.real for v in values), min(v.imag for v in values)
    wide, high = max(v.real for v in values) - left, max(v.imag for v in values) - low
    bands = outline(values)
    assert bands[0].low == 0.0 and bands[-1].high == 1.0 and len(bands) <= BANDS
    for (one, other), share in product(combinations(values, 2), shares):
        x, y = one.real + share * (other.real - one.real) - left, one.imag + share * (other.imag - one.imag) - low
        within = [band for band in bands if (band.low - 1e-9) * high <= y <= (band.high + 1e-9) * high]
        assert any((band.left - 1e-9) * wide <= x <= (band.right + 1e-9) * wide for band in within)


def test_the_corner_beside_a_slope_is_bare() -> None:
    bands = outline([0j, 80 + 80j])  # a line on the diagonal
    assert [(band.left, band.right) for band in bands] == [(k / BANDS, (k + 1) / BANDS) for k in range(BANDS)]


def test_the_fewest_sheets_are_taken_and_filled_evenly() -> None:
    areas = [3.0, 1.0, 1.0, 1.0]
    fits = lambda i, j: sum(areas[i : j + 1]) <= 5.0  # noqa: E731 - as short as the rule that it states
    assert fewest(4, fits) == 2
    assert partings(4, 2, fits, areas)[0] == ((0, 0), (1, 3))
    assert fewest(4, lambda i, j: (i, j) != (2, 2)) == 1 and fewest(1, lambda i, j: False) == 0


def apart(one: Field, other: Field) -> bool:
    beside = one.right <= other.left + 1e-6 or other.right <= one.left + 1e-6
    return beside or one.top <= other.bottom + 1e-6 or other.top <= one.bottom + 1e-6


def inside(box: Field, room: Field) -> bool:
    low = box.left >= room.left - 1e-6 and box.bottom >= room.bottom - 1e-6
    return low and box.right <= room.right + 1e-6 and box.top <= room.top + 1e-6
