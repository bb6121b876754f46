"""Plans on a form: arrows and points in the place of one are of it, each told by its letters (планы на бланке)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Final, NamedTuple

import numpy as np

from drawings.checks.hold import Label, along, distance, off
from drawings.grading.asked import PlanAsked, VectorAsked
from drawings.grading.curves.drawn_figure import foot
from drawings.grading.drawing_faults import scales_written
from drawings.grading.drawn_plan import Arrow, DrawnPlan, places_of
from drawings.grading.form_place import KIND, FormPlace, place_of
from drawings.grading.onlooker import JOINED, Segment, figures, spelled
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Box, Circle, Group, Leaf, Line, Polyline, Stroke, Text
from plans.linkage.plan import POLES
from plans.model.motion import POSITIONS

FAR = 25.0  # mm: a letter that is farther from an arrow does not name it
CLOSE = 8.0  # mm: nor one that is farther from a line without an arrowhead
HEADING = 80.0  # mm: and a scale from its plan
UNSURE = 8.0  # mm within which a letter is as near to another arrow: the one that is drawn less otherwise has it
ALIKE = 0.05  # of a vector: an arrow that bears no letter is the one that it is so near to
TOLD = 2  # vectors more that are right say that two letters stand in each other's place
BACKWARD = 4.0  # mm that an arrow is farther from the letters of its ends if it is drawn back to front
NONE: Final = 2 * FAR + UNSURE + BACKWARD  # mm: what an arrow costs that is not there


def redrawn(plan: DrawnPlan, lines: Sequence[Segment]) -> DrawnPlan:
    """Give a plan with arrows that were drawn anew between places of its letters, and so bear no data."""
    again = dict(plan.arrows)
    for vector in plan.asked.vectors:
        start, end = plan.places.get(vector.start), plan.places.get(vector.end)
        if vector.letters not in again and start is not None and end is not None:
            both = (line for line in lines if _joins(line, start, end) or _joins(line, end, start))
            again |= ((vector.letters, Arrow(line.start, line.end)) for line in both if line.headed)
    return replace(plan, arrows=again)


def _joins(line: Segment | Arrow, start: complex, end: complex) -> bool:
    return abs(line.start - start) <= JOINED and abs(line.end - end) <= JOINED


def plans_on_form(
    asked: Sequence[PlanAsked],
    lines: Sequence[Segment],
    texts: Sequence[Text],
    labels: Mapping[str, Sequence[Label]],
    places: Sequence[FormPlace],
) -> Iterator[DrawnPlan]:
    """Find plans by their places: all arrows that are drawn there are of the plan."""
    expected = {plan.place: plan for plan in asked if plan.lettered}
    taken: dict[FormPlace, list[Segment]] = {place: [] for place in places if place.plan in expected}
    for joined in figures(lines):
        here = place_of([spot for line in joined for spot in (line.start, line.end)], places)
        if here in taken:
            taken[here].extend(joined)
    bare = [line for line in lines if not line.headed]
    for here, arrows in taken.items():
        near, due, known = [line for line in bare if here.holds((line.start, line.end))], expected[here.plan], labels
        if here.pole is not None and any(abs(line.start - here.pole) <= JOINED for line in arrows):
            pole = POLES.get(due.plan, "")  # of which the form tells where it stands
            known = {**labels, spelled(pole): [Label(Text(here.pole, pole), here.pole)]}
        away, mu = min(((here.away(text), mu) for text, mu in scales_written(texts, due)), default=(math.inf, 0.0))
        drawn = _LetteredArrows(due, known, mu if away <= HEADING else None).drawn(arrows, near)
        if arrows or drawn.arrows:
            yield drawn


class _Match(NamedTuple):
    """An arrow that may be a vector's: how far its letters are from it, mm, and whether it is drawn back to front."""

    arrow: Segment
    away: float
    back: bool = False

    @property
    def laid(self) -> Arrow:
        """The arrow from its first letter to its second."""
        start, end, _ = self.arrow
        return Arrow(end, start) if self.back else Arrow(start, end)


