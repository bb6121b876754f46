"""What a sheet says a hand may be out, held against each slip tried by itself (проверка точности от руки).

The sheet's numbers come from the slopes of the acts by rule; here every slip of the record is made, one at a time, and
the record drawn again with it. How slips add up to what 95 of 100 drawings are within is reckoned once, for both.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Set
from typing import NamedTuple

from drawings.checks import reading
from drawings.checks.wrong import Wrong, within
from drawings.lettering.words import word
from drawings.measure.measure import Measured
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups
from plans.checks.comparison import Finding
from plans.words.words import message

Errors = Mapping[tuple[str, int], float]  # by the name and the position of a finding

DIGITS = 2  # of what is told
PLACES = 5  # digits of the largest value of a row, which tell how many decimals its cells have
HEADS = ("quantity", "by plan", "by analysis", "by hand")
EQUAL = " = "  # between the names of what is one, and has one row
TRIED = 1e-4  # of an error: what trying a slip, instead of its slope, leaves out


class Told(NamedTuple):
    """What a hand may be out, twice: by the slopes of the acts, which also say where they tell nothing; by trying."""

    ruled: Errors
    tried: Errors

    def of(self, finding: Finding, position: int) -> float:
        """Give what a cell must say; NaN: nothing, as where there is no value."""
        key = finding.name, position
        if math.isnan(abs(finding.analysis[position])) or not self.ruled.get(key, math.nan) <= finding.largest:
            return math.nan
        return self.tried[key]


def wrong_cells(leaf: Leaf, named: Mapping[str, Finding], told: Told) -> Iterator[Wrong]:
    """Give the cells of the tables of a sheet that tell another error than a hand makes at its scales."""
    for group in reading.value_tables(leaf):
        for row in _wrong(group, named, told, reading.positions_of(group)):
            yield message("wrong.value", text=row.third, name=row.finding.name, position=row.position)


def wrong_results(
    leaf: Leaf, table: str, named: Mapping[str, Finding], told: Told | None, language: str
) -> Iterator[Wrong]:
    """Give the same of a table of no position, by its name, and each of its parts that has other headings.

    Where nothing is `told` it has no column of the hand.
    """
    heads = [Text(0j, word(language, key)).plain for key in (HEADS if told is not None else HEADS[:-1])]
    for group in (one for one in groups(leaf.groups) if one.name.removeprefix(f"{table}-").isdigit()):
        if heads not in ([text.plain for text in row] for row in reading.rows(group)):
            yield within("in", table, text=heads[-1])
        for row in _wrong(group, named, told, (0,)) if told is not None else ():
            yield within("cell", table, name=row.finding.name, text=row.third)


def _wrong(
    group: Group, named: Mapping[str, Finding], told: Told, positions: tuple[int, ...]
) -> Iterator[reading.Cells]:
    rows = reading.cells(group, named, positions)
    return (row for row in rows if not holds(row.third, told.of(row.finding, row.position), row.finding.largest))


def missing_rows(leaf: Leaf, due: Mapping[str, Set[str]]) -> Iterator[Wrong]:
    """Name the rows that are left out: all that are due stand on a set of one sheet, of a longer one each has a run.

    `due` are the rows in their order, by what their first cells say before the unit, each with those before it that
    are the same vector: a row of several names has the place of the first, so that a sheet before this one may have it.
    """
    rows = [row for group in reading.value_tables(leaf) for row in reading.rows(group)]
    heads = [text.plain.rsplit(", ", 1)[0].split(EQUAL) for row in rows for text in row]
    order, seen = list(due), {name for head in heads for name in head}
    places = sorted(min(map(order.index, own)) for head in heads if (own := [one for one in head if one in due]))
    first, last = (0, len(order)) if leaf.metadata["of"] == 1 else (places[0], places[-1]) if places else (0, 0)
    run, before = order[first:last], order[:first]
    lost = (name for name in run if name not in seen and not due[name] & {*before})
    yield from (message("wrong.row_missing", name=name) for name in lost)


def wrong_scales(measured: Measured, leaf: Leaf, figures: tuple[str, ...]) -> Iterator[Wrong]:
    """Name the figures that are drawn to other scales than the table counts with."""
    scales = {name: mu for name, mu in leaf.metadata["scales"].items() if name.startswith(figures)}
    for mark in (*measured.vectors, *measured.points):
        told = scales.get(mark.plan, scales.get(f"{mark.plan}-{mark.position}"))
        if told is not None and not math.isclose(told, mark.scale):
            yield message("wrong.scale", text=f"{mark.plan} {mark.scale:g}")


def wrong_headings(leaf: Leaf, figures: tuple[str, ...]) -> Iterator[Wrong]:
    """Name the figures of a position whose headings state another scale than the table counts with."""
    scales, position = leaf.metadata["scales"], leaf.metadata["position"]
    for name in (one for one in scales if one.startswith(figures)):
        for group in (one for one in leaf.groups if one.name == f"{name}-{position}"):
            yield from reading.scales(group, [scales[name]])


def holds(text: str, error: float, largest: float) -> bool:
    """Tell whether a cell says an error to two digits, or to the last decimal of its row, whose largest value it is."""
    if math.isnan(error):
        return text == "—"
    if not text.startswith("±"):
        return False
    last = math.pow(10.0, min(math.floor(math.log10(largest)) + 1 - PLACES, 0))
    digits = DIGITS if error >= (1 - TRIED) * 10 * last else 0
    return reading.reads(text[1:], error, TRIED * error, digits)
