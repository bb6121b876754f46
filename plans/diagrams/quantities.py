"""The kinematic diagrams by both roads: the output's course, the chords; as numbers (сравнение диаграмм)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from geometry.calculus import ROUNDINGS
from geometry.meet import EPS
from plans.analytic.kinematics import ExactCourse, alone, diagrams
from plans.diagrams.study import DIAGRAMS, DiagramsStudy
from plans.linkage.quantities import ANALYSIS, MotionComparison, compare, solved
from plans.linkage.study import LinkageStudy
from plans.model.diagrams import FEWEST, Diagrams
from plans.model.mechanism import output_way
from plans.model.motion import ACCELERATIONS, ORDERS, Floats
from plans.quantity import Comparison, Numbers, Quantity, plain
from plans.study import Study
from plans.words.words import Message, message

LETTERS = {True: ("S", "v", "a"), False: ("ψ", "ω", "ε")}  # of an output that slides, and of one that turns


@dataclass(frozen=True, eq=False, repr=False)
class DiagramsComparison(Comparison):
    """The diagrams of an output by both roads; nothing where there are none."""

    construction: Diagrams
    analysis: Diagrams
    findings: tuple[Quantity, ...]
    exact: ExactCourse  # the output's course anywhere on the axis, by analysis


class NoDiagrams:
    """What either road finds where there are no diagrams."""

    by = "construction"
    unanswered = ()


def comparison_of(study: Study) -> Comparison:
    """Compare the diagrams of a scene."""
    drafted = study.of(DiagramsStudy)
    ours = drafted.diagrams
    if ours is None:
        return Comparison(NoDiagrams(), NoDiagrams(), ())
    motion = motion_of(study)
    output, road = drafted.linkage.output, motion.road
    exact = ExactCourse(road, output, ours.axis, float(motion.analysis.phi[0]), road.extremes(output))
    theirs = diagrams(exact, motion.analysis)
    return DiagramsComparison(ours, theirs, tuple(_Bounds(drafted, ours, theirs, motion).findings()), exact)


def motion_of(study: Study) -> MotionComparison:
    """Give the motion by both roads up to accelerations, whatever else is asked for."""
    found = study.of(MotionComparison)
    whole = found.construction.order == ACCELERATIONS.number == found.analysis.order
    return found if whole else compare(study.of(LinkageStudy))


class _Bounds:
    """What rounding allows both roads to differ by, from what it allows the plans' own points or links."""

    def __init__(self, study: DiagramsStudy, ours: Diagrams, theirs: Diagrams, motion: MotionComparison) -> None:
        self.study, self.ours, self.theirs, self.motion = study, ours, theirs, motion
        self.axis, self.omega = ours.axis, study.course.omega

    def findings(self) -> Iterator[Quantity]:
        """Compare S, v, a at the positions, v and a by chords, and exactly where these belong."""
        letters = LETTERS[self.study.course.travel.sliding]
        units = self.study.units
        for order, (ours, theirs) in enumerate(zip(self.ours.at, self.theirs.at, strict=True)):
            yield Quantity.of((DIAGRAMS, letters[order], units[order]), (ours, theirs), self._plan(order))
        chords = (
            (f"{letters[1]} chords", units[1], self.ours.speeds, self.theirs.speeds, self._speeds),
            (f"{letters[1]} middles", units[1], self.ours.true_speeds, self.theirs.true_speeds, self._middle(1)),
            (f"{letters[2]} chords", units[2], self.ours.growths, self.theirs.growths, self._growths),
            (f"{letters[2]} middles", units[2], self.ours.true_growths, self.theirs.true_growths, self._middle(2)),
        )
        for name, unit, ours, theirs, allowed in chords:
            yield Quantity.of((DIAGRAMS, name, unit), (ours, theirs), allowed)

    def _plan(self, order: int) -> Floats:
        """Give what the plan of an order allows the output at the positions, (M,); and of S what it allows its zero."""
        linkage: LinkageStudy = self.study.linkage
        counted, lettered = output_way(linkage.mechanism, linkage.output), ORDERS[order]
        if counted is None:
            name = f"{lettered.link.symbol}_{linkage.output.link}"
        else:
            name = f"{lettered.point.symbol}_{counted[0]}"
        found = next(quantity for quantity in self.motion.of(lettered.plan) if quantity.name == name)
        allowed = np.broadcast_to(found.allowed, found.construction.shape)[list(self.axis.numbers)]
        return np.asarray(allowed + self._zero if order == 0 else allowed)

    @property
    def _zero(self) -> float:
        """What may part the two zeros of S: each is a coordinate that is stationary, or the least or the mean one."""
        largest = float(np.nanmax(np.abs(self.ours.at.s)) + abs(self.ours.count.zero))
        return ANALYSIS * EPS * float(np.nanmax(self.motion.kappa, initial=1.0)) * largest

    @property
    def _speeds(self) -> Floats:
        """What the ends of each chord of S allow its slope, (M - 1,)."""
        s = self._plan(0) + EPS * np.abs(self.ours.at.s + self.ours.count.zero)
        slopes = self.omega * (s[1:] + s[:-1]) / np.diff(self.axis.turned)
        return np.asarray(slopes + EPS * ROUNDINGS * np.abs(self.ours.speeds))

    @property
    def _growths(self) -> Floats:
        """What the ends of each chord of v allow its slope, (M,)."""
        v, parts = self._speeds, np.diff(self.axis.turned)
        ends = np.array([v[-1], v[0]]), np.array([parts[-1], parts[0]])
        both, wide = (np.concatenate([end[:1], row, end[1:]]) for end, row in zip(ends, (v, parts), strict=True))
        slopes = self.omega * (both[1:] + both[:-1]) * 2 / (wide[1:] + wide[:-1])
        return np.asarray(slopes + EPS * ROUNDINGS * np.abs(self.ours.growths))

    def _middle(self, order: int) -> Floats:
        """Allow a value between positions what the worst position is allowed."""
        shape = (self.ours.true_speeds if order == 1 else self.ours.true_growths).shape
        lead = abs(self.ours.lead) * float(np.nanmax(self._plan(1))) if order > 1 else 0.0
        return np.full(shape, float(np.nanmax(self._plan(order))) + lead)


