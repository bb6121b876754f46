"""Faults of how a polygon of free vectors is drawn: open sides, letters missing or exchanged (многоугольник).

Any order of the sides is as good as another. Vectors that run along one another are drawn side by side.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks.letters import Label, along, distance
from drawings.grading import verdict
from drawings.grading.asked import Asked
from drawings.grading.drawn_plan import Arrow, DrawnPlan
from drawings.grading.seeing.spelling import spelled
from drawings.grading.verdict import Verdict
from drawings.paper.limits import SEEN

LANE = 60.0  # mm: a side that is drawn further beside its place is not there
BESIDE = 3.0  # mm by which a letter must be nearer to another's arrow: lanes are so far apart


class _Side(NamedTuple):
    """A side on paper, and the corners that it goes between."""

    arrow: Arrow
    corners: tuple[str, str]

    @property
    def length(self) -> float:
        return abs(self.arrow.vector)

    def gaps(self, spots: Mapping[str, complex]) -> list[complex]:
        """Give how far its ends are from the corners that are placed."""
        return [spots[one] - end for one, end in zip(self.corners, self.arrow, strict=True) if one in spots]

    def fits(self, gaps: Sequence[complex], near: float) -> bool:
        """Tell whether it ends in its corners, or in a lane square to it beside them."""
        if all(abs(gap) <= near for gap in gaps) or not self.length:
            return True
        unit = self.arrow.vector / self.length
        lane = all(abs((gap * unit.conjugate()).real) <= near and abs(gap) <= LANE for gap in gaps)
        return lane and max(abs(one - gaps[0]) for one in gaps) <= near


def open_sides(plan: DrawnPlan, near: float) -> Iterator[Verdict]:
    """Tell of a polygon whose sides do not meet, by more than a hand's slips, `near` mm."""
    sides = [
        _Side(plan.arrows[one.letters], one.corners)
        for one in plan.asked.vectors
        if one.corners is not None and one.letters in plan.arrows and not one.diagonal
    ]
    side = next(_apart(sides, near), None)
    if side is not None and not _chained(sides, near):
        spot = side.arrow.end
        yield Verdict(plan.asked.plan, plan.asked.position, "", verdict.UNCLOSED, at=(spot, spot))


def _apart(sides: Sequence[_Side], near: float) -> Iterator[_Side]:
    """Lay the sides one to another, the longest first; give those that do not fit."""
    left, spots = sorted(sides, key=lambda one: -one.length), dict[str, complex]()
    while left:
        side = next((one for one in left if not spots.keys().isdisjoint(one.corners)), left[0])
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


def _chained(sides: Sequence[_Side], near: float) -> bool:
    """Tell whether the sides go round in some order: where one ends, another begins, or beside it in a lane."""
    return all(any(_joined(one, other, near) for other in sides if other is not one) for one in sides)


def _joined(one: _Side, other: _Side, near: float) -> bool:
    gap = other.arrow.start - one.arrow.end
    return any(side.fits([gap], near) for side in (one, other) if side.length) or abs(gap) <= near


def letters(labels: Mapping[str, Sequence[Label]], plan: DrawnPlan, near: float) -> Iterator[Verdict]:
    """Name the vectors whose letters are missing, or stand at each other's arrows, `near` mm at the most."""
    shown = [(one, along(*arrow)) for one, arrow in _seen(plan)]
    for one, spots in shown:
        if any(_crossed(labels, (one, spots), other) for other in shown):
            yield _said(plan, one, verdict.SWAPPED)
        elif not distance(labels.get(spelled(one.letter), ()), spots) <= near:
            yield _said(plan, one, verdict.UNLETTERED)


def _seen(plan: DrawnPlan) -> Iterator[tuple[Asked, Arrow]]:
    for one in plan.asked.vectors:
        arrow = plan.arrows.get(one.letters) if one.letter else None
        if arrow is not None and abs(arrow.vector) > 2 * SEEN:
            yield one, arrow


def _crossed(
    labels: Mapping[str, Sequence[Label]], one: tuple[Asked, list[complex]], other: tuple[Asked, list[complex]]
) -> bool:
    """Tell whether the letters of two arrows stand close to each other's, and further from their own."""
    ours, theirs = labels.get(spelled(one[0].letter), ()), labels.get(spelled(other[0].letter), ())
    crossed = distance(ours, other[1]), distance(theirs, one[1])
    kept = distance(ours, one[1]), distance(theirs, other[1])
    return all(there + BESIDE < here for there, here in zip(crossed, kept, strict=True))


def _said(plan: DrawnPlan, one: Asked, kind: str) -> Verdict:
    asked, arrow = plan.asked, plan.arrows[one.letters]
    middle = (arrow.start + arrow.end) / 2
    return Verdict(asked.plan, asked.position, one.name, kind, at=(middle, middle))
