"""A cyclogram in the report: characteristic positions in a table, what is said of them (циклограмма в отчёте)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.cyclogram.notes import CyclogramNotes
from drawings.page.page import Drafting, drafting_of
from drawings.report.formula import DIGITS, Chapters, entry, plain
from drawings.report.report import Report, chapter
from plans.cyclogram.quantities import CyclogramComparison
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.study import Study
from plans.words.words import Message, message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


SHARE = 3  # digits


def headline(study: Study) -> str:
    """Say when an auxiliary mechanism may move."""
    return "; ".join(map(plain, _notes(study, drafting_of(study.scene)).window()))


def remarks(study: Study) -> list[Message]:
    """Warn of what no notches lead back from."""
    found = study.of(CyclogramStudy)
    trial = not all(stage.notched for stage in found.cyclogram.positions)
    return [message("sheet.cyclogram by trial")] if trial else []


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the cyclogram and its characteristic positions."""
    drafting = drafting_of(study.scene)
    title, notes = chapter(drafting.language, CYCLOGRAM), _notes(study, drafting).all
    lines = [*map(entry, notes), "", *_positions(study, drafting)]
    return Chapters(values=[title, *lines])


def _positions(study: Study, drafting: Drafting) -> Iterator[str]:
    """Give a line for each characteristic position, by both roads."""
    comparison = study.of(CyclogramComparison)
    pairs = zip(comparison.construction.positions, comparison.analysis.positions, strict=True)
    for number, (stage, other) in enumerate(pairs):
        angles = {"plan": stage.turned, "analysis": other.turned}
        texts = {name: drafting.number(math.degrees(angle), DIGITS) for name, angle in angles.items()}
        texts |= {"role": drafting.word(f"role {stage.role}"), "share": drafting.number(stage.share, SHARE)}
        yield word(drafting.language, "report.characteristic", position=number, **texts)


def _notes(study: Study, drafting: Drafting) -> CyclogramNotes:
    found = study.of(CyclogramStudy)
    return CyclogramNotes(found.cyclogram, found.cams, drafting, DIGITS)


REPORT = Report(chapters, headline, remarks)
