"""A session at the bench on a cyclogram: notches, trial and roots, error against run time (испытание циклограммы)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from drawings.bench.session import BUDGET, Order
from plans.bench import cyclogram
from plans.bench.clock import interleaved
from plans.bench.computer import machine
from plans.bench.result import Bench, Row
from plans.cyclogram.study import CYCLOGRAM
from plans.scene.scene import Scene
from plans.study import Study


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session on the characteristic positions of a scene."""
    there, found = machine(), Study(scene)[CYCLOGRAM]
    true, ways = cyclogram.truth(found), cyclogram.ways(found)
    tell("the characteristic positions")
    judged = [cyclogram.errors(run(), true) if true else None for _, run in ways]
    taken = interleaved([run for _, run in ways], order.rounds, BUDGET)
    names, count = [name for name, _ in ways], len(found.stations.asked)
    rows = [
        Row(name, count, count, errors, times=times) for name, errors, times in zip(names, judged, taken, strict=True)
    ]
    tell("")
    return Bench(scene.heading(), there, tuple(rows), (), tuple(_words(order, bool(true))), order.accepted)


def _words(order: Order, judged: bool) -> Iterator[str]:
    yield cyclogram.DEFINED
    yield cyclogram.TRUE if judged else cyclogram.NONE
    yield f"accepted: an error of at most {order.accepted:.0e} of a turn"
    yield f"time: wall time of one run, techniques in turns, {order.rounds} times each; a first run is not timed"
