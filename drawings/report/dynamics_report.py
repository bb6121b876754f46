"""The motion of a machine in the report: task, reduction, works, flywheel, motion, other fluctuations (отчёт)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from drawings.lettering.words import decimal
from drawings.page.drafting import drafting_of
from drawings.report import dynamics_tables as tables
from drawings.report import run_tables
from drawings.report.chapters import Chapters
from drawings.report.dynamics_notes import DynamicsNotes
from drawings.report.forces.force_report import counted_strokes
from drawings.report.listed import listed, plain
from drawings.report.markdown import chapter, header, row
from plans.dynamics.loop import loop
from plans.dynamics.methods import methods
from plans.dynamics.rim import rim_of
from plans.model.account import Account
from plans.model.dynamics import Cycle, Flywheel, Task
from plans.study import Study
from plans.words.words import Message, message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS = 10
NOISE = 1e-9  # per cent: a smaller difference is rounding, whose digits differ from machine to machine


def headline(study: Study) -> str:
    """Say what flywheel the machine needs."""
    notes = notes_of(study, digits=5)
    return "; ".join(map(plain, (*notes.works(), *notes.missing())))


def remarks(study: Study) -> list[Message]:
    """Say that the machine would stop, or where a run ends before its time; gaps are told with the positions."""
    found = study.comparison("dynamics").construction.run
    if found is not None and found.failure is not None:
        return [found.failure.message]
    return [message("dynamics.stops")] if notes_of(study).stops else []


def notes_of(study: Study, digits: int = 4) -> DynamicsNotes:
    """Give the notes on what the construction finds, with the exact flywheel beside it."""
    own, comparison = study["dynamics"], study.comparison("dynamics")
    account, exact = comparison.construction, comparison.exact.flywheel
    rim = rim_of(account.flywheel.inertia, own.task.rim) if account.flywheel is not None else None
    true = exact.inertia if exact is not None else None
    return DynamicsNotes(own.task, account, _at(account.cycle, own.task), drafting_of(study.scene), rim, true, digits)


def _at(cycle: Cycle, task: Task) -> partial[Flywheel]:
    """Give the flywheel of another fluctuation by the same loop."""
    return partial(_flywheel, cycle, task)


def _flywheel(cycle: Cycle, task: Task, delta: float) -> Flywheel:
    return loop(cycle, task._replace(delta=delta)).flywheel


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the motion of a machine."""
    language, notes = study.scene.sheet.language, notes_of(study, DIGITS)
    account: Account = study.comparison("dynamics").construction
    return Chapters(
        subject=[*listed(chapter(language, "dynamics"), [*notes.asked(), *_shafts(notes)]), *_ways(study)],
        values=[
            *_reduction(account, notes),
            *_works(account, notes),
            *_wheel(study, notes),
            *_motion(notes),
            *_run(study, notes),
        ],
        left_out=[word(language, "report.dynamics_left_out")],
    )


def _ways(study: Study) -> Iterator[str]:
    """Tell how the crank turns, and the strokes that loads count where no chapter of forces does."""
    statics, language = study["forces"], study.scene.sheet.language
    way = "clockwise" if statics.study.mechanism.drive.omega < 0 else "counter-clockwise"
    yield word(language, "report.crank_turns", way=message(f"way.{way}"))
    if "forces" not in study.techniques:
        yield from counted_strokes(statics, language)


def _shafts(notes: DynamicsNotes) -> Iterator[str]:
    """Tell each rotating mass beside the linkage, reduced to the crank."""
    for one in notes.task.shafts:
        numbers = {"inertia": one.inertia, "ratio": one.ratio, "reduced": one.reduced}
        told = {name: notes.drafting.number(value, DIGITS) for name, value in numbers.items()}
        yield word(notes.drafting.language, "report.shaft", name=one.name, **told)


def _reduction(account: Account, notes: DynamicsNotes) -> Iterator[str]:
    yield chapter(notes.drafting.language, "reduction")
    yield from tables.reduction(account.reduced, notes.drafting)


def _works(account: Account, notes: DynamicsNotes) -> Iterator[str]:
    if account.cycle is not None:
        yield from listed(chapter(notes.drafting.language, "works"), [*notes.works(), *notes.stopping()])
        yield ""
        yield from tables.works(account.cycle, account.speeds, notes.drafting)


def _wheel(study: Study, notes: DynamicsNotes) -> Iterator[str]:
    """Tell the tangents, the flywheel by every method, and what other fluctuations ask for."""
    wheel, language, drafting = notes.account.flywheel, notes.drafting.language, notes.drafting
    if wheel is None:
        return
    exact = study.comparison("dynamics").exact.flywheel
    yield from listed(chapter(language, "flywheel"), [*notes.reasons(), *notes.other(), *notes.sizes()])
    yield ""
    yield from tables.tangents(wheel, exact, drafting)
    yield ""
    yield from _methods(notes, wheel, exact)
    yield chapter(language, "other_fluctuations")
    yield from tables.others(notes.task, notes.flywheel_at, notes.fluctuation, drafting)


def _methods(notes: DynamicsNotes, wheel: Flywheel, exact: Flywheel | None) -> Iterator[str]:
    """Tell J0 by Wittenbauer, Mertsalov, Gutyar and the book's formula, and how far each is off the first."""
    language, drafting = notes.drafting.language, notes.drafting
    assert notes.account.cycle is not None  # there is a flywheel
    found = methods(notes.account.cycle, notes.task)
    if found is None or not wheel.whole:
        return
    yield from header([word(language, f"table.{head}") for head in ("method", "whole", "off_loop")])
    values = {"loop": wheel.whole, "mertsalov": found.mertsalov, "gutyar": found.gutyar, "book": found.book}
    if exact is not None:
        values["exact"] = exact.whole
    for name, whole in values.items():
        share = 100 * (whole / wheel.whole - 1)
        off = "—" if abs(share) < NOISE else decimal(f"{share:.2e}", language)
        yield row([word(language, f"report.method_{name}"), drafting.number(whole, DIGITS), off])
    yield f"\n{word(language, 'report.energy', energy=drafting.number(wheel.energy, DIGITS))}"


def _motion(notes: DynamicsNotes) -> list[str]:
    return listed(chapter(notes.drafting.language, "motion"), notes.achieved())


def _run(study: Study, notes: DynamicsNotes) -> Iterator[str]:
    """Tell the run from rest by the table and by the solver, of a machine with a motor."""
    comparison, language = study.comparison("dynamics"), notes.drafting.language
    pairs = {"report.by_table": comparison.construction.run, "report.by_solver": comparison.exact.run}
    runs = {name: run for name, run in pairs.items() if run is not None}
    if runs:
        yield from listed(chapter(language, "run"), run_tables.told(runs, notes.drafting))
        yield ""
        yield from run_tables.stages(runs, notes.drafting)
