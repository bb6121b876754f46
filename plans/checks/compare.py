"""Comparison of the two roads: every quantity by construction and by analysis, and the difference allowed (сравнение).

A difference is judged against the largest vector of its plan, for a true zero has no per cent. The allowed one is
derived: the construction's own error carried from step to step (geometry.precision), and the analytic solver's, whose
linear systems magnify a rounding by the condition of the Jacobian once for every order of derivative.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from geometry.meet import EPS
from geometry.precision import condition, errors
from plans.analytic.kinematics import Analysis
from plans.linkage.drafts import Drafts
from plans.linkage.margin import margins
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import (
    Complexes,
    Extremes,
    Floats,
    Gap,
    Motion,
)
from plans.model.order import ORDERS

if TYPE_CHECKING:
    from plans.model.kinetostatics import Kinetostatics
    from plans.model.losses import Friction

_Road = TypeVar("_Road")

# A Newton step or a linear solution at rest leaves a few roundings of the largest term in each of its rows.
ANALYSIS = 8.0

# A difference allowed beyond this share of the plan's largest would let a drawn error through: except in positions that
# are named as too near a dead centre it is not, however bad the conditions.
MOST_ALLOWED = 1e-6
NOT_GRADED = 600.0  # kappa of a notch of 6 minutes of arc: 0.01 mm in a length moves such a point by 6 mm

EXTREMES = ("φ_start", "φ_end", "H", "θ")


class Finding(NamedTuple):
    """One quantity over all positions by both roads, with the allowed difference; NaN at gaps."""

    plan: str
    name: str  # "v_B", "ω_3"
    unit: str
    construction: Complexes | Floats
    analysis: Complexes | Floats
    difference: Floats
    allowed: Floats
    largest: float  # the largest of its kind on the plan, over all positions

    @property
    def excess(self) -> Floats:
        """The difference in units of the allowed one; an undetermined comparison counts as infinite."""
        with np.errstate(divide="ignore", invalid="ignore"):
            share = np.where(self.difference == 0, 0.0, self.difference / self.allowed)
        gap = np.isnan(np.abs(self.construction)) & np.isnan(np.abs(self.analysis))
        return np.where(gap, 0.0, np.where(np.isnan(share), np.inf, share))

    @property
    def per_cent(self) -> float:
        """The worst difference in per cent of the plan's largest."""
        if not np.isfinite(self.difference).any() or self.largest == 0:
            return 0.0
        return float(100 * np.nanmax(self.difference) / self.largest)


class Comparison(NamedTuple):
    """All findings of a study."""

    construction: Motion
    analysis: Motion
    findings: tuple[Finding, ...]
    kappa: Floats  # condition of the scaled Jacobian at every position
    road: Analysis  # by which the analysis was made
    forces: tuple[Kinetostatics, Kinetostatics] | None = None  # by construction and by analysis, where asked for
    friction: tuple[Friction, Friction] | None = None  # likewise

    @property
    def alone(self) -> tuple[tuple[Motion | Kinetostatics, Gap], ...]:
        """Gaps that one road names and the other does not, or for another reason; each with the road that names it."""
        roads = self.construction, self.analysis
        found = _alone(roads, [road.gaps for road in roads])
        forces = self.forces or ()
        return (*found, *_alone(forces, [road.unanswered for road in forces]))

    @property
    def left_out(self) -> dict[str, list[int]]:
        """Positions left out of the comparison, as both roads give them up, by the first plan that has none of them."""
        found: dict[str, list[int]] = {}
        for gap in (*self.construction.gaps, *(self.forces[0].unanswered if self.forces else ())):
            found.setdefault(gap.plan, []).append(gap.position)
        return found

    def of(self, plan: str) -> tuple[Finding, ...]:
        """Give the findings of one plan."""
        return tuple(finding for finding in self.findings if finding.plan == plan)

    @property
    def worst(self) -> float:
        """The largest difference in units of its allowed one."""
        return max((float(np.max(finding.excess)) for finding in self.findings), default=0.0)

    @property
    def agrees(self) -> bool:
        """Whether every difference is within its allowed one, and both roads name the same gaps."""
        return self.worst <= 1.0 and not self.alone


def _alone(roads: Sequence[_Road], told: Sequence[Sequence[Gap]]) -> Iterator[tuple[_Road, Gap]]:
    """Give the gaps told by one of two roads and not by the other."""
    named = [{(gap.position, gap.plan, gap.reason) for gap in gaps} for gaps in told]
    for road, gaps, other in zip(roads, told, reversed(named), strict=True):
        yield from ((road, gap) for gap in gaps if (gap.position, gap.plan, gap.reason) not in other)


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN on both roads
def compare(study: LinkageStudy, order: int = 2) -> Comparison:
    """Compare construction and analysis over all positions of a study, up to an order of derivative."""
    drawn = study.motion(order)
    road = Analysis(study.mechanism, first=study.scene.drive.first is not None, looks=study.looks.phi)
    solved = road.motion(study.turn.phi, order)
    kappa = road.conditions(solved)
    drafts = study.drafts()
    findings: list[Finding] = []
    for k in range(order + 1):
        findings += _points(study, drafts, k, drawn, solved, kappa)
        findings += _links(drafts, k, drawn, solved, kappa)
    return Comparison(drawn, solved, capped(study, findings), kappa, road)


def notches(study: LinkageStudy) -> Floats:
    """Give kappa of every group's meeting over the positions, (groups, positions)."""
    _, marks = margins(study.drafts().positions, study.groups, study.sweep.sides)
    count = len(study.turn)
    return np.array([np.broadcast_to(condition(mark), count) for mark in marks]).reshape(len(marks), count)


