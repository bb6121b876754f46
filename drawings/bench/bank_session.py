"""A session at the bench on a bank: both roads to its harmonics, error against run time (испытание блока)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from drawings.bench.session import BUDGET, Order
from plans.bench import bank
from plans.bench.clock import interleaved
from plans.bench.computer import machine
from plans.bench.result import Bench, Row
from plans.model.balance.bank import BankTask
from plans.scene.scene import Scene

ONCE = "a bank has no positions of its own: --positions does nothing here, and positions are the ordinates of a turn"
OF_LINKAGE = "the harmonics of a linkage have no truth here: the bench judges banks of slider-cranks by their sizes"


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session on the bank of a scene."""
    task: BankTask = scene.meaning["bank"].task
    rows = tuple(_rows(task, order, tell)) if task.unit is not None else ()
    words = tuple(_words(order)) if rows else (OF_LINKAGE,)
    return Bench(scene.heading(), machine(), rows, (), words, order.accepted)


def _rows(task: BankTask, order: Order, tell: Callable[[str], None]) -> Iterator[Row]:
    true, ways = bank.truth(task), bank.ways(task)
    errors = [bank.errors(run(), true, task.members) for *_, run in ways]
    tell("the bank")
    taken = interleaved([run for *_, run in ways], order.rounds, BUDGET)
    for (name, count, _), error, times in zip(ways, errors, taken, strict=True):
        note = "so many ordinates as are taken on paper" if count in bank.FEW else ""
        yield Row(name, count, 0, error, times=times, note=note)
    tell("")


def _words(order: Order) -> Iterator[str]:
    yield bank.DEFINED
    yield bank.TRUE
    yield ONCE
    yield f"accepted: an error of at most {order.accepted:.0e} of the largest of its kind"
    yield f"time: wall time of one run, techniques in turns, {order.rounds} times each; a first run is not timed"
