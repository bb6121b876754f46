"""The self-check of a written force sheet: every vector of its force plans against the analysis (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.force_marks import lever_marks, polygon_marks
from drawings.measure import Measured
from drawings.strokes import Leaf
from plans.compare import Comparison
from plans.force_expected import ExpectedForces
from plans.motion import ORDERS
from plans.statics import Statics


def forces_of(measured: Measured, leaf: Leaf, comparison: Comparison, statics: Statics) -> Iterator[str]:
    """Hold the force plans and the lever of one sheet against the analysis."""
    study, k, forces = statics.study, leaf.metadata["position"], comparison.forces
    assert forces is not None  # a force sheet compares them
    if any(gap.position == k for road in forces for gap in road.gaps):
        return
    loads = statics.loading(comparison.analysis)
    expected = ExpectedForces(study.mechanism, statics.machine, comparison.analysis, loads, forces[1], k)
    shown = {cut.label: cut.group for cut in statics.drafts().plans.plan.cuts}
    slack = max(float(one.allowed[k]) for one in comparison.of("forces") if one.unit == "N")
    for label in leaf.metadata["groups"]:
        yield from polygon_marks(measured, expected, study.groups, shown[label], 2 * slack)
    velocities = study.drafts().velocities
    letters = {name: velocities.point(name).name for name in comparison.analysis.points}
    speed = max(float(one.allowed[k]) for one in comparison.of(ORDERS[1]))
    yield from lever_marks(measured, expected, letters, 2 * speed)
