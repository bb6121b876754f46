"""What may be written into a sheet's file: characters, names of groups, names of data (имена в файле листа)."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TypeAlias

from drawings.paper.strokes import Group, SheetError
from drawings.paper.walk import groups as within

Attributes: TypeAlias = dict[str, str]

_ILLEGAL = re.compile("[^\t\n\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_NAME = re.compile(r"[^\W\d][\w.-]*")
_DATA = re.compile(r"[a-z][a-z0-9-]*")
_RESERVED = ("sheet", "seal")


def legal(text: str) -> str:
    """Pass text on if XML can carry it unchanged; control characters and halves of characters are refused."""
    if found := _ILLEGAL.search(text):
        raise SheetError(f"{text!r}: the character {found[0]!r} at {found.start()} cannot be written")
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
