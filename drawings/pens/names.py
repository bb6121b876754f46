"""What may be written into a sheet's file: characters, names of groups, names of data (имена в файле листа)."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TypeAlias

from drawings.paper.strokes import Group, SheetError
from drawings.paper.walk import groups as within

Attributes: TypeAlias = dict[str, str]

# What XML carries unchanged. As a class of a regular expression it takes 5 ms to compile, a tenth of all imports.
_LEGAL = (range(0x20, 0x7F), range(0xA0, 0xD800), range(0xE000, 0xFFFE), range(0x10000, 0x110000))
_NAME = re.compile(r"[^\W\d][\w.-]*")
_DATA = re.compile(r"[a-z][a-z0-9-]*")
_RESERVED = ("sheet", "seal")


def legal(text: str) -> str:
    """Pass text on if XML can carry it unchanged; control characters and halves of characters are refused."""
    if text.isascii() and text.isprintable():
        return text
    for place, sign in enumerate(text):
        if sign not in "\t\n" and not any(ord(sign) in codes for codes in _LEGAL):
            raise SheetError(f"{text!r}: the character {sign!r} at {place} cannot be written")
    return text


def own_ids(groups: Iterable[Group]) -> None:
    """Refuse groups whose names no file can hold, or that share one."""
    seen = set(_RESERVED)
    for name in (group.name for group in within(groups) if group.name):
        if not _NAME.fullmatch(name):
            raise SheetError(f"{name!r} cannot name a group: a letter, then letters, digits, '_', '-', '.'")
        if name in seen:
            raise SheetError(f"two groups of a sheet are named {name!r}")
        seen.add(name)


def data_of(group: Group) -> Attributes:
    """Give the data of a group as attributes."""
    for key in group.data:
        if not _DATA.fullmatch(key):
            raise SheetError(f"{key!r} cannot name data: small letters, digits, '-'")
    return {f"data-{key}": legal(value) for key, value in group.data.items()}
