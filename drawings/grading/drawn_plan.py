"""Plans as a student drew them: letters, arrows, written scale, and how its polygons fail (план на листе)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from statistics import median
from typing import NamedTuple

from drawings.grading import verdict
from drawings.grading.asked import PlanAsked, VectorAsked, ends_of, is_free
from drawings.grading.verdict import Verdict
from drawings.paper.limits import SEEN
from drawings.reading.marks import MeasuredPoint, MeasuredVector
from drawings.reading.measure import Measured
from geometry.board import Mark
from plans.linkage.plan import POLES


class Arrow(NamedTuple):
    """An arrow on paper, mm, y up: where it starts and where its head is."""

    start: complex
    end: complex

    @property
    def vector(self) -> complex:
        """From its start to its head, mm."""
        return self.end - self.start


@dataclass(frozen=True)
class DrawnPlan:
    """One plan of a sheet: its arrows by the letters of their ends, its scale (true units a mm), where its pole is.

    A point of the plan of positions is an arrow from the pole, which nobody draws. A free vector has no places.
    """

    asked: PlanAsked
    arrows: Mapping[tuple[str, str], Arrow]
    scale: float
    places: Mapping[str, complex]  # where each letter lies, mm
    written: bool = True  # whether its scale stands on the sheet
    lettered: bool = False  # whether it was found by its letters alone
    doubled: tuple[str, ...] = ()  # the letters between which arrows go both ways
    headless: tuple[str, ...] = ()  # the vectors whose arrows have no heads
    plain: bool = False  # whether none of its letters is read

    @property
    def lacking(self) -> list[VectorAsked]:
        """The vectors that are asked for and not on it."""
        return [vector for vector in self.asked.vectors if vector.letters not in self.arrows]

    @property
    def whole(self) -> bool:
        """Whether each vector that is asked for is on it."""
        return not self.lacking

    def is_small(self, vector: VectorAsked) -> bool:
        """Tell whether a vector is too short on paper to be found by its letter."""
        return self.lettered and abs(vector.true) < (2 if vector.letter else 1) * SEEN * self.scale

    def is_covered(self, vector: VectorAsked) -> bool:
        """Tell whether a vector that lacks lies on another one that lacks, which hangs together with more."""
        ends = [letter for other in self.asked.vectors for letter in other.letters]
        others = (other for other in vector.twins(self.asked, self.scale) if other.letters not in self.arrows)
        return any(ends.count(other.end) > ends.count(vector.end) for other in others if vector.start)

    @property
    def unread(self) -> Verdict | None:
        """What is said of a plan of which no letter is read, or that has arrows both ways."""
        if not self.doubled and not self.plain:
            return None
        kind = verdict.DOUBLED if self.doubled else verdict.UNNAMED
        return Verdict(*self.asked.place, "", kind, of=", ".join(dict.fromkeys(self.doubled)))

    @property
    def fitted(self) -> float:
        """The scale by which it is nearest to what is asked for: of a plan on which none is written."""
        there = (vector for vector in self.asked.vectors if vector.letters in self.arrows)
        pairs = [(vector.true, self.arrows[vector.letters].vector) for vector in there]
        size = sum(abs(vector) ** 2 for _, vector in pairs)
        return abs(sum(true * vector.conjugate() for true, vector in pairs)) / size if size else 1.0

    @property
    def bare(self) -> DrawnPlan:
        """The plan without the record of what is asked for, which takes long to send from process to process."""
        asked = self.asked._replace(vectors=tuple(vector._replace(found=None) for vector in self.asked.vectors))
        return replace(self, asked=asked)

    def value(self, letters: tuple[str, str]) -> complex | None:
        """Give a vector in true units; None of one that is not drawn."""
        arrow = self.arrows.get(letters)
        return None if arrow is None else arrow.vector * self.scale

    def between(self, start: str, end: str) -> complex | None:
        """Give the vector between the places of two letters, true units."""
        if start not in self.places or end not in self.places:
            return None
        return (self.places[end] - self.places[start]) * self.scale


def places_of(arrows: Mapping[tuple[str, str], Arrow]) -> dict[str, complex]:
    """Give where each letter lies: in the middle of the ends that bear it, however far one of them is off."""
    found: dict[str, list[complex]] = {}
    for (start, end), arrow in arrows.items():
        found.setdefault(start, []).append(arrow.start)
        found.setdefault(end, []).append(arrow.end)
    middles = ((median(end.real for end in ends), median(end.imag for end in ends)) for ends in found.values())
    return {letter: complex(*middle) for letter, middle in zip(found, middles, strict=True)}


def from_marks(asked: PlanAsked, measured: Measured, scale: float | None) -> DrawnPlan | None:
    """Give a plan by the marks of a sheet; None where none of them is of it. `scale` is the one that is written."""
    marks = [mark for mark in measured.marks if (mark.plan, mark.position) == asked.place]
    if not marks:
        return None
    arrows = {ends_of(mark): _arrow(mark) for mark in marks}
    hung = {ends_of(mark): arrows[ends_of(mark)] for mark in marks if not is_free(mark)}
    return DrawnPlan(asked, arrows, scale or marks[0].scale, places_of(hung), scale is not None)


def _arrow(mark: MeasuredVector | MeasuredPoint) -> Arrow:
    if isinstance(mark, MeasuredVector):
        return Arrow(mark.start, mark.end)
    return Arrow(mark.at - mark.value / mark.scale, mark.at)


LANE = 60.0  # mm: a side that is drawn further beside its place is not there


class _Side(NamedTuple):
    """A side on paper, and the corners that it goes between."""

    arrow: Arrow
    corners: tuple[str, str]

    @property
    def length(self) -> float:
        return abs(self.arrow.vector)

    def gaps(self, spots: Mapping[str, complex]) -> list[complex]:
        """Give how far its ends are from the corners that are placed."""
        return [spots[corner] - end for corner, end in zip(self.corners, self.arrow, strict=True) if corner in spots]

    def fits(self, gaps: Sequence[complex], near: float) -> bool:
        """Tell whether it ends in its corners, or in a lane square to it beside them."""
        if all(abs(gap) <= near for gap in gaps) or not self.length:
            return True
        unit = self.arrow.vector / self.length
        lane = all(abs((gap * unit.conjugate()).real) <= near and abs(gap) <= LANE for gap in gaps)
        return lane and max(abs(gap - gaps[0]) for gap in gaps) <= near


def open_sides(plan: DrawnPlan, near: float) -> Iterator[Verdict]:
    """Tell of a polygon whose sides do not meet, by more than a hand's slips, `near` mm."""
    sides = [
        _Side(plan.arrows[vector.letters], vector.corners)
        for vector in plan.asked.vectors
        if vector.corners is not None and vector.letters in plan.arrows and not vector.diagonal
    ]
    side = next(_apart(sides, near), None)
    # They may go round in another order: where one ends another begins, or beside it in a lane, and none is left over.
    pairs = [(k, j) for k, one in enumerate(sides) for j, two in enumerate(sides) if k != j and _joined(one, two, near)]
    if side is not None and not len({k for k, _ in pairs}) == len({j for _, j in pairs}) == len(sides):
        spot = side.arrow.end
        yield Verdict(plan.asked.plan, plan.asked.position, "", verdict.UNCLOSED, at=(spot, spot))


