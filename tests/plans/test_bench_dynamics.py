"""The bench of a machine's motion: the order of the chords, and the flywheel of the same strips by both roads."""

from __future__ import annotations

import pytest

from plans.bench import machine as bench
from plans.bench.trial import order
from plans.dynamics.quantities import exact_turn
from plans.linkage.quantities import compare
from tests.plans.dynamics_scenes import study

COUNTS = (24, 96, 384)


def test_the_flywheel_by_chords_is_of_order_two() -> None:
    """Performance goal 10: 2.0 +- 0.1 where every jump has an edge."""
    machine = study()["dynamics"]
    motion = compare(machine.linkage, 1)
    rows = bench.by_strips(machine, lambda: exact_turn(machine, motion), 1, COUNTS).rows[:3]
    assert order([row.error for row in rows], COUNTS) == pytest.approx(2.0, abs=0.1)


def test_its_rows_tell_each_way_at_each_number_of_strips() -> None:
    machine = study()["dynamics"]
    motion = compare(machine.linkage, 1)
    rows, words, *_ = bench.by_strips(machine, lambda: exact_turn(machine, motion), 1, COUNTS[:2])
    told = [(row.technique, row.positions) for row in rows]
    assert told == [
        *((way, count) for way in (bench.CHORDS, bench.SAMPLED) for count in COUNTS[:2]),
        (bench.EXACT, None),
    ]
    assert rows[-1].error < 1e-12
    assert any("order 2" in word or "order 1.9" in word for word in words)
