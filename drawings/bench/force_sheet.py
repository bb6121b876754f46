"""The force sheet by hand: the record of forces drawn again at the scales of its sheets (силовой расчёт от руки)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from drawings.bench.sheet import BY_HAND, DrawnSheets, scale
from drawings.files import atomic_files
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured, measure_file
from drawings.pens.svg import svg
from drawings.sheets import forces as sheets
from geometry.draughtsman import Draughtsman
from geometry.errors import DraftError
from plans.bench.draughtsman import SLIPS, Toll, toll
from plans.bench.forces import prepared
from plans.bench.truth import replay
from plans.checks.force_comparison import compare_forces
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.order import ORDERS

FORCES_BY_HAND = f"forces {BY_HAND}"
FORCES = "forces"  # the board of the record, on a sheet a figure of each group: "forces-4-5"
SCALED = (
    "forces by hand: the three plans and then those of forces, arms measured on the plan of positions; all polygons of "
    "a position at the coarsest scale that its sheet has for one"
)


def by_hand(
    study: LinkageStudy, drawn: DrawnSheets, largest: Mapping[str, float], folder: Path
) -> tuple[dict[str, Toll], int]:
    """Draw the force sheets' positions by hand; give what that costs, and the number of positions."""
    statics = Statics(study)
    scales = _polygons(study, statics, drawn, folder)
    ready, positions = prepared(study), [k for k in scales if np.isfinite(statics.forces.balancing.moment[k])]
    if ready is None or not positions:
        raise DraftError("no position of a force sheet has forces")
    wanted = replay(study, positions, ready)
    found = {order.plan: np.array([scale(drawn.measured, order.plan, k) for k in positions]) for order in ORDERS}
    found[FORCES] = np.array([scales[k] for k in positions])
    truth, only = wanted.truth(), wanted.only_forces
    tolls = {FORCES_BY_HAND.format(slip): toll(only, Draughtsman(slip, found), truth, largest) for slip in SLIPS}
    return tolls, len(positions)


def _polygons(study: LinkageStudy, statics: Statics, drawn: DrawnSheets, folder: Path) -> dict[int, float]:
    """Draw the force sheets; give the coarsest scale N/mm of the polygons of each of their positions."""
    found: dict[int, float] = {}
    for number, leaf in enumerate(sheets.sheets(study, compare_forces(statics, drawn.comparison), statics)):
        path = folder / f"force-sheet-{number}.svg"
        atomic_files.write(path, svg(lettered(leaf)))
        position = int(leaf.metadata["position"])
        found[position] = max(found.get(position, 0.0), _coarsest(measure_file(path)))
    return found


def _coarsest(read: Measured) -> float:
    return max((vector.scale for vector in read.vectors if vector.plan.startswith(f"{FORCES}-")), default=0.0)
