"""Tables of a task: cells, each with its true value and what a hand may be out in it; where a sheet has them."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

from drawings.checks.differences import plain
from drawings.checks.expected import Expected
from drawings.form.laid import BESIDE
from drawings.grading.allowance import DEVIATIONS, Allowance, Allowances
from drawings.grading.altered import idle_due
from drawings.grading.cells.seen_table import Key, SeenCell, SeenTable, ruling, tables_seen
from drawings.grading.curves.figure_records import PRICKED
from drawings.grading.written_number import SURE, number
from drawings.lettering.words import last_place, word
from drawings.paper.strokes import Text
from drawings.paper.walk import groups, stated, texts
from drawings.reading.alphabet import folded
from drawings.reading.sheet import SeenSheet
from drawings.redrawn import Original, Originals
from drawings.sheets.kind import table_of
from geometry.board import Reading
from geometry.hand_error import POINT
from plans.linkage.study import LinkageStudy
from plans.model.motion import ORDERS
from plans.quantity import SLIP
from plans.study import Study
from plans.words.words import term

Sought: TypeAlias = tuple[str, str, int | None]  # a kind of sheet, a table of it, the cam that the sheet is of

ROUGH = 40.0  # mm: what no figure tells the scale of is read off a graph that is at the least so high


class CellAsked(NamedTuple):
    """One cell: what it tells of and how that is called, in which position or row, its value.

    `hand` is what 95 of 100 drawings are within, `coarse` how much of the quantity a mm of paper shows, `largest` its
    largest value. A cell that is not `told` lies so near a dead centre that slips tell nothing of it.
    """

    name: str
    quantity: str
    place: str
    true: float
    printed: float  # half of the last digit
    unit: str
    largest: float
    hand: float | None = None
    coarse: float = 0.0
    told: bool = True
    position: int | None = None
    read: tuple[str, ...] = ()  # the vectors that it is read off, as their letters are seen
    reading: Reading | None = None  # or the rate
    sheet: str = ""  # the sheet of the task that it stands on
    idle: float | None = None  # what it is if the idle stroke is loaded

    def allowed(self, by: Allowances, rough: float) -> float:
        """Give what it may be out, of a sheet that is written so roughly, mm."""
        allowance = by.to(self.quantity)
        if allowance.share is not None:
            return allowance.share * self.largest + self.printed
        return self._by_hand(allowance, rough) + self.printed

    def is_(self, value: float) -> bool:
        """Tell whether it tells of a value, as it is printed."""
        return abs(value - self.true) <= self.printed + ROUNDED * abs(self.true)

    def pricked(self, by: Allowances, rough: float, scale: float) -> float:
        """Give what it may be out that is read off a vector of some scale, true units a mm, both ends pricked."""
        return DEVIATIONS * PRICKED * max(by.to(self.quantity).slip, rough) * scale + self.printed

    def _by_hand(self, by: Allowance, rough: float) -> float:
        slip = max(by.slip, rough)
        if self.hand is not None:
            return self.hand * slip / SLIP * DEVIATIONS / POINT
        return DEVIATIONS * PRICKED * slip * max(self.coarse, self.largest / ROUGH)


@dataclass(frozen=True)
class TableAsked:
    """A table that is asked for: its name, the sheets that it stands on and their titles, its corner, its cells."""

    sought: Sought
    sheets: tuple[str, ...]
    titles: frozenset[str]
    corner: str
    cells: Mapping[Key, CellAsked]
    language: str

    @property
    def name(self) -> str:
        """What it is called."""
        return f"table {self.sought[1]}"


Rates: TypeAlias = Mapping[tuple[str, int | None], Reading]  # by the letter of a rate as it is seen, and its position
PLANS = ("kinematics",)  # kinds of sheets that the plans stand on


def rates_of(study: Study, kind: str, positions: Collection[int | None]) -> Rates:
    """Give what the rates of some positions are read off."""
    if kind not in PLANS:
        return {}
    known, drafts = [k for k in positions if k is not None], study.of(LinkageStudy).drafts
    plans = ((k, order, drafts([k]).plan(order.number)) for k in known for order in ORDERS[1:])
    return {
        (folded(Text(0j, f"{order.link.symbol}_{{{link}}}").plain), k): reading
        for k, order, plan in plans
        for link, reading in plan.readings.items()
    }


READ_OFF = ("kinematics", "dynamics", "involute")  # sheets whose values without an error by hand are read off figures
POSITIONS = ("output", "positions")  # tables whose rows are positions
COURSES = (*POSITIONS, "radii", "coordinates")  # tables that tell how a quantity goes on from row to row
CAM = "cam"  # what the data of a sheet say that its table is of
ROUNDED = 1e-9  # of a value: what is printed at the middle between two numbers may be either
MARKS = {-1: "_", 0: "", 1: "^"}


class _Cell(NamedTuple):
    """A cell of our own: how it is written, what is due in it, the sheet that it stands on."""

    plain: str
    expected: Expected
    sheet: Original
    idle: Expected | None = None


class _TablePart(NamedTuple):
    """A table or a part of one: the sheet that it stands on, and those of its cells in which something is due."""

    sheet: Original
    table: SeenTable
    cells: Mapping[Key, _Cell]


def tables_asked(originals: Originals) -> tuple[TableAsked, ...]:
    """Give the tables of a scene's sheets whose cells a form leaves empty."""
    found: dict[Sought, list[_TablePart]] = {}
    for sheet in originals.sheets:
        for name, part in _of_sheet(originals, sheet):
            found.setdefault((sheet.kind, name, sheet.leaf.metadata.get(CAM)), []).append(part)
    return tuple(_Own(originals, sought, parts).asked() for sought, parts in found.items())


