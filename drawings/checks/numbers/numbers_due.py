"""Which numbers of positions must stand along a track: extremes, the shown one, of the rest every so many (номера)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks.letters import Label
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.lettering.extent import bounds
from plans.linkage.study import EXTREMES
from plans.linkage.travel import frame_slide
from plans.model.mechanism import FRAME, Output, Slide
from plans.model.motion import Complexes, Extremes

STEPS = (1, 2, 3, 4, 6, 12)  # every which position may bear a number
KEPT = 0.7  # share of the numbers of a step that have room: with so many no coarser step is taken
USED = 0.8  # share of the numbers of a step that are there: with so many the step is that of the track
WIDER = 1.5  # times the size of a number: two that are so far apart, or farther, both have room
REVERSALS = 2  # of a stroke with a working and an idle side; between more all numbers stand on one side


class Seen(NamedTuple):
    """The numbers of a plan, each with whether it has a prime, and the middle of where it stands, mm."""

    numbers: Sequence[tuple[int, bool]]
    middles: Complexes
    size: complex

    @classmethod
    def of(cls, labels: Sequence[tuple[int, bool, Label]]) -> Seen:
        """Gather labels; the size is that of the largest, across no less than up."""
        boxes = [bounds(label.text) for *_, label in labels]
        wide, high = (max((box[k + 2] - box[k] for box in boxes), default=0.0) for k in (0, 1))
        middles = [complex(box[0] + box[2], box[1] + box[3]) / 2 for *_, label in labels for box in (label.place,)]
        numbers = [(number, between) for number, between, _ in labels]
        return cls(numbers, np.array(middles, dtype=np.complex128), complex(max(wide, high), high))

    def near(self, number: int, between: bool, spot: complex, far: float) -> bool:
        """Tell whether a number stands no farther than so many mm from a place."""
        spots = zip(self.numbers, self.middles, strict=True)
        return any(one == (number, between) and abs(middle - spot) <= far for one, middle in spots)


class DueNumbers(NamedTuple):
    """A track with its places by position, NaN of a gap, the one that is shown, and its extremes by those before them.

    `strokes` tells of each place on which of the strokes it is passed: the numbers of each stand on a side of their
    own. `seen` are the numbers of the plan, `own` those that stand nearer to this track than to any other.
    """

    places: Complexes
    shown: int
    strokes: Sequence[int]
    extremes: Sequence[tuple[int, complex]]
    seen: Seen
    own: Collection[int]

    def missing(self, far: float, same: float) -> Iterator[int]:
        """Give the numbers that are owed and stand no nearer than `far` mm; places `same` mm apart are one."""
        there = {k for k in self._known if self.seen.near(k, False, complex(self.places[k]), far)}
        yield from {self.shown} & {*self._known} - there
        for before, spot in self.extremes:
            alike = any(abs(self.places[k] - spot) <= same for k in there)
            if not (alike or self.seen.near(before, True, spot, far)):
                yield before
        rest = [k for k in self._known if k != self.shown]
        step = self._step(rest)
        owed = [k for k in rest if step and k % step == 0 and k not in there]
        yield from (k for k in owed if self._has_room(k, {*there, self.shown}))

    @property
    def _known(self) -> list[int]:
        return [k for k in range(len(self.places)) if np.isfinite(self.places[k])]

    def _step(self, rest: Sequence[int]) -> int:
        """Give every which number is owed: as many as are there, and no fewer than surely have room; 0: none is."""
        for step in STEPS:
            due = [k for k in rest if k % step == 0]
            roomy = [k for k in due if self._has_room(k, {*due, self.shown})]
            there = [k for k in due if k in self.own]
            if due and (len(roomy) >= KEPT * len(due) or len(there) >= USED * len(due)):
                return step
        return 0

    def _has_room(self, k: int, others: Collection[int]) -> bool:
        """Tell whether a number is clear of some others on its own side, and of the extremes."""
        beside = [complex(self.places[j]) for j in others if j != k and self.strokes[j] == self.strokes[k]]
        off = np.array([*beside, *(spot for _, spot in self.extremes)], dtype=np.complex128) - self.places[k]
        wide, high = WIDER * self.seen.size.real, WIDER * self.seen.size.imag
        return not ((np.abs(off.real) < wide) & (np.abs(off.imag) < high)).any()


class Course(NamedTuple):
    """A track by its point, and the extremes of what goes along it, if it has any; how often that turns back."""

    point: str
    extremes: Extremes | None = None
    reversals: int = REVERSALS

    def strokes(self, plan: LaidPlan) -> list[int]:
        """Tell of each position on which stroke it is."""
        phi, sense, turn = plan.laid.motion.phi, plan.laid.study.sense, 2 * np.pi
        if self.extremes is None or self.reversals > REVERSALS:
            return [0] * len(phi)
        start, end = self.extremes.phi
        ahead = np.mod(sense * (phi - start), turn)
        return [int(one) for one in ahead >= np.mod(sense * (end - start), turn)]


def courses(plan: LaidPlan, output: str | None) -> Iterator[Course]:
    """Give the tracks that bear numbers: of the output, by its point, and of each other slider with a stroke."""
    study = plan.laid.study
    mechanism, out = study.mechanism, study.output
    if output is not None and out.link != mechanism.drive.link:
        yield Course(output, plan.told, REVERSALS if study.travel is None else len(study.travel.rests))
    known = {frame_slide(mechanism, link) for link in (out.link, mechanism.drive.link)}
    strokes = EXTREMES in study.plans and mechanism.drive.turns
    for slide in (one for one in mechanism.slides if one.owner == FRAME and one not in known) if strokes else ():
        found = plan.road.extremes(Output(slide.slider, slide.point))
        if found is not None:
            yield Course(slide.point, found, _reversals(plan, slide))


def _reversals(plan: LaidPlan, slide: Slide) -> int:
    """Count how often a slider turns back on its way round."""
    if plan.way is None:
        return REVERSALS + 1
    along = plan.way.along(slide)
    ahead = np.sign(np.diff([*along, along[0]]))
    return int((ahead != np.roll(ahead, 1)).sum())
