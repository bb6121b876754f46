"""The composition of a set of sheets: which figure stands where, at which scale, on which sheet (компоновка листов)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.layout.picture import Spot
from drawings.layout.trials import Content, Sheet, Trial
from drawings.layout.value_table import Setting, Table
from drawings.page.page import Field, Page
from drawings.paper.strokes import SheetError
from plans.words.words import message


class Composed(NamedTuple):
    """One sheet: what it shows, and where."""

    content: Content
    positions: slice  # of the drawn ones
    main: Spot | None
    plans: dict[str, Spot]  # by the names of their pictures
    table: complex | None  # upper left corner
    setting: Setting | None
    notes: Field | None


def compose(content: Content, page: Page) -> tuple[Composed, ...]:
    """Compose the sheets: all on one if every figure stays readable there, or else the plans on following ones."""
    whole = Sheet(content, page).best()
    if whole is not None:
        return (_composed(whole, content, slice(0, len(content.velocities))),)
    alone = Content(content.main, (), (), None, content.notes)
    first = Sheet(alone, page).best()
    if first is None:
        raise SheetError(message("refused.positions", format=page.name))
    return _composed(first, alone, slice(0, 0)), *_following(content, page)


def _following(content: Content, page: Page) -> Iterator[Composed]:
    """Compose the sheets of the plans: as many positions on each as stay readable, their table with them or after."""
    count, start = len(content.velocities), 0
    while start < count:
        found, part, chosen = _next(content, page, start)
        yield _composed(found, part, chosen)
        if part.table is None and content.table is not None:
            yield from _tables(content.table.of(chosen), page)
        start = chosen.stop


def _next(content: Content, page: Page, start: int) -> tuple[Trial, Content, slice]:
    """Compose the sheet of the plans from a position on; a single position's plans may be as small as they must."""
    count = len(content.velocities)
    for end in range(count, start, -1):
        chosen = slice(start, end)
        for rows in (slice(None), None):
            part = content.part(chosen, rows)
            found = Sheet(part, page).best(legible=end - start > 1)
            if found is not None:
                return found, part, chosen
    raise SheetError(message("refused.plan", format=page.name))


def _tables(table: Table, page: Page) -> Iterator[Composed]:
    """Set a table on sheets of its own, as many rows on each as fit."""
    start = 0
    while start < len(table.lines):
        for end in range(len(table.lines), start, -1):
            part = Content(None, (), (), table.part(slice(start, end)), None)
            found = Sheet(part, page).best()
            if found is not None:
                break
        else:
            raise SheetError(message("refused.table", format=page.name))
        yield _composed(found, part, slice(0, 0))
        start = end


def _composed(trial: Trial, content: Content, positions: slice) -> Composed:
    spots = trial.grid.spots(trial.plans) if trial.grid is not None and trial.plans is not None else {}
    main = None if trial.spot is None else Spot(_centred(trial.spot, trial.room), trial.spot.scale)
    return Composed(content, positions, main, spots, trial.table, trial.setting, trial.notes)


def _centred(spot: Spot, room: Field) -> Field:
    half = complex(spot.box.width, spot.box.height) / 2
    low, high = room.centre - half, room.centre + half
    return Field(low.real, low.imag, high.real, high.imag)