def _of_sheet(originals: Originals, sheet: Original) -> Iterator[tuple[str, _TablePart]]:
    leaf, expected = plain(sheet.leaf, sheet.leaf.lettering), originals.expected(sheet)
    bare = (group for group in groups(leaf.groups) if group.name)
    bands = ((table_of(sheet.kind, group.name), next(texts((group,)), None)) for group in bare)
    corners = [(text, name) for name, text in bands if name and text is not None]
    if not corners:
        return
    states = ((group.states.key, group) for group in stated(leaf.groups) if group.states is not None)
    by_text = {id(text): expected[key] for key, group in states if key in expected for text in texts((group,))}
    idle = idle_due(originals, sheet.kind)
    for table in tables_seen(ruling(leaf), {folded(text.plain) for text, _ in corners}):
        cells = {
            key: _Cell(
                " ".join(text.plain for text in cell.texts), due, sheet, idle.get((due.kind, due.figure, due.name))
            )
            for key, cell in table.cells.items()
            if cell.texts and (due := by_text.get(id(cell.texts[0]))) is not None
        }
        yield from ((name, _TablePart(sheet, table, cells)) for text, name in corners if text is table.corner)


class _Own:
    """One table as our own sheets have it, in all its parts."""

    def __init__(self, originals: Originals, sought: Sought, parts: Sequence[_TablePart]) -> None:
        self.originals, self.sought, self.parts = originals, sought, parts
        self.labels = {label: text for part in parts for label, text in part.table.labels.items()}
        self.heads = {head: text for part in parts for head, text in part.table.heads.items()}
        self.cells = {key: cell for part in parts for key, cell in part.cells.items()}
        self.plan, *self.beside = (folded(word(originals.language, key)) for key in ("by plan", *BESIDE))
        heads = [head for head in self.heads if head not in self.beside]
        self.across = 2 * sum(", " in text.plain for text in map(self.heads.__getitem__, heads)) > len(heads)
        self.rates: Rates = rates_of(originals.study, sought[0], {key[1] for key in self.cells})

    def asked(self) -> TableAsked:
        """Give what is asked for: all cells in which a number is due."""
        values = {key: value for key in self.cells if (value := self._value(key)) is not None}
        asked = {key: value for key, value in values.items() if key[2] not in self.beside}
        most: dict[tuple[str, str], float] = {}
        for key, value in asked.items() if self.sought[1] in COURSES else ():
            most[self._worded(key)] = max(abs(value), most.get(self._worded(key), 0.0))
        scales = {part.sheet.name: dict(self._scales(part.sheet)) for part in self.parts}
        sizes = {key: most.get(self._worded(key), abs(value)) for key, value in asked.items()}
        # No slip alters a count.
        sizes |= {key: 0.0 for key in asked if isinstance(self.cells[key].expected.value, int)}
        cells = {key: self._cell(key, value, sizes[key]) for key, value in asked.items()}
        for key, cell in cells.items():
            cells[key] = cell._replace(coarse=scales[cell.sheet].get(folded(cell.unit), 0.0))
        sheets = tuple(dict.fromkeys(part.sheet.name for part in self.parts))
        corner = folded(self.parts[0].table.corner.plain)
        titles = frozenset(part.sheet.leaf.title for part in self.parts)
        return TableAsked(self.sought, sheets, titles, corner, cells, self.originals.language)

    def _cell(self, key: Key, value: float, largest: float) -> CellAsked:
        label, position, head = key
        quantity, unit = self._worded(key)
        read = tuple(map(folded, _bare(self.labels[label].plain).split(" = "))) if head == self.plan else ()
        hand = self._value((label, position, self.beside[0]))
        name, place = self._called(key, quantity)
        told = hand is not None or self.sought[1] != "values"  # where it lies by a dead centre
        shown = int(place) if self.sought[1] in POSITIONS and place.isdigit() else position
        return CellAsked(
            name, quantity, place, value, self._printed(key, value, largest), unit, largest,
            hand if head == self.plan else None, told=told, position=shown, read=read,
            reading=next((self.rates[vector, position] for vector in read if (vector, position) in self.rates), None),
            sheet=self.cells[key].sheet.name,
            idle=_due(self.cells[key].idle),
        )  # fmt: skip

    def _printed(self, key: Key, value: float, largest: float) -> float:
        """Give how far what is printed is from the value, by its last digit where that is not told by three others."""
        plain, expected, *_ = self.cells[key]
        written = number((Text(0j, plain),))
        off = math.inf if written is None or not largest else abs(written.value - value)
        rough = 0.5 * 10.0 ** (math.floor(math.log10(largest or 1.0)) + 1 - SURE)
        return (off if off <= rough else 0.5 * 10.0 ** last_place(plain)) + expected.allowed + ROUNDED * abs(value)

    def _called(self, key: Key, quantity: str) -> tuple[str, str]:
        """Give what a cell is called beside its position, and its place among those of its quantity."""
        label, position, head = key
        if not self.across:
            column = self.heads[head].plain
            return f"{quantity} ({column})", column if position is None else str(position)
        row = self.labels[label].plain
        return (quantity if self.sought[1] in POSITIONS else f"{quantity} ({row})"), row

    def _worded(self, key: Key) -> tuple[str, str]:
        label, head = self.labels[key[0]], self.heads[key[2]]
        named = head if self.across else label
        unit = next((text.plain.rpartition(", ")[2] for text in (head, label) if ", " in text.plain), "")
        return _marked(named), unit

    def _value(self, key: Key) -> float | None:
        """Give the number that is due in a cell; of a text, and of what rounding decides, none."""
        return _due(self.cells[key].expected) if key in self.cells else None

    def _scales(self, sheet: Original) -> Iterator[tuple[str, float]]:
        """Give the coarsest scale of a sheet in each unit, as the sheet writes it."""
        if sheet.kind in READ_OFF:
            for mark in sorted(self.originals.read_back(sheet).measured.marks, key=lambda mark: mark.scale):
                for unit, times in {mark.unit: 1.0, **({"mm": 1e3} if mark.unit == "m" else {})}.items():
                    yield folded(Text(0j, term(self.originals.language, "unit", unit)).plain), times * mark.scale


