"""A cyclogram in the report: characteristic positions in a table, what is said of them (циклограмма в отчёте)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from drawings.cyclogram.notes import CyclogramNotes
from drawings.cyclogram.sheet import HEADS, SWINGS, cells, name
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.formula import Chapters, entry, plain
from drawings.report.report import Report, chapter, header, row
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.model.cyclogram import BEGIN, END, Cyclogram, Position
from plans.study import Study
from plans.words.words import Message, message

TIMES = 3  # digits of a condition


def headline(study: Study) -> str:
    """Say when an auxiliary mechanism may move."""
    return "; ".join(map(plain, _notes(study, drafting_of(study.scene)).window()))


def remarks(study: Study) -> list[Message]:
    """Warn of what no notches lead back from."""
    trial = not all(stage.notched for stage in study.of(CyclogramStudy).cyclogram.positions)
    return [message("sheet.cyclogram by trial")] if trial else []


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the cyclogram and its characteristic positions."""
    drafting = drafting_of(study.scene)
    title, said = chapter(drafting.language, CYCLOGRAM), _notes(study, drafting)
    notes = *said.machine(), *said.window(), *said.settings(), *said.reading()
    return Chapters(values=[title, *map(entry, notes), "", *_positions(study, drafting)])


def _positions(study: Study, drafting: Drafting) -> Iterator[str]:
    found = study.of(CyclogramStudy).cyclogram
    heads = "characteristic position", *(HEADS if found.sliding else SWINGS), "condition"
    yield from header([drafting.word(head) for head in heads])
    yield from (row(_cells(k, position, found, drafting)) for k, position in enumerate(found.positions))
    yield f"\n{drafting.word('cyclogram condition')}"


def _cells(k: int, position: Position, found: Cyclogram, drafting: Drafting) -> list[str]:
    condition = "∞" if position.role in (BEGIN, END) else drafting.number(position.condition, TIMES)
    return [name(k, position, drafting), *cells(position, found, drafting), condition]


def _notes(study: Study, drafting: Drafting) -> CyclogramNotes:
    found = study.of(CyclogramStudy)
    return CyclogramNotes(found.cyclogram, found.cams, drafting)


REPORT = Report(chapters, headline, remarks)
