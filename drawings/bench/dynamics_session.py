"""A session at the bench on a machine's motion: chords, points and positions against the exact turn (испытание)."""

from __future__ import annotations

from collections.abc import Callable

from drawings.bench.session import BUDGET, Order
from plans.bench import dynamics
from plans.bench import run as runs
from plans.bench.calculus import COUNTS
from plans.bench.computer import machine
from plans.bench.result import Bench, Row
from plans.dynamics.link import reduced_link
from plans.scene.scene import Scene
from plans.study import Study

QUICK = 3  # rounds: of no more than these the finest strips are left out
NO_CYCLE = "the crank cannot turn fully: there is no cycle to be judged"


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session on the motion of a scene's machine."""
    there, study = machine(), Study(scene)
    own, comparison = study["dynamics"], study.comparison("dynamics")
    if comparison.turn is None:
        return Bench(scene.heading(), there, (), (), (NO_CYCLE,), order.accepted)
    tell("strips of a turn")
    counts = COUNTS[:-2] if order.rounds <= QUICK else COUNTS
    truth = dynamics.Truth(own.task, comparison.turn)
    found, words = dynamics.rows(own.reduction, truth, order.rounds, BUDGET, counts)
    tell("the run")
    found += _run(study)
    tell("")
    return Bench(scene.heading(), there, tuple(found), (), tuple(words), order.accepted)


def _run(study: Study) -> list[Row]:
    """Judge the table of the run at several steps; nothing of a machine without a motor that starts."""
    own = study["dynamics"]
    if own.run is None or own.run.failure is not None:
        return []
    link = reduced_link(own.works, own.constant)
    return runs.rows(runs.step_errors(link, own.motor, own.run_task))
