"""The composition of sheets about a foremost figure: it takes half a sheet, the others stand in rows (компоновка)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.layout.contents import Composition, Contents, at_foot
from drawings.layout.picture import Picture, Spot
from drawings.layout.table import RuledTable
from drawings.layout.trials import SheetTrials, Trial
from drawings.page.page import Field, Page
from drawings.paper.strokes import SheetError
from plans.words.words import message


def fits(contents: Contents) -> bool:
    """Tell whether contents are composed so: a foremost figure, the others in groups alike, a table that goes by them.

    >>> fits(Contents())
    False
    """
    counts = {len(group) for group in contents.others}
    figures = all(isinstance(panel.item, Picture) for panel in contents.panels)
    by_groups = [len(table.positions) == len(contents.others) for table in contents.tables]
    return contents.foremost is not None and figures and len(counts) < 2 and by_groups in ([], [True])


def compose(contents: Contents, page: Page) -> Iterator[Composition]:
    """Compose the sheets: all on one if every figure stays readable there, or else the others on following ones."""
    whole = SheetTrials(contents, page).best()
    if whole is not None:
        yield _composed(whole, contents)
        return
    assert contents.foremost is not None  # else it is not composed so
    alone = Contents((contents.foremost,), (), contents.notes)
    first = SheetTrials(alone, page).best()
    if first is None:
        raise SheetError(message("refused.largest", format=page.name))
    yield _composed(first, alone)
    yield from _following(contents, page)


def _following(contents: Contents, page: Page) -> Iterator[Composition]:
    """Compose the following sheets: as many groups on each as stay readable, their table with them or after."""
    count, start = len(contents.others), 0
    while start < count:
        trial, part, chosen = _next(contents, page, start)
        yield _composed(trial, part)
        if part.table is None and contents.table is not None:
            yield from table_sheets(contents.table.of(chosen), page)
        start = chosen.stop


def _next(contents: Contents, page: Page, start: int) -> tuple[Trial, Contents, slice]:
    """Compose the sheet of the groups from one on; a single group's figures may be as small as they must."""
    count = len(contents.others)
    for end in range(count, start, -1):
        chosen = slice(start, end)
        panels = tuple(panel for group in contents.others[chosen] for panel in group)
        for tables in (tuple(table.of(chosen) for table in contents.tables), ()):
            part = Contents(panels, tables)
            trial = SheetTrials(part, page).best(legible=end - start > 1)
            if trial is not None:
                return trial, part, chosen
    raise SheetError(message("refused.figure", format=page.name))


def table_sheets(table: RuledTable, page: Page) -> Iterator[Composition]:
    """Set a table on sheets of its own, as many rows on each as fit."""
    start = 0
    while start < len(table.lines):
        for end in range(len(table.lines), start, -1):
            part = Contents((), (table.part(slice(start, end)),))
            trial = SheetTrials(part, page).best()
            if trial is not None:
                break
        else:
            raise SheetError(message("refused.table", format=page.name))
        yield _composed(trial, part)
        start = end


def _composed(trial: Trial, contents: Contents) -> Composition:
    spots = trial.grid.spots(trial.plans) if trial.grid is not None and trial.plans is not None else {}
    if trial.spot is not None and contents.foremost is not None:
        own = Spot(_centred(trial.spot, trial.room), trial.spot.scale)
        spots = {contents.foremost.item.name: own, **spots}
    return Composition(spots, {}, at_foot(contents.table, trial.table, trial.setting), trial.notes)


def _centred(spot: Spot, room: Field) -> Field:
    half = complex(spot.box.width, spot.box.height) / 2
    low, high = room.centre - half, room.centre + half
    return Field(low.real, low.imag, high.real, high.imag)
