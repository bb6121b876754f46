"""Refusals: what the form of the scene does not take, turned into faults; and the rest, which is still examined."""

from __future__ import annotations

import copy
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from plans.scene.faults import Fault, Path, dotted, nearest, suggestion
from plans.scene.forms import needing
from plans.scene.readers import REFUSED, Refusal, Refused
from plans.scene.source import Source, with_points
from plans.scene.tables import REQUIRED, Kinds, Missing, holders_of, tables_of
from plans.scene.units import type_name
from plans.words.words import Message, message

REFUSALS_LIMIT = 1_000  # worded one by one; beyond it they are only counted
ROUNDS = 12  # of leaving out what is refused; each goes one table outward at most

T = TypeVar("T")
Tables = Mapping[Path, Kinds]


def refusals(error: Refused, source: Source, kinds: Kinds) -> list[Fault]:
    """Word the first refusals of a scene's form; `kinds` are all tables that may stand at the top of a file."""
    tables = tables_of(kinds)
    listed = [refusal for refusal in error.refusals[:REFUSALS_LIMIT] if not _lacks(refusal)]
    faults = [_fault(refusal, source, tables) for refusal in listed]
    misspelt = {_meant(fault) for fault in faults}
    tops: set[Path] = {() for path in misspelt if len(path) == 1}
    spelt: Mapping[str, set[Path]] = {"missing": misspelt, "missing_for": misspelt, "no_table": tops}
    faults = [fault for fault in faults if fault.path not in spelt.get(fault.kind, set())]
    missing: dict[Path, list[str]] = {}
    for name in [str(r.path[0]) for r in error.refusals if _lacks(r) and r.path not in misspelt]:
        missing.setdefault(needing(name, source.tables), []).append(name)
    return faults + [lacking(path, tables, source, kinds) for path, tables in missing.items()]


def _lacks(refusal: Refusal) -> bool:
    return refusal.kind == "missing" and len(refusal.path) == 1


def lacking(path: Path, names: Sequence[str], source: Source, kinds: Kinds) -> Fault:
    """Make the fault of a key that needs tables which the file lacks."""
    stated = [_missing((name,), tables_of(kinds)).example for name in names]
    examples = tuple(message("example.stated", example=example) for example in stated)
    details = {"tables": ", ".join(f"[{name}]" for name in names), "example": examples}
    return source.fault(path, "needs", **details, lacks=tuple((name,) for name in names))


def _missing(path: Path, tables: Tables) -> Missing:
    """Give what the tables state of a required key."""
    holders = holders_of(tables[_pattern(path[:-1], tables)]).get(str(path[-1]), ())
    stated = (kind.keys[str(path[-1])].missing for kind in holders)
    return next((missing for missing in stated if missing), Missing("key", f"{path[-1]} = ..."))


def spare(source: Source, check: Callable[[Mapping[str, Any]], T], kinds: Kinds) -> T | None:
    """Give the scene without what its form refuses, required keys by a stand-in; nothing where that fails."""
    data, tables = copy.deepcopy(dict(source.tables)), tables_of(kinds)
    for _ in range(ROUNDS):
        try:
            return check(data)
        except Refused as error:
            for refusal in error.refusals:
                lacks = refusal.kind == "missing"
                _leave_out(data, refusal.path, lacks, _missing(refusal.path, tables).stand_in if lacks else None)
    return None


def _fault(refusal: Refusal, source: Source, tables: Tables) -> Fault:
    path = refusal.path
    if refusal.kind == "missing":
        missing, why = _missing(path, tables), refusal.details.get("why")
        details = {"thing": missing.thing, "example": missing.example, **({"why": why} if why else {})}
        return source.fault(path, "missing_for" if why else "missing", **details)
    if refusal.kind == "unknown_key":
        return _unknown_key(path, source, tables)
    if refusal.kind == "not_a_table":
        return _bare(refusal, source, tables)
    if refusal.kind == "not_a_list":
        several = message("example.list", name=dotted(path)) if (*path, "*") in tables else f"{path[-1]} = [...]"
        return source.fault(path, "wrong_type", wanted="a list", found=type_name(refusal.value), example=several)
    if refusal.kind == "pair" and (pointed := with_points(source.places.written(path))).count(",") == 1:
        advice = message("advice.decimal_comma", written=pointed)
        return source.fault(path, "pair", **{**refusal.details, "advice": advice})
    return source.fault(path, refusal.kind, **refusal.details)


