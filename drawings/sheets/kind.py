"""A kind of sheet (лист): what is asked of a scene before any work, what lays it out, checks it, and is its task."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module
from types import MappingProxyType
from typing import Final, NamedTuple

from drawings.checks.expected import Expected
from drawings.files.atomic_files import Enclosure
from drawings.paper.strokes import Leaf
from plans.scene.scene import Scene
from plans.study import Study
from plans.techniques import technique_of

# What a form shows of a figure: a place with its pole; fixed points and guides too; bare axes.
PLAN, FRAME, GRAPH = "plan", "frame", "graph"
NOTHING: Final[Mapping[str, str]] = MappingProxyType({})


class SheetKind(NamedTuple):
    """One kind of sheet; those of a technique are the SHEETS of its file sheet.py.

    A form takes over its `figures` and the heads of its `tables`: whatever is not named there belongs to the answer.
    """

    leaves: Callable[[Study], Sequence[Leaf]]  # lays out the leaves, one or several
    expected: Callable[[Study, Sequence[Leaf]], Iterable[Expected]]  # what must stand on them, by the analysis
    scales: Mapping[str, str] = NOTHING  # how names of figures begin, and their keys of [sheet.scale]
    admit: Callable[[Scene], None] = lambda scene: None  # refuses what the sheet cannot show, before any work
    # What a letter that the sheet alone gives is on the record of a position; nothing where it is none.
    letters: Callable[[Study, int, str], str] = lambda study, position, letter: ""
    enclosures: Callable[[Study], Iterable[Enclosure]] = lambda study: ()  # the files beside its sheets
    figures: Mapping[str, str] = NOTHING  # how names of figures begin, and what a form shows of them
    tables: tuple[str, ...] = ()  # the names of its tables


def sheet_kind(sheet: str) -> SheetKind:
    """Give a kind of sheet by its name.

    >>> sheet_kind("rotor").scales["couples"]
    'couple'
    """
    kinds: Mapping[str, SheetKind] = import_module(f"drawings.{technique_of(sheet)}.sheet").SHEETS
    return kinds[sheet]


def figure_of(sheet: str, name: str) -> str:
    """Tell what a form shows of a figure, or nothing where it is not known as a part of the task.

    >>> figure_of("kinematics", "velocities-4"), figure_of("forces", "detail-2-3-Z"), figure_of("cam", "law-1-velocity")
    ('plan', '', 'graph')
    """
    return next((shown for begin, shown in sheet_kind(sheet).figures.items() if name.startswith(begin)), "")


def table_of(sheet: str, name: str) -> str:
    """Give the table that a band of a laid sheet, by its name, is of; nothing where that is no part of the task.

    >>> table_of("kinematics", "values-2"), table_of("kinematics", "velocities-2")
    ('values', '')
    """
    table, _, number = name.rpartition("-")
    return table if number.isdigit() and table in sheet_kind(sheet).tables else ""
