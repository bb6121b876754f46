"""The roads to characteristic positions, timed and judged against the notches replayed in 50 digits (эталон)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from geometry.replay import DIGITS, exact
from plans.analytic.cyclogram import cyclogram
from plans.analytic.kinematics import Analysis
from plans.bench.error import Errors
from plans.bench.trial import Found, Order, Road, terms, timed
from plans.bench.truth import digits
from plans.cyclogram.stations import Stations, crank
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.model.cyclogram import TURN, Position, Stop
from plans.scene.scene import Scene
from plans.study import Study

NOTCHED, TRIED, ANALYSED = "construction: notches from the tool", "trial on the travel", "analysis: roots of the travel"
KIND = "φ"
DEFINED = "error: the largest difference from the truth of the turns of the main shaft at the tool's places, in turns"
TRUE = f"truth: the notches from the tool's places carried out in {DIGITS} digits"
NONE = "no notches lead back from this tool: there is no truth to judge by"


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge the characteristic positions of a scene."""
    study: CyclogramStudy = Study(scene)[CYCLOGRAM]
    true, count = truth(study), len(study.stations.asked)
    tell("the characteristic positions")

    def judge(found: Sequence[float]) -> Errors | None:
        return errors(found, true) if true else None

    rows = timed([Road(run, count, {name: judge}) for name, run in ways(study)], order.rounds)
    return Found(rows, [DEFINED, TRUE if true else NONE, *terms(order, "of a turn")])


def ways(study: CyclogramStudy) -> list[tuple[str, Callable[[], Sequence[float]]]]:
    """List the roads to the turns of the main shaft, rad, at the tool's places; each begins anew with every run."""

    def anew() -> Stations:
        """Begin the way from the tool back to the crank anew; the extremes are those of the linkage."""
        return Stations(study.linkage.sweep, study.output, study.reached, study.task)

    def analysed() -> list[float]:
        linkage = study.linkage
        road = Analysis(linkage.mechanism, first=linkage.first, looks=linkage.looks.phi)
        found = cyclogram(road, study.task, study.output, None)
        return [] if found is None else in_order(study, found.positions)

    return [
        (NOTCHED, lambda: in_order(study, anew().cyclogram.positions)),
        (TRIED, lambda: [float(angle) * study.cyclogram.sense for angle in anew().tried]),
        (ANALYSED, analysed),
    ]


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


def in_order(study: CyclogramStudy, positions: Sequence[Position]) -> list[float]:
    """Give the turns at the tool's places in the order in which they are asked for; a share is known to a rounding."""
    return [_nearest(stop, positions).turned for stop in study.stations.asked]


def _nearest(stop: Stop, positions: Sequence[Position]) -> Position:
    alike = (one for one in positions if (one.role, one.back) == (stop.role, stop.back))
    return min(alike, key=lambda one: abs(one.share - stop.share))
