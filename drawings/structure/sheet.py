"""The sheet of a structure: schemes, groups drawn apart, tables, the mechanism freed (лист структурного анализа)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
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
from drawings.sheets.kind import PLAN, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, exhibit, figures_facts
from drawings.structure import scheme
from drawings.structure.due import expected
from drawings.structure.links import group, primary, whole
from drawings.structure.notes import LISTED, StructureNotes
from drawings.structure.scheme import StructureScheme, formula_of
from plans.model.mechanism import FRAME
from plans.model.structure import CYLINDRICAL, POINT, ROMAN, SPHERICAL, GroupDivision, KinematicPair
from plans.quantity import Comparison
from plans.structure.study import STRUCTURE, StructureStudy
from plans.study import Study

PAIRS, DIVISIONS, WAYS, RESULTS = "pairs", "divisions", "ways", "results"  # the tables
SCHEME, FREED, LOWERED, DIVISION = "structure", "freed", "lowered", "division-"  # the figures


def pairs_table(study: StructureStudy, drafting: Drafting) -> RuledTable:
    """Tell the pairs of a mechanism: links, kind, mobility, class."""
    lines = [TableRow(with_index(pair.name), _pair(pair, drafting)) for pair in study.structure.pairs]
    heads = ("structure links", "structure kind", "structure mobility", "structure pair class")
    return _table(PAIRS, lines, "structure pairs", heads, drafting)


def _pair(pair: KinematicPair, drafting: Drafting) -> tuple[str, ...]:
    kind = drafting.word(f"pair {pair.kind}")
    return ", ".join(map(str, pair.links)), kind, f"p_{pair.mobility}", ROMAN[pair.constraints]


def divisions_table(study: StructureStudy, drafting: Drafting) -> RuledTable:
    """Tell the divisions of a mechanism for each choice of its primary link."""
    lines = [TableRow(_links(division), _division(division)) for division in study.divisions]
    heads = ("structure formula", "structure rank", "structure order")
    return _table(DIVISIONS, lines, "structure primary head", heads, drafting)


def _links(division: GroupDivision) -> str:
    return ", ".join(map(str, division.primaries))


def _division(division: GroupDivision) -> tuple[str, ...]:
    orders = ", ".join(str(group.order) for group in division.groups)
    return formula_of(division.formula), ROMAN[division.rank], orders


def ways_table(study: StructureStudy, drafting: Drafting, most: int | None = None) -> RuledTable:
    """Tell the ways of fewest changes to a mechanism without redundant constraints, all of them or the first."""
    names = {pair.key: with_index(pair.name) for pair in study.structure.pairs}
    kinds = [kind for kind in (SPHERICAL, CYLINDRICAL, POINT) if any(way.of(kind) for way in study.replacements)]
    lines = [
        TableRow(
            str(number), tuple(", ".join(names[key] for key in names if key in way.of(kind)) or "—" for kind in kinds)
        )
        for number, way in enumerate(study.replacements[:most], 1)
    ]
    return _table(WAYS, lines, "structure way", tuple(f"pair {kind}" for kind in kinds), drafting)


def results_table(comparison: Comparison, drafting: Drafting) -> RuledTable:
    """Tell the numbers that are found."""
    found = ((with_index(one.name), float(one.construction[0])) for one in comparison.findings)
    lines = [TableRow(name, (drafting.number(value),)) for name, value in found]
    return _table(RESULTS, lines, "quantity", ("structure value",), drafting)


def _table(name: str, lines: list[TableRow], first: str, heads: Sequence[str], drafting: Drafting) -> RuledTable:
    words = tuple(drafting.word(head) for head in heads)
    return table(lines, drafting.word(first), words, drafting.hand.text)._replace(name=name)


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's structure."""
    found, drafting = study.of(StructureStudy), drafting_of(study.scene)
    shows: tuple[Exhibit | Caption, ...] = (*_figures(found, drafting), *_captions(found, drafting))
    tables = (pairs_table(found, drafting), results_table(study.comparison(STRUCTURE), drafting))
    notes = StructureNotes(found, drafting).all
    title = drafting.word("structure sheet title")
    size = drafting.hand.text
    narrow = size + max(
        text_width(Text(0j, note, size)) for note in notes if note.startswith("W")
    )  # no formula is broken
    return lay_out(study.scene, [Draft(STRUCTURE, title, shows, tables, notes, figures_facts, SCHEME, narrow)])


def _figures(study: StructureStudy, drafting: Drafting) -> Iterator[Exhibit]:
    for shown in schemes(study, drafting):
        one = DIVISION if shown.name.startswith(DIVISION) else ""
        yield exhibit(scheme, shown, drafting, weight=shown.weight, scale=one)


def schemes(study: StructureStudy, drafting: Drafting) -> Iterator[StructureScheme]:
    """Give the figures of the sheet in their order."""
    word, fixed = drafting.word, reference(study.mechanism)
    first = whole(study, study.structure, fixed)
    yield StructureScheme(SCHEME, word("structure scheme"), "", (("", first),), stated=fixed, weight=1.5)
    if study.structure.higher:
        yield StructureScheme(LOWERED, word("structure lowered"), "", (("", whole(study, study.plain)),))
    for division in study.divisions:
        yield _division_scheme(study, division, drafting)
    if study.replacements:
        changed = dict(study.replacements[0].kinds)
        names = (
            f"{with_index(pair.name)} – {word(f'pair {pair.kind}')}"
            for pair in study.freed.pairs
            if pair.key in changed
        )
        yield StructureScheme(
            FREED,
            word("structure freed across" if study.freedom.within else "structure freed"),
            "",
            (("", whole(study, study.freed)),),
            ", ".join(names),
        )


def _division_scheme(study: StructureStudy, division: GroupDivision, drafting: Drafting) -> StructureScheme:
    parts, known = [(f"I(0,{link})", primary(study, link)) for link in division.primaries], [FRAME, *division.primaries]
    for found in division.groups:
        parts.append((formula_of(found.label), group(study, found, known)))
        known += found.links
    title = drafting.word("structure primary", links=_links(division))
    further = drafting.word("structure class", rank=ROMAN[division.rank])
    return StructureScheme(
        f"{DIVISION}{'-'.join(map(str, division.primaries))}",
        title,
        formula_of(division.formula),
        tuple(parts),
        further,
    )


def _captions(study: StructureStudy, drafting: Drafting) -> Iterator[Caption]:
    tables = [divisions_table(study, drafting)]
    tables += [ways_table(study, drafting, LISTED)] if study.replacements else []
    for each in tables:
        yield Caption(Panel(each.block(each.name)), partial(each.write, drafting=drafting))


FORM: Final = {SCHEME: PLAN}
SCALES: Final = {SCHEME: "structure"}
SHEETS: Final = {"structure": SheetKind(leaves, expected, SCALES, of_linkage, figures=FORM, tables=(RESULTS,))}