def _bare(refusal: Refusal, source: Source, tables: Tables) -> Fault:
    """Make the fault of a bare value where a table belongs: its keys, and the value under the first that takes it."""
    path, pattern = refusal.path, _pattern(refusal.path, tables)
    holders = holders_of(tables[pattern]) if pattern else {}
    keys = {name: kinds[0].keys[name] for name, kinds in holders.items()}
    fits = next((name for name, known in keys.items() if known.field.read(refusal.value, (), []) is not REFUSED), "")
    missing = [known.missing for known in keys.values() if known.default is REQUIRED and known.missing]
    asked = [known.example.partition(", or ")[0] for known in missing]
    lines = [f"{fits} = {source.places.written(path)}"] * bool(fits)
    lines += [line for line in asked if re.match(rf"(?!{fits} =)\w+ = ", line)]
    stated = _missing(path, tables).example
    inline = f"{{ {', '.join(lines)} }}" if lines else "a table of key = value lines"
    wanted = message("example.keys", keys=", ".join(keys)) if keys else "a table"
    shown = {"found": type_name(refusal.value), "example": stated if stated.startswith("[") else inline}
    return source.fault(path, "wrong_type", wanted=wanted, **shown)


def _unknown_key(path: Path, source: Source, tables: Tables) -> Fault:
    key, pattern = str(path[-1]), _pattern(path[:-1], tables)
    known = list(holders_of(tables[pattern]))
    elsewhere = [table for table in tables if table != pattern and key in holders_of(tables[table])]
    homes = [] if elsewhere or key in known else [home for kind in tables[()] if (home := kind.home_of(key))]
    stated = ((name, kind.keys[name].also) for kind in tables[pattern] for name in kind.keys)
    other = next((name for name, also in stated if key.casefold() in also), "")
    near = [other] if other else nearest(key, known)
    meant: Path = (*path[:-1], *near[:1]) if near else (*elsewhere[0], key) if elsewhere else ()
    line = (_missing((*path[:-1], other), tables).example,) if other else ()  # its unit may be another than was said
    hint = message("advice.meant", names=line) if other else _meaning(key, known, elsewhere, homes)
    shown = {"table": table_name(pattern), "known": ", ".join(known), "suggestion": hint}
    return source.fault(path, "unknown_key", **shown, meant=meant)


def _meaning(key: str, known: list[str], elsewhere: list[Path], homes: list[Path]) -> Message:
    """Say what an unknown key may be: one of another table, a misspelt one, or a free name such as that of a point."""
    near = nearest(key, known)
    if near and not elsewhere:
        return suggestion(key, known)
    if not elsewhere and not homes:
        return message("advice.delete")
    tables = tuple(map(table_name, elsewhere or homes))
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
    return frozenset(path for fault in faults for path in (fault.path, _meant(fault), *_meant(fault, "lacks")) if path)


def _meant(fault: Fault, detail: str = "meant") -> tuple[Any, ...]:
    meant = fault.details.get(detail)
    return meant if isinstance(meant, tuple) else ()


def _leave_out(data: dict[str, Any], path: Path, missing: bool, stand_in: Any) -> None:
    """Leave out a refused entry; of a list all, for the others would change their numbers."""
    if stand_in is None:
        path = path[:-1] if missing else path
        path = path[:-1] if path and isinstance(path[-1], int) else path
    table = _table(data, path[:-1])
    if not path or table is None:
        return  # it went with the table around it
    if stand_in is not None:
        table[path[-1]] = copy.deepcopy(stand_in)
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
