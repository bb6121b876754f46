"""The self-check of a written sheet: everything on it that can be measured or read is held against the analysis."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from drawings.checks import reading
from drawings.checks.labelled import unlettered
from drawings.figures.linkage.vector_plan import LEAST
from drawings.measure.measure import Measured, MeasuredVector, check, measure_file
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Leaf
from geometry.errors import DraftError
from plans.checks.compare import Comparison
from plans.checks.expected import Expected
from plans.linkage.study import LinkageStudy
from plans.model.order import POSITIONS

if TYPE_CHECKING:
    from plans.forces.statics import Statics

TOLD = 5  # mismatches told one by one


class SelfCheckFailed(DraftError):  # noqa: N818  (the exit code's own word)
    """A sheet or a comparison that failed plandraft's own check; the sheet is withheld."""

    exit_code = 5


def verify(
    path: Path, leaf: Leaf, study: LinkageStudy, comparison: Comparison, statics: Statics | None = None
) -> Measured:
    """Measure a written sheet: all that it must show is there, states what it shows, and is what the analysis gives."""
    try:
        measured = measure_file(path)
    except SheetRefused as refused:
        raise SelfCheckFailed(f"the written sheet cannot be measured: {refused}") from refused
    wrong = [f"{miss.key.name} on {miss.key.plan}" for miss in check(measured)]
    if leaf.metadata["sheet"] == "forces":
        from drawings.checks.verify_forces import forces_of, table_names  # noqa: PLC0415  (only a force sheet pays for it)

        assert statics is not None  # a force sheet is drawn from them
        wrong += forces_of(measured, leaf, comparison, statics)
        names = table_names(comparison, statics)
    else:
        wrong += _kinematics(measured, leaf, study, comparison)
        wrong += _scales(leaf)
        names = {finding.name.replace("_", ""): finding for finding in comparison.findings}
    for group in leaf.groups:
        if group.name.startswith("values"):
            positions = tuple(int(k) for k in group.data["positions"].split())
            wrong += reading.table(group, names, positions)
    wrong += unlettered(leaf)
    if wrong:
        more = f" and {len(wrong) - TOLD} more" if len(wrong) > TOLD else ""
        raise SelfCheckFailed(f"the written sheet does not measure back: {', '.join(wrong[:TOLD])}{more}")
    return measured


def check_report(text: str, comparison: Comparison) -> None:
    """Read the friction that a report tells against the analysis."""
    from drawings.checks.verify_friction import report_of  # noqa: PLC0415  (only a scene with friction pays for it)

    wrong = list(report_of(text, comparison))
    if wrong:
        raise SelfCheckFailed(f"the report does not tell what the analysis gives: {', '.join(wrong[:TOLD])}")


def _kinematics(measured: Measured, leaf: Leaf, study: LinkageStudy, comparison: Comparison) -> Iterator[str]:
    """Hold the plans and the points of a kinematics sheet against the analysis."""
    for k in leaf.metadata["plans"]:
        if not any(gap.position == k for gap in comparison.construction.gaps):
            yield from _plans(measured, study, comparison, k)
    if leaf.metadata["shown"] is not None:
        yield from _points(measured, study, comparison, leaf.metadata["shown"])


def _plans(measured: Measured, study: LinkageStudy, comparison: Comparison, k: int) -> Iterator[str]:
    """Hold the arrows of one position's plans against the analysis: each that must be there, each that is."""
    drafts = study.drafts()
    expected = Expected(study.mechanism, comparison.analysis, k, drafts.velocities.written)
    letters = {drafts.velocities.point(name).name for name in expected.moving()}  # one image may have several letters
    arrows = expected.arrows(study.groups)
    seen = {(v.plan, *v.name.split(" ")): v for v in measured.vectors if v.position == k}
    scales = {v.plan: v.scale for v in measured.vectors if v.position == k}
    for (plan, start, end), value in arrows.items():
        found = seen.get((plan, start, end))
        must = start in ("p", "π") and end in letters
        if found is not None:
            if not abs(found.value - value) <= _allowed(comparison, found, measured):
                yield f"{start} {end} on {plan} in position {k} (against the analysis)"
        elif must and not abs(value) <= 2 * LEAST * scales.get(plan, 0.0):
            yield f"{start} {end} on {plan} in position {k} is missing"


def _allowed(comparison: Comparison, vector: MeasuredVector, measured: Measured) -> float:
    """Allow the paper's resolution, and twice the largest difference that the plan's own points are allowed."""
    position = vector.position or 0
    own = max((float(finding.allowed[position]) for finding in comparison.of(vector.plan)), default=0.0)
    return 2 * own + 2 * measured.quantum * vector.scale


def _points(measured: Measured, study: LinkageStudy, comparison: Comparison, shown: int) -> Iterator[str]:
    """Hold the points of the shown position against the analysis; none may be missing."""
    seen = {mark.name: mark for mark in measured.points if mark.position == shown}
    for finding in comparison.of(POSITIONS.plan):
        symbol, _, name = finding.name.partition("_")
        true = complex(finding.analysis[shown])
        if symbol != POSITIONS.point.symbol or math.isnan(true.real):
            continue
        mark = seen.get(name)
        if mark is None:
            yield f"{name} on the plan of positions is missing"
        elif not abs(mark.value - true) <= float(finding.allowed[shown]) + 2 * measured.quantum * mark.scale:
            yield f"{name} on the plan of positions (against the analysis)"


def _scales(leaf: Leaf) -> Iterator[str]:
    """Read the written scale of each plan."""
    for group in leaf.groups:
        marked = (one.data for one in reading.groups(group) if one.data.get("kind") in ("vector", "point"))
        yield from reading.scales(group, {float(data["scale"]) for data in marked})