def numbers(study: Study, by: str) -> Numbers:
    """Find the diagrams of a scene by a road; why there are none, where they are wanted."""
    drafted = study.of(DiagramsStudy)
    if not drafted.wanted or drafted.unfit:
        return _left_out(drafted.unfit if drafted.wanted else None)
    if by == "construction":
        found, left_out = drafted.diagrams, drafted.left_out
    else:
        found, left_out = analysed(drafted), message("diagrams.few", least=FEWEST)
    return _left_out(left_out) if found is None else Numbers({"diagrams": _plain(found, drafted.linkage)})


def _left_out(why: Message | None) -> Numbers:
    return Numbers({} if why is None else {"diagrams": {"left_out": str(why)}})


def _plain(found: Diagrams, linkage: LinkageStudy) -> dict[str, Any]:
    link, axis = linkage.output.link, found.axis
    letters = LETTERS[output_way(linkage.mechanism, linkage.output) is not None]
    at = dict(zip(letters, map(plain, found.at), strict=True))
    chords = {
        f"{letters[1]}_chords": {"turned": plain(axis.middles), "values": plain(found.speeds)},
        f"{letters[2]}_chords": {"turned": plain(axis.places), "values": plain(found.growths)},
    }
    return {"output": link, "positions": list(axis.numbers), "turned": plain(axis.turned), **at, **chords}


def analysed(drafted: DiagramsStudy) -> Diagrams | None:
    """Find the diagrams by analysis alone."""
    motion, extremes, road = solved(drafted.linkage, ACCELERATIONS.number, True)
    return alone(road, drafted.linkage.output, extremes, motion, drafted.whole)
