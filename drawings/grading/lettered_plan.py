"""Plans on a form: arrows that hang together are the plan of their place, each told by its letters (план на бланке)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, permutations
from typing import NamedTuple

from drawings.checks.letters import off
from drawings.grading.asked import PlanAsked
from drawings.grading.drawing_faults import JOINED, Segment, scales_written
from drawings.grading.drawn_plan import Arrow, DrawnPlan
from drawings.grading.form_places import FormPlace, place_of
from drawings.grading.marking import Place
from drawings.grading.seeing.onlooker import spelled
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Text
from plans.linkage.letters import POLES

FAR = 25.0  # mm: a letter that is farther from a place does not name it
HEADING = 80.0  # mm: and a scale from its plan
LEAST = 2  # letters that a figure has in common with a plan
ARROW, BACKWARD = 10.0, 0.9  # mm that an arrow between two letters is worth, and its share if it is drawn back to front
ROUNDS = 40  # of bringing letters elsewhere: a plan has some fifteen


class Figure(NamedTuple):
    """Arrows that hang together, and the place of each of their ends."""

    arrows: Sequence[Segment]
    spots: Sequence[complex]

    def nearest(self, spot: complex) -> complex:
        """Give the place of an end."""
        return min(self.spots, key=lambda one: abs(one - spot))

    def away(self, text: Text) -> float:
        """Give how far a text is from the figure, mm."""
        return min(_distance(text, spot) for spot in self.spots)


def figure_of(own: Sequence[Segment]) -> Figure:
    """Give arrows with their places: ends that are near each other are one."""
    spots: list[complex] = []
    for end in (end for one in own for end in (one.start, one.end)):
        if all(abs(end - spot) > JOINED for spot in spots):
            spots.append(end)
    return Figure(own, spots)


def lettered_plans(
    asked: Sequence[PlanAsked], figures: Sequence[Figure], texts: Sequence[Text], places: Sequence[FormPlace]
) -> list[DrawnPlan]:
    """Find plans among figures, each by the place of the form that it was drawn in; the fullest of one counts."""
    due, found = {plan.place: plan for plan in asked}, dict[Place, DrawnPlan]()
    for figure in figures:
        here = place_of(figure.spots, places)
        plan = None if here is None else due.get(here.plan)
        names = {} if plan is None else _named(plan, figure, texts)
        if here is not None and plan is not None and len(names) >= LEAST and POLES.get(plan.plan) in names:
            drawn = _drawn(plan, figure, names, texts, here)
            found[plan.place] = min(found.get(plan.place, drawn), drawn, key=lambda one: len(one.lacking))
    return list(found.values())


def redrawn(plan: DrawnPlan, lines: Sequence[Segment]) -> DrawnPlan:
    """Give a plan with arrows that were drawn anew between places of its letters, and so bear no data."""
    again = dict(plan.arrows)
    for one in plan.asked.vectors:
        ends = plan.places.get(one.start), plan.places.get(one.end)
        if one.letters in again or ends[0] is None or ends[1] is None:
            continue
        for line in (line for line in lines if line.headed):
            if _joins(line, ends[0], ends[1]) or _joins(line, ends[1], ends[0]):
                again[one.letters] = Arrow(line.start, line.end)
    return replace(plan, arrows=again)


def _joins(line: Segment, start: complex, end: complex) -> bool:
    return abs(line.start - start) <= JOINED and abs(line.end - end) <= JOINED


def _named(plan: PlanAsked, figure: Figure, texts: Sequence[Text]) -> dict[str, complex]:
    """Give the places of the letters of a plan: the nearest pairs first, then as the arrows between them tell."""
    letters = {spelled(letter): letter for letter in plan.letters}
    near: dict[tuple[str, complex], float] = {}
    beside: dict[str, str] = {}  # letters that stand after another, at the same place
    for text in texts:
        first, *others = [letters.get(name, "") for name in map(spelled, text.plain.split(", "))]
        if not first or not all(others):
            continue
        for spot in figure.spots:
            away = _distance(text, spot)
            if away <= min(FAR, near.get((first, spot), FAR)):
                near[first, spot] = away
                beside |= dict.fromkeys(others, first)
    near = {pair: away for pair, away in near.items() if pair[0] not in beside}
    found: dict[str, complex] = {}
    for letter, spot in sorted(near, key=lambda pair: near[pair]):
        if letter not in found and spot not in found.values():
            found[letter] = spot
    found = _settled(plan, figure, near, found)
    return found | {letter: found[first] for letter, first in beside.items() if first in found}


def _close(plan: PlanAsked, found: Mapping[str, complex]) -> frozenset[tuple[str, str]]:
    """Give the pairs of letters that lie at one place of the plan as it is to be: no farther apart than ends may be."""
    there = true_places(plan)
    known = combinations((letter for letter in found if letter in there), 2)
    true, paper = max(((abs(there[a] - there[b]), abs(found[a] - found[b])) for a, b in known), default=(0.0, 0.0))
    pairs = permutations(there, 2)
    return frozenset((a, b) for a, b in pairs if abs(there[a] - there[b]) * paper <= JOINED * true)


def true_places(plan: PlanAsked) -> dict[str, complex]:
    """Give where the letters of a plan lie from the first of them, as its vectors lead from one to the next."""
    found: dict[str, complex] = {}
    for _ in plan.vectors:
        for one in plan.vectors:
            start, end = found.setdefault(one.start, 0j) if not found else found.get(one.start), found.get(one.end)
            if start is not None and end is None:
                found[one.end] = start + one.true
            elif end is not None and start is None:
                found[one.start] = end - one.true
    return found


def _settled(
    plan: PlanAsked, figure: Figure, near: Mapping[tuple[str, complex], float], first: dict[str, complex]
) -> dict[str, complex]:
    """Move letters among the places that they are near to, while more of the arrows that are asked for are there.

    The arrows that there are decide, not where they lead: a wrong plan bears its letters as a right one does.
    """
    ends = {(figure.nearest(one.start), figure.nearest(one.end)) for one in figure.arrows}

    def worth(names: Mapping[str, complex]) -> float:
        pairs = [(names.get(one.start), names.get(one.end)) for one in plan.vectors]
        arrows = sum(1.0 if pair in ends else BACKWARD * (pair[::-1] in ends) for pair in pairs)
        return arrows * ARROW - sum(near[pair] for pair in names.items())

    best, most, close = first, worth(first), _close(plan, first)
    for _ in range(ROUNDS):
        better = max(_others(best, near, close), key=worth, default=best)
        if worth(better) <= most:
            return best
        best, most = better, worth(better)
    return best


def _others(
    names: Mapping[str, complex], near: Mapping[tuple[str, complex], float], close: Collection[tuple[str, str]]
) -> Iterator[dict[str, complex]]:
    """Give what is had by bringing one letter to another place that it is near to, whose letter takes its own.

    Letters that belong to one place may share it.
    """
    there = {spot: letter for letter, spot in names.items()}
    for letter, spot in near:
        if names.get(letter) == spot:
            continue
        moved, other = {**names, letter: spot}, there.get(spot)
        if other is not None:
            if (letter, other) in close:
                yield dict(moved)
            moved.pop(other)
            if letter in names and (other, names[letter]) in near:
                moved[other] = names[letter]
        yield moved


def _drawn(
    plan: PlanAsked, figure: Figure, names: Mapping[str, complex], texts: Sequence[Text], place: FormPlace
) -> DrawnPlan:
    """Give the plan that a figure is: its arrows between its letters, laid as its letters are upright."""
    lines = {(figure.nearest(one.start), figure.nearest(one.end)): one for one in reversed(figure.arrows)}
    ends, arrows = list(lines), {}
    for one in plan.vectors:
        wanted = names.get(one.start), names.get(one.end)
        line = lines.get(wanted) or lines.get(wanted[::-1])  # type: ignore[arg-type]
        if line is not None:
            arrows[one.letters] = Arrow(line.start, line.end)
    scale = scale_at(place, texts, plan)
    bare = DrawnPlan(plan, arrows, 1.0, names, False)
    own = {spelled(letter) for letter in plan.letters}
    turn = turn_of([text for text in texts if spelled(text.plain) in own], figure.away)
    both = tuple(f"{start} {end}" for start, end in arrows if _is_doubled(plan, (start, end), names, ends))
    return DrawnPlan(plan, arrows, scale or bare.fitted, names, scale is not None, turn, lettered=True, doubled=both)


def _is_doubled(
    plan: PlanAsked,
    letters: tuple[str, str],
    names: Mapping[str, complex],
    ends: Sequence[tuple[complex, complex]],
) -> bool:
    """Tell whether arrows go both ways between two letters, one of which cannot be meant."""
    there = names[letters[0]], names[letters[1]]
    meant = any(one.letters == letters[::-1] for one in plan.vectors)
    return not meant and there[0] != there[1] and there in ends and there[::-1] in ends


def scale_at(place: FormPlace, texts: Sequence[Text], plan: PlanAsked) -> float | None:
    """Give the scale that is written nearest to the place of a plan, true units a mm; None where none is near."""
    near = min(((place.away(text), mu) for text, mu in scales_written(texts, plan)), default=(math.inf, 0.0))
    return near[1] if near[0] <= HEADING else None


def turn_of(own: Sequence[Text], away: Callable[[Text], float]) -> complex:
    """Give what lays a figure upright whose page is turned: as the nearest of its letters stands."""
    turn = min(own, key=away).rotation if own else 0.0
    return cmath.rect(1.0, -math.radians(turn))


def _distance(text: Text, spot: complex) -> float:
    return off(spot, bounds(text))
