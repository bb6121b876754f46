"""The self-check of a written kinematics sheet: plans, points, table, scales against the analysis (проверка листа)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence

from drawings.checks import arrowheads, line_kinds, reading
from drawings.checks.diagrams import verify_diagrams
from drawings.checks.documents_old import title_block
from drawings.checks.graphs.scale_line import ratio
from drawings.checks.linkage import (
    bars,
    centre_images,
    drive_arrows,
    filled_corners,
    guides,
    linkage_notes,
    linkage_set,
    notches,
    notes_beside,
    own_scales,
    pair_symbols,
    part_letters,
    paths,
    position_marks,
    stroke_dimensions,
    stroke_marks,
    strokes,
    ticks,
    value_rows,
)
from drawings.checks.linkage.laid import LaidMechanism, ground, mass_centres
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.part_letters import LetteredPlan, TruePart
from drawings.checks.linkage.position_marks import EXACT
from drawings.checks.numbers import position_numbers
from drawings.checks.seen import repeats
from drawings.checks.vectors import plan_headings, vector_plans
from drawings.checks.vectors.laid_vectors import LaidVectorPlan
from drawings.checks.workings import linkage_workings
from drawings.checks.wrong import Wrong, on
from drawings.figures.linkage.part_letters import is_relative
from drawings.figures.linkage.vector_plan import LEAST
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from plans.checks.compare import MotionComparison
from plans.checks.comparison import Finding
from plans.checks.expected import Expected
from plans.checks.parts import findings, spans
from plans.linkage.letters import POLES
from plans.linkage.study import LinkageStudy
from plans.model.order import ORDERS, POSITIONS
from plans.study import Study
from plans.words.words import Message, message

COMMON = "common"  # of the scales of plans: each order has one
KIND = "kinematics"  # the kind of sheet that shows more than the plan of positions


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold the plans, the points, the table and the scales of a kinematics sheet against the analysis."""
    linkage, comparison = study["linkage"], study.comparison("linkage")
    gone = {gap.position for gap in comparison.construction.gaps}
    shown = [(plan, k) for plan, k in leaf.metadata["vectors"] if k not in gone]
    for k in dict.fromkeys(k for _, k in shown):
        yield from _plans(measured, linkage, comparison, k, {plan for plan, own in shown if own == k})
        yield from _centres(measured, leaf, linkage, comparison, k)
        yield from _parts(measured, leaf, linkage, comparison, k)
        for plan in [plan for plan, own in shown if own == k]:
            yield from vector_plans.faults(_laid_plan(measured, leaf, linkage, comparison, (plan, k)))
    if leaf.metadata["shown"] is not None:
        yield from _points(measured, comparison, leaf.metadata["shown"])
        yield from _positions(measured, leaf, linkage, comparison)
    if "diagrams" in leaf.metadata:
        yield from verify_diagrams.faults(measured, leaf, study)
    yield from arrowheads.faults(leaf, drafting_of(study.scene).hand.symbol)
    yield from line_kinds.faults(leaf, drafting_of(study.scene).hand)
    yield from repeats.faults(leaf, drafting_of(study.scene).hand.result.width)
    yield from reading.marked_scales(leaf)
    yield from linkage_notes.faults(leaf, linkage, comparison)
    yield from notes_beside.faults(leaf, study)
    yield from linkage_workings.of_linkage(measured, leaf, linkage, comparison)
    yield from _page(measured, leaf, linkage)
    if "scales" in leaf.metadata:
        yield from value_rows.faults(measured, leaf, linkage, comparison)


def _page(measured: Measured, leaf: Leaf, study: LinkageStudy) -> Iterator[Wrong]:
    """Hold the paper and the title block; its scale is that of the plan of positions."""
    at, kind = ground(measured), leaf.metadata["sheet"]
    subtitle = drafting_of(study.scene).word("sheet title" if kind == KIND else POSITIONS.plan)
    scale = "" if at is None else ratio(at.scale, study.language)
    yield from title_block.faults(leaf, study.scene, kind, subtitle, scale)


