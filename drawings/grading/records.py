"""The techniques whose sheets are graded, and what the record of each tells of its vectors (записи построений)."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, NamedTuple, TypeAlias

from geometry.span import Span

Letters: TypeAlias = tuple[str, int | None, str, str]  # plan, position, and the letters of both ends


class Slip(NamedTuple):
    """A mistake that students make: its kind, what the vector is by it, and of which quantity the mistake is."""

    kind: str
    value: complex
    of: str = ""


class Found(NamedTuple):
    """How a vector is found: its name, its true value by analysis, and the marks of the record that it lies between.

    The side of a polygon has the corners of the polygon that it is laid between, and so has a diagonal; `slips` are
    mistakes known of it.
    """

    name: str
    true: complex
    span: Span
    side: Span | None = None
    diagonal: bool = False
    slips: tuple[Slip, ...] = ()


class Record(NamedTuple):
    """What a technique tells of a sheet: its vectors, and which plans the sheet has to what scales, by position.

    `boards` are the subjects of the record on which plans are drawn that have names of their own, `senses` the
    directions of arrows that are not to scale, by plan and name, `turns` the senses of arcs.
    """

    found: Mapping[Letters, Found]
    plans: Mapping[str, Mapping[int | None, float]]
    boards: Mapping[str, str] = MappingProxyType({})
    senses: Mapping[str, Mapping[str, complex]] = MappingProxyType({})
    turns: Mapping[str, Mapping[str, int]] = MappingProxyType({})


# By technique: of a study and a leaf to the record of that sheet.
RECORDS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "linkage": "drawings.grading.techniques.linkage:record_of",
        "forces": "drawings.grading.techniques.forces:record_of",
        "balance": "drawings.grading.techniques.balance:record_of",
        "bank": "drawings.grading.techniques.bank:record_of",
        "rotor": "drawings.grading.techniques.rotor:record_of",
    }
)
