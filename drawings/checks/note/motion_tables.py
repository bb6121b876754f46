"""The self-check of the tables of motion in a report: every value of every position (проверка таблиц движения)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from itertools import zip_longest
from typing import NamedTuple

import numpy as np

from drawings.checks.linkage.value_rows import is_something
from drawings.checks.note.lines import cells, part
from drawings.checks.reading import reads
from drawings.lettering.words import fixed
from drawings.lettering.words import word as lettered
from drawings.page.drafting import drafting_of
from drawings.report.formula import Formula
from plans.checks.compare import MotionComparison
from plans.checks.comparison import Finding
from plans.linkage.study import LinkageStudy
from plans.model.order import PLANS, POSITIONS
from plans.words.words import Message, message, term, word

DIGITS = 10
NOUGHT = 1e-10  # of the largest of a column: less is told as 0
EQUAL = " = "  # between the letters of what is one, and has one column
_HEAD = re.compile(r"\$(?P<letters>.+)\$, (?P<unit>.+)")


class MotionTables(NamedTuple):
    """The report on a motion."""

    text: str
    study: LinkageStudy
    comparison: MotionComparison

    def faults(self) -> Iterator[Message]:
        """Hold the table of each plan: its heads, a row for each position, every value by both roads."""
        lines = part(self.text, word(self.study.language, "report.values"))
        for plan in PLANS:
            due = [one for one in self.comparison.of(plan) if is_something(one)]
            title = term(self.study.language, "plan", plan)
            head = word(self.study.language, "report.plan", plan=title[:1].upper() + title[1:]).strip()
            if due and head not in lines:
                yield message("wrong.missing", name=head)
            elif due:
                own = lines[lines.index(head) + 1 :]
                end = next((k for k, line in enumerate(own) if line.startswith("#")), len(own))
                yield from self._table([cells(line) for line in own[:end] if line.startswith("|")], plan, due)

    def _table(self, rows: Sequence[Sequence[str]], plan: str, due: Sequence[Finding]) -> Iterator[Message]:
        known = {self._letter(one): one for one in self.comparison.of(plan)}
        first = [word(self.study.language, "table.position"), self._station]
        columns = [self._column(head, known) for head in rows[0][2:]] if rows else []
        if not rows or list(rows[0][:2]) != first or not all(columns):
            yield message("wrong.row_cell", text=" | ".join(rows[0]) if rows else "—", name=plan)
            return
        seen = {one.name for own in columns for one in own}
        yield from (message("wrong.missing", name=one.name) for one in due if one.name not in seen)
        for k, (line, phi) in enumerate(zip_longest(rows[2:], self.study.turn.phi)):
            yield from self._row(k, line, phi, columns)

    def _row(
        self, k: int, line: Sequence[str] | None, phi: float | None, columns: Sequence[Sequence[Finding]]
    ) -> Iterator[Message]:
        if line is None or phi is None or list(line[:2]) != [str(k), self._at(float(phi))]:
            yield message("wrong.row", name=str(k), where="values")
            return
        for text, own in zip_longest(line[2:], columns, fillvalue=()):
            if not own or not all(self._reads(str(text), one, k) for one in own):
                yield message("wrong.row_cell", text=str(text), name=f"{own[0].name if own else '—'}, {k}")

    def _letter(self, one: Finding) -> str:
        symbol, _, index = one.name.partition("_")
        return Formula(drafting_of(self.study.scene)).letter(f"{symbol}_{{{index}}}")

    def _column(self, head: str, known: dict[str, Finding]) -> list[Finding]:
        """Give the findings of a column by its head: a letter with its unit, or all letters of what is one."""
        found = _HEAD.fullmatch(head)
        own = [known.get(letter) for letter in found["letters"].split(EQUAL)] if found else [None]
        units = {lettered(self.study.language, one.unit) for one in own if one is not None}
        return [one for one in own if one is not None] if found and None not in own and units == {found["unit"]} else []

    @property
    def _station(self) -> str:
        return word(self.study.language, "table.way") if self.study.mechanism.drive.pushed else "φ, °"

    def _at(self, phi: float) -> str:
        """Write the crank's angle, or the drive's way."""
        drive = self.study.mechanism.drive
        return fixed(1000 * drive.unit * phi if drive.pushed else float(np.degrees(phi)), self.study.language, 4)

    def _reads(self, cell: str, one: Finding, k: int) -> bool:
        value, gap = one.analysis[k], word(self.study.language, "table.gap")
        slack = float(one.allowed[k]) + NOUGHT * one.largest
        if np.isnan(value) or not np.isfinite(slack):
            return bool(np.isnan(value)) == (cell == gap)
        parts = (value.real, value.imag) if np.iscomplexobj(one.analysis) else (float(value),)
        roads = [road.split("; ") for road in cell.split("<br>")]
        turns = (0.0, math.tau, -math.tau) if one.unit == POSITIONS.link.unit else (0.0,)  # an angle is one by turns
        return all(
            len(own) == len(parts) and any(_tells(own, [true + turn for true in parts], slack) for turn in turns)
            for own in roads
        )


def _tells(texts: Sequence[str], parts: Sequence[float], slack: float) -> bool:
    return all(reads(text, true, slack, DIGITS) for text, true in zip(texts, parts, strict=True))
