"""The clock of the bench: runs in turns, each within its budget. No test asks how long anything takes."""

from __future__ import annotations

import gc
from collections.abc import Callable

import pytest

from plans.bench import trial as clock
from plans.bench.trial import interleaved


@pytest.fixture
def ticking(monkeypatch: pytest.MonkeyPatch) -> Callable[[float], None]:
    """Replace the wall clock by one that only moves when it is told to."""
    now = [0.0]

    def pass_by(seconds: float) -> None:
        now[0] += seconds

    monkeypatch.setattr(clock, "perf_counter", lambda: now[0])
    return pass_by


def test_runs_take_turns() -> None:
    called: list[str] = []
    interleaved([lambda: called.append("A"), lambda: called.append("B"), lambda: called.append("C")], 3, 1.0)
    assert "".join(called) == "ABCABCABC"


def test_a_run_that_has_spent_its_budget_leaves_and_the_others_go_on(ticking: Callable[[float], None]) -> None:
    slow, quick = interleaved([lambda: ticking(3.0), lambda: ticking(0.5)], 8, 7.0)
    assert slow.seconds == (3.0, 3.0, 3.0)
    assert quick.seconds == (0.5,) * 8


def test_the_collector_of_garbage_rests_during_a_run_and_is_woken_after_it() -> None:
    seen: list[bool] = []
    assert gc.isenabled()
    interleaved([lambda: seen.append(gc.isenabled())], 1, 1.0)
    with pytest.raises(ZeroDivisionError):
        interleaved([lambda: 1 // 0], 1, 1.0)
    assert seen == [False]
    assert gc.isenabled()
