"""A session at the bench on a machine's motion: flywheel, graphical integration, run (испытание динамики машины)."""

from __future__ import annotations

from collections.abc import Callable

from drawings.bench.session import BUDGET, Order
from plans.analytic.dynamics.exact import Exact
from plans.bench import calculus, dynamics, run, sampled_turn
from plans.bench.computer import machine
from plans.bench.result import Bench, Row
from plans.checks.compare import compare
from plans.checks.dynamics_comparison import exact_turn
from plans.dynamics.link import reduced_link
from plans.dynamics.study import DynamicsStudy
from plans.model.order import VELOCITIES
from plans.scene.scene import Scene
from plans.study import Study

STRIPS = (12, 24, 96, 384, 1024, 4096)
QUICK_STRIPS = (12, 24, 96, 384)
ROUNDS = 5  # at most: a turn of thousands of strips takes the better part of a second
NO_FLYWHEEL = "no fluctuation is asked for: no flywheel is judged"


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session on the motion of a scene's machine."""
    there, study = machine(), Study(scene)
    found: DynamicsStudy = study["dynamics"]
    rounds, counts = min(order.rounds, ROUNDS), STRIPS if order.startup else QUICK_STRIPS
    tell("graphical integration")
    rows, words = calculus.rows(rounds, BUDGET, counts)
    tell("the flywheel")
    motion = compare(found.linkage, VELOCITIES.number)

    def exact() -> Exact:
        return exact_turn(found, motion)

    more, told = _flywheel(found, exact, rounds, counts)
    few, meant = sampled_turn.rows(exact(), found.task, rounds, BUDGET, counts)
    tell("the run")
    last, said = _run(found)
    tell("")
    every = (*rows, *more, *few, *last)
    return Bench(scene.heading(), there, every, (), (*words, *told, *meant, *said), order.accepted)


def _flywheel(
    study: DynamicsStudy, exact: Callable[[], Exact], rounds: int, counts: tuple[int, ...]
) -> tuple[list[Row], list[str]]:
    if study.task.delta is None:
        return [], [NO_FLYWHEEL]
    return dynamics.rows(study, exact, rounds, BUDGET, counts)


def _run(study: DynamicsStudy) -> tuple[list[Row], list[str]]:
    """Give the rows of the table of a run by its step, of a scene with a motor that starts."""
    if study.motor is None or study.run is None or study.run.failure is not None:
        return [], []
    link = reduced_link(study.works, study.constant)
    return run.rows(run.step_errors(link, study.motor, study.run_task)), [run.DEFINED]
