"""The tables of a scene's own sheets, which tell what a form leaves to the student (таблицы подлинников)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

from drawings.diagrams.due import columns, headings
from drawings.diagrams.report import NAME
from drawings.eye.alike import folded
from drawings.forces.due_acting import named as force_rows
from drawings.form.laid import BESIDE
from drawings.form.task import table_of
from drawings.grading.cells.asked_table import CellAsked, Key, SeenTable, Sought, TableAsked, number, tables_seen
from drawings.grading.cells.frames import ruling
from drawings.lettering.words import word
from drawings.linkage.due import VALUES as TABLE
from drawings.linkage.due import mass_centres, named
from drawings.original.originals import Original, Originals
from drawings.page.scale import drafting_of
from drawings.paper.strokes import Text
from drawings.paper.walk import groups, texts
from geometry.steps import Reading
from plans.diagrams.quantities import DiagramsComparison
from plans.linkage.by_hand import MotionByHand
from plans.model.motion import ORDERS
from plans.quantity import Quantity
from plans.study import Study
from plans.words.words import term


class Known(NamedTuple):
    """A value by the analysis, and how far the two roads may be apart in it."""

    value: float
    apart: float


def findings_of(study: Study, kind: str, table: str) -> Mapping[str, Quantity]:
    """Give the findings that the rows of a table tell, by their letters as they are read; of no other table any."""
    if (kind, table) == ("kinematics", TABLE):
        linkage, comparison = study["linkage"], study.comparison("linkage")
        parts = MotionByHand(linkage, comparison, mass_centres(linkage)).parts
        return named([*comparison.findings, *parts], linkage.language)
    if (kind, table) == ("forces", TABLE):
        rows = force_rows(study["forces"], study.comparison("forces"))
        return {Text(0j, letters).plain: one for letters, one in rows}
    return {}


def columns_of(study: Study, kind: str, table: str) -> Mapping[tuple[str, str], Known]:
    """Give what the analysis knows of a table of the output's course, by positions and headings; of no other any."""
    comparison = study.comparison("diagrams") if (kind, table) == ("kinematics", NAME) else None
    if not isinstance(comparison, DiagramsComparison):
        return {}
    heads = headings(comparison, drafting_of(study.scene))
    due = columns(comparison, abs(study["linkage"].mechanism.drive.omega))
    numbers = comparison.analysis.axis.numbers
    return {
        (str(number), head): Known(float(values[k]), apart)
        for head, (values, apart) in zip(heads, due, strict=True)
        for k, number in reversed(list(enumerate(numbers)))
        if math.isfinite(values[k]) and math.isfinite(apart)
    }


def known(one: Quantity | None, position: int | None) -> Known | None:
    """Give what the analysis knows of a row in a position, as a table tells it; None where it knows nothing.

    >>> import numpy as np
    >>> row = np.array([3 + 4j])
    >>> known(Quantity("velocities", "v_B", "m/s", row, row, np.zeros(1), np.zeros(1), 5.0), 0)
    Known(value=5.0, apart=0.0)
    """
    if one is None or position is None or not 0 <= position < len(one.analysis):
        return None
    found, apart = one.analysis[position], float(one.allowed[position])
    value = abs(found) if isinstance(found, complex) else float(found)
    return Known(float(value), apart) if math.isfinite(value) and math.isfinite(apart) else None


Rates: TypeAlias = Mapping[tuple[str, int | None], Reading]  # by the letter of a rate as it is seen, and its position
PLANS = ("kinematics",)  # kinds of sheets that the plans stand on


def rates_of(study: Study, kind: str, positions: Collection[int | None]) -> Rates:
    """Give what the rates of some positions are read off."""
    if kind not in PLANS:
        return {}
    plans = (
        (k, order, study["linkage"].drafts([k]).plan(order.number))
        for k in positions
        if k is not None
        for order in ORDERS[1:]
    )
    return {
        (folded(Text(0j, f"{order.link.symbol}_{{{link}}}").plain), k): reading
        for k, order, plan in plans
        for link, reading in plan.readings.items()
    }


READ_OFF = ("kinematics", "dynamics")  # kinds of sheets on which what has no error by hand is read off graphs
POSITIONS = ("output", "positions")  # tables whose rows are positions
COURSES = (*POSITIONS, "radii", "coordinates")  # tables that tell how a quantity goes on from row to row
CAM = "cam"  # what the data of a sheet say that its table is of
ROUNDED = 1e-9  # of a value: what is printed at the middle between two numbers may be either
MARKS = {-1: "_", 0: "", 1: "^"}


class _Part(NamedTuple):
    """A table or a part of one, and the sheet that it stands on."""

    sheet: Original
    table: SeenTable


def tables_asked(originals: Originals) -> tuple[TableAsked, ...]:
    """Give the tables of a scene's sheets whose cells a form leaves empty."""
    found: dict[Sought, list[_Part]] = {}
    for sheet in originals.sheets:
        for name, table in _of_sheet(originals, sheet):
            found.setdefault((sheet.kind, name, sheet.leaf.metadata.get(CAM)), []).append(_Part(sheet, table))
    return tuple(_Own(originals, sought, parts).asked() for sought, parts in found.items())


def _of_sheet(originals: Originals, sheet: Original) -> Iterator[tuple[str, SeenTable]]:
    seen = originals.seen(sheet)
    known = ((table_of(sheet.kind, one.name), one) for one in groups(seen.leaf.groups) if one.name)
    corners = [(next(texts((one,))), name) for name, one in known if name and any(texts((one,)))]
    if not corners:
        return
    for table in tables_seen(ruling(seen.leaf, seen.measured.moved), {folded(text.plain) for text, _ in corners}):
        yield from ((name, table) for text, name in corners if text is table.corner)


