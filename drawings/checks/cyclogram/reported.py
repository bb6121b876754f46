"""The chapter of a cyclogram in the report held to the analysis: every note, every position, no other (отчёт)."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import zip_longest
from typing import TYPE_CHECKING

from drawings.checks.cyclogram.due_notes import DueNotes
from drawings.checks.documents_old import chapters
from drawings.checks.documents_old.told_cell import Cell
from drawings.checks.note.lines import in_report, part
from drawings.checks.precise import KNOWN, precise, tells
from drawings.page.drafting import Drafting, drafting_of
from plans.cyclogram.study import CYCLOGRAM
from plans.model.cyclogram import Position
from plans.study import Study
from plans.words.words import Message, message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

SHARED = 6  # digits of a share of the stroke
DIGITS = 10  # of the numbers of the report
PLAN, ANALYSIS = "@plan@", "@analysis@"  # where the turns by both roads stand in a line


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """Hold the lines of the chapter, one for one, to what the analysis says (row of the table of reports)."""
    comparison, drafting = study.comparison(CYCLOGRAM), drafting_of(study.scene)
    seen = part(text, word(drafting.language, f"report.{CYCLOGRAM}").strip())
    notched = all(one.notched for one in comparison.construction.positions)
    notes = [*DueNotes(comparison.analysis, notched, study[CYCLOGRAM].cams, precise(drafting)).all()]
    for line, note in zip_longest(seen[: len(notes)], notes, fillvalue=""):
        if not tells(line, f"- {in_report(note)}", (DIGITS,), KNOWN):
            yield message("wrong.told", text=line or in_report(note))
    own = seen[len(notes) :]
    for k, one in enumerate(comparison.analysis.positions):
        line = own[k] if k < len(own) else ""
        if not _tells(line, k, one, drafting):
            yield message("wrong.told", text=line or drafting.word(f"role {one.role}"))
    yield from (message("wrong.told", text=line) for line in own[len(comparison.analysis.positions) :])
    yield from chapters.faults(text, drafting.language, [CYCLOGRAM, "left_out"])


def headline(study: Study) -> Callable[[str], bool]:
    """Give what tells whether a line says when the tool is off the work."""
    comparison = study.comparison(CYCLOGRAM)
    notes = DueNotes(comparison.analysis, True, study[CYCLOGRAM].cams, precise(drafting_of(study.scene)))
    return lambda line: tells(line, in_report(notes.window()), (DIGITS,), KNOWN)


def _tells(line: str, number: int, one: Position, drafting: Drafting) -> bool:
    """Tell whether a line says what a position is, at which share of the stroke, and its turn by both roads."""
    turned = Cell(math.degrees(one.turned), digits=DIGITS, turns=True)
    for share in {drafting.number(one.share * (1 + off), SHARED) for off in (-KNOWN, 0.0, KNOWN)}:
        parts = {"position": number, "role": drafting.word(f"role {one.role}"), "share": share}
        due = word(drafting.language, "report.characteristic", plan=PLAN, analysis=ANALYSIS, **parts)
        found = re.fullmatch(re.escape(due).replace(PLAN, "(.+)").replace(ANALYSIS, "(.+)"), line)
        if found is not None:
            return all(turned.holds(text) for text in found.groups())
    return False
