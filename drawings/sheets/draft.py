"""What the sheets of one kind show, before it is composed: figures, lettering, tables, notes (содержание листов)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from drawings.figures.workings.working import Working
from drawings.layout.contents import Panel
from drawings.layout.figure import Figure
from drawings.layout.picture import Spot
from drawings.layout.table import Later, RuledTable
from drawings.paper.strokes import Group


class Exhibit(NamedTuple):
    """A figure that a sheet shows: what it wants of its place, and how it is drawn in its spot."""

    panel: Panel
    draw: Callable[[Spot], Figure]


class Caption(NamedTuple):
    """Lettering that stands with figures: what it wants of its place, and how it is written in its box.

    One `of` a figure is written by the spot of that figure too, where both stand on one sheet: lengths as drawn. One
    that `waits` is written by what writes the cells of the tables that wait for the scales of the figures. A `working`
    of its figure is written only where paper beside that would stay bare.
    """

    panel: Panel
    write: Callable[..., Group]  # of a field, and of a spot
    of: str = ""
    waits: bool = False
    working: bool = False


def captions(workings: Iterable[Working]) -> Iterator[Caption]:
    """Give workings that have anything to say as lettering of their figures that only bare paper calls for."""
    return (Caption(one.panel, one.write, of=one.of, working=True) for one in workings if one.lines(None))


@dataclass(frozen=True)
class Draft:
    """What the sheets of one kind show: figures and lettering in their order, tables, notes.

    `facts` gives what the data of a sheet say of it beside title and number, by the names of the figures that it bears.
    `scaled` is the figure whose scale the title block states: the foremost one, unless it is named. The notes stand in
    no column of less than `narrow` mm. The drafts `instead` show the same in other ways, where that can be read better
    or takes fewer sheets. `later` writes, by the spots of all figures, the cells that wait for them; `remarks` says, by
    them, what follows the notes.
    """

    kind: str
    title: str
    shows: tuple[Exhibit | Caption, ...]
    tables: tuple[RuledTable, ...]
    notes: tuple[str, ...]
    facts: Callable[[Collection[str]], Mapping[str, Any]]
    scaled: str = ""
    narrow: float = 0.0
    instead: tuple[Draft, ...] = ()
    later: Callable[[Mapping[str, Spot]], Callable[[Later], str]] | None = None
    remarks: Callable[[Mapping[str, Spot]], tuple[str, ...]] | None = None
