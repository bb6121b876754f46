"""The chapters of a note on forces: the equations of the drawn positions, before the tables of all (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.note.force_equations import drawn_scales, equations
from drawings.report.chapters import Chapters
from drawings.report.forces import force_report
from plans.study import Study

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the forces of a linkage."""
    own = force_report.chapters(study, leaves)
    told = equations(study["forces"], study.comparison("forces"), drawn_scales(leaves))
    return own._replace(values=[*told, *own.values])
