"""Faults of drawing: a scale that is not written, a polygon that is open, letters missing or swapped (оформление)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks.hold import Label, along, distance
from drawings.grading import verdict
from drawings.grading.asked import PlanAsked
from drawings.grading.drawn_plan import DrawnPlan, open_sides
from drawings.grading.onlooker import spelled
from drawings.grading.verdict import Verdict
from drawings.grading.written_number import scales_of
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Group, Leaf, Line, Text
from drawings.paper.walk import groups, texts
from drawings.reading.sheet import SeenSheet
from plans.quantity import SLIP

# mm: two arrows end at one place if a hand that slips by four times a fair one's has drawn both there.
CLOSED = 2 * math.sqrt(2) * 4 * SLIP
# mm: a letter that is farther from what it names, is not seen to be its own; a leader reaches so far.
NEAR = 25.0
BESIDE = 3.0  # mm by which a letter must be nearer to what is another's: lanes are so far apart


def written_scale(sheet: SeenSheet, asked: PlanAsked) -> float | None:
    """Give the scale that is written on a sheet for a plan, true units a mm; None where none is.

    The headings of the plan's own group go first, then what the mark itself states where it is written anywhere.
    """
    marks = [mark for mark in sheet.measured.marks if (mark.plan, mark.position) == asked.place]
    here = [mu for group in _around(sheet.leaf, asked) for mu in _scales((group,), asked)]
    anywhere = _scales(sheet.leaf.groups, asked)
    stated = marks[0].scale if marks else math.nan
    if here:
        return stated if any(_same(mu, stated) for mu in here) else here[0]
    return stated if any(_same(mu, stated) for mu in anywhere) else None


def _around(leaf: Leaf, asked: PlanAsked) -> list[Group]:
    """Give the groups at the top that hold marks of a plan, and of no other."""
    marks = ((group, [mark.data for mark in groups((group,)) if "kind" in mark.data]) for group in leaf.groups)
    places = ((group, {(data.get("plan"), data.get("position", "None")) for data in rows}) for group, rows in marks)
    return [group for group, found in places if found == {(asked.plan, str(asked.position))}]


def _scales(strokes: Sequence[Group], plan: PlanAsked) -> list[float]:
    return [mu for _, mu in scales_written(texts(strokes), plan)]


def scales_written(lettering: Iterable[Text], plan: PlanAsked) -> list[tuple[Text, float]]:
    """Give the scales of plans of one subject that are written, true units a mm."""
    return [(text, mu) for text in lettering for mu in scales_of(text, plan.symbol, plan.unit)]


def _same(written: float, stated: float) -> bool:
    return math.isclose(written, stated, rel_tol=1e-3)  # three digits are written at the least


def drawing_faults(leaf: Leaf, labels: Mapping[str, Sequence[Label]], plan: DrawnPlan) -> Iterator[Verdict]:
    """List the faults of how a plan is drawn."""
    if not plan.written:
        yield _of(plan, verdict.UNSCALED)
    if plan.headless:
        yield _of(plan, verdict.HEADLESS)._replace(of=", ".join(plan.headless))
    gaps = (*_open(plan), *open_sides(plan, CLOSED))
    yield from gaps
    opened = {gap.name for gap in gaps}
    yield from (letter for letter in _letters(leaf, labels, plan) if letter.name not in opened)
    yield from _outside(leaf, plan)


def _open(plan: DrawnPlan) -> Iterator[Verdict]:
    """Name the letters at which arrows do not meet."""
    ends: dict[str, list[complex]] = {}
    for (start, end), arrow in plan.arrows.items():
        if end not in plan.places:  # a free vector
            continue
        if (arrow.end, arrow.start) != (plan.places[start], plan.places[end]):  # drawn back to front, it meets them too
            ends.setdefault(start, []).append(arrow.start)
            ends.setdefault(end, []).append(arrow.end)
    for letter, spots in ends.items():
        if letter and max(abs(spot - plan.places[letter]) for spot in spots) > CLOSED:
            yield _of(plan, verdict.OPEN, letter)


class _Bearer(NamedTuple):
    """What bears a letter: an end of arrows at its place, or a vector that is lettered itself, all along."""

    name: str
    letter: str
    spots: Sequence[complex]

    def away(self, labels: Mapping[str, Sequence[Label]], letter: str) -> float:
        """Give how far a letter is from it, mm."""
        return distance(labels.get(letter, ()), self.spots)


def _detailed(leaf: Leaf, plan: DrawnPlan, name: str) -> Iterator[complex]:
    """Give where an arrow lies in the enlarged details of its polygon, by whose letters it is known too."""
    begun = f"detail-{plan.asked.plan.partition('-')[2]}-"
    for group in groups(leaf.groups):
        if group.data.get("name") == name and group.data.get("plan", "").startswith(begun):
            lines = (stroke for stroke in group.strokes if isinstance(stroke, Line))
            yield from (spot for line in lines for spot in along(line.start, line.end))


def _letters(leaf: Leaf, labels: Mapping[str, Sequence[Label]], plan: DrawnPlan) -> Iterator[Verdict]:
    """Name the letters that stand at the place of another, and those that are missing."""
    titles = {vector.end: vector.title for vector in plan.asked.vectors if not vector.start and vector.title}
    lost = {vector.end for vector in plan.lacking} - {end for _, end in plan.arrows}  # which need no letter
    places = ((letter, spot) for letter, spot in plan.places.items() if letter and letter not in lost)
    ends = [_Bearer(letter, spelled(titles.get(letter, letter)), [spot]) for letter, spot in places]
    drawn = (vector for vector in plan.asked.vectors if vector.letter and vector.letters in plan.arrows)
    free = ((vector, plan.arrows[vector.letters]) for vector in drawn)
    seen = ((vector, arrow) for vector, arrow in free if abs(arrow.vector) > 2 * SEEN)
    spots = ((vector, [arrow.start, *_detailed(leaf, plan, vector.end), *along(*arrow)]) for vector, arrow in seen)
    for bearers in (ends, [_Bearer(vector.name, spelled(vector.letter), where) for vector, where in spots]):
        for bearer in bearers:
            away = bearer.away(labels, bearer.letter)
            if away > CLOSED and any(_takes(labels, bearer, other) for other in bearers):
                yield _of(plan, verdict.SWAPPED, bearer.name, bearer.spots)
            elif away > NEAR:
                yield _of(plan, verdict.UNLETTERED, bearer.name, bearer.spots)


def _takes(labels: Mapping[str, Sequence[Label]], bearer: _Bearer, other: _Bearer) -> bool:
    """Tell whether two letters stand each close to what bears the other, and farther from its own."""
    crossed = other.away(labels, bearer.letter), bearer.away(labels, other.letter)
    kept = bearer.away(labels, bearer.letter), other.away(labels, other.letter)
    return max(crossed) <= NEAR and all(there + BESIDE < here for there, here in zip(crossed, kept, strict=True))


def _outside(leaf: Leaf, plan: DrawnPlan) -> Iterator[Verdict]:
    """Name the letters of arrows with an end off the paper; of one that is lettered itself its own."""
    off = dict[str, None]()
    for (start, end), arrow in plan.arrows.items():
        begun = start if end in plan.places else end
        ends = ((begun, arrow.start), (end, arrow.end))
        on = (0 <= spot.real <= leaf.width and 0 <= spot.imag <= leaf.height for _, spot in ends)
        off |= {letter: None for (letter, _), there in zip(ends, on, strict=True) if letter and not there}
    yield from (_of(plan, verdict.OUTSIDE, letter) for letter in off)


def _of(plan: DrawnPlan, kind: str, letter: str = "", spots: Sequence[complex] = ()) -> Verdict:
    places = spots or [spot for name, spot in plan.places.items() if name == letter]
    middle = (places[0] + places[-1]) / 2 if places else None
    return Verdict(*plan.asked.place, letter, kind, at=None if middle is None else (middle, middle))
