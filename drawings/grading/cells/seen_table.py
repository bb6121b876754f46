"""Tables as they are ruled on a sheet: their cells, what is written in them, frames about them (таблица на листе)."""

from __future__ import annotations

import re
from bisect import bisect
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple, TypeAlias

from drawings.layout.value_table import BOTH, COLUMNS
from drawings.lettering.lettering import bounds
from drawings.lettering.words import word
from drawings.paper.strokes import Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import flat
from drawings.reading.alphabet import folded
from plans.scene.sheet import LANGUAGES

LEVEL = 0.2  # mm: a line that is out by more is no line of a table, and two that are nearer are one
SHORT = 2.0  # mm: no cell is smaller


class CellFrame(NamedTuple):
    """A box on paper, mm."""

    left: float
    low: float
    right: float
    high: float

    @property
    def corners(self) -> tuple[complex, complex, complex, complex]:
        """The corners, from the lower left on, counter-clockwise."""
        low, high = complex(0, self.low), complex(0, self.high)
        return self.left + low, self.right + low, self.right + high, self.left + high

    def holds(self, spot: complex) -> bool:
        """Tell whether a place is in it."""
        return self.left < spot.real < self.right and self.low < spot.imag < self.high


class Rule(NamedTuple):
    """A line along or up a sheet, mm: how high or how far along it lies, and between which ends."""

    at: float
    low: float
    high: float

    def passes(self, spot: float) -> bool:
        """Tell whether it passes by a place."""
        return self.low - LEVEL <= spot <= self.high + LEVEL


class Ruling(NamedTuple):
    """The lines of a sheet, its texts by their middles, and the middles of its other ink."""

    levels: tuple[Rule, ...]
    uprights: tuple[Rule, ...]
    texts: tuple[tuple[complex, Text], ...]
    ink: tuple[complex, ...]

    def around(self, spot: complex) -> CellFrame | None:
        """Give the cell about a place; None where no lines are about it."""
        columns, rows = self.columns(spot.imag), self.rows(spot.real)
        k, j = bisect(columns, spot.real), bisect(rows, spot.imag)
        if not 0 < k < len(columns) or not 0 < j < len(rows):
            return None
        return CellFrame(columns[k - 1], rows[j - 1], columns[k], rows[j])

    def columns(self, height: float) -> list[float]:
        """Give where upright lines pass by a height, from left to right."""
        return _once(rule.at for rule in self.uprights if rule.passes(height))

    def rows(self, along: float) -> list[float]:
        """Give where level lines pass by a place along the sheet, upward."""
        return _once(rule.at for rule in self.levels if rule.passes(along))

    def below(self, box: CellFrame) -> float:
        """Give how far down the upright line on the left of a box goes."""
        lows = (rule.low for rule in self.uprights if _on(rule, box.left) and rule.passes(box.low))
        return min(lows, default=box.low)

    def right_of(self, box: CellFrame) -> float:
        """Give how far to the right the level line under a box goes."""
        highs = (rule.high for rule in self.levels if _on(rule, box.low) and rule.passes(box.right))
        return max(highs, default=box.right)  # of one about a word that stands in no table


def ruling(leaf: Leaf) -> Ruling:
    """Read the ruling of a sheet."""
    levels, uprights, strokes = list[Rule](), list[Rule](), list(flat(leaf.groups))
    lines = [(stroke, ends) for stroke in strokes if (ends := _ends(stroke)) is not None]
    for _, (start, end) in lines:
        along, middle = end - start, (start + end) / 2
        if abs(along.imag) <= LEVEL and abs(along.real) >= SHORT:
            levels.append(Rule(middle.imag, *sorted((start.real, end.real))))
        elif abs(along.real) <= LEVEL and abs(along.imag) >= SHORT:
            uprights.append(Rule(middle.real, *sorted((start.imag, end.imag))))
    ruled = {id(stroke) for stroke, _ in lines}
    spots = [(_middle(stroke), stroke) for stroke in strokes if id(stroke) not in ruled]
    texts = tuple((spot, stroke) for spot, stroke in spots if isinstance(stroke, Text))
    return Ruling(
        tuple(levels), tuple(uprights), texts, tuple(spot for spot, stroke in spots if not isinstance(stroke, Text))
    )


