"""A structure in the report: mobility, pairs, divisions, ways to free it of redundant constraints (отчёт)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.page.page import drafting_of
from drawings.report.formula import Chapters, entry, plain
from drawings.report.report import Report, TableSubject, chapter, ruled
from drawings.structure.notes import StructureNotes
from drawings.structure.sheet import divisions_table, pairs_table, ways_table
from plans.structure.study import STRUCTURE, StructureStudy
from plans.study import Study
from plans.words.words import word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def headline(study: Study) -> str:
    """Say how many redundant constraints there are, and what class the mechanism has."""
    notes = StructureNotes(study.of(StructureStudy), drafting_of(study.scene))
    return "; ".join(map(plain, (*notes.redundant(), *notes.ranks())))


def subject(study: Study) -> TableSubject:
    """Tell the structure by its formula and its redundant constraints."""
    found = study.of(StructureStudy)
    q = word("en", "structure.told", q=found.freedom.redundant)
    return TableSubject(found.chosen.formula, q, f"{found.chosen.formula}, {q}.")


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the structure: what is worked out, then all tables of the sheet."""
    found, drafting = study.of(StructureStudy), drafting_of(study.scene)
    tables = [pairs_table(found, drafting), divisions_table(found, drafting)]
    tables += [ways_table(found, drafting)] if found.replacements else []
    told = [line for each in tables for line in ("", *ruled(each.plain))]
    notes = map(entry, StructureNotes(found, drafting).all)
    return Chapters(values=[chapter(drafting.language, STRUCTURE), *notes, *told])


REPORT = Report(chapters, headline, subject=subject)
