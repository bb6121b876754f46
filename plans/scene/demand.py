"""What a scene asks for (что задано): which techniques it has a part in, and which of its keys needs what it lacks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from plans.scene.faults import Path
from plans.techniques import TECHNIQUES, Technique

SHEETS = tuple(sheet for technique in TECHNIQUES.values() for sheet in technique.sheets)


def techniques_of(data: Mapping[str, Any]) -> tuple[str, ...]:
    """Name the techniques that a file has a part in, by a sheet, a table or a key, and those that they build on."""
    return reading([name for name, technique in TECHNIQUES.items() if next(_parts(technique, data), None)])


def reading(techniques: Iterable[str]) -> tuple[str, ...]:
    """Add to some techniques those whose tables they read: they rest on them, or borrow from them.

    >>> reading(["dynamics"])
    ('linkage', 'forces', 'dynamics')
    """
    asked = resting(techniques)
    return resting([*asked, *(other for name in asked for other in TECHNIQUES[name].borrows)])


def resting(techniques: Iterable[str]) -> tuple[str, ...]:
    """Add to some techniques those that they rest on, in the order of the table.

    >>> resting(["forces"])
    ('linkage', 'forces')
    """
    waiting = list(techniques)
    for name in waiting:
        waiting += TECHNIQUES[name].needs
    return tuple(name for name in TECHNIQUES if name in waiting)


def first_sheet(data: Mapping[str, Any]) -> tuple[str, ...]:
    """Give the sheet of a file that asks for none: the first of the first technique that it has a table of."""
    found = (technique for technique in TECHNIQUES.values() if any(name in data for name in technique.tables))
    return next(((next(iter(technique.sheets)),) for technique in found), ())


def needing(table: str, data: Mapping[str, Any]) -> Path:
    """Find the key of a file that needs a table which it lacks: a sheet first, else a table or a key."""
    owner = next((name for name, technique in TECHNIQUES.items() if table in technique.tables), "")
    others = [technique for name, technique in TECHNIQUES.items() if owner in resting([name])]
    return min((part for technique in others for part in _parts(technique, data)), key=_rank, default=())


def _rank(path: Path) -> int:
    return 0 if path == ("sheets",) else len(path)


def _parts(technique: Technique, data: Mapping[str, Any]) -> Iterator[Path]:
    """Give the keys of a file by which it asks for a technique."""
    wanted = data.get("sheets")
    if isinstance(wanted, list) and any(sheet in wanted for sheet in technique.sheets):
        yield ("sheets",)
    yield from ((name,) for name in technique.tables if name in data)
    for table, names in technique.shares.items():
        given = data.get(table)
        yield from ((table, name) for name in names if isinstance(given, dict) and name in given)