def capped(study: LinkageStudy, findings: Sequence[Finding]) -> tuple[Finding, ...]:
    """Allow no more than MOST_ALLOWED of the largest where the construction is sharp."""
    sharp = ~(notches(study).max(axis=0, initial=1.0) >= NOT_GRADED)
    mosts = (np.where(sharp, MOST_ALLOWED * finding.largest, np.inf) for finding in findings)
    pairs = zip(findings, mosts, strict=True)
    return tuple(finding._replace(allowed=np.minimum(finding.allowed, most)) for finding, most in pairs)


def compare_extremes(study: LinkageStudy, comparison: Comparison) -> Comparison:
    """Add the output's extreme positions, their crank angles, stroke and overlap, found by both roads."""
    ours, theirs = None if study.found is None else study.found.extremes, comparison.road.extremes(study.output)
    told = ours or theirs
    if told is None:
        return comparison
    values = [np.full(4, np.nan) if one is None else _told(one) for one in (ours, theirs)]
    size = max(abs(reach) for reach in told.reach) if told.sliding else np.pi
    largest = np.array([2 * np.pi, 2 * np.pi, max(size, told.stroke), 2 * np.pi])
    # An extreme's crank angle is where a velocity is zero: its rounding is the velocity's over the acceleration's.
    allowed = np.minimum(ANALYSIS * EPS * float(np.nanmax(comparison.kappa, initial=1.0)) ** 2, MOST_ALLOWED) * largest
    apart = np.abs(values[0] - values[1])
    apart[:2] = np.abs(np.angle(np.exp(1j * apart[:2])))
    units = ("rad", "rad", "m" if told.sliding else "rad", "rad")
    added = tuple(
        Finding("extremes", *named, values[0][k], values[1][k], apart[k], allowed[k], float(largest[k.start]))
        for k, named in zip(map(slice, range(4), range(1, 5)), zip(EXTREMES, units, strict=True), strict=True)
    )
    return comparison._replace(findings=comparison.findings + added)


def _told(found: Extremes) -> Floats:
    return np.array([*found.phi, found.stroke, found.overlap])


def _points(
    study: LinkageStudy, drafts: Drafts, order: int, drawn: Motion, solved: Motion, kappa: Floats
) -> Iterator[Finding]:
    names = [name for name in drawn.points if name not in study.mechanism.links[FRAME].points]
    pairs = [(drawn.points[n][order], solved.points[n][order]) for n in names]
    largest = largest_of([np.abs(ours) for ours, _ in pairs])
    plan, told = drafts.plan(order), ORDERS[order]
    marks = [plan.point(name) for name in names]
    bounds = errors(*marks)
    for name, mark, (ours, theirs) in zip(names, marks, pairs, strict=True):
        allowed = with_analysis(bounds[mark].place, order, kappa, largest)
        label = f"{told.point.symbol}_{name}"
        yield Finding(told.plan, label, told.point.unit, ours, theirs, np.abs(ours - theirs), allowed, largest)


def _links(drafts: Drafts, order: int, drawn: Motion, solved: Motion, kappa: Floats) -> Iterator[Finding]:
    told = ORDERS[order]
    pairs = {n: (drawn.links[n][order], solved.links[n][order]) for n in drawn.links}
    largest = (
        np.pi if order == 0 else max(largest_of([np.abs(ours) for ours, _ in pairs.values()]), _slowest(drawn, order))
    )
    for number, (ours, theirs) in pairs.items():
        apart = np.abs(np.angle(np.exp(1j * (ours - theirs)))) if order == 0 else np.abs(ours - theirs)
        bound = _turn_bound(drafts, order, number)
        allowed = with_analysis(bound, order, kappa, largest)
        label = f"{told.link.symbol}_{number}"
        yield Finding(told.plan, label, told.link.unit, ours, theirs, apart, allowed, largest)


def _slowest(drawn: Motion, order: int) -> float:
    """Give the rate at which the plan's largest vector turns the mechanism's whole size: less is no large rate.

    Links that only translate have rates that are truly zero, and no per cent of themselves.
    """
    places = np.array([motion.r for motion in drawn.points.values()])
    size = largest_of([np.abs(places - places[0])])
    vector = largest_of([np.abs(motion[order]) for motion in drawn.points.values()])
    return vector / size if size > 0 else 0.0


def _turn_bound(drafts: Drafts, order: int, number: int) -> Floats:
    """Bound the error of an angle or a rate read from a vector: the vector's own error over the arm's length."""
    plan = drafts.plan(order)
    if order == 0:
        arm = plan.images[number].arm
        assert arm is not None  # every link has an arm on the plan of positions
        return np.asarray(errors(arm)[arm].place / np.abs(np.asarray(arm.point)) + 2 * EPS)
    if number not in plan.readings:
        return np.zeros(1)
    arm, turning = plan.readings[number]
    bounds = errors(arm, turning)
    size, part = np.abs(np.asarray(arm.point)), np.abs(np.asarray(turning.point))
    return np.asarray((bounds[turning].place + part / size * bounds[arm].place) / size + 4 * EPS * part / size)


def with_analysis(own: Floats, order: int, kappa: Floats, largest: float) -> Floats:
    """Add the analytic road's share: kappa once for the position and once more for every derivative."""
    return np.asarray(own + ANALYSIS * EPS * kappa ** (order + 1) * largest)


def largest_of(sizes: Sequence[Floats]) -> float:
    """Give the largest of some sizes over all positions, gaps left out."""
    finite = [float(np.nanmax(size)) for size in sizes if np.isfinite(size).any()]
    return max(finite, default=0.0)
