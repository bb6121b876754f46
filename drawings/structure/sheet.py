"""The sheet of a structure: schemes, groups drawn apart, tables, the mechanism freed (лист структурного анализа)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Final

from drawings.layout.contents import Panel
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.lettering import text_width
from drawings.lettering.words import with_index
from drawings.linkage.positions import of_linkage
from drawings.linkage.skeleton import reference
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf, Text
from drawings.sheets.kind import FRAME as FRAMED
from drawings.sheets.kind import SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, exhibit, figures_facts
from drawings.structure import scheme
from drawings.structure.due import expected
from drawings.structure.links import group, primary, whole
from drawings.structure.notes import LISTED, StructureNotes
from drawings.structure.scheme import StructureScheme, formula_of
from plans.model.mechanism import FRAME
from plans.model.structure import ROMAN, GroupDivision
from plans.structure.study import STRUCTURE, StructureStudy
from plans.study import Study

PAIRS, DIVISIONS, WAYS, RESULTS = "pairs", "divisions", "ways", "results"  # the tables
KEY = "structure "  # how the words of the sheet begin
SCHEME, FREED, LOWERED, DIVISION = "structure", "freed", "lowered", "division-"  # the figures


def pairs_table(study: StructureStudy, drafting: Drafting) -> RuledTable:
    """Tell the pairs of a mechanism: links, kind, mobility, class."""
    rows = {
        pair.mark: (_row(pair.links), drafting.word(f"pair {pair.kind}"), f"p_{pair.mobility}", ROMAN[pair.constraints])
        for pair in study.structure.pairs
    }
    return _table(PAIRS, rows, "pairs", ("links", "kind", "mobility", "pair class"), drafting)


def divisions_table(study: StructureStudy, drafting: Drafting) -> RuledTable:
    """Tell the divisions of a mechanism for each choice of its primary link."""
    rows = {
        _row(one.primaries): (formula_of(one.formula), ROMAN[one.rank], _row(group.order for group in one.groups))
        for one in study.divisions
    }
    return _table(DIVISIONS, rows, "primary head", ("formula", "rank", "order"), drafting)


def _row(parts: Iterable[object]) -> str:
    return ", ".join(map(str, parts))


def ways_table(study: StructureStudy, drafting: Drafting, most: int | None = None) -> RuledTable:
    """Tell the ways of fewest changes to a mechanism without redundant constraints, all of them or the first."""
    names = {pair.key: with_index(pair.mark) for pair in study.structure.pairs}
    kinds = [kind for kind in "SCK" if any(way.of(kind) for way in study.replacements)]
    rows = {
        str(number): tuple(_row(names[key] for key in names if key in way.of(kind)) or "—" for kind in kinds)
        for number, way in enumerate(study.replacements[:most], 1)
    }
    return _table(WAYS, rows, "way", [f"pair {kind}" for kind in kinds], drafting, "")


def _table(
    name: str, rows: Mapping[str, tuple[str, ...]], first: str, heads: Sequence[str], drafting: Drafting, key: str = KEY
) -> RuledTable:
    lines = [TableRow(with_index(head) if "_" in head else head, cells) for head, cells in rows.items()]
    words = tuple(drafting.word(key + head) for head in heads)
    return table(lines, drafting.word(KEY + first), words, drafting.hand.text)._replace(name=name)


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's structure."""
    found, drafting = study.of(StructureStudy), drafting_of(study.scene)
    shows: tuple[Exhibit | Caption, ...] = (*_figures(found, drafting), *_captions(found, drafting))
    results = {k.name: (drafting.number(float(k.construction[0])),) for k in study.comparison(STRUCTURE).findings}
    tables = (pairs_table(found, drafting), _table(RESULTS, results, "number", ("value",), drafting))
    notes = StructureNotes(found, drafting).all
    title, size = drafting.word("structure sheet title"), drafting.hand.text
    # No formula is broken
    narrow = size + max(text_width(Text(0j, note, size)) for note in notes if note.startswith("W"))
    return lay_out(study.scene, [Draft(STRUCTURE, title, shows, tables, notes, figures_facts, SCHEME, narrow)])


def _figures(study: StructureStudy, drafting: Drafting) -> Iterator[Exhibit]:
    for shown in schemes(study, drafting):
        one = DIVISION if shown.name.startswith(DIVISION) else ""
        yield exhibit(scheme, shown, drafting, weight=shown.weight, scale=one)


def schemes(study: StructureStudy, drafting: Drafting) -> Iterator[StructureScheme]:
    """Give the figures of the sheet in their order."""
    word, fixed = drafting.word, reference(study.mechanism)
    first = whole(study, study.structure, fixed)
    yield StructureScheme(SCHEME, word("structure scheme"), (("", first),), stated=fixed, weight=1.5)
    if study.structure.higher:
        yield StructureScheme(LOWERED, word("structure lowered"), (("", whole(study, study.plain)),))
    yield from (_division_scheme(study, division, drafting) for division in study.divisions)
    if study.replacements:
        title = word("structure freed across" if study.freedom.within else "structure freed")
        changed = [pair for pair in study.freed.pairs if pair.key in dict(study.replacements[0].kinds)]
        names = _row(f"{with_index(pair.mark)} – {word(f'pair {pair.kind}')}" for pair in changed)
        yield StructureScheme(FREED, title, (("", whole(study, study.freed)),), further=names)


def _division_scheme(study: StructureStudy, division: GroupDivision, drafting: Drafting) -> StructureScheme:
    parts, known = [(f"I(0,{link})", primary(study, link)) for link in division.primaries], [FRAME, *division.primaries]
    for found in division.groups:
        parts.append((formula_of(found.label), group(study, found, known)))
        known += found.links
    name = f"{DIVISION}{'-'.join(map(str, division.primaries))}"
    title = drafting.word("structure primary", links=_row(division.primaries))
    further = drafting.word("structure class", rank=ROMAN[division.rank])
    return StructureScheme(name, title, tuple(parts), formula_of(division.formula), further)


def _captions(study: StructureStudy, drafting: Drafting) -> Iterator[Caption]:
    tables = [divisions_table(study, drafting)]
    tables += [ways_table(study, drafting, LISTED)] if study.replacements else []
    for each in tables:
        yield Caption(Panel(each.block(each.name)), partial(each.write, drafting=drafting))


FORM: Final = {SCHEME: FRAMED}
SCALES: Final = {SCHEME: "structure"}
SHEETS: Final = {"structure": SheetKind(leaves, expected, SCALES, of_linkage, figures=FORM, tables=(RESULTS,))}
