"""The self-check of a written sheet of dynamics: graphs, loop, loads, flywheel, tables, notes (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.checks.dynamics_expected import INERTIA, MOMENTS, SPEEDS, SURPLUS, WORKS, Expected
from drawings.checks.dynamics_graphs import graphs
from drawings.checks.dynamics_loop import loop
from drawings.checks.dynamics_sizes import flywheel, loads
from drawings.checks.dynamics_told import equations, notes, positions, reduction, results
from drawings.checks.verify_bare_speeds import bare
from drawings.checks.verify_tachogram import tachogram
from drawings.checks.wrong import Wrong
from drawings.figures.dynamics import flywheel_sketch
from drawings.figures.dynamics.bare_speeds import NUMBERED
from drawings.figures.dynamics.load_diagram import NAME as LOAD
from drawings.figures.dynamics.plate import ENERGY, GRAPHS, LOWER, UPPER, WHOLE
from drawings.figures.dynamics.quantities import BEFORE
from drawings.figures.dynamics.tachogram import NAME as TACHOGRAM
from drawings.measure.measure import Measured
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from plans.checks.dynamics_comparison import DynamicsComparison
from plans.model.dynamics import Task
from plans.study import Study

OVER_TURN, LOOP = (MOMENTS, WORKS, SURPLUS), (INERTIA,)
PLATES: Mapping[str, tuple[str, ...]] = {
    WHOLE: (*OVER_TURN, *LOOP),
    GRAPHS: OVER_TURN,
    ENERGY: LOOP,
    UPPER: (MOMENTS, WORKS),
    LOWER: (SURPLUS,),
}


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a machine's motion shows against the analysis (row of the table of sheets)."""
    own, comparison, drafting = study["dynamics"], study.comparison("dynamics"), drafting_of(study.scene)
    expected, shown = expected_of(own.task, comparison), leaf.metadata["figures"]
    strokes = own.statics.over(comparison.motion.road.extremes)
    yield from loads([name for name in shown if name.startswith(LOAD)], measured, leaf, own.statics.machine, strokes)
    if comparison.analysis.cycle is None:
        yield from reduction(leaf, comparison.analysis.reduced, drafting)
        return
    for plate in PLATES.keys() & set(shown):
        due = [*PLATES[plate], *([SPEEDS] if expected.omega is not None and plate in (WHOLE, GRAPHS, LOWER) else [])]
        yield from graphs(measured, leaf, expected, due, drafting)
        if plate in (WHOLE, ENERGY):
            yield from loop(measured, leaf, expected, drafting)
            yield from equations(leaf, expected, drafting)
    if TACHOGRAM in shown:
        yield from tachogram(measured, leaf, comparison.construction.run, drafting)
    if BEFORE in shown:
        yield from bare(measured, leaf, expected, BEFORE, NUMBERED)
    if flywheel_sketch.NAME in shown:
        yield from flywheel(measured, leaf, expected, drafting)
    yield from positions(leaf, expected, drafting)
    yield from results(leaf, expected, comparison, drafting)
    yield from notes(leaf, expected, comparison, drafting)


def expected_of(task: Task, comparison: DynamicsComparison) -> Expected:
    """Give what the analysis says."""
    return Expected(task, comparison.analysis)
