"""Transfer functions by both roads: u, u' of links that turn, S', S'' of what slides (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from geometry.meet import EPS
from geometry.precision import errors
from plans.linkage.quantities import MotionComparison, cap, compare, largest_of, with_analysis
from plans.model.motion import ACCELERATIONS, Floats, Motion
from plans.quantity import Comparison, Quantity
from plans.transfer.functions import TransferFunctions, functions
from plans.transfer.study import TRANSFER, TransferStudy
from plans.transfer.turned import TurnedPlan


@dataclass(frozen=True, eq=False, repr=False)
class TransferComparison(Comparison):
    """Transfer functions by both roads, over the motion at 1 rad/s."""

    construction: Motion
    analysis: Motion
    findings: tuple[Quantity, ...]
    even: MotionComparison  # at 1 rad/s


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN on both roads
def compare_transfer(study: TransferStudy) -> TransferComparison:
    """Put the turned plan, and the acceleration plan at 1 rad/s, beside the derivatives by analysis."""
    motion = compare(study.unit)
    found = cap(study.unit, [*_findings(study, motion)])
    return TransferComparison(motion.construction, motion.analysis, found, motion, motion=motion)


def _findings(study: TransferStudy, motion: MotionComparison) -> Iterator[Quantity]:
    told = functions(study.linkage.mechanism)
    first = {course.unit: largest_of([course.rows(motion.analysis)[0] for course in told if course.unit == unit])
             for unit in ("", "m") for course in told if course.unit == unit}  # fmt: skip
    for course in told:
        ours, theirs = course.rows(motion.construction), course.rows(motion.analysis)
        read = np.where(np.isnan(ours[0]), np.nan, course.read(study.turned))  # a gap of the motion is one here
        allowed = with_analysis(_bound(course, study.turned), 1, motion.kappa, first[course.unit])
        named = [(TRANSFER, name, course.unit) for name in course.names]
        shown = course.shown(study.turned)
        yield Quantity.of(named[0], (read, theirs[0]), allowed, max(first[course.unit], np.finfo(float).tiny), shown)
        yield Quantity.of(named[1], (ours[1], theirs[1]), _allowed(course, motion))


def _bound(course: TransferFunctions, plan: TurnedPlan) -> Any:
    """Bound what rounding makes of a reading: the turned vector's own error, over the link's length of a ratio."""
    start, end = course.shown(plan)
    bounds = errors(start, end)
    if isinstance(course.of, int):
        size, part = np.abs(np.asarray(start.point)), np.abs(np.asarray(end.point))
        return (bounds[end].place + part / size * bounds[start].place) / size + 4 * EPS * part / size
    return bounds[end].place


def _allowed(course: TransferFunctions, motion: MotionComparison) -> Floats:
    """Give what the acceleration plan is allowed in the same."""
    name = f"ε_{course.of}" if isinstance(course.of, int) else f"a_{course.of.point}"
    return next(found.allowed for found in motion.of(ACCELERATIONS.plan) if found.name == name)


def told(comparison: TransferComparison) -> list[Quantity]:
    """List what tables tell: all that is anywhere more than rounding."""
    return [
        found
        for found in comparison.findings
        if np.nanmax(np.abs(found.analysis), initial=0.0) > np.nanmax(found.allowed, initial=0.0)
    ]
