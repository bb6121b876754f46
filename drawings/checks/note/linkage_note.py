"""The self-check of a note on a linkage: equations of its plans against the analysis (проверка уравнений планов)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import TYPE_CHECKING

from drawings.checks.note import motion_lines
from drawings.checks.note.equation_marks import EquationMarks
from drawings.checks.note.lines import held, part
from drawings.checks.note.motion_tables import MotionTables
from drawings.checks.precise import precise
from drawings.page.drafting import drafting_of
from drawings.report.linkage.equations_chapter import drawn_scales, equations, shown_positions
from plans.checks.compare import MOST_ALLOWED
from plans.study import Study
from plans.words.words import Message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """Hold the equations of the plans, with the scales of the sheets, against the motion by analysis."""
    linkage, motion = study["linkage"], study.comparison("linkage").analysis
    head = word(linkage.language, "report.equations")
    due = equations(linkage, motion, drawn_scales(leaves), shown_positions(leaves), precise(drafting_of(study.scene)))
    yield from held(part(text, head), islice(due, 1, None), MOST_ALLOWED)


def report_faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """Hold a whole report: the note, the values of all positions, and what is said of the linkage."""
    yield from faults(text, study, leaves)
    yield from MotionTables(text, study["linkage"], study.comparison("linkage")).faults()
    yield from EquationMarks(text, study["linkage"], study.comparison("linkage"), leaves).faults()
    yield from motion_lines.faults(text, study, leaves)
