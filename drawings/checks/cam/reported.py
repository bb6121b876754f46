"""The chapters of a cam in the report held to the analysis: its task, every position, what was found (отчёт)."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import TYPE_CHECKING

import numpy as np

from drawings.checks import reading
from drawings.checks.cam.cam_expected import Expected
from drawings.checks.cam.cam_units import BARE
from drawings.checks.cam.due_notes import DueNotes
from drawings.checks.documents_old import chapters
from drawings.checks.note.lines import cells, in_report, parts
from drawings.checks.precise import KNOWN, precise, tells
from drawings.checks.reading import reads
from drawings.page.drafting import Drafting, drafting_of
from plans.cam.study import LAWS
from plans.model.motion import Floats
from plans.study import Study
from plans.words.words import Message, message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS, PHASES, CHORDS, SAID = (
    10,
    5,
    3,
    5,
)  # of numbers: of most, of the phases, of what chords leave out, said first
MM = 1000.0
# Units in which S' and S'' are told, and how many of them are one of SI, by their own.
CHORDED = {"count": "…", "slope": "…", "travel": "…"}
TOLD = {"m/rad": ("mm", MM), "m/rad2": ("mm", MM), "1/rad": ("", 1.0)}


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """Hold the lines of every cam, one for one, to what the analysis says (row of the table of reports)."""
    drafting, drawings = drafting_of(study.scene), study["cam"].drawings
    for found in study.comparison("cam").analysis.cams:
        expected = Expected(found, drawings[found.cam.name])
        yield from ReportedCam(text, expected, drafting, LAWS in study.plans).faults()
    heads = [(key, name) for key in ("cam", "cam_values", "cam_found") for name in drawings]
    told = [word(drafting.language, f"report.{key}", name=name) for key, name in heads]
    told += [word(drafting.language, f"report.{key}") for key in ("left_out", "cam_left_out")]
    yield from chapters.ordered(text, told)


def headline(study: Study) -> Callable[[str], bool] | None:
    """Give what tells whether a line says the main sizes of all cams; None where no cam has any to be found."""
    drafting = precise(drafting_of(study.scene))
    notes = (DueNotes(found, drafting) for found in study.comparison("cam").analysis.cams)
    due = "; ".join(in_report(line) for one in notes for line in one.sizes())
    return (lambda line: tells(line, due, (SAID,), KNOWN)) if due else None


@dataclass(frozen=True)
class ReportedCam:
    """A report, and one cam of it with what must be said; of one whose `laws` are asked for what chords leave out."""

    text: str
    expected: Expected
    drafting: Drafting
    laws: bool

    def faults(self) -> Iterator[Message]:
        """Hold its three parts."""
        task = [line for line in self._part("cam") if line.startswith("- ")]
        yield from self._listed(task, [*self._task()])
        yield from self._rows()
        found = [line for line in self._part("cam_found") if line.startswith("- ")]
        if self.laws and (not found or not self._chorded(found.pop())):
            yield message("wrong.missing", name=word(self.drafting.language, "report.cam_chords", **CHORDED))
        yield from self._listed(found, [*self._found()])

    def _part(self, key: str) -> list[str]:
        """Give the lines under a heading, up to the next one; none where it does not stand exactly once."""
        head = word(self.drafting.language, f"report.{key}", name=self.expected.cam.name).strip()
        found = list(parts(self.text, head))
        return found[0] if len(found) == 1 else []

    def _listed(self, seen: Sequence[str], due: Sequence[tuple[str, int]]) -> Iterator[Message]:
        """Hold the lines of a list, each to what is due with so many digits."""
        for line, (note, digits) in zip_longest(seen, due, fillvalue=("", DIGITS)):
            told = line if isinstance(line, str) else ""
            if not tells(told, f"- {in_report(note)}", (digits,), KNOWN):
                yield message("wrong.told", text=told or in_report(note))

    @property
    def _notes(self) -> DueNotes:
        return DueNotes(self.expected.found, precise(self.drafting))

    def _task(self) -> Iterator[tuple[str, int]]:
        *asked, phases = self._notes.task()
        yield from ((one, DIGITS) for one in asked)
        yield phases, PHASES
        if self.expected.cam.setting:
            angle = precise(self.drafting).number(math.degrees(self.expected.cam.setting))
            yield self.drafting.word("cam setting", angle=angle), DIGITS

    def _found(self) -> Iterator[tuple[str, int]]:
        own = self._notes
        told = (*own.smoothed(), *own.sizes(), *own.pressure(), *own.bent(), *own.rolled(), *own.failing())
        yield from ((one, DIGITS) for one in told)

    def _chorded(self, line: str) -> bool:
        """Tell whether a line says by how much S' and S by chords are off the law, per cent of its largest."""
        drawn, expected = self.expected.drawing.diagrams, self.expected
        pairs = (drawn.slope[1], expected.before.slope[1:]), (drawn.travel.values, expected.after.s)
        parts = {"count": len(expected.edges) - 1, "slope": "@", "travel": "@"}
        due = word(self.drafting.language, "report.cam_chords", **parts)
        found = re.fullmatch(re.escape(f"- {due}").replace("@", "(.+)"), line)
        shares = (100 * _share(*pair) for pair in pairs)
        return found is not None and all(
            reads(text, share, 100 * KNOWN, CHORDS) for text, share in zip(found.groups(), shares, strict=True)
        )

    def _rows(self) -> Iterator[Message]:
        """Hold the table of all numbered positions: its heads, and each cell."""
        lines = [cells(line) for line in self._part("cam_values")]
        heads, rows = (lines[0] if lines else []), lines[2:]
        columns = [*self._columns()]
        if heads != ["i", *(head for head, _ in columns)]:
            yield message("wrong.told", text=" | ".join(heads))
        for k in range(max(len(rows), len(columns[0][1]))):
            row = rows[k] if k < len(rows) else []
            if len(row) != len(columns) + 1 or row[0] != str(k) or k >= len(columns[0][1]):
                yield message("wrong.row_missing", name=str(k))
                continue
            for text, (head, values) in zip(row[1:], columns, strict=True):
                bent = head.startswith("ρ")
                if not (_bends(text, k, values) if bent else _reads(text, k, values)):
                    yield message("wrong.row_cell", text=text, name=f"{head}, {k}")

    def _columns(self) -> Iterator[tuple[str, Floats]]:
        """Give the columns over the positions by their heads, in the units in which they are told."""
        cam, own = self.expected.cam, self.expected.contour
        turn, way = ("x", "S"), ("φ", "S")
        letter = (turn if cam.translates else way)[0]
        yield self._head(letter, "mm" if cam.translates else "°"), _scaled(own.turned, cam.translates)
        yield self._head("S", "°" if cam.rocks else "mm"), _scaled(own.travel.s, not cam.rocks)
        for name, values, si in zip(("S'", "S''"), own.travel[1:3], BARE[cam.rocks, cam.translates], strict=True):
            unit, size = TOLD.get(si, (si, 1.0))
            yield self._head(name, unit), size * values
        yield self._head("x_P", "mm"), MM * own.pitch.real
        yield self._head("y_P", "mm"), MM * own.pitch.imag
        yield self._head("α", "°"), np.degrees(own.pressure)
        yield self._head("ρ", "mm"), MM * own.radius

    def _head(self, name: str, unit: str) -> str:
        return f"{name}, {self.drafting.word(unit)}" if unit else name


def _scaled(values: Floats, length: bool) -> Floats:
    return np.asarray(MM * values if length else np.degrees(values))


def _reads(text: str, k: int, values: Floats) -> bool:
    return reads(text, float(values[k]), KNOWN * float(np.abs(values).max()), DIGITS)


def _bends(text: str, k: int, radii: Floats) -> bool:
    """Tell whether a radius of curvature is written, infinite where the curve is straight, by how the curve bends."""
    with np.errstate(divide="ignore"):
        bends = 1 / radii
    most = KNOWN * float(np.abs(bends[np.isfinite(bends)]).max(initial=0.0))
    if text == "∞":
        return abs(float(bends[k])) <= most
    value = reading.value(text)
    if value is None or not value:
        return value == 0.0 and abs(float(radii[k])) <= KNOWN
    return abs(1 / value - float(bends[k])) <= most + KNOWN * abs(float(bends[k]))


def _share(values: Floats, exact: Floats) -> float:
    most = float(np.abs(exact).max())
    return float(np.abs(values - exact).max()) / most if most else 0.0
