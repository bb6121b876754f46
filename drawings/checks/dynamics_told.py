"""The self-check of what a sheet of dynamics tells: equations of the loop, tables, notes (проверка таблиц)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial

import numpy as np

from drawings.checks import reading
from drawings.checks.dynamics_expected import INERTIA, KNOWN, MOMENTS, SPEEDS, SURPLUS, WORKS, Expected
from drawings.checks.dynamics_graphs import part, written
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, within
from drawings.figures.dynamics import dynamics_table
from drawings.figures.dynamics import equations as written_out
from drawings.figures.graphs.axes import Axes
from drawings.layout.table import RuledTable
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups, texts
from drawings.report.dynamics_notes import PER_CENT, DynamicsNotes
from plans.analytic.dynamics.flywheel import flywheel_of_points
from plans.analytic.dynamics.rim import wheel
from plans.checks.dynamics_comparison import DynamicsComparison
from plans.model.dynamics import Flywheel, Reduced
from plans.words.words import message

LOOP = "loop"
# What the columns of the table of the edges tell, in their order: letters and units.
COLUMNS = (
    ("φ", "°"),
    ("M_{us}", "N*m"),
    ("A_{us}", "J"),
    ("ΔT", "J"),
    ("ΔJ", "kg*m2"),
    ("ω", "rad/s"),
    ("ε", "rad/s2"),
)


def _due(expected: Expected, scales: Mapping[str, float], drafting: Drafting) -> list[str]:
    """Give the equations of the loop by the analysis, with all digits."""
    assert expected.wheel is not None  # asked before
    axes = Axes(0j, Scale(scales["J"], "J", "kg*m2"), Scale(scales["T"], "T", "J"))
    found = written_out.write(expected.wheel, axes, 0j, precise(drafting))
    return [text.plain for text in texts((found,))]


def equations(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Read the equations beside the loop back."""
    own, loop = part(leaf, written_out.NAME), part(leaf, LOOP)
    if expected.wheel is None:
        return
    scales = written(loop) if loop is not None else {}
    if own is None or not {"J", "T"} <= scales.keys():
        yield message("wrong.missing", name="J_0")
        return
    seen = [text.plain for text in texts((own,))]
    due = _due(expected, scales, drafting)
    if len(seen) != len(due):
        yield message("wrong.missing", name="J_0")
    for text, true in zip(seen, due, strict=False):
        if not tells(text, true, (written_out.DIGITS,), KNOWN):
            yield message("wrong.told", text=text)


