"""Transfer functions by both roads: u, u' of links that turn, S', S'' of what slides (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from geometry.board import Reading, Span
from geometry.meet import EPS
from geometry.precision import errors
from plans.analytic.kinematics import Analysis
from plans.linkage.quantities import MotionComparison, cap, compare, largest_of, with_analysis
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import ACCELERATIONS, Floats, Motion
from plans.quantity import Comparison, Quantity
from plans.transfer.study import TRANSFER, TransferStudy, sliding, turning
from plans.transfer.turned import TurnedPlan


class Course:
    """A transfer function of the first order and its derivative, as either road's motion at 1 rad/s has them."""

    def __init__(self, mechanism: Mechanism, of: int | Slide) -> None:
        self.of, self.letter, self.unit = of, ratio_letter(mechanism, of), "" if isinstance(of, int) else "m"

    @property
    def names(self) -> tuple[str, str]:
        """The names of both: u_31 and u_31', S_B' and S_B''."""
        return (self.letter, f"{self.letter}'") if isinstance(self.of, int) else (f"{self.letter}'", f"{self.letter}''")

    def rows(self, motion: Motion) -> tuple[Floats, Floats]:
        """Read both off a motion, (N,) each."""
        if isinstance(self.of, int):
            _, omega, epsilon = motion.links[self.of]
            return omega, epsilon
        _, v, a = motion.points[self.of.point]
        along = np.conj(self.of.way(FRAME).direction)
        return (v * along).real, (a * along).real

    def read(self, plan: TurnedPlan) -> Any:
        """Read the first off the turned plan."""
        if isinstance(self.of, int):
            return np.real(plan.ratio(self.of))
        return np.real(plan.slope(self.of.point) * np.conj(self.of.way(FRAME).direction))

    def shown(self, plan: TurnedPlan) -> Reading | Span:
        """Give what of the turned plan shows the first."""
        return plan.readings[self.of] if isinstance(self.of, int) else Span(plan.pole, plan.images[self.of.point])


def ratio_letter(mechanism: Mechanism, of: int | Slide) -> str:
    """Letter the ratio of a link's turning to the crank's, u_31; the way of a slider's point, S_B."""
    if not isinstance(of, int):
        return f"S_{of.point}"
    crank = mechanism.drive.link
    return f"u_{of}{crank}" if max(of, crank) < 10 else f"u_{of},{crank}"


def courses(mechanism: Mechanism) -> list[Course]:
    """List what is told of a mechanism: its links that turn, then its sliders on the frame."""
    return [Course(mechanism, of) for of in (*turning(mechanism), *sliding(mechanism))]


def output_course(study: TransferStudy) -> Course | None:
    """Give the transfer functions of the output, which are drawn over the turn; None of one that does neither."""
    link, mechanism = study.linkage.output.link, study.linkage.mechanism
    alike = {n for n, least in mechanism.turning_with.items() if least == mechanism.turning_with[link]}
    found = courses(mechanism)
    own = (c for c in found if not isinstance(c.of, int) and link in (c.of.slider, c.of.owner))
    return next(own, next((course for course in found if isinstance(course.of, int) and course.of in alike), None))


@dataclass(frozen=True, eq=False, repr=False)
class TransferComparison(Comparison):
    """Transfer functions by both roads, over the motion at 1 rad/s."""

    construction: Motion
    analysis: Motion
    findings: tuple[Quantity, ...]
    road: Analysis  # at 1 rad/s


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN on both roads
def compare_transfer(study: TransferStudy) -> TransferComparison:
    """Put the turned plan, and the acceleration plan at 1 rad/s, beside the derivatives by analysis."""
    motion = compare(study.unit)
    found = cap(study.unit, [*_findings(study, motion)])
    return TransferComparison(motion.construction, motion.analysis, found, motion.road, motion=motion)


def _findings(study: TransferStudy, motion: MotionComparison) -> Iterator[Quantity]:
    told = courses(study.linkage.mechanism)
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


def _bound(course: Course, plan: TurnedPlan) -> Any:
    """Bound what rounding makes of a reading: the turned vector's own error, over the link's length of a ratio."""
    start, end = course.shown(plan)
    bounds = errors(start, end)
    if isinstance(course.of, int):
        size, part = np.abs(np.asarray(start.point)), np.abs(np.asarray(end.point))
        return (bounds[end].place + part / size * bounds[start].place) / size + 4 * EPS * part / size
    return bounds[end].place


def _allowed(course: Course, motion: MotionComparison) -> Floats:
    """Give what the acceleration plan is allowed in the same."""
    name = f"ε_{course.of}" if isinstance(course.of, int) else f"a_{course.of.point}"
    return next(found.allowed for found in motion.of(ACCELERATIONS.plan) if found.name == name)
