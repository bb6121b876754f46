"""What a plan holds, drawn again on other boards: each mark in it answered by its new one (перечерчивание)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from geometry.board import Board, Mark

T = TypeVar("T")


def remade(value: T, made: Mapping[Mark, Mark], boards: Mapping[str, Board]) -> T:
    """Give a value with each mark in it answered by its new one, and each board by that of its subject."""
    found: Any = value
    if isinstance(value, Mark):
        found = made[value]
    elif isinstance(value, Board):
        found = boards[value.subject]
    elif isinstance(value, tuple):
        parts = [remade(part, made, boards) for part in value]
        found = type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    elif isinstance(value, list):
        found = [remade(part, made, boards) for part in value]
    elif isinstance(value, dict):
        found = {key: remade(part, made, boards) for key, part in value.items()}
    return cast(T, found)
