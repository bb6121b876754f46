"""Plans without marks: arrows that hang together, told by their letters, their heading and their shape (по буквам)."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, permutations
from typing import NamedTuple

from drawings.checks.letters import off
from drawings.eye.alike import folded
from drawings.grading.asked import PlanAsked
from drawings.grading.drawing_faults import scales_written
from drawings.grading.drawn_plan import Arrow, DrawnPlan
from drawings.grading.form_places import FormPlace, place_of
from drawings.grading.seeing.spelling import spelled
from drawings.grading.segments import JOINED, Segment
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Text
from plans.linkage.letters import POLES
from plans.words.words import languages, word, words

FAR = 25.0  # mm: a letter that is farther from a place does not name it
HEADING = 80.0  # mm: and a heading from its plan
FITS = 0.01  # share by which a plan of a fair hand may differ from the scale that it was drawn to
LEAST = 2  # letters that a figure has in common with a plan
ARROW, BACKWARD = 10.0, 0.9  # mm that an arrow between two letters is worth, and its share if it is drawn back to front
ROUNDS = 40  # of bringing letters elsewhere: a plan has some fifteen
_POSITION = re.compile(r"(?:position|положени\w+|pos\.?|пол\.?)\s*№?\s*(\d{1,4})", re.IGNORECASE)


class Likeness(NamedTuple):
    """How unlike a plan some arrows are: if another's place or heading is theirs, how much they lack, how ill they fit.

    A heading may be nearer to another's arrows than to its own: those that are left then have another's.
    """

    elsewhere: bool
    headed: bool
    lacks: int
    misfit: float


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
    asked: Sequence[PlanAsked], figures: Sequence[Figure], texts: Sequence[Text], places: Sequence[FormPlace] = ()
) -> Iterator[DrawnPlan]:
    """Find plans among figures: each is the one plan that its place, its letters, its heading or its shape say."""
    found = sorted(_candidates(asked, figures, texts, places), key=lambda one: one[0])
    taken, own = set[int](), dict[object, DrawnPlan]()
    for like, k, plan in found:
        beside = not like.headed or plan.asked.sheet in {one.asked.sheet for one in own.values()}
        if beside and k not in taken and plan.asked.place not in own:
            taken.add(k)
            own[plan.asked.place] = plan
    sheets = {plan.asked.sheet for plan in own.values() if _is_half(plan)}
    yield from (plan for plan in own.values() if not sheets or plan.asked.sheet in sheets)


def _is_half(plan: DrawnPlan) -> bool:
    """Tell whether half of a plan is there: a small figure beside it may bear some letters of another sheet's plan."""
    return 2 * len(plan.lacking) <= len(plan.asked.vectors)


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


def _candidates(
    asked: Sequence[PlanAsked], figures: Sequence[Figure], texts: Sequence[Text], places: Sequence[FormPlace]
) -> Iterator[tuple[Likeness, int, DrawnPlan]]:
    """Give what each figure may be, and how like that it is."""
    headings = {plan.plan: own_headings(plan, asked, texts) for plan in asked}
    for k, figure in enumerate(figures):
        there = place_of(figure.spots, places)
        for plan in asked:
            here = there if there is not None and there.plan == plan.place else None
            position = position_named(figure.away, headings[plan.plan])
            names = _named(plan, figure, texts)
            if len(names) < LEAST or POLES.get(plan.plan) not in names:
                continue
            drawn = _drawn(plan, figure, names, texts, here)
            headed = here is None and position not in (None, plan.position)
            yield Likeness(there != here, headed, len(plan.letters) - len(names), misfit(drawn)), k, drawn


def own_headings(plan: PlanAsked, asked: Sequence[PlanAsked], texts: Sequence[Text]) -> list[Text]:
    """Give texts without the headings of plans of another kind, which may be nearer to a figure than its own is."""
    others = {folded(heading) for one in asked if one.plan != plan.plan for heading in _headings(one)}
    return [text for text in texts if folded(text.plain) not in others]


def _headings(plan: PlanAsked) -> Iterator[str]:
    """Give how a plan with a pole is headed in each language."""
    for language in languages() if plan.plan in POLES else ():
        if f"sheet.{plan.plan}" in words(language):
            yield word(language, f"sheet.{plan.plan}", position=plan.position)


def position_named(away: Callable[[Text], float], texts: Sequence[Text]) -> int | None:
    """Give the position that the nearest heading names."""
    own = [(away(text), int(match[1])) for text in texts if (match := _POSITION.search(text.plain))]
    near = [one for one in own if one[0] <= HEADING]
    return min(near)[1] if near else None


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
    plan: PlanAsked, figure: Figure, names: Mapping[str, complex], texts: Sequence[Text], place: FormPlace | None
) -> DrawnPlan:
    """Give the plan that a figure is: its arrows between its letters, laid as its letters are upright."""
    lines = {(figure.nearest(one.start), figure.nearest(one.end)): one for one in reversed(figure.arrows)}
    ends, arrows = list(lines), {}
    for one in plan.vectors:
        wanted = names.get(one.start), names.get(one.end)
        line = lines.get(wanted) or lines.get(wanted[::-1])  # type: ignore[arg-type]
        if line is not None:
            arrows[one.letters] = Arrow(line.start, line.end)
    away = figure.away if place is None else place.away
    near = [(away(text), mu) for text, mu in scales_written(texts, plan)]
    bare = DrawnPlan(plan, arrows, 1.0, names, False)
    fits = [mu for _, mu in near if math.isclose(mu, bare.fitted, rel_tol=FITS)]  # a plan may be far from its heading
    scale = min(near)[1] if near and min(near)[0] <= HEADING else next(iter(fits), None)
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


def turn_of(own: Sequence[Text], away: Callable[[Text], float]) -> complex:
    """Give what lays a figure upright whose page is turned: as the nearest of its letters stands."""
    turn = min(own, key=away).rotation if own else 0.0
    return cmath.rect(1.0, -math.radians(turn))


def misfit(drawn: DrawnPlan) -> float:
    """Give by what share the vectors of a plan are out, each of its own size."""
    pairs = [(one.true, value) for one in drawn.asked.vectors if (value := drawn.value(one.letters)) is not None]
    size = sum(abs(true) for true, _ in pairs)
    return sum(abs(value - true) for true, value in pairs) / size if size else math.inf


def _distance(text: Text, spot: complex) -> float:
    return off(spot, bounds(text))