Matches = dict[tuple[str, str], _Match]


class _LetteredArrows(NamedTuple):
    """What tells the arrows of a plan: its letters on the sheet, and its scale if one is written."""

    asked: PlanAsked
    labels: Mapping[str, Sequence[Label]]
    scale: float | None

    def drawn(self, arrows: Sequence[Segment], bare: Sequence[Segment]) -> DrawnPlan:
        """Give the plan that arrows are; lines without heads are what lacks, where they bear its letters."""
        named = self._exchanged(arrows)
        lines = [line for start, end, _ in bare for line in (Segment(start, end), Segment(end, start))]
        headless = self._matches([vector for vector in self._named if vector.letters not in named], lines, CLOSE)
        found = named | headless
        mu = self.scale or DrawnPlan(self.asked, _arrows(found), 1.0, {}, False).fitted
        found = self._replace(scale=mu)._left(found, arrows)
        drawn = _arrows(found)
        hung = {letters: match.laid for letters, match in found.items() if letters[0]}
        spots = places_of(hung)
        both = tuple(_both_ways([match.arrow for match in found.values()], drawn, arrows))
        bald = tuple(vector.name for vector in self.asked.vectors if vector.letters in headless)
        drawn |= self._shared(drawn, spots, mu)
        plain = not named and not headless
        return DrawnPlan(self.asked, drawn, mu, spots, self.scale is not None, True, both, bald, plain)

    @property
    def _named(self) -> list[VectorAsked]:
        return [vector for vector in self.asked.vectors if vector.corners or not vector.letter]

    def _exchanged(self, arrows: Sequence[Segment]) -> Matches:
        """Match arrows by their letters; where clearly more is right with two letters exchanged, these are."""
        found = self._matches(self._named, arrows)
        fits, best = self._right(found), found
        if self.scale is None or fits == len(self._named):
            return found
        lettered = ([vector.letter] if vector.letter else vector.letters for vector in self._named)
        letters = dict.fromkeys(spelled(letter) for bearers in lettered for letter in bearers)
        for first, second in combinations((letter for letter in letters if letter in self.labels), 2):
            swapped = {**self.labels, first: self.labels[second], second: self.labels[first]}
            other = self._replace(labels=swapped)._matches(self._named, arrows)
            if self._right(other) >= max(fits + TOLD, self._right(best) + 1):
                best = other
        return best

    def _right(self, found: Matches) -> int:
        named = {vector.letters: vector for vector in self._named}
        return sum(self._fits(named[letters], match.arrow) <= 1 for letters, match in found.items())

    def _fits(self, vector: VectorAsked, arrow: Segment) -> float:
        """Tell how far an arrow is from a vector, as a share of what it may be out and still be told by it."""
        scale = self.scale or math.nan
        off = abs((arrow.end - arrow.start) * scale - vector.true)
        return off / (ALIKE * abs(vector.true) + SEEN * scale)

    def _left(self, found: Matches, arrows: Sequence[Segment]) -> Matches:
        """Give arrows that bear no letters of their own to the vectors that they are, where these lack."""
        left = [arrow for arrow in arrows if not any(arrow is match.arrow for match in found.values())]
        for vector in self._named if found else ():
            fits = [(self._fits(vector, arrow), arrow) for arrow in left] if vector.letters not in found else []
            off, arrow = min(fits, key=lambda fit: fit[0], default=(math.inf, None))
            if arrow is not None and off <= 1:
                found = found | {vector.letters: _Match(arrow, off)}
                left = [other for other in left if other is not arrow]
        return found

    def _shared(
        self, drawn: Mapping[tuple[str, str], Arrow], spots: Mapping[str, complex], mu: float
    ) -> Iterator[tuple[tuple[str, str], Arrow]]:
        """Give arrows that nobody draws: one that lies on another, and between places that other arrows tell."""
        for vector in self._named:
            if vector.letters in drawn or not vector.start:
                continue
            twin = next((other for other in vector.twins(self.asked, mu) if other.letters in drawn), None)
            if twin is not None:
                yield vector.letters, drawn[twin.letters]
            elif vector.auxiliary and vector.start in spots and vector.end in spots:
                yield vector.letters, Arrow(spots[vector.start], spots[vector.end])

    def _matches(self, named: Sequence[VectorAsked], arrows: Sequence[Segment], reach: float = FAR) -> Matches:
        """Give the arrows by their letters: all letters together as close to their arrows as they can be.

        Where letters are as near to one arrow as to another, the one that is drawn rightly has it: nobody is marked
        down for a letter that can be read in two ways.
        """
        rows = [[self._match(vector, arrow, reach) for arrow in arrows] for vector in named]
        columns = paired([[match.away for match in row] + [NONE] * len(named) for row in rows])
        pairs = zip(named, rows, columns, strict=True)
        return {vector.letters: row[k] for vector, row, k in pairs if k < len(arrows) and row[k].away < NONE}

    def _match(self, asked: VectorAsked, arrow: Segment, reach: float) -> _Match:
        """Tell how far the letters of a vector are from an arrow, and farther where it is drawn otherwise."""
        off = abs(arrow.end - arrow.start - asked.true / self.scale) if self.scale else 0.0
        unsure = UNSURE * asked.auxiliary + min(off, UNSURE)
        if asked.letter:
            distances = (_distance(label.place, arrow) for label in self.labels.get(spelled(asked.letter), ()))
            away = min(distances, default=math.inf)
            return _Match(arrow, away + unsure if away <= reach else NONE)
        first, last = (self.labels.get(spelled(letter), ()) for letter in asked.letters)
        ahead = distance(first, [arrow.start]), distance(last, [arrow.end])
        behind = distance(first, [arrow.end]), distance(last, [arrow.start])
        back = sum(behind) + BACKWARD < sum(ahead)
        far = behind if back else ahead
        return _Match(arrow, sum(far) + back * BACKWARD + unsure if max(far) <= reach else NONE, back)


