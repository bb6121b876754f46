"""Transfer functions by both roads: u, u' of links that turn, S', S'' of what slides (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from geometry.board import Reading, behind
from geometry.precision import errors
from plans.explanation import Explanation, NoMark, in_position
from plans.linkage.marks import UNITS, position_of, title
from plans.linkage.quantities import MotionComparison, cap, compare, read_bound, with_analysis
from plans.model.motion import ACCELERATIONS, POSITIONS, VELOCITIES, Motion, Order
from plans.quantity import Comparison, Quantity, by_hand
from plans.transfer.study import TransferFunctions, TransferStudy, functions
from plans.transfer.turned import TRANSFER, TurnedPlan
from plans.words.words import message

if TYPE_CHECKING:
    from plans.study import Study


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
    ours, theirs = (road._replace(gaps=()) for road in (motion.construction, motion.analysis))  # told of the motion
    return TransferComparison(ours, theirs, found, motion, motion=motion)


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
    name = f"{order.link.symbol}_{of.of}" if isinstance(of.of, int) else f"{order.point.symbol}_{of.of.point}"
    return next(found for found in motion.of(order.plan) if found.name == name)


def _bound(of: TransferFunctions, plan: TurnedPlan) -> Any:
    """Bound what rounding makes of a reading: the turned vector's own error, of a ratio over the link's length."""
    shown = of.shown(plan)
    return read_bound(shown) if isinstance(shown, Reading) else errors(shown[1])[shown[1]].place


def listed(comparison: TransferComparison) -> list[Quantity]:
    """List what tables tell: all that is anywhere more than rounding."""
    sizes = ((found, np.nanmax(np.abs(found.analysis), initial=0.0)) for found in comparison.findings)
    return [found for found, size in sizes if size > np.nanmax(found.allowed, initial=0.0)]


def by_scales(found: Sequence[Quantity], scales: Mapping[str, float], k: int) -> Mapping[tuple[str, int], float]:
    """Give what a hand may be out in a position: scheme and turned plan are drawn at one scale."""
    mu = scales.get(f"turned-{k}")
    return {} if mu is None else by_hand(found, {TRANSFER: mu, POSITIONS.plan: mu}, k)


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind an image of the turned plan, b', a3', or behind what a transfer function is read off."""
    plan, linkage = study.of(TransferStudy).turned, study.of(TransferStudy).linkage
    read = {of.names[0]: tuple(of.shown(plan)) for of in functions(linkage.mechanism)}
    named = {mark.name: (mark,) for mark in plan.board if mark.name.endswith("'")} | read
    found = named.get(name) or sum((named.get(end, ()) for end in name.split(" ")), ())  # "a' b'": of a vector
    if not found:
        return NoMark(tuple(named), message("mark.marks", marks=", ".join(read)), tuple(read)[:1])
    wanted = position_of(linkage, position)
    steps = in_position(behind(*found), wanted, len(linkage.turn))
    return Explanation(title(linkage, name, wanted), steps, {**UNITS, TRANSFER: "m"}, (), POSITIONS.plan)