def _ends(stroke: Stroke) -> tuple[complex, complex] | None:
    if isinstance(stroke, Line):
        return stroke.start, stroke.end
    points = stroke.points if isinstance(stroke, Polyline) else ()
    return (points[0], points[1]) if len(points) == 2 else None


def _middle(stroke: Stroke) -> complex:
    left, low, right, high = bounds(stroke)
    return complex(left + right, low + high) / 2


def _on(rule: Rule, place: float) -> bool:
    return abs(rule.at - place) <= LEVEL


def _once(places: Iterable[float]) -> list[float]:
    """Give places from the least to the greatest, those that are one once."""
    found = list[float]()
    for place in sorted(places):
        if not found or place - found[-1] > LEVEL:
            found.append(place)
    return found


Key: TypeAlias = tuple[str, int | None, str]  # a row, the position of a column, and its heading, as they are seen


_NUMBER = re.compile(r"\d+")


class SeenCell(NamedTuple):
    """A cell: its texts from left to right, whether other ink is in it, and where it is, mm, as upright a sheet."""

    texts: tuple[Text, ...]
    inked: bool
    box: CellFrame

    @property
    def plain(self) -> str:
        """What is written in it."""
        return " ".join(text.plain for text in self.texts)


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


def _table(sheet: Ruling, corner: Text, box: CellFrame) -> SeenTable | None:
    whole = CellFrame(box.left, sheet.below(box), sheet.right_of(box), box.high)
    inside = [(spot, text) for spot, text in sheet.texts if whole.holds(spot)]
    edges = [x for x in sheet.columns(box.low) if box.left <= x <= whole.right + 1e-9]
    floors = [y for y in sheet.rows((box.left + box.right) / 2) if whole.low - 1e-9 <= y <= box.low + 1e-9]
    columns = _columns([head for head in inside if head[0].imag > box.low and head[0].real > box.right], edges)
    if not columns or len(floors) < 2:
        return None
    heads = {_worded(head): head for whole, _ in columns for head in _split(whole)}
    cells, labels = dict[Key, SeenCell](), dict[str, Text]()
    for low, high in pairwise(floors):
        row = [_cell(sheet, inside, CellFrame(left, low, right, high)) for left, right in pairwise(edges)]
        if not row[0].texts:
            continue
        label = folded(row[0].plain)
        labels.setdefault(label, row[0].texts[0])
        for (head, position), cell in zip(columns, row[1:], strict=True):
            for part in _split(head):
                cells.setdefault((label, position, _worded(part)), cell)
    return SeenTable(corner, heads, labels, cells)


def _worded(head: Text) -> str:
    """Give a heading as it is seen: what is counted from a datum may be headed as what it is."""
    return folded(head.plain).lstrip("Δ∆")


def _split(head: Text | None) -> Iterator[Text]:
    """Give the headings that a column has: that of plan and analysis together is both of theirs."""
    if head is not None:
        parts = _together().get(folded(head.plain))
        yield from [head] if parts is None else (head._replace(content=part) for part in parts)


@cache
def _together() -> Mapping[str, tuple[str, ...]]:
    """Give what the column of both roads stands for, in each language."""
    return {folded(word(one, BOTH)): tuple(word(one, key) for key in COLUMNS[:2]) for one in LANGUAGES}


def _cell(sheet: Ruling, inside: Sequence[tuple[complex, Text]], box: CellFrame) -> SeenCell:
    within = sorted((spot.real, k) for k, (spot, _) in enumerate(inside) if box.holds(spot))
    return SeenCell(tuple(inside[k][1] for _, k in within), any(box.holds(spot) for spot in sheet.ink), box)


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
