"""Special points of triads on the plan of positions: the lines of two leads prolonged to their meeting (M3.10)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.lettering.words import with_index
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Line, Stroke
from drawings.symbols.figure import Subject, point
from geometry.board import at
from plans.model.triad import Triad

RADIUS = 0.6  # mm: of the mark, in sizes of symbols


class SpecialMark(NamedTuple):
    """A special point in the position in full lines, m, and the leads' points on the lines that meet in it."""

    name: str
    value: complex
    contacts: tuple[complex, ...]


def special_marks(bones: Skeletons) -> Iterator[SpecialMark]:
    """Give the special points that lie within the figure: one of leads all but parallel is far away."""
    plan, known = bones.study.drafts().positions, bones.points
    across, up = [spot.real for spot in known], [spot.imag for spot in known]
    for triad in (group for group in bones.study.groups if isinstance(group, Triad)):
        letters = plan.written.specials.get(triad.basis)
        if letters is None or letters.name not in plan.board:
            continue
        value = at(plan.board[letters.name].point, bones.shown)
        inside = min(across) <= value.real <= max(across) and min(up) <= value.imag <= max(up)
        if inside and not math.isnan(value.real):
            pair = (lead for k, lead in enumerate(triad.leads) if k != letters.out)
            yield SpecialMark(letters.name, value, tuple(at(plan.point(lead.pin).point, bones.shown) for lead in pair))


def special_lines(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Prolong the lines of the leads to the special point."""
    marks = special_marks(bones)
    return [Line(place.on(start), place.on(mark.value), hand.drafted) for mark in marks for start in mark.contacts]


def special_spots(bones: Skeletons, subject: Subject, place: Place, hand: Hand) -> Iterator[Group]:
    """Mark the special points."""
    for mark in special_marks(bones):
        dot = Circle(place.on(mark.value), RADIUS * hand.symbol, hand.drafted)
        yield point(subject, mark.name, mark.value, place, dot)


def special_letters(pairs: Pairs, labels: Labels) -> tuple[Group, ...]:
    """Letter the special points."""
    size, gap = pairs.sheet.letter, 2 * RADIUS * pairs.hand.symbol
    marks = special_marks(pairs.bones)
    strokes = [labels.beside(pairs.place.on(mark.value), with_index(mark.name), size, gap) for mark in marks]
    return (Group(tuple(strokes)),) if strokes else ()
