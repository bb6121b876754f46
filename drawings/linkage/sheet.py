"""The sheets of a linkage (листы рычажного механизма)."""

from __future__ import annotations

from typing import Final

from drawings.linkage import kinematics, positions
from drawings.linkage.due import expected
from drawings.linkage.positions import of_linkage
from drawings.sheets.kind import FRAME, GRAPH, PLAN, SheetKind

POSITIONS: Final = {"positions": "length"}
MOTION: Final = {"velocities-": "velocity", "accelerations-": "acceleration", "diagrams": "angle"}
SHOWN: Final = {"positions": FRAME}
FORM: Final = {**SHOWN, "velocities-": PLAN, "accelerations-": PLAN} | {
    f"diagrams-{course}": GRAPH for course in ("travel", "velocity", "acceleration")
}
SHEETS: Final = {
    "kinematics": SheetKind(
        kinematics.leaves, expected, {**POSITIONS, **MOTION}, of_linkage, figures=FORM, tables=("values", "output")
    ),
    "positions": SheetKind(positions.leaves, expected, POSITIONS, of_linkage, figures=SHOWN),
}