def _apart(sides: Sequence[_Side], near: float) -> Iterator[_Side]:
    """Lay the sides one to another, the longest first; give those that do not fit."""
    left, spots = sorted(sides, key=lambda side: -side.length), dict[str, complex]()
    while left:
        side = next((side for side in left if not spots.keys().isdisjoint(side.corners)), left[0])
        left.remove(side)
        gaps = side.gaps(spots)
        if not side.fits(gaps, near):  # drawn back to front it meets the others too
            side = side._replace(arrow=Arrow(side.arrow.end, side.arrow.start))
            gaps = side.gaps(spots)
        if not side.fits(gaps, near):
            yield side
            continue
        shift = gaps[0] if gaps else 0j
        for corner, end in zip(side.corners, side.arrow, strict=True):
            spots.setdefault(corner, end + shift)


def _joined(ahead: _Side, behind: _Side, near: float) -> bool:
    gap = behind.arrow.start - ahead.arrow.end
    return any(side.fits([gap], near) for side in (ahead, behind) if side.length) or abs(gap) <= near


def drawn_places(plans: Iterable[DrawnPlan]) -> dict[Mark, complex]:
    """Give where a student has the marks of the record, from the poles, true units."""
    found: dict[Mark, complex] = {}
    for plan in plans:
        for vector in plan.asked.vectors:
            if vector.found is not None and vector.letter:
                value = plan.value(vector.letters)
                found |= {} if value is None else {vector.found.span.end: value}
            elif vector.found is not None:
                found |= _of(plan, vector.found.span.start, vector.start)
                found |= _of(plan, vector.found.span.end, vector.end)
    return found


def scales_beside(plan: DrawnPlan, beside: Iterable[DrawnPlan]) -> dict[str, float]:
    """Give the scales of a student's plans by their names and by their boards, whose coarsest counts; its own last."""
    found: dict[str, float] = {}
    for drawn in beside:
        board = drawn.asked.board or drawn.asked.plan
        found[board] = max(drawn.scale, found.get(board, 0.0))
    return found | {plan.asked.plan: plan.scale}


def lacking_places(plans: Iterable[DrawnPlan]) -> dict[Mark, complex]:
    """Give the free vectors that a student has left out: to him they are nothing."""
    lacking = ((plan, vector) for plan in plans for vector in plan.lacking)
    return {vector.found.span.end: 0j for _, vector in lacking if vector.found is not None and vector.letter}


def _of(plan: DrawnPlan, mark: Mark, letter: str) -> dict[Mark, complex]:
    """Give the place of a mark; the pole is where it is, and nothing is measured from anywhere else."""
    pole = POLES.get(plan.asked.plan, "")
    pole = pole if pole in plan.places else ""  # on the plan of positions no arrow goes from the datum
    place = plan.between(pole, letter)
    return {} if place is None or letter == pole else {mark: place}
