"""The kinematic diagrams in the report: the output's course (диаграммы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.report.chapters import Chapters
from plans.study import Study
from plans.words.words import Message

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the output's course and the diagrams."""
    return Chapters()


def headline(study: Study) -> str:
    """Say nothing: the output is told with the motion."""
    return ""


def remarks(study: Study) -> list[Message]:
    """Warn of nothing: diagrams that are left out are told on the sheet and in the report."""
    return []


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """Find no fault: the values are printed from the comparison that was judged."""
    yield from ()