def _arrows(found: Matches) -> dict[tuple[str, str], Arrow]:
    return {letters: Arrow(match.arrow.start, match.arrow.end) for letters, match in found.items()}


def _both_ways(
    known: Sequence[Segment], drawn: Mapping[tuple[str, str], Arrow], arrows: Sequence[Segment]
) -> Iterator[str]:
    """Name the vectors beside whose arrows others go back, one of which cannot be meant."""
    left = [arrow for arrow in arrows if not any(arrow is other for other in known)]
    for letters, arrow in drawn.items():
        if abs(arrow.vector) > JOINED and any(_joins(other, arrow.end, arrow.start) for other in left):
            yield " ".join(filter(None, letters))


def _distance(box: Box, arrow: Segment) -> float:
    left, low, right, high = box
    corners = (complex(x, y) for x in (left, right) for y in (low, high))
    ends = min(off(spot, box) for spot in along(arrow.start, arrow.end))
    return min(ends, *(_from(corner, arrow) for corner in corners), _from(complex(left + right, low + high) / 2, arrow))


def _from(spot: complex, arrow: Segment) -> float:
    vector = arrow.end - arrow.start
    share = ((spot - arrow.start) * vector.conjugate()).real / abs(vector) ** 2 if vector else 0.0
    return abs(spot - arrow.start - vector * min(max(share, 0.0), 1.0)) if math.isfinite(share) else math.inf


