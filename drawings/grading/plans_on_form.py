"""Plans on a form: the arrows in the place of one are of it, each told by its letters (планы на бланке)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Final, NamedTuple

from drawings.checks.hold import Label, along, distance, off
from drawings.grading.asked import Place, PlanAsked, VectorAsked
from drawings.grading.drawing_faults import scales_written
from drawings.grading.drawn_plan import Arrow, DrawnPlan, places_of
from drawings.grading.onlooker import JOINED, Segment, spelled
from drawings.lettering.lettering import bounds
from drawings.paper.strokes import Box, Circle, Group, Leaf, Line, Text
from drawings.paper.walk import groups
from drawings.reading.pathdata import number

FAR = 25.0  # mm: a letter that is farther from an arrow does not name it
HEADING = 80.0  # mm: and a scale from its plan
LEAST = 2  # arrows of a polygon that is taken for one, and half of them
UNSURE, SHARE = 8.0, 0.2  # mm within which a letter is as near to another arrow; how far out one is drawn otherwise
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
    figures: Sequence[Sequence[Segment]],
    texts: Sequence[Text],
    labels: Mapping[str, Sequence[Label]],
    places: Sequence[FormPlace],
    turn: complex = 1 + 0j,
) -> Iterator[DrawnPlan]:
    """Find plans by their places: all arrows that are drawn there are of the plan, laid upright by a `turn`."""
    expected = {plan.place: plan for plan in asked if plan.lettered}
    taken: dict[FormPlace, list[Segment]] = {}
    for joined in figures:
        here = place_of([spot for line in joined for spot in (line.start, line.end)], places)
        if here is not None and here.plan in expected:
            taken.setdefault(here, []).extend(joined)
    for here, arrows in taken.items():
        plan = expected[here.plan]
        drawn = _drawn(plan, arrows, texts, labels, here, turn)
        free = all(vector.letter for vector in plan.vectors)
        if len(drawn.arrows) >= (max(LEAST, len(plan.vectors) / 2) if free else 1):
            yield drawn


def _drawn(
    plan: PlanAsked,
    arrows: Sequence[Segment],
    texts: Sequence[Text],
    labels: Mapping[str, Sequence[Label]],
    place: FormPlace,
    turn: complex,
) -> DrawnPlan:
    """Give the plan that arrows are."""
    scale = scale_at(place, texts, plan)
    found = _matches(plan, arrows, labels, (scale or 0.0) * turn)
    drawn = {letters: Arrow(match.arrow.start, match.arrow.end) for letters, match in found.items()}
    hung = {letters: match.laid for letters, match in found.items() if letters[0]}
    bare = DrawnPlan(plan, drawn, 1.0, {}, False)
    both = tuple(_both_ways([match.arrow for match in found.values()], drawn, arrows))
    mu, spots = scale or bare.fitted, places_of(hung)
    return DrawnPlan(plan, drawn, mu, spots, scale is not None, turn, lettered=True, doubled=both)


def _both_ways(
    known: Sequence[Segment], drawn: Mapping[tuple[str, str], Arrow], arrows: Sequence[Segment]
) -> Iterator[str]:
    """Name the vectors beside whose arrows others go back, one of which cannot be meant."""
    left = [arrow for arrow in arrows if not any(arrow is other for other in known)]
    for letters, arrow in drawn.items():
        if abs(arrow.vector) > JOINED and any(_joins(other, arrow.end, arrow.start) for other in left):
            yield " ".join(filter(None, letters))


class _Match(NamedTuple):
    """An arrow that may be a vector's: how far its letters are from it, mm, and whether it is drawn back to front."""

    arrow: Segment
    away: float
    back: bool

    @property
    def laid(self) -> Arrow:
        """The arrow from its first letter to its second."""
        start, end, _ = self.arrow
        return Arrow(end, start) if self.back else Arrow(start, end)


def _matches(
    plan: PlanAsked, arrows: Sequence[Segment], labels: Mapping[str, Sequence[Label]], scale: complex
) -> dict[tuple[str, str], _Match]:
    """Give the arrows by their letters: all letters together as close to their arrows as they can be.

    Where letters are as near to one arrow as to another, the one that is drawn rightly has it: nobody is marked down
    for a letter that can be read in two ways.
    """
    named = [vector for vector in plan.vectors if vector.corners or not vector.letter]
    rows = [[_match(vector, arrow, labels, scale) for arrow in arrows] for vector in named]
    columns = paired([[match.away for match in row] + [NONE] * len(named) for row in rows])
    pairs = zip(named, rows, columns, strict=True)
    return {vector.letters: row[k] for vector, row, k in pairs if k < len(arrows) and row[k].away < NONE}


def _match(asked: VectorAsked, arrow: Segment, labels: Mapping[str, Sequence[Label]], scale: complex) -> _Match:
    """Tell how far the letters of a vector are from an arrow, and farther where it is drawn otherwise."""
    unsure = UNSURE if scale and abs((arrow.end - arrow.start) * scale - asked.true) > SHARE * abs(asked.true) else 0.0
    if asked.letter:
        distances = (_distance(label.place, arrow) for label in labels.get(spelled(asked.letter), ()))
        away = min(distances, default=math.inf)
        return _Match(arrow, away + unsure if away <= FAR else NONE, False)
    first, last = (labels.get(spelled(letter), ()) for letter in asked.letters)
    ahead = distance(first, [arrow.start]), distance(last, [arrow.end])
    behind = distance(first, [arrow.end]), distance(last, [arrow.start])
    back = sum(behind) + BACKWARD < sum(ahead)
    far = behind if back else ahead
    return _Match(arrow, sum(far) + back * BACKWARD + unsure if max(far) <= FAR else NONE, back)


