"""An involute pair in the report: what is given, how it meshes, all sizes by both roads (передача в отчёте)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.involute.notes import InvoluteNotes
from drawings.involute.sheet import NAME, tables
from drawings.page.page import drafting_of
from drawings.report.formula import Chapters, entry, plain
from drawings.report.report import Report, TableSubject, chapter, ruled
from plans.involute.study import InvoluteStudy
from plans.study import Study

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def _notes(study: Study) -> InvoluteNotes:
    return InvoluteNotes(study.of(InvoluteStudy), drafting_of(study.scene))


def headline(study: Study) -> str:
    """Say how far the axes are apart, and how many pairs of teeth are in mesh."""
    return "; ".join(map(plain, _notes(study).mesh()))


def subject(study: Study) -> TableSubject:
    """Tell a pair in a few words, for the gallery's page."""
    pair = study.of(InvoluteStudy).pair
    kind = "internal involute pair" if pair.internal else "involute pair"
    teeth = f"{kind} {pair.teeth[0]}–{pair.teeth[1]}"
    shifts = ", ".join(f"x_{n} = {shift:.3g}" for n, shift in enumerate(pair.shifts, 1))
    return TableSubject(teeth, f"m = {1e3 * pair.rack.module:g} mm", f"An {teeth}, {shifts}.")


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell a pair: what is given and found, then both tables of the sheet."""
    drafting = drafting_of(study.scene)
    told = [line for one in tables(study, drafting) for line in ("", *ruled(one.plain))]
    return Chapters(values=[chapter(drafting.language, NAME), *map(entry, _notes(study).all), *told])


REPORT = Report(chapters, headline, subject=subject)
