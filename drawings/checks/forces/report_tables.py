"""The self-check of the tables of forces in a report: every number of every position (проверка таблиц отчёта)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks.note.lines import cells, tables
from drawings.checks.reading import reads
from drawings.lettering import words as lettering
from drawings.lettering.words import number
from drawings.page.drafting import drafting_of
from drawings.report.formula import Formula
from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import indices
from plans.forces.primary import balancing_quantity
from plans.forces.statics import Statics
from plans.forces.stroke import asks
from plans.words.words import Message, message, word

DIGITS = 10  # of a reaction in the report; of what balances the drive six
FEW = 6
GRAVITY, BODY = "report.gravity", "report.body"
_MATH = re.compile(r"[$\\{}_]|text")


class Column(NamedTuple):
    """A column of a table over the positions: how its head begins, its values and what these may be out."""

    head: str
    values: np.ndarray
    slack: np.ndarray


class ForceTables(NamedTuple):
    """The report beside force sheets."""

    text: str
    statics: Statics
    comparison: ForceComparison

    def faults(self) -> Iterator[Message]:
        """Hold the reactions and what balances the drive in every position, and what is given."""
        yield from self._table(list(self._reactions()), DIGITS)
        yield from self._table(list(self._balancing()), FEW)
        yield from self._given()
        yield from self._said()

    @property
    def _language(self) -> str:
        return self.statics.study.language

    def _letter(self, name: str) -> str:
        return _bare(lettering.letter(self._language, name))

    def _reactions(self) -> Iterator[Column]:
        found, own = self.comparison.analysis, self.statics.form.sheet.reactions
        allowed = {one.name: one.allowed for one in self.comparison.of("forces")}
        told = balancing_quantity(self.statics.study.mechanism.drive)
        strokes = self.statics.over(self.comparison.motion.road.extremes)
        given = self.statics.given(found, self.comparison.motion.analysis, strokes)
        force, turned = found.nothing_over
        yield Column(self._letter(told.name), given, allowed[told.name] + told.share * turned)
        for one in sorted(found.reactions.values(), key=lambda one: (one.giver, one.taker)):
            index = indices(one.giver, one.taker)
            slack = next((slack for name, slack in allowed.items() if name == f"R_{index}"), np.zeros(len(one.force)))
            yield Column(self._letter(f"{own}_{{{index}}}"), one.force, slack + force)
            moment = allowed.get(f"M_{index}")
            if moment is None or one.moment is None:
                continue
            if np.any(np.abs(found.counted(one.moment)) > 2 * turned):
                yield Column(self._letter(f"M_{{{index}}}"), one.moment, moment + turned)

    def _balancing(self) -> Iterator[Column]:
        told, none = balancing_quantity(self.statics.study.mechanism.drive), self.comparison.analysis.nothing_over[1]
        own = [one for one in self.comparison.of("forces") if one.name.partition(" ")[0] == told.name]
        for one in (own[:1] * 2 + own[1:]) if own else ():
            yield Column(self._letter(told.name), np.real(one.analysis), one.allowed + none)

    def _table(self, columns: Sequence[Column], digits: int) -> Iterator[Message]:
        """Hold the table whose heads are those of the columns."""
        if not columns:
            return
        for rows in tables(self.text):
            heads = [_bare(cell) for cell in rows[0]]
            first = word(self._language, "table.position")
            if heads[0] == _bare(first) and _alike(heads[1:], [one.head for one in columns]):
                yield from self._rows(rows[2:], columns, digits)
                return
        yield message("wrong.missing", name=", ".join(one.head for one in columns))

    def _rows(self, rows: Sequence[Sequence[str]], columns: Sequence[Column], digits: int) -> Iterator[Message]:
        count = len(columns[0].values)
        if [row[0] for row in rows] != [str(k) for k in range(count)]:
            yield message("wrong.row_missing", name=word(self._language, "table.position"))
        for k, row in enumerate(rows[:count]):
            for one, cell in zip(columns, row[1:], strict=False):
                if not self._reads(cell, one.values[k], float(one.slack[k]), digits):
                    yield message("wrong.row_cell", text=cell, name=f"{one.head}, {row[0]}")

    def _reads(self, cell: str, value: complex, slack: float, digits: int) -> bool:
        if np.isnan(value):
            return cell == word(self._language, "table.gap")
        parts = (value.real, value.imag) if np.iscomplexobj(value) else (float(np.real(value)),)
        texts = cell.split("; ")
        pairs = zip(texts, parts, strict=False)
        return len(texts) == len(parts) and all(reads(text, part, slack, digits) for text, part in pairs)

    def _given(self) -> Iterator[Message]:
        """Hold what is given of masses and loads."""
        due, machine = list[str](), self.statics.machine
        for link, body in machine.bodies.items():
            centre = {"x": self._number(body.centre.real), "y": self._number(body.centre.imag)}
            given = {"mass": self._number(body.mass), "inertia": self._number(body.inertia)}
            due.append(word(self._language, BODY, link=link, **given, **centre))
        if machine.gravity:
            gravity = {"x": self._number(machine.gravity.real), "y": self._number(machine.gravity.imag)}
            due.append(word(self._language, GRAVITY, **gravity))
        sizes: Mapping[str, float] = {one.name: one.size for one in machine.forces if one.diagram is None}
        for name, size in sizes.items():
            ending = f": {self._number(size)} {lettering.word(self._language, 'N')}"
            if not any(line.startswith(f"- {name} ") and line.endswith(ending) for line in self.text.splitlines()):
                yield message("wrong.missing", name=f"{name}{ending}")
        yield from (message("wrong.missing", name=line) for line in due if line not in self.text)

    def _said(self) -> Iterator[Message]:
        """Hold what is said of loads: where each acts and when; the heads of the table of what balances the drive."""
        seen, language = self.text.splitlines(), self._language
        for force in self.statics.machine.forces:
            ends = {"point": force.point, "link": force.link, "during": force.during}
            far = {} if force.other is None else {"far": force.other.point, "other": force.other.link}
            line = word(language, "report.force_between" if far else "report.force", name=force.name, **ends, **far)
            if not any(one.startswith(line) for one in seen):
                yield message("wrong.missing", name=line)
        told = balancing_quantity(self.statics.study.mechanism.drive)
        parts = {"letter": lettering.letter(language, told.name), "unit": lettering.word(language, told.unit)}
        heads = [word(language, f"report.{key}", **parts) for key in ("by_plans", "by_equilibrium")]
        rows = [cells(line) for line in seen if line.startswith("|")]
        if list(self._balancing()) and not any(row[1:3] == heads for row in rows):
            yield message("wrong.missing", name="; ".join(heads))
        yield from self._pointed(rows)

    def _pointed(self, rows: Sequence[Sequence[str]]) -> Iterator[Message]:
        """See that each reaction of the table is said to act where its pair is, each load over its stroke."""
        own, language = self.statics.form.sheet.reactions, self._language
        formula = Formula(drafting_of(self.statics.study.scene))
        heads = {cell for row in rows for cell in row}
        for one in self.comparison.analysis.reactions.values():
            letter = f"${formula.letter(f'{own}_{{{indices(one.giver, one.taker)}}}')}$"
            head = word(language, "report.reaction", letter=letter, point=f"${formula.line(one.point)}$")
            if head not in heads:
                yield message("wrong.missing", name=head)
        loads = [load for load in self.statics.machine.loads if asks(load)]
        for track in dict.fromkeys(load.stroke for load in loads):
            names = ", ".join(load.name for load in loads if load.stroke == track)
            line = word(language, "report.counted", names=names, line="")
            if line not in self.text:
                yield message("wrong.missing", name=line)

    def _number(self, value: float) -> str:
        return number(value, self._language)


def _bare(text: str) -> str:
    """Write a head without its marks of math: the letters that are read."""
    return _MATH.sub("", text)


def _alike(heads: Sequence[str], due: Sequence[str]) -> bool:
    """Tell whether heads begin as they should, one for one."""
    return len(heads) == len(due) and all(
        re.match(rf"{re.escape(name)}(?:\W|$)", head) for head, name in zip(heads, due, strict=True)
    )
