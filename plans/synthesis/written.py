"""The mechanism of a task written as a scene, to be studied like any other (исходные данные найденного механизма)."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterator, Mapping
from typing import Any, NamedTuple

from plans.words.words import message

TABLE = re.compile(r"^\s*\[+([\w.]+)\]", re.MULTILINE)
SPEED = "60 rpm"  # of the crank, where a task does not ask for one


class MechanismText(NamedTuple):
    """The tables of a mechanism as plain data; a place is a complex number, m; each slide is the keys of its table."""

    frame: Mapping[str, complex]
    links: tuple[str, ...]  # the letters of each, the driving one first
    lengths: Mapping[str, float]
    sketch: Mapping[str, complex]
    slides: tuple[Mapping[str, Any], ...] = ()
    drive: Mapping[str, Any] = {"link": 1, "speed": SPEED, "start": "extreme", "positions": 12}
    points: Mapping[str, Mapping[str, Any]] = {}  # by their places in the frames of links


def written(made: MechanismText, title: str, source: str, sheet: Mapping[str, Any], further: str = "") -> str:
    """Write a scene with all digits of the lengths, and further keys and tables, which stand instead of its own.

    >>> made = MechanismText({"O": 0j}, ("OA",), {"OA": 0.06}, {})
    >>> print(*written(made, "Pump", "task.toml", {"language": "en"}).splitlines()[1:5], sep="|")
    title = "Pump"||[mechanism.frame]|O = [0.0, 0.0]
    """
    heads = [f"# {message(_said(made), source=source).worded(sheet['language'])}"]
    first = TABLE.search(further)
    keys, tables = (further[: first.start()], further[first.start() :]) if first else (further, "")
    own = {"title": title} if title and not re.search("^title", keys, re.MULTILINE) else {}
    others = {found[1] for found in TABLE.finditer(tables)}
    parts = *heads, *_rows(own), *keys.strip().splitlines(), *_mechanism(made, sheet, others), ""
    return "\n".join((*parts, *tables.splitlines(), "") if tables else parts)


def _said(made: MechanismText) -> str:
    return "synthesis.written" if made.drive["speed"] in {SPEED, f"-{SPEED}"} else "synthesis.timed"


def _mechanism(made: MechanismText, sheet: Mapping[str, Any], others: Collection[str]) -> Iterator[str]:
    yield from _table("[mechanism.frame]", made.frame)
    yield from _table("[mechanism.links]", {str(k): link for k, link in enumerate(made.links, 1)})
    for slide in made.slides:
        yield from _table("[[mechanism.slides]]", slide)
    yield from _table("[mechanism.lengths]", made.lengths)
    yield from _table("[mechanism.points]", made.points)
    yield from _table("[mechanism.sketch]", made.sketch)
    for name, rows in (("drive", made.drive), ("sheet", sheet)):
        if name not in others:
            yield from _table(f"[{name}]", rows)


def _table(head: str, rows: Mapping[str, Any]) -> Iterator[str]:
    if rows:
        yield from ("", head, *_rows(rows))


def _rows(rows: Mapping[str, Any]) -> Iterator[str]:
    return (f"{key} = {_value(value)}" for key, value in rows.items())


def _value(value: Any) -> str:
    """Write a value as TOML does."""
    if isinstance(value, complex):
        return f"[{value.real!r}, {value.imag!r}]"
    if isinstance(value, Mapping):
        return f"{{ {', '.join(_rows(value))} }}"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)
