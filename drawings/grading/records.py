"""The techniques whose sheets are graded, and what the record of each tells of its vectors (записи построений)."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, NamedTuple, TypeAlias

from geometry.span import Span

Letters: TypeAlias = tuple[str, int | None, str, str]  # plan, position, and the letters of both ends


class Found(NamedTuple):
    """How a vector is found: its name, its true value by analysis, and the marks of the record that it lies between."""

    name: str
    true: complex
    span: Span


class Record(NamedTuple):
    """What a technique tells of a sheet: its vectors, and which plans the sheet has to what scales, by position."""

    found: Mapping[Letters, Found]
    plans: Mapping[str, Mapping[int | None, float]]


# By technique: of a study and a leaf to the record of that sheet.
RECORDS: Final[Mapping[str, str]] = MappingProxyType({"linkage": "drawings.grading.linkage:record_of"})
