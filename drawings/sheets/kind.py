"""A kind of sheet (лист): what is asked of a scene before any work, what lays a sheet out, and what checks it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from plans.techniques import technique_of

if TYPE_CHECKING:
    from drawings.checks.expected import Expected
    from drawings.files.file_error import Enclosure
    from drawings.paper.strokes import Leaf
    from plans.scene.scene import Scene
    from plans.study import Study


class SheetKind(NamedTuple):
    """One kind of sheet; those of a technique are the SHEETS of its file sheet.py."""

    leaves: Callable[[Study], Sequence[Leaf]]  # lays out the leaves, one or several
    due: Callable[[Study, Sequence[Leaf]], Iterable[Expected]]  # what must stand on them, by the analysis
    scales: Mapping[str, str] = MappingProxyType({})  # how names of figures begin, and their keys of [sheet.scale]
    admit: Callable[[Scene], None] = lambda scene: None  # refuses what the sheet cannot show, before any work
    # What a letter that the sheet alone gives is on the record of a position; nothing where it is none.
    letters: Callable[[Study, int, str], str] = lambda study, position, letter: ""
    enclosures: Callable[[Study], Iterable[Enclosure]] = lambda study: ()  # the files beside its sheets


def sheet_kind(sheet: str) -> SheetKind:
    """Give a kind of sheet by its name.

    >>> sheet_kind("rotor").scales["couples"]
    'couple'
    """
    kinds: Mapping[str, SheetKind] = import_module(f"drawings.{technique_of(sheet)}.sheet").SHEETS
    return kinds[sheet]