def set_faults(sheets: Sequence[tuple[Measured, Leaf]], study: Study) -> Iterator[Wrong]:
    """See that each position has both its plans, on whichever sheet of the set, and that nothing else is missing."""
    shown = {(plan, k) for _, leaf in sheets for plan, k in leaf.metadata["vectors"]}
    for plan, k in ((order.plan, k) for order in ORDERS[1:] for k in sorted({k for _, k in shown})):
        if (plan, k) not in shown:
            yield on("missing_at", plan, name=POLES[plan], position=k)
    yield from linkage_set.faults([leaf for _, leaf in sheets], study)
    if study.scene.sheet.scales == COMMON:
        yield from own_scales.faults(sheets, drafting_of(study.scene))


def _plans(
    measured: Measured, study: LinkageStudy, comparison: MotionComparison, k: int, shown: Collection[str]
) -> Iterator[Message]:
    """Hold the arrows of one position's plans against the analysis: each that must be there, each that is."""
    drafts = study.drafts()
    expected = Expected(study.mechanism, comparison.analysis, k, drafts.velocities.written)
    letters = {drafts.velocities.point(name).name for name in expected.moving()}  # one image may have several letters
    arrows = expected.arrows(study.groups)
    seen = {(v.plan, *v.name.split(" ")): v for v in measured.vectors if v.position == k}
    ends = {(one[0], one[-1]) for one in seen}
    scales = {v.plan: v.scale for v in measured.vectors if v.position == k}
    for (plan, start, end), value in arrows.items():
        found = seen.get((plan, start, end))
        must = plan in shown and (end in letters if start in POLES.values() else (plan, start) in ends)
        if found is not None:
            if not abs(found.value - value) <= _allowed(comparison, found, measured):
                yield on("differs_at", plan, name=f"{start} {end}", position=k)
        elif must and not abs(value) <= 2 * LEAST * scales.get(plan, 0.0):
            yield on("missing_at", plan, name=f"{start} {end}", position=k)


def _centres(
    measured: Measured, leaf: Leaf, study: LinkageStudy, comparison: MotionComparison, k: int
) -> Iterator[Message]:
    """Hold the images of mass centres on one position's plans against the analysis."""
    expected = Expected(study.mechanism, comparison.analysis, k, study.drafts().velocities.written)
    allowed = {v.plan: _allowed(comparison, v, measured) / v.scale for v in measured.vectors if v.position == k}
    if allowed:
        yield from centre_images.faults(measured, leaf, expected, mass_centres(study), max(allowed.values()))


def _laid_plan(
    measured: Measured, leaf: Leaf, study: LinkageStudy, comparison: MotionComparison, which: tuple[str, int]
) -> LaidVectorPlan:
    """Give the plan of one position with all that the analysis has of it."""
    plan, k = which
    expected = Expected(study.mechanism, comparison.analysis, k, study.drafts().velocities.written)
    vectors = tuple(one for one in measured.vectors if (one.plan, one.position) == which)
    allowed = max((_allowed(comparison, one, measured) / one.scale for one in vectors), default=0.0)
    return LaidVectorPlan(
        leaf, plan, expected, study.groups, vectors, allowed, mass_centres(study), drafting_of(study.scene)
    )


def _parts(
    measured: Measured, leaf: Leaf, study: LinkageStudy, comparison: MotionComparison, k: int
) -> Iterator[Message]:
    """Hold the letters of relative vectors and of parts on one position's plans against the analysis."""
    ends = spans(study, study.drafts(), comparison.analysis)
    names = {name: f"{span.start.name} {span.end.name}" for name, span in ends.items()}
    told = findings(study, comparison)
    for plan in (order.plan for order in ORDERS[1:]):
        vectors = tuple(one for one in measured.vectors if (one.plan, one.position) == (plan, k))
        parts = (TruePart(one.name, names[one.name], complex(one.analysis[k])) for one in told if one.plan == plan)
        relative = [part for part in parts if is_relative(part.name, part.vector)]
        allowed = max((_allowed(comparison, one, measured) / one.scale for one in vectors), default=0.0)
        shown = LetteredPlan(plan, k, vectors, allowed)
        yield from part_letters.faults(leaf, shown, relative, drafting_of(study.scene))


