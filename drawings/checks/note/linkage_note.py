"""The self-check of a note on a linkage: equations of its plans against the analysis (проверка уравнений планов)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.checks.note import motion_lines
from drawings.checks.note.arithmetic import miscounted
from drawings.checks.note.lines import part
from drawings.checks.note.motion_tables import MotionTables
from drawings.checks.note.sum_lines import SumLines
from drawings.checks.wrong import Wrong
from plans.study import Study
from plans.words.words import word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Wrong]:
    """Hold the equations of the plans, with the scales of the sheets, against the motion by analysis."""
    linkage, comparison = study["linkage"], study.comparison("linkage")
    lines = part(text, word(linkage.language, "report.equations"))
    yield from miscounted(lines)
    yield from SumLines(lines, linkage, comparison, leaves).faults()


def report_faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Wrong]:
    """Hold a whole report: the note, the values of all positions, and what is said of the linkage."""
    yield from faults(text, study, leaves)
    yield from MotionTables(text, study["linkage"], study.comparison("linkage")).faults()
    yield from motion_lines.faults(text, study, leaves)
