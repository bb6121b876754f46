"""The roads to characteristic positions, timed and judged against the notches replayed in 50 digits (эталон)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from geometry.replay import DIGITS, exact
from plans.analytic.cyclogram import cyclogram
from plans.analytic.kinematics import Analysis
from plans.bench.error import Errors
from plans.bench.truth import digits
from plans.cyclogram.stations import Stations, crank
from plans.cyclogram.study import CyclogramStudy
from plans.model.cyclogram import TURN, Position, Stop

NOTCHED, TRIED, ANALYSED = "construction: notches from the tool", "trial on the travel", "analysis: roots of the travel"
KIND = "φ"
DEFINED = "error: the largest difference from the truth of the turns of the main shaft at the tool's places, in turns"
TRUE = f"truth: the notches from the tool's places carried out in {DIGITS} digits"
NONE = "no notches lead back from this tool: there is no truth to judge by"
Way = tuple[str, Callable[[], Sequence[float]]]


def ways(study: CyclogramStudy) -> list[Way]:
    """List the roads to the turns of the main shaft, rad, at the tool's places; each begins anew with every run."""
    return [(NOTCHED, lambda: _notched(study)), (TRIED, lambda: _tried(study)), (ANALYSED, lambda: _analysed(study))]


def truth(study: CyclogramStudy) -> list[float]:
    """Find the turns in many digits, rounded once; nothing where no notches lead back."""
    plan, mp = study.stations.plan, digits()
    if plan is None:
        return []
    arm, count = crank(plan), len(study.stations.asked)
    return [float(mp.arg(exact([arm], k)[arm])) * study.cyclogram.sense for k in range(count)]


def errors(found: Sequence[float], true: Sequence[float]) -> Errors:
    """Judge what a road has found."""
    off = [abs(math.remainder(one - other, TURN)) / TURN for one, other in zip(found, true, strict=True)]
    return Errors({KIND: max(off)} if off else {}, f"{KIND}_{off.index(max(off))}" if off else "")


def _anew(study: CyclogramStudy) -> Stations:
    """Begin the way from the tool back to the crank anew; the extremes are those of the linkage."""
    return Stations(study.linkage.sweep, study.output, study.reached, study.task)


def _notched(study: CyclogramStudy) -> list[float]:
    return in_order(study, _anew(study).cyclogram.positions)


def _tried(study: CyclogramStudy) -> list[float]:
    return [float(angle) * study.cyclogram.sense for angle in _anew(study).tried]


def _analysed(study: CyclogramStudy) -> list[float]:
    linkage = study.linkage
    road = Analysis(linkage.mechanism, first=linkage.first, looks=linkage.looks.phi)
    found = cyclogram(road, study.task, study.output, None)
    return [] if found is None else in_order(study, found.positions)


def in_order(study: CyclogramStudy, positions: Sequence[Position]) -> list[float]:
    """Give the turns at the tool's places in the order in which they are asked for; a share is known to a rounding."""
    return [_nearest(stop, positions).turned for stop in study.stations.asked]


def _nearest(stop: Stop, positions: Sequence[Position]) -> Position:
    alike = (one for one in positions if (one.role, one.back) == (stop.role, stop.back))
    return min(alike, key=lambda one: abs(one.share - stop.share))
