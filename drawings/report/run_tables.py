"""The run of a machine in the report: its stages by table and by solver, works, energy, steady turn, cost (разбег)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import partial

from drawings.lettering.phrase import Phrase, template_of
from drawings.lettering.words import decimal
from drawings.page.drafting import Drafting
from drawings.report.markdown import header, row
from plans.model.run import Run, Stage
from plans.words.words import word


def plain(note: str) -> str:
    """Write a note without the braces of its indices.

    >>> plain("r_{C1} = 12  mm^2")
    'r_C1 = 12 mm²'
    """
    return " ".join(note.replace("{", "").replace("}", "").replace("^2", "²").split())


def listed(title: str, notes: Iterable[str]) -> list[str]:
    """Write a chapter as a list; one without notes is left out."""
    told = [*map(entry, notes)]
    return [title, *told] if told else []


def entry(note: str) -> Phrase:
    """Give a note as a line of a list, its numbers still those of their quantities."""
    return Phrase(f"- {plain(note)}", f"- {plain(template_of(note))}")


DIGITS = 6
NOISE = 1e-9  # of the largest work or energy: what is left of a solver's account is rounding
STAGES = ("stage", "from", "to", "driving", "useful_work", "braking", "weights", "energy", "closing")


def stages(runs: Mapping[str, Run], drafting: Drafting) -> Iterator[str]:
    """Tell each stage by each road: its instants, works, kinetic energy, and by how much the account does not close."""
    yield from header([word(drafting.language, f"table.{head}") for head in STAGES])
    for said, run in runs.items():
        for stage in run.stages:
            yield row([f"{_named(stage, drafting)}, {word(drafting.language, said)}", *_cells(run, stage, drafting)])


def _named(stage: Stage, drafting: Drafting) -> str:
    return word(drafting.language, f"run.{stage.name.replace('-', '_')}")


def _cells(run: Run, stage: Stage, drafting: Drafting) -> Iterator[str]:
    write, works = partial(drafting.number, digits=DIGITS), stage.works
    yield from (write(float(run.t[at])) for at in (stage.first, stage.last))
    yield from (write(one) for one in (works.driving, works.useful, works.braking, works.weights))
    yield " → ".join(write(one) for one in stage.energies)
    noise = NOISE * max(map(abs, (works.driving, works.braking, *stage.energies)))
    yield "—" if abs(stage.closing) <= noise else decimal(f"{stage.closing:.1e}", drafting.language)


def told(runs: Mapping[str, Run], drafting: Drafting) -> Iterator[str]:
    """Say how the run ends, how even its steady turn is, and by what method and at what cost it was found."""
    say = partial(word, drafting.language)
    for key, run in runs.items():
        by = say(key)
        if run.failure is not None:
            yield f"{by}: {run.failure.message.worded(drafting.language)}"
        if run.steady is not None:
            turn, write = run.steady, partial(drafting.number, digits=DIGITS)
            share = turn.works.efficiency if turn.repeats else None  # else the flywheel gives or takes a part
            useful = "—" if share is None else write(share)
            numbers = {"mean": write(turn.mean), "delta": write(turn.delta), "period": write(turn.period)}
            yield say("report.steady_turn", by=by, **numbers, efficiency=useful)
        yield _method(run, by, drafting)


def _method(run: Run, by: str, drafting: Drafting) -> str:
    """Tell the method: the step of a table, the tolerance and the cost of a solver."""
    how, write = run.method, partial(drafting.number, digits=3)
    if how.step is not None:
        return word(drafting.language, "report.run_table", by=by, step=write(how.step), rows=len(run.t))
    tolerance = decimal(f"{how.tolerance or 0.0:.0e}", drafting.language)
    cost = {"evaluations": how.evaluations, "jacobians": how.jacobians, "stiffness": write(how.stiffness)}
    return word(drafting.language, "report.run_solver", by=by, name=how.name, tolerance=tolerance, **cost)
