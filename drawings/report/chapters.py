"""The chapters of a technique in the report, as lines of Markdown (главы отчёта)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple


class Chapters(NamedTuple):
    """What one technique tells in the report, in the places that the report gives to all techniques."""

    subject: Iterable[str] = ()  # what is studied
    values: Iterable[str] = ()  # what is found: equations, tables of all positions
    conditions: Iterable[str] = ()  # how sharply it is determined, after the comparison of the two roads
    left_out: Iterable[str] = ()  # what the sheets leave out
