"""Instant centres by both roads, and the rates by them as a third one beside plans and analysis (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from geometry.board import Mark, behind
from geometry.meet import EPS
from geometry.precision import errors
from plans.centres.kennedy import CENTRES, Kennedy, Pair, letter, pairs
from plans.centres.study import CentresStudy
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.linkage.marks import UNITS, position_of, title
from plans.linkage.quantities import ANALYSIS, MotionComparison, compare, read_bound
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import POSITIONS, VELOCITIES, Complexes, Floats, Motion, evenly
from plans.quantity import Comparison, Quantity
from plans.words.words import message

if TYPE_CHECKING:
    from plans.study import Study


@dataclass(frozen=True, eq=False, repr=False)
class CentresComparison(Comparison):
    """Instant centres by both roads, over a motion."""

    construction: Motion
    analysis: Motion
    findings: tuple[Quantity, ...]
    plans: MotionComparison  # the motion up to velocities by plans and analysis
    moving: MotionComparison  # the same, or of a drive that rests one at 1 rad/s: its centres are the same


def spin(mechanism: Mechanism, motion: Motion, link: int) -> tuple[Complexes, Floats]:
    """Give the velocity that a link would have in the datum, m/s, and its rate rad/s, (N,): all of its motion."""
    name = next(iter(mechanism.links[link].points))
    none = np.zeros(len(motion.phi))
    omega = none if link == FRAME else motion.links[link].omega
    return (motion.points[name].v if link != FRAME else none + 0j) - 1j * omega * motion.points[name].r, omega


def hinge_of(mechanism: Mechanism, pair: Pair) -> str | None:
    """Give the hinge that joins two links, if one does."""
    return next((point for point, links in mechanism.hinges.items() if {*pair} <= {*links}), None)


@np.errstate(invalid="ignore", divide="ignore")  # links that turn alike have none
def common(mechanism: Mechanism, motion: Motion, pair: Pair) -> Complexes:
    """Give by analysis the places in which two links have one velocity, (N,) m: their hinge, or far where they turn."""
    if (hinge := hinge_of(mechanism, pair)) is not None:
        return motion.points[hinge].r
    (first, one), (second, two) = (spin(mechanism, motion, link) for link in pair)
    return np.asarray(-(first - second) / (1j * (one - two)))


@np.errstate(invalid="ignore", divide="ignore")  # centres at infinity, and gaps, are NaN on both roads
def compare_centres(study: CentresStudy) -> CentresComparison:
    """Put centres and rates beside those by analysis, in all positions."""
    motion = compare(study.linkage, VELOCITIES.number)
    rests = not np.any(study.linkage.rates.omega)
    moving = compare(study.linkage.paced(evenly), VELOCITIES.number) if rests else motion
    both = _Compared(study, motion, moving)
    found = (*both.places(), *both.rates())
    ours, theirs = (road._replace(gaps=()) for road in (motion.construction, motion.analysis))  # told of the motion
    return CentresComparison(ours, theirs, found, motion, moving, motion=motion)


class _Compared:
    def __init__(self, study: CentresStudy, motion: MotionComparison, moving: MotionComparison) -> None:
        self.study, self.motion, self.mechanism, self.moving = study, motion, study.linkage.mechanism, moving.analysis
        self.count = len(motion.analysis.phi)
        self.read = {k: study.rates(k) for k in study.whole}
        self.bounds = {k: self._bounds(study.at(k)) for k in self.read}
        self.kappa = ANALYSIS * EPS * motion.kappa**2

    def _bounds(self, found: Kennedy) -> dict[Mark, float]:
        bounds = errors(*(centre.mark for centre in found.found.values()))
        return {mark: float(np.ravel(error.place)[0]) for mark, error in bounds.items()}

    def places(self) -> Iterator[Quantity]:
        """Compare the centres that are not at infinity."""
        fastest = max(float(np.nanmax(np.abs(point.v))) for point in self.moving.points.values())
        for pair in pairs(self.mechanism.links):
            ours, bound = np.full(self.count, np.nan + 0j), np.full(self.count, np.nan)
            found = np.zeros(self.count, bool)
            for k in self.study.whole:
                centre = self.study.at(k).found.get(pair)
                if centre is not None and not centre.infinite:
                    ours[k], bound[k], found[k] = centre.place, self.bounds[k][centre.mark], True
            (_, one), (_, two) = (spin(self.mechanism, self.moving, link) for link in pair)
            theirs, fast = common(self.mechanism, self.moving, pair), np.maximum(np.abs(one), np.abs(two))
            apart = np.abs(one - two) if hinge_of(self.mechanism, pair) is None else fast
            found &= apart > self.kappa * fast  # two links that for a moment move as one have a centre anywhere
            allowed = np.where(found, bound + self.kappa * (fast * np.abs(theirs) + fastest) / apart, np.nan)
            both = np.where(found, ours, np.nan), np.where(found, theirs, np.nan)
            yield Quantity.of((CENTRES, letter(pair), "m"), both, allowed)

    def rates(self) -> Iterator[Quantity]:
        """Compare the rates of the links."""
        for link in (n for n in sorted(self.mechanism.links) if n not in (FRAME, self.mechanism.drive.link)):
            ours, bound = np.full(self.count, np.nan), np.full(self.count, np.nan)
            for k, rates in self.read.items():
                if link in rates:
                    ours[k], read = rates[link]
                    bound[k] = 0.0 if read is None else read_bound(read).item()
            finding = next(row for row in self.motion.of(VELOCITIES.plan) if row.name == f"ω_{link}")
            theirs = np.where(np.isnan(ours), np.nan, finding.analysis)
            named, allowed = (CENTRES, f"ω_{link}", "rad/s"), bound + self.kappa * finding.largest
            yield Quantity.of(named, (ours, theirs), allowed, finding.largest)


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a centre in a position: P_02, P_13."""
    found = study.of(CentresStudy)
    named = {letter(pair): pair for pair in pairs(found.linkage.mechanism.links)}
    if name not in named:
        return NoMark(tuple(named), message("mark.marks", marks=", ".join(named)), tuple(named)[:1])
    wanted = position_of(found.linkage, position)
    centre = found.at(wanted).found.get(named[name])
    if centre is None:
        raise UnknownMark(message("mark.open_centre", mark=name, position=wanted))
    heading, steps = title(found.linkage, name, wanted), tuple(behind(centre.mark))
    return Explanation(heading, steps, {**UNITS, CENTRES: "m"}, (), POSITIONS.plan)
