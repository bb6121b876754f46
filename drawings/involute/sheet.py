"""The sheet of an involute pair: mesh, generation, sliding, tables of sizes and of measuring (лист передачи)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Final

from drawings.involute import generation, mesh, sliding
from drawings.involute.due import DATA, DIGITS, PAIR, SIZES, data_rows, expected, pair_rows, size_rows, slips
from drawings.involute.notes import InvoluteNotes
from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.value_table import COLUMNS, value_row
from drawings.lettering.words import fixed
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.kind import GRAPH, PLAN, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Draft, exhibit, figures_facts
from plans.involute.study import InvoluteStudy
from plans.study import Study

NAME = "involute"


def tables(study: Study, drafting: Drafting) -> tuple[RuledTable, ...]:
    """Tell the data of both wheels, the sizes of the pair, those of each wheel, as they are drawn and by formulas."""
    found, comparison = study.of(InvoluteStudy), study.comparison(NAME)
    word, text = drafting.word, drafting.hand.text
    roads = tuple(map(word, COLUMNS[:2]))
    both = tuple(word("involute wheel", number=n, road=road) for n in (1, 2) for road in roads)
    first = [value_row(one, name, (0,), drafting.language) for name, one in pair_rows(comparison, drafting)]
    second = [_row(name, cells, places, drafting) for name, cells, places in size_rows(comparison, drafting)]
    data = [
        TableRow(name, tuple("—" if one is None else drafting.number(one, DIGITS) for one in cells))
        for name, cells in data_rows(found.pair, found.sizes, drafting)
    ]
    wheels = tuple(word("involute wheel alone", number=n) for n in (1, 2))
    return (
        table(data, word("involute data"), wheels, text)._replace(name=DATA),
        table(first, word("quantity"), tuple(map(word, COLUMNS)), text)._replace(name=PAIR),
        table(second, word("involute sizes"), both, text)._replace(name=SIZES),
    )


def _row(name: str, cells: Sequence[float | None], places: int, drafting: Drafting) -> TableRow:
    return TableRow(name, tuple("—" if one is None else fixed(one, drafting.language, places) for one in cells))


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's pair."""
    found, drafting = study.of(InvoluteStudy), drafting_of(study.scene)
    shows = (
        exhibit(mesh, mesh.shown(found), drafting, weight=2.0),
        exhibit(generation, generation.shown(found), drafting),
        exhibit(sliding, sliding.shown(found), drafting),
    )
    told = tables(study, drafting)
    title, notes = drafting.word("involute sheet title"), InvoluteNotes(found, drafting).all
    later = partial(slips, study.comparison(NAME))
    return lay_out(study.scene, [Draft(NAME, title, shows, told, notes, figures_facts, mesh.NAME, later=later)])


SCALES: Final = {mesh.NAME: "mesh", generation.NAME: "generation"}
FORM: Final = {mesh.NAME: PLAN, generation.NAME: PLAN, sliding.NAME: GRAPH}
SHEETS: Final = {NAME: SheetKind(leaves, expected, SCALES, figures=FORM, tables=(DATA, PAIR, SIZES))}
