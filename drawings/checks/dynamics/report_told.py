"""The self-check of what a report tells of a machine's motion: tables, sentences, the run by both roads (отчёт)."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from drawings.checks.documents_old import chapters
from drawings.checks.dynamics.due_notes import DueNotes
from drawings.checks.dynamics.dynamics_expected import KNOWN, Expected
from drawings.checks.dynamics.told_table import NOTHING, DueCell, Shared
from drawings.checks.note.lines import in_report, tables
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong
from drawings.lettering.words import number
from drawings.page.drafting import Drafting, drafting_of
from plans.analytic.dynamics.flywheel import book_slopes, flywheel_of_points
from plans.checks.dynamics_comparison import DynamicsComparison
from plans.model.dynamics import TURN, Flywheel, Task
from plans.model.motion import Floats
from plans.model.run import Run
from plans.study import Study
from plans.words.words import message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS, FEW, RUN, METHOD, SAID = 10, 3, 6, 3, 5  # of values; of per cents; of a run; of how it was found; said first
OTHERS = (4.0, 2.0, 1.0, 0.5, 0.25)  # times the fluctuation that is asked for
LARGEST = 1.0  # fluctuation: of a machine that comes to rest once in a turn it is 2
LOST = 1e-9  # of the largest work or energy: what is left of a solver's account is rounding
STAGES = ("stage", "from", "to", "driving", "useful_work", "braking", "weights", "energy", "closing")
_NUMBER = re.compile(r"[−-]?\d+(?:[.,]\d+)?(?P<share>(?=\s%))?")


Due = Sequence[DueCell | Shared | str]


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Wrong]:
    """Hold the chapters on a machine's motion (row of the table of reports)."""
    own, comparison, drafting = study["dynamics"], study.comparison("dynamics"), drafting_of(study.scene)
    clockwise = own.statics.study.mechanism.drive.omega < 0
    yield from ReportTold(text, own.task, comparison, drafting, clockwise).faults()
    account, runs = comparison.analysis, [comparison.construction.run, comparison.exact.run]
    due = {
        "reduction": True,
        "works": account.cycle is not None,
        "flywheel": account.flywheel is not None,
        "other_fluctuations": account.flywheel is not None,
        "run": any(one is not None for one in runs),
        "dynamics_left_out": True,
    }
    yield from chapters.faults(text, drafting.language, [key for key, there in due.items() if there])


def headline(study: Study) -> Callable[[str], bool] | None:
    """Give what tells whether a line says what work is done in a turn, and what flywheel the machine needs."""
    comparison = study.comparison("dynamics")
    if comparison.analysis.cycle is None:
        return None
    expected = Expected(study["dynamics"].task, comparison.analysis)
    notes = DueNotes(expected, comparison.exact.flywheel, precise(drafting_of(study.scene)))
    told = [notes.work(), *([] if expected.wheel is None else [notes.missing(expected.wheel)])]
    due = "; ".join(map(_bare, told))
    return lambda line: tells(_bare(line), due, (SAID,), KNOWN)


