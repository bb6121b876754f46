"""Special points of triads on the plan of positions: the lines of two leads prolonged to their meeting (M3.10)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.lettering.words import with_index
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Line, Stroke
from drawings.symbols.figure import Subject, point

RADIUS = 0.6  # mm: of the mark, in sizes of symbols


def special_lines(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Prolong the lines of the leads to the special point."""
    marks = bones.specials
    return [Line(place.on(start), place.on(mark.value), hand.drafted) for mark in marks for start in mark.contacts]


def special_spots(bones: Skeletons, subject: Subject, place: Place, hand: Hand) -> Iterator[Group]:
    """Mark the special points."""
    for mark in bones.specials:
        dot = Circle(place.on(mark.value), RADIUS * hand.symbol, hand.drafted)
        yield point(subject, mark.name, mark.value, place, dot)


def special_letters(pairs: Pairs, labels: Labels) -> tuple[Group, ...]:
    """Letter the special points."""
    size, gap = pairs.sheet.letter, 2 * RADIUS * pairs.hand.symbol
    marks = pairs.bones.specials
    strokes = [labels.beside(pairs.place.on(mark.value), with_index(mark.name), size, gap) for mark in marks]
    return (Group(tuple(strokes)),) if strokes else ()
