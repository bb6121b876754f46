"""Students at tables: the tables of a scene's own sheets, in some cells of which an editor has written anew."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any
from xml.sax.saxutils import escape

from drawings.form.blank_file import SEAL
from drawings.grading.asked import PlanAsked
from drawings.grading.cells.asked_table import TableAsked
from drawings.grading.cells.seen_table import Key, SeenCell, ruling, tables_seen
from drawings.paper.strokes import Group, Leaf, Stroke
from drawings.paper.walk import texts
from drawings.pens.svg import svg
from drawings.reading.alphabet import folded
from drawings.redrawn import Original
from drawings.sheets.kind import table_of
from tests.drawings.students import Task, drawn

SIZE = 4.9  # of an editor's letters, user units


def tables_of(sheet: Original) -> Leaf:
    """Give a sheet with its tables alone: what else stands on it takes long to read."""
    own = (one for one in _inside(sheet.leaf.groups) if one.name and table_of(sheet.kind, one.name))
    return sheet.leaf._replace(groups=tuple(own))


def _inside(strokes: tuple[Stroke, ...]) -> Iterator[Group]:
    for one in strokes:
        if isinstance(one, Group):
            yield one
            yield from _inside(one.strokes)


def cells_of(leaf: Leaf, table: TableAsked) -> dict[Key, SeenCell]:
    """Give the cells of a table by their keys."""
    found = tables_seen(ruling(leaf), {table.corner})
    return {key: cell for one in found for key, cell in one.cells.items() if key in table.cells}


def key_of(table: TableAsked, row: str, column: str, position: int | None = None) -> Key:
    """Give the key of a cell by how its row begins, its column and its position."""
    begun, head = folded(row), folded(column)
    return next(
        key for key in table.cells
        if key[0] in (begun, *(f"{begun}{unit}" for unit in [key[0][len(begun):]] if unit.startswith(",")))
        and key[2].startswith(head) and key[1] == position
    )  # fmt: skip


def written(leaf: Leaf, table: TableAsked, new: Mapping[Key, str]) -> bytes:
    """Draw a sheet in whose cells texts of an editor stand instead of ours; an empty one leaves a cell empty."""
    cells = cells_of(leaf, table)
    gone = {id(text) for key in new for text in cells[key].texts}
    source = svg(leaf._replace(groups=tuple(_without(one, gone) for one in leaf.groups)))
    own = (_text(leaf, cells[key], text) for key, text in new.items() if text)
    return source.partition(SEAL)[0] + "".join(own).encode() + b"</svg>"


def _without(group: Group, gone: set[int]) -> Group:
    strokes = (one for one in group.strokes if id(one) not in gone)
    return group._replace(strokes=tuple(_without(one, gone) if isinstance(one, Group) else one for one in strokes))


def _text(leaf: Leaf, cell: SeenCell, text: str) -> str:
    x, y = (cell.box.left + cell.box.right) / 2, leaf.height - cell.box.low - 2
    style = f"font-size:{SIZE}px;font-family:Arial;text-anchor:middle"
    return f'<text style="{style}"><tspan x="{x:.3f}" y="{y:.3f}">{escape(text)}</tspan></text>'


def made(task: Task, row: Mapping[str, Any]) -> bytes:
    """Draw a sheet with a mistake of the list of rows."""
    table = task.table(row["table"])
    leaf = tables_of(task.sheet(table.sheets[0]))
    if "without" in row:
        cells = (cell for key, cell in cells_of(leaf, table).items() if key[0].startswith(row["without"]))
        gone = {id(text) for cell in cells for text in cell.texts}
        gone |= {id(text) for text in texts(leaf.groups) if folded(text.plain).startswith(row["without"])}
        return svg(leaf._replace(groups=tuple(_without(one, gone) for one in leaf.groups)))
    own = {key_of(table, *_place(name)): text for name, text in row["writes"].items()}
    return written(leaf, table, own)


def _place(name: str) -> tuple[str, str, int | None]:
    """Read where a text is written: "vB | by plan | 9"."""
    row, column, *position = name.split(" | ")
    return row, column, int(position[0]) if position else None


def both(
    sheet: Original, plan: PlanAsked, places: Mapping[str, complex], table: TableAsked, new: Mapping[Key, str]
) -> bytes:
    """Draw a sheet with the letters of one plan elsewhere, and with texts in some cells of its tables."""
    page, tables = drawn(sheet, plan, places).partition(SEAL)[0], written(tables_of(sheet), table, new)
    return page + tables[tables.index(b"<g ") :]