def positions(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table of the edges back: each row that must be there, each cell to its last digit."""
    told = leaf.metadata["positions"]
    table = dynamics_table.positions(expected.task, expected.account, precise(drafting), told)
    yield from _edges(table, expected, drafting)
    yield from _table(leaf, table, dynamics_table.DIGITS, True)


def _edges(table: RuledTable, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the rows that are due to the graphs of the analysis: each column is one of them, by its heading."""
    heads = tuple(f"{drafting.letter(letter)}, {drafting.word(unit)}" for letter, unit in COLUMNS)
    yield from (message("wrong.told", text=text) for text, due in zip(table.heads, heads, strict=True) if text != due)
    angles, graphs = np.degrees(expected.cycle.turned), expected.graphs
    speeds = graphs[SPEEDS] + expected.mean if SPEEDS in graphs else None
    after = [
        angles,
        *(graphs[name] for name in (MOMENTS, WORKS, SURPLUS, INERTIA)),
        *([speeds] if speeds is not None else []),
    ]
    for line in table.lines:
        cells = [reading.value(str(cell)) for cell in line.cells]
        k = int(np.argmin(np.abs(angles - (cells[0] or 0.0))))
        before = line.name.endswith("−0")
        due = [angles, expected.before] if before else after
        for text, value, column in zip(line.cells, cells, due, strict=False):
            near = KNOWN * np.nanmax(np.abs(column), initial=0.0)
            if value is None or not abs(value - column[k]) <= near:
                yield message("wrong.row_cell", text=str(text), name=line.name)


def reduction(leaf: Leaf, reduced: Reduced, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table of the reduction back, of a machine whose crank cannot turn fully."""
    yield from _table(leaf, dynamics_table.reduction(reduced, precise(drafting)), dynamics_table.DIGITS, True)


def results(leaf: Leaf, expected: Expected, comparison: DynamicsComparison, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table of results back."""
    table = dynamics_table.results(expected.account, comparison.exact, comparison.methods, precise(drafting))
    yield from _table(leaf, table, dynamics_table.DIGITS + 1, False)


def _table(leaf: Leaf, table: RuledTable, digits: int, uniform: bool) -> Iterator[Wrong]:
    """Hold the rows of a table that stands on a sheet; a set of one sheet bears all of its tables.

    A column of one quantity is `uniform`: rounding is counted in shares of its largest.
    """
    parts = _parts(leaf, table.name)
    if not parts:
        yield from [message("wrong.missing", name=table.name)] if leaf.metadata["of"] == 1 else []
        return
    seen, heads = _rows(parts), [Text(0j, one).plain for one in (table.first, *table.heads)]
    due = {Text(0j, line.name).plain: [Text(0j, str(cell)).plain for cell in line.cells] for line in table.lines}
    most = _largest(list(due.values()))  # of a column of one quantity
    yield from (message("wrong.told", text=" ".join(row)) for row in seen if row[0] not in due and row != heads)
    found = {row[0]: row[1:] for row in seen if row[0] in due}
    for name, cells in due.items():
        if name not in found:
            yield message("wrong.row_missing", name=name)
            continue
        sizes = most if uniform else [abs(reading.value(cell) or 0.0) for cell in cells]
        row, true = found[name], [pair for pair in zip(cells, sizes, strict=True) if pair[0]]
        wrong = [text for text, (one, size) in zip(row, true, strict=False) if not _cell(text, one, size, digits)]
        if len(row) != len(true):
            wrong = [name]
        yield from (message("wrong.row_cell", text=text, name=name) for text in wrong)


def _parts(leaf: Leaf, name: str) -> list[Group]:
    return [one for one in groups(leaf.groups) if one.name.removeprefix(f"{name}-").isdigit()]


def _rows(parts: Sequence[Group]) -> list[list[str]]:
    """Give the texts of all rows of the parts of a table, an empty cell left out."""
    return [[text.plain for text in row if text.plain] for one in parts for row in reading.rows(one)]


def _largest(rows: Sequence[Sequence[str]]) -> list[float]:
    """Give the largest number of each column."""
    columns = zip(*rows, strict=True)
    return [max((abs(reading.value(cell) or 0.0) for cell in column), default=0.0) for column in columns]


def _cell(text: str, true: str, most: float, digits: int) -> bool:
    """Tell whether a cell says a number, to its last digit, or the same words."""
    value = reading.value(true)
    if value is None or text == true:
        return text == true
    return reading.reads(text, value, KNOWN * most, digits)


def notes(leaf: Leaf, expected: Expected, comparison: DynamicsComparison, drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes of the first sheet back."""
    if not leaf.metadata["notes"]:
        return
    seen = " ".join(text.plain for one in groups(leaf.groups) if one.name == "notes" for text in texts((one,)))
    true = notes_of(expected, comparison, precise(drafting))
    due = " ".join(Text(0j, note).plain for note in true.all)
    missing = [one for one in _said(expected, precise(drafting)) if _spaced(Text(0j, one).plain) not in _spaced(due)]
    yield from (within("missing_from", "notes", name=one) for one in missing)
    if not tells(_spaced(seen), _spaced(due), (DynamicsNotes._field_defaults["digits"], PER_CENT), KNOWN):
        yield message("wrong.notes")


def _said(expected: Expected, drafting: Drafting) -> Iterator[str]:
    """Give what the notes must say by the analysis alone: task, work of the turn, flywheel, motion, rim."""
    word, number, task, account, cycle = drafting.word, drafting.number, expected.task, expected.account, expected.cycle
    asked = {"n": number(task.speed * (30 / math.pi)), "omega": number(task.speed)}
    asked |= {} if task.delta is None else {"delta": f"1/{number(1 / task.delta)}"}
    yield word("dynamics asked speed" if task.delta is None else "dynamics asked", **asked)
    if cycle.net:
        key = "work of turn" if cycle.net < 0 else "work given"
        yield word(key, work=number(abs(cycle.net)), moment=number(abs(cycle.driving)))
    if (own := account.flywheel) is not None and own.needed > 0:
        parts = {"whole": own.whole, "own": own.own, "present": own.present, "inertia": own.needed}
        yield word("flywheel adds", **{name: number(value) for name, value in parts.items()})
        yield from _rim(expected, own.needed, drafting)
    if (speeds := account.speeds) is not None:
        ends = {"low": float(np.min(speeds.omega)), "high": float(np.max(speeds.omega))}
        told = {name: number(value) for name, value in ends.items()}
        yield word("achieved motion", delta=number(speeds.delta), **told)


def _rim(expected: Expected, inertia: float, drafting: Drafting) -> Iterator[str]:
    """Give what is said of a rim that fits, mm and m/s at its own shaft."""
    own, number = wheel(inertia, expected.task.rim), drafting.number
    if own is not None and own.fits:
        sizes = {"diameter": own.diameter, "breadth": own.breadth, "thickness": own.thickness}
        told = {name: number(1000 * size) for name, size in sizes.items()}
        speed = number(abs(expected.task.speed * expected.task.rim.ratio) * own.diameter / 2)
        added = number(100 * (own.thickness / own.diameter) ** 2)
        yield drafting.word("rim sizes", mass=number(own.mass), speed=speed, added=added, **told)


def _spaced(text: str) -> str:
    return " ".join(text.split())


def notes_of(expected: Expected, comparison: DynamicsComparison, drafting: Drafting) -> DynamicsNotes:
    """Give the notes by the analysis."""
    own, exact = expected.wheel, comparison.exact.flywheel
    rim = None if own is None else wheel(own.inertia, expected.task.rim)
    at = partial(_flywheel, expected)
    return DynamicsNotes(expected.task, expected.account, at, drafting, rim, None if exact is None else exact.inertia)


def _flywheel(expected: Expected, delta: float) -> Flywheel:
    return flywheel_of_points(expected.cycle, expected.task._replace(delta=delta))
