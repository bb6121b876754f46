"""Refusals: what the form of the scene does not take, turned into faults; and the rest, which is still examined."""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from plans.scene.faults import Fault, Path, dotted, nearest, suggestion
from plans.scene.fields import split_letters
from plans.scene.source import Source
from plans.scene.tables import Refusal, Refused, Table
from plans.scene.units import type_name
from plans.words.words import Message, message

REFUSALS_LIMIT = 1_000  # worded one by one; beyond it they are only counted
ROUNDS = 12  # of leaving out what is refused; each goes one table outward at most

# What a missing key is, and a line that would do.
MISSING: Mapping[Path, tuple[str, str]] = {
    ("mechanism",): ("table", "[mechanism.frame], [mechanism.links], [mechanism.lengths]"),
    ("mechanism", "frame"): ("table of fixed points", "[mechanism.frame] with O = [0, 0]"),
    ("mechanism", "links"): ("table of links", '[mechanism.links] with 1 = "OA"'),
    ("drive",): ("table", '[drive] with link = 1 and speed = "60 rpm"'),
    ("drive", "link"): ("number of the crank", "link = 1"),
    ("drive", "speed"): ("angular speed", 'speed = "60 rpm"'),
    ("link",): ("number of a moving link", "link = 2"),
    ("along",): ("line", 'along = "CB", or along = { through = [0, 0], angle = 0 }'),
    ("through",): ("point of the line", "through = [0, 0]"),
    ("on",): ("number of a moving link", "on = 2"),
    ("point",): ("point of the link", 'point = "B"'),
    ("mass",): ("mass", 'mass = "3 kg"'),
    ("travel",): ("list of shares of the stroke", "travel = [0, 1]"),
    ("force",): ("list of forces", "force = [1500, 1500]"),
    ("between",): ("pair of ends", 'between = ["B", "O"]'),
    ("stiffness",): ("stiffness", 'stiffness = "20 N/mm"'),
    ("free",): ("free length", 'free = "80 mm"'),
    ("coefficient",): ("reduced coefficient of friction", "coefficient = 0.1"),
    ("friction", "radius"): ("journal radius of the hinges", 'radius = "20 mm"'),
    ("at",): ("place in the link's own frame", "at = [0.1, 0]"),
}
# What stands in for a refused table while the rest is examined.
STAND_INS: Mapping[Path, Any] = {
    ("mechanism",): {},
    ("mechanism", "frame"): {"O": [0, 0]},
    ("mechanism", "links"): {"1": "OA"},
    ("drive",): {},
    ("drive", "link"): 1,
    ("drive", "speed"): 1,
}
T = TypeVar("T")
Tables = Mapping[Path, type[Table]]


def refusals(error: Refused, source: Source, tables: Tables) -> list[Fault]:
    """Word the first refusals of a scene's form; `tables` are its tables, with "*" for any key or index."""
    faults = [_fault(refusal, source, tables) for refusal in error.refusals[:REFUSALS_LIMIT]]
    misspelt = {_meant(fault) for fault in faults}
    return [fault for fault in faults if fault.kind != "missing" or fault.path not in misspelt]


def spare(source: Source, check: Callable[[Mapping[str, Any]], T]) -> T | None:
    """Give the scene without what its form refuses, required keys by a stand-in; nothing where that fails."""
    data = copy.deepcopy(dict(source.tables))
    for _ in range(ROUNDS):
        try:
            return check(data)
        except Refused as error:
            for refusal in error.refusals:
                _leave_out(data, refusal.path, refusal.kind == "missing")
    return None


def _fault(refusal: Refusal, source: Source, tables: Tables) -> Fault:
    path = refusal.path
    if refusal.kind == "missing":
        thing, example = MISSING.get(path) or MISSING.get(path[-1:]) or ("key", f"{path[-1]} = ...")
        return source.fault(path, "missing", thing=thing, example=example)
    if refusal.kind == "unknown_key":
        return _unknown_key(path, source, tables)
    if refusal.kind in ("not_a_list", "not_a_table"):
        wanted, lines = ("a table" if refusal.kind == "not_a_table" else "a list"), "a table of key = value lines"
        several = message("example.list", name=dotted(path)) if (*path, "*") in tables else f"{path[-1]} = [...]"
        shown = {"found": type_name(refusal.value), "example": lines if wanted == "a table" else several}
        return source.fault(path, "wrong_type", wanted=wanted, **shown)
    return source.fault(path, refusal.kind, **refusal.details)


def _unknown_key(path: Path, source: Source, tables: Tables) -> Fault:
    key, own = str(path[-1]), _pattern(path[:-1], tables)
    known = list(tables[own].form)
    elsewhere = [table for table in tables if table != own and key in tables[table].form]
    near = nearest(key, known)
    meant: Path = (*path[:-1], *near[:1]) if near else (*elsewhere[0], key) if elsewhere else ()
    details = {"table": table_name(own), "known": ", ".join(known), "suggestion": _meaning(key, known, elsewhere)}
    return source.fault(path, "unknown_key", **details, meant=meant)


def _meaning(key: str, known: list[str], elsewhere: list[Path]) -> Message:
    """Say what an unknown key may be: one of another table, a misspelt one, a length or a point."""
    near = nearest(key, known)
    if near and not elsewhere:
        return suggestion(key, known)
    ends = split_letters(key)
    if not elsewhere and ends:
        elsewhere = [("mechanism", "lengths")] if len(ends) == 2 else [("mechanism", "frame")] if len(ends) == 1 else []
    if not elsewhere:
        return message("advice.delete")
    tables = tuple(map(table_name, elsewhere))
    if near:
        return message("advice.belongs_or_meant", tables=tables, near=near[0])
    return message("advice.belongs", tables=tables)


def _pattern(path: Path, tables: Tables) -> Path:
    """Find the table of the form that a path leads to."""
    for pattern in tables:
        if len(pattern) == len(path) and all(a in ("*", b) for a, b in zip(pattern, path, strict=True)):
            return pattern
    return ()


def table_name(pattern: Path) -> str | Message:
    """Name a table of the form as its header would.

    >>> table_name(("mechanism", "slides", "*")), str(table_name(()))
    ('[mechanism.slides]', 'the top of the file')
    """
    return f"[{dotted(tuple(part for part in pattern if part != '*'))}]" if pattern else message("place.top")


def doubts_of(faults: list[Fault]) -> frozenset[Path]:
    """Give the paths of which nothing more should be said: those at fault, and those a misspelt key was meant for."""
    return frozenset(path for fault in faults for path in (fault.path, _meant(fault)) if path)


def _meant(fault: Fault) -> Path:
    meant = fault.details.get("meant")
    return meant if isinstance(meant, tuple) else ()


def _leave_out(data: dict[str, Any], path: Path, missing: bool) -> None:
    """Leave out a refused entry; of a list all, for the others would change their numbers."""
    stands_in = missing and path in STAND_INS
    if not stands_in:
        path = path[:-1] if missing else path
        path = path[:-1] if path and isinstance(path[-1], int) else path
    table = _table(data, path[:-1])
    if not path or table is None:
        return  # it went with the table around it
    if stands_in:
        table[path[-1]] = copy.deepcopy(STAND_INS[path])
    else:
        table.pop(path[-1], None)


def _table(data: dict[str, Any], path: Path) -> dict[str | int, Any] | None:
    table: Any = data
    try:
        for part in path:
            table = table[part]
    except (KeyError, IndexError, TypeError):
        return None
    return table if isinstance(table, dict) else None
