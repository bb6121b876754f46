"""The bench of a machine's motion: the orders that the methods promise, against the exact turn."""

from __future__ import annotations

import numpy as np
import pytest

from plans.bench.calculus import order
from plans.bench.dynamics import CHORDS, DRIVING, EXACT, MEAN, POINTS, WHOLE, Truth, by_chords, rows
from plans.study import Study
from tests.plans.dynamics_scenes import PLANING, PUSHED, study

COUNTS = (48, 96, 192, 384)


def truth_of(made: Study) -> Truth:
    return Truth(made["dynamics"].task, made.comparison("dynamics").turn)


def test_chords_find_the_flywheel_to_the_second_order() -> None:
    """Strips with an edge on every jump keep the order."""
    made = study(PLANING)
    truth, reduction = truth_of(made), made["dynamics"].reduction
    errors = [truth.errors(*by_chords(reduction, truth.task, count)).kinds[WHOLE] for count in COUNTS]
    assert order(errors, COUNTS) == pytest.approx(2.0, abs=0.1)


def test_chords_find_the_works_of_a_smooth_load_to_the_second_order() -> None:
    made = study(PUSHED)
    truth, errors = truth_of(made), []
    for count in COUNTS:
        cycle, _ = by_chords(made["dynamics"].reduction, truth.task, count)
        errors.append(float(np.abs(cycle.work - truth.found.work(cycle.turned)).max()))
    assert order(errors, COUNTS) == pytest.approx(2.0, abs=0.1)


def test_the_planing_machine_s_flywheel_is_that_of_the_book() -> None:
    """M4.9: J0 = 36.73754573 kg*m2."""
    wheel = truth_of(study()).wheel
    assert wheel is not None and wheel.whole == pytest.approx(36.73754573, rel=1e-9)


def test_of_a_smooth_load_a_few_positions_give_the_driving_moment() -> None:
    truth = truth_of(study(PUSHED))
    assert truth.mean(36).kinds[DRIVING] <= 1e-14
    assert truth_of(study(PLANING)).mean(36).kinds[DRIVING] > 1e-3


def test_rows_and_words_of_a_session() -> None:
    made = study()
    truth = truth_of(made)
    found, words = rows(made["dynamics"].reduction, truth, lambda: truth.found, 1, 0.0, (12, 24, 48))
    assert [row.technique for row in found] == [CHORDS] * 3 + [POINTS] * 3 + [EXACT] + [MEAN] * 3
    assert all(row.times is not None for row in found[:7])
    assert any(word.startswith(f"  {CHORDS}: order") for word in words)