def scale_at(place: FormPlace, texts: Sequence[Text], plan: PlanAsked) -> float | None:
    """Give the scale that is written nearest to the place of a plan, true units a mm; None where none is near."""
    near = min(((place.away(text), mu) for text, mu in scales_written(texts, plan)), default=(math.inf, 0.0))
    return near[1] if near[0] <= HEADING else None


def _distance(box: Box, arrow: Segment) -> float:
    """Give how far a box is from an arrow, mm."""
    left, low, right, high = box
    corners = (complex(x, y) for x in (left, right) for y in (low, high))
    ends = min(off(spot, box) for spot in along(arrow.start, arrow.end))
    return min(ends, *(_from(corner, arrow) for corner in corners), _from(complex(left + right, low + high) / 2, arrow))


def _from(spot: complex, arrow: Segment) -> float:
    """Give how far a place is from an arrow, mm."""
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
    rows, columns = [0.0] * (len(costs) + 1), [0.0] * (count + 1)
    owner = [0] * (count + 1)  # by columns, from 1 on: the row that has it
    for row in range(1, len(costs) + 1):
        _exchange(costs, row, (rows, columns), owner)
    found = [0] * len(costs)
    for column, row in enumerate(owner[1:]):
        if row:
            found[row - 1] = column
    return found


def _exchange(
    costs: Sequence[Sequence[float]], row: int, prices: tuple[list[float], list[float]], owner: list[int]
) -> None:
    """Give a row its column, and those whose columns it takes others."""
    rows, columns = prices
    least, before = [math.inf] * len(columns), [0] * len(columns)
    used, here = set[int](), 0
    owner[0] = row
    while owner[here]:
        used.add(here)
        owning = owner[here]
        free = [k for k in range(1, len(columns)) if k not in used]
        for k in free:
            cost = costs[owning - 1][k - 1] - rows[owning] - columns[k]
            if cost < least[k]:
                least[k], before[k] = cost, here
        there = min(free, key=lambda k: least[k])
        step = least[there]
        for k in used:
            rows[owner[k]] += step
            columns[k] -= step
        for k in free:
            least[k] -= step
        here = there
    while here:
        owner[here] = owner[before[here]]
        here = before[here]


KIND = "place"  # of the data of a group that is the place of a figure
BESIDE = 25.0  # mm: arrows that lie farther from a place are not of it
CORNERS = 8  # lines, two to a corner, with which such a group begins


class FormPlace(NamedTuple):
    """The place of a plan on a form: its pole, if it has one, and its corners, mm; its scale, true units a mm."""

    plan: Place
    pole: complex | None
    low: complex
    high: complex
    scale: float = 1.0

    def away(self, text: Text) -> float:
        """Give how far a text is from the middle of its upper edge, over which its heading stands; none within it."""
        left, low, right, high = box = bounds(text)
        within = self.holds([complex(left + right, low + high) / 2])
        return 0.0 if within else off(complex((self.low.real + self.high.real) / 2, self.high.imag), box)

    def off(self, spot: complex) -> float:
        """Give how far a spot is from the place, mm; none within it."""
        return off(spot, (self.low.real, self.low.imag, self.high.real, self.high.imag))

    def holds(self, spots: Sequence[complex]) -> bool:
        """Tell whether most of some spots lie within its corners."""
        return 2 * sum(self.off(spot) == 0 for spot in spots) > len(spots)


def form_places(leaf: Leaf) -> tuple[FormPlace, ...]:
    """Give the places of a form; none of a sheet that is none."""
    return tuple(_places(leaf))


def place_of(spots: Sequence[complex], places: Sequence[FormPlace]) -> FormPlace | None:
    """Give the place in which arrows were drawn: at whose pole one ends, else within whose corners, or hard by them."""
    begun = [(min(abs(spot - place.pole) for spot in spots), place) for place in places if place.pole is not None]
    away, nearest = min(begun, key=lambda row: row[0], default=(JOINED + 1.0, None))
    if away <= JOINED:
        return nearest
    middle = sum(spots) / len(spots)
    beside = min(places, key=lambda place: (not place.holds(spots), place.off(middle)), default=None)
    return beside if beside is not None and (beside.holds(spots) or beside.off(middle) <= BESIDE) else None


def _places(leaf: Leaf) -> Iterator[FormPlace]:
    for group in groups(leaf.groups):
        lines = tuple(stroke for stroke in group.strokes if isinstance(stroke, Line))[:CORNERS]
        if group.data.get("kind") != KIND or not lines:
            continue
        left, low, right, high = bounds(Group(lines))
        poles = [mark for mark in groups(group.strokes) if mark.data.get("kind") == "pole"]
        data = (poles[0] if poles else group).data
        plan = data.get("plan", ""), _position(data.get("position", ""))
        pole = next(
            (stroke.centre for stroke in (poles[0].strokes if poles else ()) if isinstance(stroke, Circle)), None
        )
        scale = number(group.data.get("scale", "1"))
        yield FormPlace(plan, pole, complex(left, low), complex(right, high), scale)


def _position(text: str) -> int | None:
    return int(text) if text.isascii() and text.removeprefix("-").isdigit() else None
