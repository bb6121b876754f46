"""The sheet of a task of synthesis: the construction of each reading, the lengths, what was asked (лист синтеза)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Final

from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.value_table import COLUMNS, NOTHING, value_row
from drawings.lettering.words import joined
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.kind import PLAN, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Draft, exhibit, figures_facts
from drawings.synthesis import construction, region
from drawings.synthesis.due import VALUES, expected, others, rows, slips, told
from drawings.synthesis.due_shown import NAME, shown
from plans.study import Study
from plans.synthesis.quantities import FIRST
from plans.synthesis.study import SynthesisStudy
from plans.words.words import term


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's task."""
    found, drafting = study.of(SynthesisStudy), drafting_of(study.scene)
    shows = tuple(
        exhibit(construction, one, drafting, weight=2.0 if one.name == NAME else 1.0, scale=NAME)
        for one in shown(found)
    )
    shows += tuple(exhibit(region, one, drafting) for one in region.shown(found.region))
    said = tuple(notes(found, drafting))
    later = partial(slips, study.comparison(NAME))
    draft = Draft(
        NAME,
        drafting.word("synthesis sheet title"),
        shows,
        (values(study, drafting),),
        said,
        figures_facts,
        NAME,
        later=later,
    )
    return lay_out(study.scene, [draft])


def family(found: SynthesisStudy, language: str) -> str:
    """Name the mechanism that is asked for."""
    return term(language, "family", found.key)


def values(study: Study, drafting: Drafting) -> RuledTable:
    """Tell the lengths and angles by both roads; of further mechanisms each has a column."""
    comparison = study.comparison(NAME)
    beside = others(comparison)
    lines = []
    for row, found in rows(comparison, drafting).items():
        each = [
            value_row(found[one], row, (0,), drafting.language).cells if one in found else [NOTHING] * len(COLUMNS)
            for one in (FIRST, *beside)
        ]
        lines.append(TableRow(row, (*each[0][:2], *(cells[0] for cells in each[1:]), each[0][2])))
    plan, analysis, hand = map(drafting.word, COLUMNS)
    heads = plan, analysis, *(drafting.phrase("synthesis by roads", letter=one) for one in beside), hand
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text)._replace(name=VALUES)


def notes(study: SynthesisStudy, drafting: Drafting) -> Iterator[str]:
    """Say what was asked, and what the family says of how it is found."""
    parts = [told(name, one, drafting) for name, one in study.task.asked.items()]
    yield drafting.phrase("synthesis asked", mechanism=family(study, drafting.language), parts=joined(", ", parts))
    yield from map(drafting.word, study.family.notes(study.task))
    if study.region is not None:
        yield drafting.word("synthesis region")


SCALES: Final = {NAME: "synthesis"}
FORM: Final = {NAME: PLAN}
SHEETS: Final = {NAME: SheetKind(leaves, expected, SCALES, figures=FORM, tables=(VALUES,))}
