"""What a task asks for of its tables: cells, each with its true value and what a hand may be out in it (таблица)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

from drawings.grading.allowance import DEVIATIONS, Allowance, Allowances
from drawings.grading.cells.seen_table import Key
from drawings.grading.curves.asked_figure import PRICKED
from geometry.scatter import POINT
from geometry.span import Reading
from plans.checks.hand.quantity import SLIP

Sought: TypeAlias = tuple[str, str, int | None]  # a kind of sheet, a table of it, the cam that the sheet is of

ROUGH = 40.0  # mm: what no figure tells the scale of is read off a graph that is at the least so high


class CellAsked(NamedTuple):
    """One cell: what it tells of and how that is called, in which position or row, the values that it may have.

    `hand` is what 95 of 100 drawings are within, `coarse` how much of the quantity a mm of paper shows, `largest` its
    largest value. A cell that is not `told` lies so near a dead centre that slips tell nothing of it.
    """

    name: str
    quantity: str
    place: str
    true: tuple[float, ...]
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