def _allowed(comparison: MotionComparison, vector: MeasuredVector, measured: Measured) -> float:
    """Allow the paper's resolution, and twice the largest difference that the plan's own points are allowed."""
    position = vector.position or 0
    own = max((float(finding.allowed[position]) for finding in comparison.of(vector.plan)), default=0.0)
    return 2 * own + 2 * measured.quantum * vector.scale


def _apart(finding: Finding, k: int, seen: float) -> float:
    """Give how far a place may be out, m: no more than the roads are apart where a dead centre allows all of the sheet.

    What is less than can be `seen` is left as it is allowed.
    """
    return min(float(finding.allowed[k]), max(float(finding.difference[k]), seen))


def _positions(measured: Measured, leaf: Leaf, study: LinkageStudy, comparison: MotionComparison) -> Iterator[Message]:
    """Hold the mass centres of the plan of positions, and what stands beside its links, against the analysis."""
    at = ground(measured)
    if at is None:
        return
    laid = LaidMechanism(study, comparison.analysis, leaf.metadata["shown"], at)
    seen = {mark.name: mark for mark in measured.points if mark.plan == POSITIONS.plan}
    roads = [_apart(finding, laid.position, EXACT * at.scale) for finding in comparison.of(POSITIONS.plan)]
    allowed = max((one for one in roads if math.isfinite(one)), default=0.0)  # a gap has but its frame
    for name, (link, own) in laid.centres.items():
        mark, true = seen.get(name), laid.true(link, own)
        if mark is None and not math.isnan(true.real):
            yield message("wrong.point_missing", name=name)
        elif mark is not None and not abs(mark.value - true) <= 2 * allowed + 2 * measured.quantum * mark.scale:
            yield message("wrong.point_differs", name=name)
    plan = LaidPlan(leaf, laid, comparison.road, allowed / at.scale)
    yield from plan_headings.of_positions(leaf, at.scale, drafting_of(study.scene))
    yield from bars.faults(plan)
    yield from position_numbers.faults(plan)
    yield from guides.faults(plan)
    yield from pair_symbols.faults(plan)
    yield from filled_corners.faults(plan)
    yield from notches.faults(plan)
    yield from paths.faults(plan)
    yield from position_marks.faults(leaf, laid)
    yield from ticks.faults(leaf, laid)
    if study.travel is not None:
        yield from strokes.faults(leaf, laid, comparison.road.extremes(study.output))
        yield from stroke_dimensions.faults(leaf, laid, comparison.road)
    if study.mechanism.drive.pushed:
        yield from stroke_marks.faults(leaf, laid)
    else:
        yield from drive_arrows.faults(plan)


def _points(measured: Measured, comparison: MotionComparison, shown: int) -> Iterator[Message]:
    """Hold the points of the shown position against the analysis; none may be missing."""
    seen = {mark.name: mark for mark in measured.points if mark.position == shown}
    for finding in comparison.of(POSITIONS.plan):
        symbol, _, name = finding.name.partition("_")
        true = complex(finding.analysis[shown])
        if symbol != POSITIONS.point.symbol or math.isnan(true.real):
            continue
        mark = seen.get(name)
        if mark is None:
            yield message("wrong.point_missing", name=name)
        elif not abs(mark.value - true) <= float(finding.allowed[shown]) + 2 * measured.quantum * mark.scale:
            yield message("wrong.point_differs", name=name)
