"""Transfer functions by both roads: u, u' of links that turn, S', S'' of what slides (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from geometry.meet import EPS
from geometry.precision import errors
from plans.linkage.quantities import MotionComparison, cap, compare, with_analysis
from plans.model.motion import ACCELERATIONS, VELOCITIES, Motion, Order
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
    for of in functions(study.linkage.mechanism):
        (ours, second), (theirs, exact) = of.rows(motion.construction), of.rows(motion.analysis)
        first, other = (_of_motion(of, motion, order) for order in (VELOCITIES, ACCELERATIONS))
        read = np.where(np.isnan(ours), np.nan, of.read(study.turned))  # a gap of the motion is one here
        allowed = with_analysis(_bound(of, study.turned), VELOCITIES.number, motion.kappa, first.largest)
        names = [(TRANSFER, name, of.unit) for name in of.names]
        yield Quantity.of(names[0], (read, theirs), allowed, first.largest, of.shown(study.turned))
        yield Quantity.of(names[1], (second, exact), other.allowed, other.largest)


def _of_motion(of: TransferFunctions, motion: MotionComparison, order: Order) -> Quantity:
    """Find what the plan of an order at 1 rad/s tells of the same."""
    name = f"{order.link.symbol}_{of.of}" if isinstance(of.of, int) else f"{order.point.symbol}_{of.of.point}"
    return next(found for found in motion.of(order.plan) if found.name == name)


def _bound(of: TransferFunctions, plan: TurnedPlan) -> Any:
    """Bound what rounding makes of a reading: the turned vector's own error, over the link's length of a ratio."""
    start, end = of.shown(plan)
    bounds = errors(start, end)
    if not isinstance(of.of, int):
        return bounds[end].place
    size, part = np.abs(np.asarray(start.point)), np.abs(np.asarray(end.point))
    return (bounds[end].place + part / size * bounds[start].place) / size + 4 * EPS * part / size


def told(comparison: TransferComparison) -> list[Quantity]:
    """List what tables tell: all that is anywhere more than rounding."""
    return [
        found
        for found in comparison.findings
        if np.nanmax(np.abs(found.analysis), initial=0.0) > np.nanmax(found.allowed, initial=0.0)
    ]
