"""The self-check of a written sheet of dynamics: graphs, loop, loads, flywheel, tables, notes (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from drawings.checks.documents_old import title_block
from drawings.checks.dynamics.due_figures import DueFigures
from drawings.checks.dynamics.due_notes import DueNotes
from drawings.checks.dynamics.dynamics_expected import INERTIA, MOMENTS, SPEEDS, SURPLUS, WORKS, Expected
from drawings.checks.dynamics.dynamics_graphs import graphs
from drawings.checks.dynamics.dynamics_loop import LOOP as LOOPED
from drawings.checks.dynamics.dynamics_loop import loop
from drawings.checks.dynamics.dynamics_sizes import flywheel, loads
from drawings.checks.dynamics.dynamics_told import equations, lost_notes, notes, positions, reduction, results
from drawings.checks.dynamics.joined import joined
from drawings.checks.dynamics.told_table import DueTable
from drawings.checks.dynamics.verify_bare_speeds import bare
from drawings.checks.dynamics.verify_tachogram import tachogram
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.workings import machine_workings
from drawings.checks.workings.due_line import DueLine
from drawings.checks.wrong import Wrong
from drawings.figures.dynamics import flywheel_sketch
from drawings.figures.dynamics.bare_speeds import NUMBERED
from drawings.figures.dynamics.load_diagram import NAME as LOAD
from drawings.figures.dynamics.plate import ENERGY, GRAPHS, LOWER, UPPER, WHOLE
from drawings.figures.dynamics.quantities import BEFORE
from drawings.figures.dynamics.tachogram import NAME as TACHOGRAM
from drawings.figures.workings.working import TANGENTS
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.paper.walk import group_named
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
    # Graphs have a scale along either axis: the title block has no ratio.
    yield from title_block.faults(leaf, study.scene, "dynamics", drafting.word("dynamics sheet title"), "")
    diagrams = [name for name in shown if name.startswith(LOAD)]
    yield from loads(diagrams, measured, leaf, own.statics.machine, strokes, drafting)
    for table in _tables(leaf, study):
        yield from table.faults(leaf)
    if comparison.analysis.cycle is None:
        return
    for plate in PLATES.keys() & set(shown):
        due = [*PLATES[plate], *([SPEEDS] if expected.omega is not None and plate in (WHOLE, GRAPHS, LOWER) else [])]
        yield from graphs(measured, leaf, expected, due, drafting)
        yield from joined(measured, leaf, expected, plate, drafting)
        if plate in (WHOLE, ENERGY):
            yield from loop(measured, leaf, expected, drafting)
            yield from equations(leaf, expected, drafting)
    yield from machine_workings.held(leaf, _tangents(leaf, expected, drafting), drafting)
    if TACHOGRAM in shown:
        yield from tachogram(measured, leaf, comparison.construction.run, drafting)
    if BEFORE in shown:
        yield from bare(measured, leaf, expected, BEFORE, NUMBERED, drafting)
    if flywheel_sketch.NAME in shown:
        yield from flywheel(measured, leaf, expected, drafting)
    yield from notes(leaf, DueNotes(expected, comparison.exact.flywheel, drafting))


def set_faults(sheets: Sequence[tuple[Measured, Leaf]], study: Study) -> Iterator[Wrong]:
    """Hold what all sheets of a machine's motion must show together: each figure once, whole tables, the notes."""
    comparison, leaves = study.comparison("dynamics"), [leaf for _, leaf in sheets]
    shown = [name for leaf in leaves for name in leaf.metadata["figures"]]
    yield from DueFigures(study["dynamics"], comparison).faults(shown)
    for table in _tables(leaves[0], study):
        yield from table.set_faults(leaves)
    if comparison.analysis.cycle is not None:
        yield from lost_notes(leaves)


def _tangents(leaf: Leaf, expected: Expected, drafting: Drafting) -> dict[str, list[DueLine]]:
    """Give what must be told of the tangents to the loop on its plate, at the scales that are written over it."""
    own = group_named(leaf.groups, LOOPED)
    found = {} if own is None else written_scales(own)
    if expected.wheel is None or not {"J", "T"} <= found.keys():
        return {}
    due = machine_workings.tangents(expected.wheel, found["J"], found["T"], drafting)
    return {
        machine_workings.named(TANGENTS, plate): due for plate in (WHOLE, ENERGY) if plate in leaf.metadata["figures"]
    }


def _tables(leaf: Leaf, study: Study) -> list[DueTable]:
    """Give the tables that the sheets of a set must have."""
    own, comparison, drafting = study["dynamics"], study.comparison("dynamics"), drafting_of(study.scene)
    expected = expected_of(own.task, comparison)
    if comparison.analysis.cycle is None:
        return [reduction(comparison.analysis.reduced, drafting)]
    return [positions(leaf, expected, drafting), results(expected, comparison, drafting)]


def expected_of(task: Task, comparison: DynamicsComparison) -> Expected:
    """Give what the analysis says."""
    return Expected(task, comparison.analysis)
