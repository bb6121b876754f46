"""A cyclogram by both roads: turns of the main shaft, stroke, window; as numbers (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from geometry.meet import EPS
from plans.analytic import cyclogram as analysis
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.linkage.quantities import ANALYSIS as ROUNDINGS
from plans.linkage.quantities import MOST_ALLOWED, road_of
from plans.model.cyclogram import ANALYSIS, BEGIN, END, TURN, Cyclogram, Position
from plans.quantity import Comparison, Numbers, Quantity
from plans.study import Study
from plans.words.words import Message, message


@dataclass(frozen=True)
class CyclogramComparison(Comparison):
    """The characteristic positions of a main mechanism by both roads."""

    construction: Cyclogram
    analysis: Cyclogram
    findings: tuple[Quantity, ...]

    @property
    def apart(self) -> Message:
        """Say in what the two roads differ most: in what positions there are at all, or in one of them."""
        ours, theirs = (tuple(stage.role for stage in road.positions) for road in (self.construction, self.analysis))
        return super().apart if ours == theirs else message("check.positions", ours=len(ours), theirs=len(theirs))


def compare_cyclogram(study: CyclogramStudy) -> CyclogramComparison:
    """Find the characteristic positions by analysis too, and put each beside that of the construction."""
    ours, watch = study.cyclogram, study.stations.watch
    road = road_of(study.linkage)
    theirs = analysis.cyclogram(road, study.task, study.output, watch.watched if watch else None)
    if theirs is None:
        theirs = Cyclogram("analysis", study.output, ours.sense, np.nan, ours.sliding, np.nan)
    motion = road.motion(np.array([stage.turned * ours.sense for stage in ours.positions]), 0)
    kappa = float(np.max(road.conditions(motion)))
    return CyclogramComparison(ours, theirs, tuple(_findings(ours, theirs, kappa)))


def _findings(ours: Cyclogram, theirs: Cyclogram, kappa: float) -> Iterator[Quantity]:
    unit = "m" if ours.sliding else "rad"
    rounding = ROUNDINGS * EPS * kappa
    yield _finding("H", unit, ours.stroke, theirs.stroke, rounding * ours.stroke, ours.stroke)
    yield _finding("θ", "rad", ours.overlap, theirs.overlap, rounding * kappa * TURN, TURN)
    same = [stage.role for stage in ours.positions] == [stage.role for stage in theirs.positions]
    others = theirs.positions if same else (None,) * len(ours.positions)
    for number, (stage, other) in enumerate(zip(ours.positions, others, strict=True)):
        yield from _position(number, stage, other, rounding)
    if same:
        ends = [stage for stage in ours.positions if stage.turned in (ours.window.start, ours.window.end % TURN)]
        allowed = sum(_allowed(stage, rounding) for stage in ends) + rounding
        yield _finding("φ_rise", "rad", ours.window.angle, theirs.window.angle, allowed, TURN)


def _position(number: int, stage: Position, other: Position | None, rounding: float) -> Iterator[Quantity]:
    """Compare the turn of the main shaft in a position, and the pressure angle where that is extreme."""
    turned = np.nan if other is None else stage.turned + ((other.turned - stage.turned + TURN / 2) % TURN - TURN / 2)
    yield _finding(f"φ_{number}", "rad", stage.turned, turned, _allowed(stage, rounding), TURN)
    if stage.angle is not None:
        theirs = np.nan if other is None or other.angle is None else other.angle
        yield _finding(f"α_{number}", "rad", stage.angle, theirs, _allowed(stage, rounding), np.pi / 2)


def _allowed(stage: Position, rounding: float) -> float:
    """Allow what rounding can have moved: the notches, and of the analysis the root, as sharply as the place tells."""
    return min(stage.slack + rounding * TURN * max(stage.condition, 1.0), MOST_ALLOWED * TURN)


def _finding(name: str, unit: str, ours: float, other: float, allowed: float, largest: float) -> Quantity:
    return Quantity.of((CYCLOGRAM, name, unit), (ours, other), allowed, largest)


def numbers(study: Study, by: str) -> Numbers:
    """Find the characteristic positions of a scene by a road: what has no numbers is refused."""
    found: Cyclogram = study.of(CyclogramComparison).analysis if by == ANALYSIS else study.of(CyclogramStudy).cyclogram
    window = found.window
    data: dict[str, Any] = {"stroke": found.stroke, "overlap": found.overlap, "sense": found.sense}
    data["window"] = {"start": window.start, "end": window.end, "angle": window.angle, "rest": window.rest}
    data["positions"] = [_place(k, stage) for k, stage in enumerate(found.positions)]
    return Numbers({"scene": study.scene.heading(), "by": found.by, "cyclogram": data})


def _place(number: int, stage: Position) -> dict[str, Any]:
    data = {"number": number, "role": stage.role, "back": stage.back, "turned": stage.turned, "share": stage.share}
    bounded = stage.role not in (BEGIN, END)  # where the tool stands a turn of the shaft does not move it
    return data | {"place": stage.place, "pressure": stage.angle, "condition": stage.condition if bounded else None}