def _due(row: Expected | None) -> float | None:
    if row is None or not isinstance(row.value, int | float | complex) or not math.isfinite(row.allowed):
        return None
    return abs(row.value) if isinstance(row.value, complex) else float(row.value)


def _bare(plain: str) -> str:
    return plain.rpartition(", ")[0] if ", " in plain else plain


def _marked(text: Text) -> str:
    """Write the name of a quantity with its indices as verdicts do.

    >>> _marked(Text(0j, "a^{n}_{BA}, m/s^2"))
    'a^n_BA'
    """
    return _bare("".join(MARKS[run.level] + run.text for run in text.runs))


class TableDrawn(NamedTuple):
    """A table that is found on a sheet: its cells, in so many parts, and which of them differ in two."""

    asked: TableAsked
    cells: Mapping[Key, SeenCell]
    parts: int = 1
    doubled: Set[Key] = frozenset()

    @property
    def filled(self) -> bool:
        """Whether it is written in."""
        return any(self.cells[key].texts for key in self.asked.cells if key in self.cells)


Drawn: TypeAlias = Sequence[TableDrawn]


def tables_drawn(sheet: SeenSheet, asked: Sequence[TableAsked]) -> Drawn:
    """Find the tables that are asked for on a sheet; all parts of one are put together."""
    corners = {table.corner for table in asked}
    found: dict[int, list[SeenTable]] = {}
    for table in tables_seen(ruling(sheet.leaf), corners) if asked else ():
        fits = max(range(len(asked)), key=lambda k: _fit(table, asked[k], sheet))
        if _fit(table, asked[fits], sheet)[0] > 0:
            found.setdefault(fits, []).append(table)
    return [_whole(asked[k], parts) for k, parts in sorted(found.items())]


def _whole(asked: TableAsked, parts: Sequence[SeenTable]) -> TableDrawn:
    cells, doubled = dict[Key, SeenCell](), set[Key]()
    for key, cell in (pair for part in parts for pair in part.cells.items()):
        first = cells.get(key, cell)
        doubled |= {key} if key in asked.cells and len({first.plain, cell.plain, ""}) > 2 else set()
        cells[key] = first if first.texts else cell
    return TableDrawn(asked, cells, len(parts), doubled)


def answered(found: Drawn, others: Collection[str]) -> bool:
    """Tell whether the tables of a sheet can be graded: written in, or such that nothing else stands on their sheets.

    `others` are the sheets that more is asked for on: where all of it is lost it is not marked down.
    """
    return any(table.filled or not set(table.asked.sheets) & set(others) for table in found)


def alone(found: Drawn, sheet: SeenSheet) -> set[str]:
    """Give the sheets of tables that are written in on the only sheet of its kind, of which all is due then."""
    written = (table.asked for table in found if table.filled and sheet.measured.metadata.get("of") == 1)
    return {name for asked in written for name in asked.sheets}


def _fit(table: SeenTable, asked: TableAsked, sheet: SeenSheet) -> tuple[int, bool, int]:
    """Give how many cells of a table are asked for, whether its sheet is titled so, how many cells are as they must."""
    keys = [key for key in table.cells if key in asked.cells]
    written = ((number(table.cells[key].texts, asked.cells[key].unit), asked.cells[key]) for key in keys)
    said = sum(one is not None and abs(one.value - cell.true) <= cell.printed for one, cell in written)
    return len(keys), sheet.leaf.title in asked.titles, said
