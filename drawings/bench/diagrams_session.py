"""A session at the bench on the kinematic diagrams of a scene's output: error against run time (испытание диаграмм)."""

from __future__ import annotations

from collections.abc import Callable

from drawings.bench.session import BUDGET, Order
from plans.bench import diagrams
from plans.bench.computer import machine
from plans.bench.result import Bench
from plans.scene.scene import Scene

COUNTS, QUICK_COUNTS = diagrams.COUNTS, diagrams.COUNTS[:3]


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session on the diagrams of a scene."""
    there = machine()
    tell("the diagrams")
    rows, told = diagrams.rows(scene, order.rounds, BUDGET, COUNTS if order.startup else QUICK_COUNTS)
    tell("")
    return Bench(scene.heading(), there, tuple(rows), (), tuple(told), order.accepted)
