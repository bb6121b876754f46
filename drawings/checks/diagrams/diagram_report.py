"""The chapter of a report on the output's course held to the analysis: its table, and what chords miss (отчёт)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise, zip_longest
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from drawings.checks.note.lines import cells, part
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong
from drawings.lettering.words import fixed
from drawings.report.markdown import header, heading
from plans.checks.comparison import Finding
from plans.checks.diagrams_comparison import LETTERS, DiagramsComparison
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import EXACT
from plans.model.motion import Floats
from plans.study import Study
from plans.words.words import message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS, SHARED = 10, 3  # of a value; of a share in per cent
OFF, PLACE = "@off@", "@place@"  # where the numbers of a line stand


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Wrong]:
    """Hold what a report tells of the diagrams, or that it says why there are none (row of the table of reports)."""
    own: DiagramsStudy = study["diagrams"]
    language, comparison = study.scene.sheet.language, study.comparison("diagrams")
    seen = part(text, word(language, "report.diagrams"))
    if isinstance(comparison, DiagramsComparison):
        yield from DiagramReport(seen, comparison, language).faults()
        return
    yield from (message("wrong.told", text=line) for line in seen)
    due = word(language, "report.no_diagrams", why=own.left_out)
    if own.wanted and own.left_out is not None and due not in part(text, word(language, "report.left_out")):
        yield message("wrong.missing", name=due)


class DiagramReport(NamedTuple):
    """The lines of the chapter, and the course by both roads."""

    lines: Sequence[str]
    comparison: DiagramsComparison
    language: str

    def faults(self) -> Iterator[Wrong]:
        """Hold what stands before the table, its heads and rows, and the lines under it."""
        first, axis = self._before(), self.comparison.analysis.axis
        for line, due in zip_longest(self.lines[: len(first)], first, fillvalue=""):
            if line != due:
                yield message("wrong.told", text=line) if line else message("wrong.missing", name=due)
        rest = self.lines[len(first) :]
        rows = [cells(line) for line in rest if line.startswith("|")]
        for k, row in enumerate(rows[: len(axis.numbers)]):
            yield from self._row(row, k)
        if len(rows) != len(axis.numbers):
            yield message("wrong.row_missing", name=word(self.language, "table.position"))
        yield from self._errors([line for line in rest if not line.startswith("|")])

    def _before(self) -> list[str]:
        heads = (heading(one, self.language) for one in self._columns)
        table = header([word(self.language, "table.position"), "φ, °", *heads])
        return [*word(self.language, "report.diagrams").strip().splitlines()[2:], *table]

    @property
    def _letters(self) -> tuple[str, str, str]:
        return LETTERS[self.comparison.findings[0].name == LETTERS[True][0]]

    @property
    def _columns(self) -> list[Finding]:
        """Give the quantities in their order: the course, and v and a by chords."""
        known, (_, v, a) = {one.name: one for one in self.comparison.findings}, self._letters
        return [known[name] for name in (*self._letters, f"{v} chords", f"{a} chords")]

    def _row(self, row: Sequence[str], k: int) -> Iterator[Wrong]:
        axis = self.comparison.analysis.axis
        at = [str(axis.numbers[k]), fixed(math.degrees(axis.turned[k]), self.language, 4)]
        if len(row) != len(at) + len(self._columns) or list(row[:2]) != at:
            yield message("wrong.row", name=str(axis.numbers[k]), where="diagrams")
            return
        for text, one in zip(row[2:], self._columns, strict=True):
            if not self._reads(text, one, k):
                yield message("wrong.row_cell", text=text, name=f"{one.name}, {axis.numbers[k]}")

    def _reads(self, text: str, one: Finding, k: int) -> bool:
        """Tell whether a cell is a value, of a rounding 0; from the last position no step goes."""
        if k == len(one.analysis):
            return text == ""
        value, slack = float(np.real(one.analysis[k])), 2 * float(one.allowed[k])
        if math.isnan(value) or not math.isfinite(slack):
            return math.isnan(value) == (text == word(self.language, "table.gap"))
        return reads(text, value, slack, DIGITS)

    def _errors(self, lines: Sequence[str]) -> Iterator[Wrong]:
        """Hold how far v and a by chords are out at the most, and where; nothing beside."""
        rest, found = list(lines), self.comparison.analysis
        pairs = (found.speeds, found.true_speeds), (found.growths, found.true_growths)
        for letter, (values, true) in zip(self._letters[1:], pairs, strict=True):
            error = self._error(letter, values, true)
            if rest and error.pattern(self.language).fullmatch(rest[0]):
                line = rest.pop(0)
                yield from [] if error.told_by(line, self.language) else [message("wrong.told", text=line)]
            elif error.sure:
                yield message("wrong.missing", name=error.line(self.language))
        yield from (message("wrong.told", text=line) for line in rest)

    def _error(self, letter: str, values: Floats, true: Floats) -> ChordsOut:
        own = [one for one in self.comparison.findings if one.name.partition(" ")[0] == letter and " " in one.name]
        noise = sum(float(np.nanmax(one.allowed, initial=0.0)) for one in own)
        numbers = [str(number) for number in self.comparison.analysis.axis.numbers]
        steps = letter == self._letters[1]
        places = [f"{a}–{b}" for a, b in pairwise(numbers)] if steps else numbers
        return ChordsOut(letter, np.abs(values - true), np.abs(true), 2 * noise, places)


class ChordsOut(NamedTuple):
    """How far values by chords are out, how large the true ones are, what may be rounding, and where they stand."""

    letter: str
    off: Floats
    sizes: Floats
    noise: float
    places: Sequence[str]

    @property
    def sure(self) -> bool:
        """Whether they are out by more than rounding."""
        return bool(self._worst > EXACT * self._most + self.noise and self._most > self.noise)

    def line(self, language: str) -> str:
        """Write the line, marks in place of its numbers."""
        return word(language, "report.chords", name=self.letter, off=OFF, place=PLACE)

    def pattern(self, language: str) -> re.Pattern[str]:
        """Give the line with any numbers."""
        return re.compile(re.escape(self.line(language)).replace(OFF, "(.+)").replace(PLACE, "(.+)"))

    def told_by(self, line: str, language: str) -> bool:
        """Tell whether a line says the share and a place of the worst; of roundings it may say any."""
        found = self.pattern(language).fullmatch(line)
        if found is None or not self.sure:
            return found is not None
        share, slack = 100 * self._worst / self._most, 100 * self.noise / self._most
        worst = np.flatnonzero(np.nan_to_num(self.off) >= self._worst * (1 - EXACT) - self.noise)
        return reads(found[1], share, slack * (1 + share / 100), SHARED) and found[2] in {
            self.places[k] for k in worst.tolist()
        }

    @property
    def _worst(self) -> float:
        return float(np.nanmax(self.off, initial=0.0))

    @property
    def _most(self) -> float:
        return float(np.nanmax(self.sizes, initial=0.0))
