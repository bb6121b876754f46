"""A turn known at some positions alone: what a smooth load allows and a jump does not."""

from __future__ import annotations

import pytest

from plans.bench.machine import MEAN, POINTS, by_points, by_positions
from plans.study import Study
from tests.plans.dynamics_scenes import study


def exact(made: Study):
    return made.comparison("dynamics").turn


def test_extremes_at_edges_come_to_the_book_s_flywheel_from_below() -> None:
    """M4.9: J0 = 36.73754573 kg*m2; what is looked for among fewer places is never too far."""
    made = study()
    task, found = made["dynamics"].task, exact(made)
    coarse, fine = (by_points(found, task, count) for count in (24, 3072))
    assert coarse < fine < 36.73754573
    assert fine == pytest.approx(36.73754573, rel=1e-3)


def test_rows_of_both() -> None:
    made = study()
    found = by_positions(exact(made), made["dynamics"].task, 1, (12, 24)).rows
    assert [row.technique for row in found] == [MEAN] * 3 + [POINTS] * 2
    assert all(row.note for row in found[:3]) and all(row.times is not None for row in found[3:])
