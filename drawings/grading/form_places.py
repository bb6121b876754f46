"""Places of a form: which plan was to be drawn where, by the data of its poles and corners (места на бланке)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from drawings.checks.letters import off
from drawings.grading.drawing_faults import JOINED
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.marking import Place
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Circle, Group, Leaf, Line, Text
from drawings.paper.walk import groups
from drawings.reading.pathdata import number
from geometry.board import Mark
from plans.linkage.plan import POLES


def own_places(plans: Iterable[DrawnPlan]) -> dict[Mark, complex]:
    """Give where a student has the marks of the record, from the poles, true units."""
    found: dict[Mark, complex] = {}
    for plan in plans:
        for one in plan.asked.vectors:
            if one.found is not None and one.letter:
                value = plan.value(one.letters)
                found |= {} if value is None else {one.found.span.end: value}
            elif one.found is not None:
                found |= _of(plan, one.found.span.start, one.start)
                found |= _of(plan, one.found.span.end, one.end)
    return found


def scales_of(plan: DrawnPlan, beside: Iterable[DrawnPlan]) -> dict[str, float]:
    """Give the scales of a student's plans by their names and by their boards, whose coarsest counts; its own last."""
    found: dict[str, float] = {}
    for one in beside:
        board = one.asked.board or one.asked.plan
        found[board] = max(one.scale, found.get(board, 0.0))
    return found | {plan.asked.plan: plan.scale}


def left_out(plans: Iterable[DrawnPlan]) -> dict[Mark, complex]:
    """Give the free vectors that a student has left out: to him they are nothing."""
    own = ((plan, one) for plan in plans for one in plan.lacking)
    return {one.found.span.end: 0j for _, one in own if one.found is not None and one.letter}


def _of(plan: DrawnPlan, mark: Mark, letter: str) -> dict[Mark, complex]:
    """Give the place of a mark; the pole is where it is, and nothing is measured from anywhere else."""
    pole = POLES.get(plan.asked.plan, "")
    pole = pole if pole in plan.places else ""  # on the plan of positions no arrow goes from the datum
    place = plan.between(pole, letter)
    return {} if place is None or letter == pole else {mark: place}


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
        return 2 * sum(self.off(one) == 0 for one in spots) > len(spots)


def form_places(leaf: Leaf) -> tuple[FormPlace, ...]:
    """Give the places of a form; none of a sheet that is none."""
    return tuple(_places(leaf))


def place_of(spots: Sequence[complex], places: Sequence[FormPlace]) -> FormPlace | None:
    """Give the place in which arrows were drawn: at whose pole one ends, else within whose corners, or hard by them."""
    begun = [(min(abs(one - place.pole) for one in spots), place) for place in places if place.pole is not None]
    away, nearest = min(begun, key=lambda one: one[0], default=(JOINED + 1.0, None))
    if away <= JOINED:
        return nearest
    middle = sum(spots) / len(spots)
    beside = min(places, key=lambda one: (not one.holds(spots), one.off(middle)), default=None)
    return beside if beside is not None and (beside.holds(spots) or beside.off(middle) <= BESIDE) else None


def _places(leaf: Leaf) -> Iterator[FormPlace]:
    for group in groups(leaf.groups):
        lines = tuple(one for one in group.strokes if isinstance(one, Line))[:CORNERS]
        if group.data.get("kind") != KIND or not lines:
            continue
        left, low, right, high = bounds(Group(lines))
        poles = [one for one in groups(group.strokes) if one.data.get("kind") == "pole"]
        own = (poles[0] if poles else group).data
        plan = own.get("plan", ""), _position(own.get("position", ""))
        pole = next((one.centre for one in (poles[0].strokes if poles else ()) if isinstance(one, Circle)), None)
        scale = number(group.data.get("scale", "1"))
        yield FormPlace(plan, pole, complex(left, low), complex(right, high), scale)


def _position(text: str) -> int | None:
    return int(text) if text.isascii() and text.removeprefix("-").isdigit() else None
