"""A session at the bench on a mechanism that is balanced: mass centre by three ways, best share (уравновешивание)."""

from __future__ import annotations

from collections.abc import Callable

from drawings.bench import balance_sheet
from drawings.bench.session import BUDGET, NothingToMeasure, Order
from plans.balance.study import BalanceStudy
from plans.bench import balance
from plans.bench.computer import machine
from plans.bench.result import Bench
from plans.bench.roads import prepared
from plans.scene.scene import Scene
from plans.study import Study

ROUNDS = 5  # at most: the plans under a mass centre have sessions of their own


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session on the balance of a scene's mechanism."""
    there = machine()
    found: BalanceStudy = Study(scene)["balance"]
    tell("the mass centre")
    studies = [prepared(scene, count) for count in order.positions]
    if any(study.lost.all() for study in studies):
        raise NothingToMeasure(f"{scene.file}: no position can be assembled, so there is nothing to measure")
    rows, words = balance.rows(found, studies, min(order.rounds, ROUNDS), BUDGET)
    tell("the sheet of balancing")
    rows.append(
        balance_sheet.row(scene, balance.ground(found.linkage, found.points()), min(order.rounds, ROUNDS), BUDGET)
    )
    tell("")
    return Bench(scene.heading(), there, tuple(rows), (), tuple(words), order.accepted)