def paired(costs: Sequence[Sequence[float]]) -> list[int]:
    """Give each row the column of its own that makes the sum of costs least; there are no fewer columns than rows.

    Rows are added one by one, each by the shortest path of exchanges with those before it (the Hungarian method).

    >>> paired([[1.0, 2.0, 9.0], [1.0, 5.0, 9.0]])
    [1, 0]
    """
    count = len(costs[0]) if costs else 0
    table, rows, columns = np.array(costs), np.zeros(len(costs)), np.zeros(count + 1)
    owner = np.full(count + 1, -1)  # the row that has a column; the last column is that of the row which is added
    for row in range(len(costs)):
        least, before, used, here = np.full(count, np.inf), np.zeros(count, int), np.zeros(count + 1, bool), count
        owner[here] = row
        while owner[here] >= 0:
            used[here] = True
            cost = table[owner[here]] - rows[owner[here]] - columns[:count]
            nearer = ~used[:count] & (cost < least)
            least[nearer], before[nearer] = cost[nearer], here
            there = int(np.where(used[:count], np.inf, least).argmin())
            step = least[there]
            rows[owner[used]] += step
            columns[used] -= step
            least[~used[:count]] -= step
            here = there
        while here != count:
            owner[here], here = owner[before[here]], int(before[here])
    return np.argsort(owner[:count])[count - len(costs) :].tolist() if costs else []


LETTERED = 25.0  # mm: a letter that is farther from a point does not name it
BESIDE = 8.0  # mm: nor one that is farther from a place on a line where nothing marks it


def points_on_form(
    plan: PlanAsked, place: FormPlace, leaf: Leaf, labels: Mapping[str, Sequence[Label]]
) -> DrawnPlan | None:
    """Give the points that are drawn in a place, where strokes end or go by; None of none, or of a few of a view."""
    strokes = [stroke for stroke in _drawn(leaf.groups) if any(place.off(spot) == 0 for spot in _ends(stroke))]
    spots = [spot for stroke in strokes for spot in _ends(stroke)]
    datum, found = (place.pole or 0j) - place.value / place.scale, dict[str, complex]()
    for vector in plan.vectors:
        letter = spelled(vector.title or vector.end)  # alone, or with the number of the position
        named = [label for name in (letter, f"{letter}{plan.position}") for label in labels.get(name, ())]
        at = _at(datum + vector.true / place.scale, spots, strokes, named)
        found |= {} if at is None else {vector.end: at}
    arrows = {("", name): Arrow(datum, spot) for name, spot in found.items()}
    some = len(arrows) >= (1 if plan.plan == POSITIONS.plan else len(plan.vectors) / 2)
    return DrawnPlan(plan, arrows, place.scale, places_of(arrows), lettered=True) if some else None


def _drawn(strokes: Sequence[Stroke]) -> Iterator[Stroke]:
    """Give the strokes that are no part of the form's own places and axes."""
    for stroke in strokes:
        if not isinstance(stroke, Group):
            yield stroke
        elif stroke.data.get("kind") not in (KIND, "axes"):
            yield from _drawn(stroke.strokes)


def _ends(stroke: Stroke) -> Sequence[complex]:
    match stroke:
        case Line():
            return stroke.start, stroke.end
        case Polyline():
            return stroke.points
        case Circle():
            return (stroke.centre,)
    return ()


def _at(due: complex, spots: Sequence[complex], strokes: Sequence[Stroke], labels: Sequence[Label]) -> complex | None:
    """Give where a point is: at what is marked where it is due, by its letter on a line, else nearest to its letter."""
    nearest = min(spots, key=lambda spot: abs(spot - due), default=due + 2 * JOINED)
    if abs(nearest - due) <= JOINED:
        return nearest
    feet = (foot((np.array([line.start, line.end]),), due) for line in strokes if isinstance(line, Line))
    near = min(feet, key=lambda at: abs(at - due), default=nearest)
    if abs(near - due) <= JOINED and distance(labels, [due]) <= BESIDE:
        return near
    lettered = min(spots, key=lambda spot: distance(labels, [spot]), default=None)
    return lettered if lettered is not None and distance(labels, [lettered]) <= LETTERED else None
