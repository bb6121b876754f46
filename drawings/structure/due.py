"""What must stand on the sheet of a structure: numbers by the analysis, pairs as they are given (лист структуры)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

from drawings.checks.expected import NOTES, Expected, cells
from drawings.lettering.words import with_index
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.model.structure import ROMAN, SPACE
from plans.structure.study import STRUCTURE, StructureStudy
from plans.study import Study

PAIRS, DIVISIONS, WAYS = "pairs", "divisions", "ways"
MOST_WAYS = 40  # that a sheet lists
FAR = 1e-9  # of a place: both roads take it from one position of the linkage


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's structure."""
    found, drafting = study.of(StructureStudy), drafting_of(study.scene)
    numbers = {one.name: float(one.analysis[0]) for one in study.comparison(STRUCTURE).findings}
    tables = _pairs(found, drafting), _divisions(found, numbers), _ways(found)
    results = (cells("results", with_index(name), [(value, 0.0)]) for name, value in numbers.items())
    yield from chain(_points(found), *results, *tables, _notes(found, numbers))


def _points(study: StructureStudy) -> Iterator[Expected]:
    """Give the places of the scheme's points; the one that they are measured from is no point."""
    for name, place in study.pose.points.items():
        yield Expected(Kind.POINT, STRUCTURE, name, place, FAR * abs(place), may_lack=True)


def _pairs(study: StructureStudy, drafting: Drafting) -> Iterator[Expected]:
    for pair in study.structure.pairs:
        kind = drafting.word(f"pair {pair.kind}")
        row = ", ".join(map(str, pair.links)), kind, f"p{pair.mobility}", ROMAN[SPACE - pair.mobility]
        yield from cells(PAIRS, with_index(pair.mark), row)


def _divisions(study: StructureStudy, numbers: dict[str, float]) -> Iterator[Expected]:
    """Give the divisions whose groups the analysis finds too, each with its class."""
    for division in study.divisions:
        formula = division.formula.replace(" -> ", " → ")
        orders = ", ".join(str(group.order) for group in division.groups) or "—"
        rank = ROMAN[max(int(numbers[division.letters]), 0)]
        yield from cells(DIVISIONS, ", ".join(map(str, division.primaries)), (formula, rank, orders))


def _ways(study: StructureStudy) -> Iterator[Expected]:
    names = {pair.key: pair.mark.replace("_", "") for pair in study.structure.pairs}
    kinds = [kind for kind in "SCK" if any(way.of(kind) for way in study.replacements)]
    for number, way in enumerate(study.replacements[:MOST_WAYS], 1):
        row = [", ".join(names[key] for key in names if key in way.of(kind)) or None for kind in kinds]
        yield from cells(WAYS, str(number), row)


def _notes(study: StructureStudy, numbers: dict[str, float]) -> Iterator[Expected]:
    """Give the numbers of the notes by the names of their quantities."""
    said = ("W", "W_s", "q", *(("N", "W'_s", "q'") if study.replacements else ()))
    for name in said:
        yield Expected(Kind.PHRASE, NOTES, name, numbers[name])
    chosen = study.chosen.letters
    yield Expected(Kind.PHRASE, NOTES, chosen, numbers[chosen])
    yield Expected(Kind.PHRASE, NOTES, "W_c", study.structure.planar)
    yield Expected(Kind.PHRASE, NOTES, "q_w", study.freedom.within, may_lack=not study.freedom.within)