class _Own:
    """One table as our own sheets have it, in all its parts."""

    def __init__(self, originals: Originals, sought: Sought, parts: Sequence[_Part]) -> None:
        self.originals, self.sought, self.parts = originals, sought, parts
        self.labels = {label: text for part in parts for label, text in part.table.labels.items()}
        self.heads = {head: text for part in parts for head, text in part.table.heads.items()}
        self.cells = {key: (cell, part.sheet) for part in parts for key, cell in part.table.cells.items()}
        self.plan, self.analysis, *self.beside = (
            folded(word(originals.language, key)) for key in ("by plan", "by analysis", *BESIDE)
        )
        heads = [head for head in self.heads if head not in self.beside]
        self.across = 2 * sum(", " in text.plain for text in map(self.heads.__getitem__, heads)) > len(heads)
        self.findings = findings_of(originals.study, *sought[:2])
        self.columns = columns_of(originals.study, *sought[:2])
        self.rates: Rates = rates_of(originals.study, sought[0], {key[1] for key in self.cells})

    def asked(self) -> TableAsked:
        """Give what is asked for."""
        most: dict[tuple[str, str], float] = {}
        for key in self.cells:
            kind = self._told(key)
            most[kind] = max(abs(self._value(key) or 0.0), most.get(kind, 0.0))
        scales = {part.sheet.name: dict(self._scales(part.sheet)) for part in self.parts}
        course = self.sought[1] in COURSES
        cells = {
            key: self._cell(key, value, most[self._told(key)] if course else abs(value), scales[sheet.name])._replace(
                sheet=sheet.name
            )
            for key, (_, sheet) in self.cells.items()
            if (value := self._value(key)) is not None and key[2] not in self.beside
        }
        sheets = tuple(dict.fromkeys(part.sheet.name for part in self.parts))
        corner = folded(self.parts[0].table.corner.plain)
        titles = frozenset(part.sheet.leaf.title for part in self.parts)
        return TableAsked(self.sought, sheets, titles, corner, cells, self.originals.language)

    def _cell(self, key: Key, value: float, largest: float, scales: Mapping[str, float]) -> CellAsked:
        label, position, head = key
        quantity, unit = self._told(key)
        by_plan = head == self.plan
        analysis = self._value((label, position, self.analysis)) if by_plan else None
        names = _bare(self.labels[label].plain).split(" = ")
        letters = tuple(map(folded, names))
        read = letters if by_plan else ()
        hand = self._value((label, position, self.beside[0]))
        name, place = self._called(key, quantity)
        sure = known(next((self.findings[one] for one in names if one in self.findings), None), position)
        sure = sure or self.columns.get((self.labels[label].plain, self.heads[head].plain))
        half = _half(self._plain(key))
        return CellAsked(
            name,
            quantity,
            place,
            (sure.value,) if sure is not None else (value,) if analysis is None else (value, analysis),
            half if sure is None else half + sure.apart + ROUNDED * abs(sure.value),
            unit,
            largest,
            hand,
            scales.get(folded(unit), 0.0),
            hand is not None or self._is_told(key),
            int(place) if self.sought[1] in POSITIONS and place.isdigit() else position,
            read,
            next((self.rates[one, position] for one in read if (one, position) in self.rates), None),
        )

    def _called(self, key: Key, quantity: str) -> tuple[str, str]:
        """Give what a cell is called beside its position, and its place among those of its quantity."""
        label, position, head = key
        if not self.across:
            column = self.heads[head].plain
            return f"{quantity} ({column})", column if position is None else str(position)
        row = self.labels[label].plain
        return (quantity if self.sought[1] in POSITIONS else f"{quantity} ({row})"), row

    def _told(self, key: Key) -> tuple[str, str]:
        """Give the quantity of a cell and its unit."""
        label, head = self.labels[key[0]], self.heads[key[2]]
        named = head if self.across else label
        unit = next((own for one in (head, label) if (own := _unit(one.plain))), "")
        return _marked(named), unit

    def _plain(self, key: Key) -> str:
        return " ".join(text.plain for text in self.cells[key][0].texts)

    def _value(self, key: Key) -> float | None:
        """Read a cell; what is no number asks for none."""
        found = number(self.cells[key][0].texts) if key in self.cells else None
        return None if found is None or not found.understood else found.value

    def _is_told(self, key: Key) -> bool:
        """Tell whether a value of which no error by hand is told has none anywhere, and not by a dead centre."""
        return self.sought[1] != "values" or "(" in self.labels[key[0]].plain

    def _scales(self, sheet: Original) -> Iterator[tuple[str, float]]:
        """Give the coarsest scale of a sheet in each unit, as the sheet writes it."""
        if sheet.kind in READ_OFF:
            for mark in sorted(self.originals.seen(sheet).measured.marks, key=lambda one: one.scale):
                yield folded(Text(0j, term(self.originals.language, "unit", mark.unit)).plain), mark.scale


def _bare(plain: str) -> str:
    """Give the name of a quantity without its unit."""
    return plain.rpartition(", ")[0] if ", " in plain else plain


def _unit(plain: str) -> str:
    return plain.rpartition(", ")[2] if ", " in plain else ""


def _marked(text: Text) -> str:
    """Write the name of a quantity with its indices as verdicts do.

    >>> _marked(Text(0j, "a^{n}_{BA}, m/s^2"))
    'a^n_BA'
    """
    return _bare("".join(MARKS[run.level] + run.text for run in text.runs))


def _half(plain: str) -> float:
    """Give half of the last digit of a number that we have written."""
    return 0.5 * 10.0 ** -len(plain.replace(",", ".").partition(".")[2])
