"""What the analysis knows of the cells of a table: the findings that its rows tell, by their letters (известное)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from drawings.due.acting import named as force_rows
from drawings.due.diagrams import columns, headings
from drawings.due.linkage import VALUES as TABLE
from drawings.due.linkage import mass_centres, named
from drawings.figures.diagrams.output_table import NAME
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Text
from plans.checks.comparison import Finding
from plans.checks.diagrams_comparison import DiagramsComparison
from plans.checks.hand.motion import MotionByHand
from plans.study import Study


class Known(NamedTuple):
    """A value by the analysis, and how far the two roads may be apart in it."""

    value: float
    apart: float


def findings_of(study: Study, kind: str, table: str) -> Mapping[str, Finding]:
    """Give the findings that the rows of a table tell, by their letters as they are read; of no other table any."""
    if (kind, table) == ("kinematics", TABLE):
        linkage, comparison = study["linkage"], study.comparison("linkage")
        parts = MotionByHand(linkage, comparison, mass_centres(linkage)).parts
        return named([*comparison.findings, *parts], linkage.language)
    if (kind, table) == ("forces", TABLE):
        rows = force_rows(study["forces"], study.comparison("forces"))
        return {Text(0j, letters).plain: one for letters, one in rows}
    return {}


def columns_of(study: Study, kind: str, table: str) -> Mapping[tuple[str, str], Known]:
    """Give what the analysis knows of a table of the output's course, by positions and headings; of no other any."""
    comparison = study.comparison("diagrams") if (kind, table) == ("kinematics", NAME) else None
    if not isinstance(comparison, DiagramsComparison):
        return {}
    heads = headings(comparison, drafting_of(study.scene))
    due = columns(comparison, abs(study["linkage"].mechanism.drive.omega))
    numbers = comparison.analysis.axis.numbers
    return {
        (str(number), head): Known(float(values[k]), apart)
        for head, (values, apart) in zip(heads, due, strict=True)
        for k, number in reversed(list(enumerate(numbers)))
        if math.isfinite(values[k]) and math.isfinite(apart)
    }


def known(one: Finding | None, position: int | None) -> Known | None:
    """Give what the analysis knows of a row in a position, as a table tells it; None where it knows nothing.

    >>> import numpy as np
    >>> row = np.array([3 + 4j])
    >>> known(Finding("velocities", "v_B", "m/s", row, row, np.zeros(1), np.zeros(1), 5.0), 0)
    Known(value=5.0, apart=0.0)
    """
    if one is None or position is None or not 0 <= position < len(one.analysis):
        return None
    found, apart = one.analysis[position], float(one.allowed[position])
    value = abs(found) if isinstance(found, complex) else float(found)
    return Known(float(value), apart) if math.isfinite(value) and math.isfinite(apart) else None
