"""What a task asks for of its tables: cells, each with its true value and what a hand may be out in it (таблица)."""

from __future__ import annotations

import math
import re
from bisect import bisect
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple, TypeAlias

from drawings.grading.asked import DEVIATIONS, Allowance, Allowances
from drawings.grading.cells.frames import Box, Ruling
from drawings.grading.curves.figure_records import PRICKED
from drawings.grading.seeing.units import in_unit
from drawings.paper.strokes import Text
from drawings.reading.alphabet import folded
from drawings.reading.letters import UNREAD
from geometry.hand_error import POINT
from geometry.steps import Reading
from plans.by_hand import SLIP

SURE = 3  # digits: a number of as many is rounded, and one of fewer is rough
_RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺"
_LEVEL = str.maketrans(_RAISED, "0123456789-+")
_POWERS = re.compile(f"[{_RAISED}]+")
_SIGNS = str.maketrans({"−": "-", "–": "-", "—": "-", "‐": "-", "‑": "-", "µ": "μ", "∙": "·", "⋅": "·", "*": "·"})
_GAPS = re.compile(r"(?<![\d.,])\d{1,3}(?:[ \u00a0\u2009\u202f]\d{3})+(?!\d)")  # thousands, and no two numbers
_POWER = r"\s*\(?(?P<{}>[-+]?\d{{1,2}})\)?"
NUMBER = (
    r"(?P<sign>[-+]?)\s*(?P<digits>\d+(?:[.,]\d*)?|[.,]\d+)"
    rf"(?:\s*[·×xх]\s*10\s*\^?{_POWER.format('power')}"
    rf"|\s+10\s*\^{_POWER.format('apart')}"
    r"|[eEеЕ](?P<exponent>[-+]?\d{1,2}))?"
)
_WRITTEN = re.compile(rf"[=≈~±]?\s*{NUMBER}\s*(?P<unit>.*)")
# What follows a number is no unit if it begins as another number does, or holds one.
_ANOTHER = re.compile(r"(?!1/[^\W\d])[-+\d.,/×:^·]|.*\s[-+]?\d")
_ANGLE = re.compile(r"(?P<sign>-?)\s*(?P<degrees>\d+)\s*°\s*(?P<minutes>\d{1,2}(?:[.,]\d+)?)\s*['′’]")
MINUTE = 1 / 60  # of a degree


class Written(NamedTuple):
    """A number that is written in a cell: its value in the column's unit, and what half of its last digit is worth.

    The value is NaN where the unit that is written is not understood.
    """

    value: float
    rounding: float

    @property
    def understood(self) -> bool:
        """Whether its unit is."""
        return not math.isnan(self.value)


def is_read(texts: Sequence[Text]) -> bool:
    """Tell whether all letters of a cell are read."""
    return not any(UNREAD in text.plain for text in texts)


def number(texts: Sequence[Text], unit: str = "") -> Written | None:
    """Read the number of a cell; None where there is none, or more than one.

    >>> number([Text(0j, "−1,52·10^{3} mm/s")], "m/s")
    Written(value=-1.52, rounding=0.005)
    >>> number([Text(0j, "1.5")]).rounding, number([Text(0j, "2 of 3")]), number([Text(0j, "5 ells")], "m").understood
    (0.0, None, False)
    >>> number([Text(0j, "30°15'")], "°"), number([Text(0j, "0.0000 9.99")])
    (Written(value=30.25, rounding=0.008333333333333333), None)
    """
    plain = plainly(" ".join(map(levelled, texts)))
    if (angle := _ANGLE.fullmatch(plain)) is not None:
        return _angle(angle, unit)
    found = _WRITTEN.fullmatch(plain)
    if found is None or _ANOTHER.match(found["unit"]):
        return None
    times = in_unit(found["unit"], unit)
    value, half = value_of(found)
    if not math.isfinite(value):
        return None
    if times is None:
        return Written(math.nan, 0.0)
    return Written(value * times, half * times)


def plainly(text: str) -> str:
    """Write a text with one sign for each that is written in several ways, and powers after a ^."""
    signed = _POWERS.sub(lambda one: f"^{one[0].translate(_LEVEL)}", text.translate(_SIGNS))
    return _GAPS.sub(lambda one: re.sub(r"\s", "", one[0]), signed).strip()


def value_of(found: re.Match[str]) -> tuple[float, float]:
    """Give the value of a number that was found, and what half of its last digit is worth if it is rounded."""
    digits = found["digits"].replace(",", ".")
    times = math.pow(10.0, int(found["power"] or found["apart"] or found["exponent"] or 0))
    sure = len(digits.replace(".", "").lstrip("0")) >= SURE
    half = 0.5 * math.pow(10.0, -len(digits.partition(".")[2])) * times
    return float(f"{found['sign']}{digits}") * times, half if sure else 0.0