class ReportTold(NamedTuple):
    """The report's text, the task, what both roads find, the language of the sheets, the sense of the crank."""

    text: str
    task: Task
    comparison: DynamicsComparison
    drafting: Drafting
    clockwise: bool

    def faults(self) -> Iterator[Wrong]:
        """Hold every table and every sentence."""
        analysis, exact = self.comparison.analysis, self.comparison.exact
        reduced = analysis.reduced
        heads = ["φ, °", self._head("M_red", "N*m"), self._head("J_red", "kg*m2"), self._head("dJ/dφ", "kg*m2")]
        columns = [360 * reduced.phi / TURN, reduced.moment, reduced.inertia, reduced.slope]
        yield from self._table([self._word("table.position"), *heads], self._rows(columns))
        yield from self._given()
        if analysis.cycle is None:
            return
        expected = Expected(self.task, analysis)
        yield from self._works(expected)
        yield from self._sentences(expected)
        if expected.wheel is not None:
            yield from self._flywheel(expected, expected.wheel, exact.flywheel)
        runs = {"report.by_table": self.comparison.construction.run, "report.by_solver": exact.run}
        yield from self._run({self._word(key): run for key, run in runs.items() if run is not None})

    def _word(self, key: str, **parts: object) -> str:
        return word(self.drafting.language, key, **parts)

    def _head(self, name: str, unit: str) -> str:
        return f"{name}, {self.drafting.word(unit)}"

    def _rows(self, columns: Sequence[Floats]) -> list[Due]:
        """Give the rows of columns that are numbered on; rounding is counted in shares of the largest of a column."""
        slacks = [KNOWN * float(np.nanmax(np.abs(column), initial=0.0)) for column in columns]
        return [
            [str(k), *(DueCell(float(one), slack, DIGITS) for one, slack in zip(row, slacks, strict=True))]
            for k, row in enumerate(zip(*columns, strict=True))
        ]

    def _given(self) -> Iterator[Wrong]:
        """Hold each rotating mass beside the linkage, and the sense in which the crank turns."""
        for one in self.task.shafts:
            told = {"inertia": one.inertia, "ratio": one.ratio, "reduced": one.inertia * one.ratio**2}
            numbers = {name: self._number(value) for name, value in told.items()}
            yield from self._line(self._word("report.shaft", name=one.name, **numbers))
        sense = message("way.clockwise" if self.clockwise else "way.counter-clockwise")
        yield from self._line(self._word("report.crank_turns", way=sense))

    def _works(self, expected: Expected) -> Iterator[Wrong]:
        cycle, speeds = expected.cycle, expected.account.speeds
        units = (("M-", "N*m"), ("M+", "N*m"), ("A_us", "J"), ("ΔT", "J"), ("J", "kg*m2"), ("ΔJ", "kg*m2"))
        heads = [self._word("table.edge"), "φ, °", *(self._head(*one) for one in units)]
        ends, starts = cycle.moments[:, 1], cycle.moments[:, 0]
        sides = np.append(ends[-1], ends), np.append(starts, starts[0])
        columns = [360 * cycle.turned / TURN, *sides, -cycle.work, cycle.surplus, cycle.inertia, cycle.varying]
        if speeds is not None:
            heads.append(self._head("ω", "rad/s"))
            columns.append(speeds.omega)
        yield from self._table(heads, self._rows(columns))

    def _flywheel(self, expected: Expected, wheel: Flywheel, exact: Flywheel | None) -> Iterator[Wrong]:
        """Hold both tangents, the other methods, other fluctuations."""
        units = (("tan ψ", "J/(kg*m2)"), ("ΔJ", "kg*m2"), ("ΔT", "J"), ("o_1l", "J"), ("o_1k", "J"))
        slope, *others = (self._head(*one) for one in units)
        yield from self._table(["", slope, "φ, °", *others], list(self._tangents(wheel, exact)))
        if wheel.whole:
            heads = ("method", "whole", "off_loop")
            yield from self._table([self._word(f"table.{head}") for head in heads], list(self._methods(wheel, exact)))
            energy = self._word("report.energy", energy=self._number(wheel.energy))
            yield from self._line(energy)
        names = ["δ", self._head("J_0", "kg*m2"), self._head("J_fly", "kg*m2")]
        yield from self._table(names, list(self._others(expected, wheel)))

    def _number(self, value: float, digits: int = DIGITS) -> str:
        return number(value, self.drafting.language, digits)

    def _tangents(self, wheel: Flywheel, exact: Flywheel | None) -> Iterator[Due]:
        roads = (("report.as_drawn", wheel), *((("report.exactly", exact),) if exact is not None else ()))
        every = [one for _, one in roads]
        energies = max(abs(touch.surplus) for one in every for touch in one.touches)
        cuts = [max(abs(one.cuts[k]) for one in every) for k in (0, 1)]
        for key, one in roads:
            for k, name in enumerate(("ψ_min", "ψ_max")):
                touch, own = one.touches[k], [math.nan, math.nan]
                own[k] = one.cuts[k]
                inertias = max(abs(touch.varying) for one in every for touch in one.touches)
                told = (
                    (one.slopes[k], one.slopes[k]),
                    (math.degrees(touch.turned), 360.0),
                    (touch.varying, inertias),
                    (touch.surplus, energies),
                    *zip(own, cuts, strict=True),
                )
                cells = [DueCell(value, KNOWN * abs(whole), DIGITS) for value, whole in told]
                yield [f"{name}, {self._word(key)}", *cells]

    def _methods(self, wheel: Flywheel, exact: Flywheel | None) -> Iterator[Due]:
        """Give J0 by every method from the corners of the loop, and how far each is off the loop itself."""
        cycle, task = Expected(self.task, self.comparison.analysis).cycle, self.task
        square, delta = task.speed**2, task.delta or 0.0
        mean = flywheel_of_points(cycle, task, (square / 2, square / 2))
        values = {
            "loop": wheel.whole,
            "mertsalov": (mean.cuts[1] - mean.cuts[0]) / (square * delta),
            "gutyar": (wheel.cuts[1] - wheel.cuts[0]) / (square * delta),
            "book": flywheel_of_points(cycle, task, book_slopes(task)).whole,
            **({} if exact is None else {"exact": exact.whole}),
        }
        for name, whole in values.items():
            off = Shared(100 * (whole - wheel.whole) / wheel.whole)
            yield [self._word(f"report.method_{name}"), DueCell(whole, KNOWN * abs(whole), DIGITS), off]

    def _others(self, expected: Expected, wheel: Flywheel) -> Iterator[Due]:
        for delta in (times * (self.task.delta or 0.0) for times in OTHERS):
            if delta <= LARGEST:
                whole = flywheel_of_points(expected.cycle, self.task._replace(delta=delta)).whole
                both = (whole, max(whole - wheel.own - wheel.present, 0.0))
                yield [f"1/{self._number(1 / delta)}", *(DueCell(one, KNOWN * abs(whole), DIGITS) for one in both)]

    def _sentences(self, expected: Expected) -> Iterator[Wrong]:
        """Hold what is said in words, each number with ten digits."""
        due = DueNotes(expected, self.comparison.exact.flywheel, self.drafting)
        lines = [line[2:] for line in self.text.splitlines() if line.startswith("- ")]
        for told, true in zip(due.all(), due.exactly.all(), strict=True):
            mask, bare = _NUMBER.sub("#", _bare(true)), _bare(true)
            alike = [line for line in lines if _NUMBER.sub("#", _bare(line)) == mask]
            if not any(_tells(_bare(line), bare) for line in alike):
                yield message("wrong.missing", name=_bare(told))

    def _run(self, runs: Mapping[str, Run]) -> Iterator[Wrong]:
        """Hold the stages of the run by each road, its steady turn, and how it was found.

        That of the table is held to the table, for its step leads off the exact run by what both rows show together.
        """
        if not runs:
            return
        rows = [row for by, run in runs.items() for row in self._stages(by, run)]
        yield from self._table([self._word(f"table.{head}") for head in STAGES], rows)
        for by, run in runs.items():
            if run.steady is not None:
                turn, works = run.steady, run.steady.works
                low, high = turn.extremes
                told = {"mean": (low + high) / 2, "delta": 2 * (high - low) / (high + low), "period": turn.period}
                numbers = {name: self._number(one, RUN) for name, one in told.items()}
                whole = turn.repeats and works.driving > 0
                share = self._number(works.useful / works.driving, RUN) if whole else NOTHING
                yield from self._line(self._word("report.steady_turn", by=by, **numbers, efficiency=share))
            yield from self._line(self._method(by, run))

    def _method(self, by: str, run: Run) -> str:
        """Say how a run was found: by the step of a table, or by the tolerance and the cost of a solver."""
        how = run.method
        if how.step is not None:
            step = self._number(how.step, METHOD)
            return self._word("report.run_table", by=by, step=step, rows=len(run.t))
        cost = {"evaluations": how.evaluations, "jacobians": how.jacobians}
        stiffness, tolerance = self._number(how.stiffness, METHOD), f"{how.tolerance or 0.0:.0e}"
        return self._word("report.run_solver", by=by, name=how.name, tolerance=tolerance, stiffness=stiffness, **cost)

    def _stages(self, by: str, run: Run) -> Iterator[Due]:
        for stage in run.stages:
            works = stage.works
            told = [float(run.t[at]) for at in (stage.first, stage.last)]
            told += [works.driving, works.useful, works.braking, works.weights]
            energies = " → ".join(self._number(one, RUN) for one in stage.energies)
            gained = works.driving - works.useful - works.braking + works.weights
            closing = stage.energies[1] - stage.energies[0] - gained
            noise = LOST * max(map(abs, (works.driving, works.braking, *stage.energies)))
            left = NOTHING if abs(closing) <= noise else f"{closing:.1e}".replace(".", self._word("number.decimal"))
            name = self._word(f"run.{stage.name.replace('-', '_')}")
            yield [f"{name}, {by}", *(DueCell(one, 0.0, RUN) for one in told), energies, left]

    def _line(self, due: str) -> Iterator[Wrong]:
        """See that a sentence is there, its numbers as they are known."""
        lines = [_bare(line.removeprefix("- ")) for line in self.text.splitlines()]
        true = _bare(due.removeprefix("- "))
        if not any(tells(line, true, (DIGITS, RUN, METHOD), KNOWN) for line in lines):
            yield message("wrong.missing", name=true)

    def _table(self, heads: Sequence[str], rows: Sequence[Due]) -> Iterator[Wrong]:
        """Hold the table whose heads are those that are due."""
        found = next((table for table in tables(self.text) if table[0] == [*heads]), None)
        if found is None:
            yield message("wrong.missing", name=", ".join(filter(None, heads)))
            return
        for row, due in zip(found[2:], rows, strict=False):
            wrong = [text for text, cell in zip(row, due, strict=False) if not _says(text, cell)]
            yield from (message("wrong.row_cell", text=text, name=row[0]) for text in wrong)
        if [len(row) for row in found[2:]] != [len(row) for row in rows]:
            yield message("wrong.row_missing", name=heads[0])


def _says(text: str, due: DueCell | Shared | str) -> bool:
    return text == due if isinstance(due, str) else due.holds(text)


def _bare(line: str) -> str:
    """Write a sentence as a report does, squares as they are read."""
    return in_report(line.replace("^2", "²"))


def _tells(line: str, true: str) -> bool:
    """Tell whether a sentence has all numbers of another one, each to its last digit."""
    pairs = zip(_NUMBER.finditer(line), _NUMBER.finditer(true), strict=True)
    return all(tells(one[0], other[0], (FEW if other["share"] is not None else DIGITS,), KNOWN) for one, other in pairs)
