"""The record of a linkage's plans: which vector is which, its value by analysis, what it is drawn from (рычажный)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.due.linkage import mass_centres
from drawings.grading.marking import Found, Letters, Record
from drawings.paper.strokes import Leaf
from geometry.span import Span
from plans.checks.compare import MotionComparison
from plans.checks.expected import Expected
from plans.checks.hand.motion import MotionByHand
from plans.checks.parts import findings
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.order import ORDERS, POSITIONS
from plans.study import Study


def record_of(study: Study, leaf: Leaf) -> Record:
    """Give the record of the plans of a sheet of kinematics or of positions."""
    linkage, comparison = study["linkage"], study.comparison("linkage")
    shown = list(leaf.metadata["vectors"])
    found = {key: one for k in dict.fromkeys(k for _, k in shown) for key, one in _vectors(linkage, comparison, k)}
    if (k := leaf.metadata["shown"]) is not None:
        found |= dict(_points(linkage, comparison, k))
    return Record(found, _scales(leaf.metadata["scales"], shown, leaf.metadata["shown"]))


def _scales(
    scales: Mapping[str, float], shown: list[tuple[str, int]], drawn: int | None
) -> dict[str, dict[int | None, float]]:
    found: dict[str, dict[int | None, float]] = {POSITIONS.plan: {}}
    if POSITIONS.plan in scales:
        found[POSITIONS.plan] = dict.fromkeys((drawn, *(k for _, k in shown)), scales[POSITIONS.plan])
    for plan, k in shown:
        found.setdefault(plan, {})[k] = scales[f"{plan}-{k}"]
    return found


def _vectors(study: LinkageStudy, comparison: MotionComparison, k: int) -> Iterator[tuple[Letters, Found]]:
    """Give the vectors of the plans of one position by the letters of their ends; what has no name has those."""
    drafts = study.drafts([k])
    expected = Expected(study.mechanism, comparison.analysis, k, drafts.velocities.written)
    boards = {order.plan: drafts.plan(order.number).board for order in ORDERS[1:]}
    for (plan, start, end), value in expected.arrows(study.groups).items():
        if start in boards[plan] and end in boards[plan]:
            yield (plan, k, start, end), Found(f"{start} {end}", value, Span(boards[plan][start], boards[plan][end]))
    masses = mass_centres(study)
    compared = (*comparison.findings, *findings(study, comparison, masses))
    true = {one.name: complex(one.analysis[k]) for one in compared if one.plan in boards}
    for name, told in MotionByHand(study, comparison, masses).read(drafts).items():
        if isinstance(told, Span):
            yield (told.end.subject, k, told.start.name, told.end.name), Found(name, true[name], told)


def _points(study: LinkageStudy, comparison: MotionComparison, k: int) -> Iterator[tuple[Letters, Found]]:
    """Give the points of the plan of positions."""
    plan = study.drafts([k]).positions
    for name, motion in comparison.analysis.points.items():
        if name not in study.mechanism.links[FRAME].points:
            span = Span(plan.pole, plan.point(name))
            yield (POSITIONS.plan, k, "", name), Found(name, complex(motion.r[k]), span)
