"""What must stand on a sheet by the analysis, row by row, and how what is otherwise is named (ожидаемое)."""

import math
from collections.abc import Callable, Collection, Iterable, Iterator
from typing import NamedTuple, TypeAlias

import numpy as np

from drawings.layout.table import cell_name
from drawings.paper.strokes import Key, Kind, Leaf
from plans.model.motion import Complexes, Floats
from plans.words.words import ENGLISH, Message, message, words

# A value of a vector, a number, a direction; a text; a graph as a function of its argument; a path by dense points.
Value: TypeAlias = complex | float | str | Callable[[Floats], Floats] | Complexes

KNOWN = 1e-9  # share of a number that both roads may differ by: they agree far better
NOTES, NOTHING = "notes", "—"  # the figure that notes stand on; what a cell without a value says


class Expected(NamedTuple):
    """A row of the table of what must stand on the sheets of a kind, by the analysis alone.

    One that `may_lack` is too short to be drawn, or doubtful by rounding; one that rounding alone decides is `allowed`
    any difference, math.inf. `letter` is what its mark must be lettered;
    `ends` are where a graph begins and ends, in units of its argument.
    """

    kind: Kind
    figure: str
    name: str
    value: Value
    allowed: float = 0.0
    position: int | None = None
    may_lack: bool = False
    letter: str = ""
    ends: tuple[float, float] = (math.nan, math.nan)
    digits: int = 0  # of a number: so many may be written, its end may be left off that is zero
    period: float = 0.0  # of an angle: a full turn more or less is the same

    @property
    def key(self) -> Key:
        """What is stated of whom."""
        return self.kind, self.figure, self.name, self.position

    @property
    def vector(self) -> complex:
        """The value of a vector, a point, a length or a direction."""
        assert isinstance(self.value, complex | float | int)
        return complex(self.value)


def subject(leaf: Leaf) -> str:
    """Tell what a sheet is of among those of its kind; what must stand on sheets is asked of each subject apart."""
    return str(leaf.metadata.get("cam", ""))


def course(x: Floats, y: Floats) -> Callable[[Floats], Floats]:
    """Give the function that goes straight from point to point.

    >>> float(course(np.array([0.0, 2.0]), np.array([1.0, 5.0]))(np.array([0.5]))[0])
    2.0
    """
    return lambda at: np.asarray(np.interp(at, x, y))


# A number and how far off it may be; of an angle besides what more or less is the same. A text; None where nothing is.
Cell: TypeAlias = tuple[float, float] | tuple[float, float, float] | str | int | None
HAND = 0.05  # of what a hand may be out: two digits of it are told


def cells(
    table: str, row: str, values: Iterable[Cell], position: int | None = None, digits: int = 0, may_lack: bool = False
) -> Iterator[Expected]:
    """Give the cells of a row of a table from the left."""
    for column, cell in enumerate(values):
        value, allowed, period = (*cell, 0.0)[:3] if isinstance(cell, tuple) else (cell or NOTHING, 0.0, 0.0)
        expected = Expected(Kind.NUMBER, table, cell_name(row, column), value, allowed, position, may_lack)
        yield expected._replace(digits=digits, period=period) if digits or period else expected


def by_roads(
    table: str, row: str, value: Cell, error: Cell, position: int, keys: Collection[Key], may_lack: bool = False
) -> Iterator[Expected]:
    """Give the cells of a row that both roads find, in a column each or in one, and of what a hand may be out."""
    apart = (Kind.NUMBER, table, cell_name(row, 2), position) in keys
    yield from cells(table, row, (value, value, error) if apart else (value, error), position, may_lack=may_lack)


def by_hand(error: float, most: float) -> Cell:
    """Give the cell of what a hand may be out: nothing at a dead centre."""
    return (error, HAND * error) if error <= most else None


def phrases(
    figure: str, numbers: Iterable[tuple[str, float, float]], digits: int = 0, may_lack: bool = False
) -> Iterator[Expected]:
    """Give numbers within sentences by the names of their quantities, each with how far off it may be."""
    for name, value, allowed in numbers:
        yield Expected(Kind.PHRASE, figure, name, value, allowed, may_lack=may_lack, digits=digits)


def measured(
    row: Expected, lettered: float, digits: int = 0, unit: float = 1000.0, may_lack: bool | None = None
) -> Iterator[Expected]:
    """Give a dimension, or what else is drawn to scale, and the number beside it: in a unit, mm as a rule."""
    lost = row.may_lack if may_lack is None else may_lack
    yield row
    yield Expected(Kind.PHRASE, row.figure, row.name, lettered, unit * row.allowed, may_lack=lost, digits=digits)


Wrong: TypeAlias = Message | str


def on(key: str, plan: str, **parts: object) -> Message:
    """Say what is wrong on a plan or a figure, by the names of its marks.

    >>> on("letter", "forces-2-3", name="R_12").worded("ru")
    'буква R_12 (план сил 2-3)'
    """
    return message(f"wrong.{key}", plan=_figure(plan), **parts)


def within(key: str, where: str, **parts: object) -> Message:
    """Say what is wrong in a table or in the notes of a sheet, by the name of its figure.

    >>> str(within("cell", "masses", name="II", text="0.5"))
    '0.5 for II in the table of masses'
    """
    return message(f"wrong.{key}", where=where, **parts)


def _figure(plan: str) -> Wrong:
    """Name the figure of a group of links or a pair; any other by the word for its plan."""
    if f"plan.{plan}" in words(ENGLISH):
        return plan
    kind, _, which = plan.replace(" ", "-", 1).partition("-")
    return message(f"figure.{kind}", which=which) if which and f"figure.{kind}" in words(ENGLISH) else plan
