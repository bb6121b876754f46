"""The table of a force sheet: reactions, moments of sliding pairs, what the drive gives (таблица реакций)."""

from __future__ import annotations

import numpy as np

from drawings.figures.forces.force_letters import force_letter
from drawings.layout.table import TableRow
from drawings.layout.value_table import row_by_hand
from drawings.lettering.words import word
from plans.checks.comparison import Finding
from plans.checks.force_comparison import ForceComparison


def label(finding: Finding, language: str, reactions: str) -> str:
    """Name a finding of the forces as the sheet does, with its unit: "R_{34}, N"."""
    name, _, how = finding.name.partition(" ")
    letter = force_letter(name, language, reactions)
    by = f" ({word(language, f'by {how}')})" if how else ""
    return f"{letter}{by}, {word(language, finding.unit)}"


def rows(comparison: ForceComparison, position: int, language: str, reactions: str) -> list[TableRow]:
    """Give the rows of one position; what is zero over the whole turn has none."""
    nothing = dict(zip(("N", "N*m"), comparison.construction.nothing_over, strict=True))
    return [
        row_by_hand(finding, label(finding, language, reactions), (position,), language)
        for finding in comparison.of("forces")
        if np.any(np.abs(comparison.construction.counted(finding.construction)) > nothing[finding.unit])
    ]