def _angle(found: re.Match[str], unit: str) -> Written:
    """Read an angle in degrees and minutes."""
    minutes = found["minutes"].replace(",", ".")
    value = float(found["degrees"]) + MINUTE * float(minutes)
    half = 0.5 * math.pow(10.0, -len(minutes.partition(".")[2])) * MINUTE
    times = in_unit("°", unit)
    times = math.nan if times is None else times
    return Written((-value if found["sign"] else value) * times, half * times)


def levelled(text: Text) -> str:
    """Write a text with a ^ before what is raised over a ten."""
    return "".join(f"^{run.text}" if run.level > 0 and "10" in text.plain else run.text for run in text.runs)


Key: TypeAlias = tuple[str, int | None, str]  # a row, the position of a column, and its heading, as they are seen
_NUMBER = re.compile(r"\d+")


class SeenCell(NamedTuple):
    """A cell: its texts from left to right, whether other ink is in it, and where it is, mm, as upright a sheet."""

    texts: tuple[Text, ...]
    inked: bool
    box: Box


class SeenTable(NamedTuple):
    """A table, or a part of one: the text in its corner, the headings of its columns, its rows, its cells."""

    corner: Text
    heads: Mapping[str, Text]  # by what is seen of them
    labels: Mapping[str, Text]
    cells: Mapping[Key, SeenCell]


def tables_seen(sheet: Ruling, corners: Collection[str]) -> Iterator[SeenTable]:
    """Give the tables of a sheet in whose corners one of some words stands, as they are seen."""
    for spot, text in sheet.texts:
        if folded(text.plain) in corners and (box := sheet.around(spot)) is not None:
            found = _table(sheet, text, box)
            if found is not None:
                yield found


def _table(sheet: Ruling, corner: Text, box: Box) -> SeenTable | None:
    whole = Box(box.left, sheet.below(box), sheet.right_of(box), box.high)
    inside = [(spot, text) for spot, text in sheet.texts if whole.holds(spot)]
    edges = [x for x in sheet.columns(box.low) if box.left <= x <= whole.right + 1e-9]
    floors = [y for y in sheet.rows((box.left + box.right) / 2) if whole.low - 1e-9 <= y <= box.low + 1e-9]
    columns = _columns([one for one in inside if one[0].imag > box.low and one[0].real > box.right], edges)
    if not columns or len(floors) < 2:
        return None
    heads = {folded(head.plain): head for head, _ in columns if head is not None}
    cells, labels = dict[Key, SeenCell](), dict[str, Text]()
    for low, high in pairwise(floors):
        row = [_cell(sheet, inside, Box(left, low, right, high)) for left, right in pairwise(edges)]
        if not row[0].texts:
            continue
        label = folded(" ".join(text.plain for text in row[0].texts))
        labels.setdefault(label, row[0].texts[0])
        for (head, position), cell in zip(columns, row[1:], strict=True):
            if head is not None:
                cells.setdefault((label, position, folded(head.plain)), cell)
    return SeenTable(corner, heads, labels, cells)


def _cell(sheet: Ruling, inside: Sequence[tuple[complex, Text]], box: Box) -> SeenCell:
    own = sorted((spot.real, k) for k, (spot, _) in enumerate(inside) if box.holds(spot))
    return SeenCell(tuple(inside[k][1] for _, k in own), any(box.holds(spot) for spot in sheet.ink), box)


def _columns(heads: Sequence[tuple[complex, Text]], edges: Sequence[float]) -> list[tuple[Text | None, int | None]]:
    """Give the heading and the position of each column: where there are positions, they stand in a row above."""
    count = len(edges) - 2
    heights = [spot.imag for spot, _ in heads]
    if count < 1 or not heights:
        return []
    middle = (min(heights) + max(heights)) / 2
    titled = max(heights) - min(heights) > min(text.size for _, text in heads)
    low = [(spot, text) for spot, text in heads if not titled or spot.imag < middle]
    names: list[Text | None] = [None] * count
    for spot, text in low:
        k = bisect(edges, spot.real) - 2
        if 0 <= k < count:
            names[k] = text
    titles = sorted((spot.real, text.plain) for spot, text in heads if titled and spot.imag > middle)
    numbers = [_NUMBER.search(plain) for _, plain in titles]
    if not titles or count % len(titles) or not all(numbers):
        return [(name, None) for name in names]
    each = count // len(titles)
    return [(name, int(found[0])) for k, name in enumerate(names) if (found := numbers[k // each]) is not None]


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

    def allowed(self, by: Allowances, rough: float) -> float:
        """Give what it may be out, of a sheet that is written so roughly, mm."""
        own = by.to(self.quantity)
        if own.share is not None:
            return own.share * self.largest + self.printed
        return self._by_hand(own, rough) + self.printed

    def pricked(self, by: Allowances, rough: float, scale: float) -> float:
        """Give what it may be out that is read off a vector of some scale, true units a mm, both ends pricked."""
        return DEVIATIONS * PRICKED * max(by.to(self.quantity).slip, rough) * scale + self.printed

    def _by_hand(self, own: Allowance, rough: float) -> float:
        slip = max(own.slip, rough)
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
