"""The figures of a structure: its kinematic scheme, and one division with each group drawn apart (схемы структуры)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

from drawings.kinds.scheme import frame_number, link_numbers
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Spot, picture
from drawings.page.page import Drafting
from drawings.paper.strokes import NO_DATA, Group, Stroke, Text
from drawings.structure.links import ShownLinks
from drawings.structure.pairs import StructurePairs
from drawings.symbols.figure import Subject, around, heading, heading_width
from plans.model.structure import CONTACT

MARGINS = Margins(5.0, 6.0, 3.0)  # paper around a scheme for letters, stands and numbers, in sizes of letters
LETTERS = 14.0  # a scheme is drawn at least so many letters large
UNDER = 5.0  # sizes of letters from the lowest point of a group to its label
APART = 0.45  # of the mechanism's size: between two groups drawn apart


class StructureScheme(NamedTuple):
    """A scheme under its title: links in their places with stands, or parts of them drawn apart, each with its label.

    Of the one that is `stated` all points can be measured. Of one not to scale that is `said` under its title.
    """

    name: str
    title: str
    parts: tuple[tuple[str, ShownLinks], ...]
    under: str = ""
    further: str = ""
    stated: str = ""  # the point from which its points are measured
    weight: float = 1.0
    said: str = ""
    data: Mapping[str, str] = NO_DATA


def measure(shown: StructureScheme, drafting: Drafting) -> Picture:
    """Measure the room that a scheme needs."""
    hand = drafting.hand
    spots = [spot + shift for (_, part), shift in zip(shown.parts, shifts(shown), strict=True) for spot in part.points]
    title = max(heading_width(shown.title, hand), heading_width(shown.under, hand) * 0.8)
    below = UNDER * hand.letter if len(shown.parts) > 1 else 0.0
    margins = around(MARGINS, hand, below=below, above=hand.text * (1.6 if shown.further else 0.0))
    return picture(shown.name, spots, ("l", "m"), margins, title, LETTERS * hand.letter)


def shifts(shown: StructureScheme) -> list[complex]:
    """Give how far each part is moved, m: side by side, their lowest points on one level."""
    found, right = list[complex](), 0.0
    size = max(part.reach for _, part in shown.parts)
    for _, part in shown.parts:
        across, up = [spot.real for spot in part.points], [spot.imag for spot in part.points]
        found.append(complex(right - min(across), -min(up)) if len(shown.parts) > 1 else 0j)
        right += max(across) - min(across) + APART * size
    return found


def draw(shown: StructureScheme, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw a scheme in its spot: links with their pairs, letters of points, numbers of links in circles."""
    place, hand = room.place(*spot), drafting.hand
    scale = shown.said or drafting.scale(spot.scale)
    below = (shown.under, f"{shown.further};  {scale}") if shown.under else (scale, *filter(None, [shown.further]))
    head = heading(spot.box, shown.title, below[0], hand, *below[1:])
    moved = [place._replace(zero=place.zero - by) for by in shifts(shown)]
    pairs = [StructurePairs(part, there, hand) for (_, part), there in zip(shown.parts, moved, strict=True)]
    lines = (head, *(Group(tuple(_lines(one, shown))) for one in pairs), *_labels(shown, pairs, drafting))
    return LetteredFigure(shown.name, lines, partial(_letters, shown, pairs, drafting), data=shown.data)


def _lines(pairs: StructurePairs, shown: StructureScheme) -> Iterator[Stroke]:
    """Draw links and pairs of one part, from the thinnest lines to the symbols."""
    yield from pairs.guides()
    yield from (block for _, block in pairs.blocks)
    yield from pairs.bars()
    yield from pairs.corners()
    yield from pairs.contacts()
    if not shown.parts[0][0] or len(pairs.bones.links) == 1:  # a whole mechanism, or a primary link
        yield from pairs.grounds()
        yield from pairs.stands()
    if shown.stated:
        yield from pairs.marks(Subject(shown.name, "r", None), shown.stated)
    else:
        for name, value in pairs.named.items():
            yield from pairs.symbol(name, pairs.place.on(value))


def _labels(shown: StructureScheme, pairs: Sequence[StructurePairs], drafting: Drafting) -> Iterator[Stroke]:
    """Write under each part drawn apart what it is."""
    hand = drafting.hand
    for (label, _), one in zip(shown.parts, pairs, strict=True):
        if label:
            spots = [one.place.on(spot) for spot in one.bones.points]
            low = min(spot.imag for spot in spots) - UNDER * hand.letter
            middle = (min(spot.real for spot in spots) + max(spot.real for spot in spots)) / 2
            yield Text(complex(middle, low), label, hand.text, "middle", True)


def _letters(
    shown: StructureScheme, pairs: Sequence[StructurePairs], drafting: Drafting, labels: Labels
) -> Iterator[Stroke]:
    """Letter points and number links."""
    for one in pairs:
        yield from one.letters(one.named, labels)
        for joint in (joint for joint in one.bones.joints if joint.nature == CONTACT):
            yield labels.beside(one.place.on(joint.at), joint.letter, drafting.hand.letter, 1.0)
        yield from link_numbers(one, one.bones.links, labels, drafting.hand, pairs)
        if len(shown.parts) == 1:
            yield from frame_number(one, labels, drafting.hand)


def formula_of(text: str) -> str:
    """Write a formula of structure with lowered kinds and arrows.

    >>> formula_of("I(0,1) -> II3(2,3)")
    'I(0,1) → II_{3}(2,3)'
    """
    return re.sub(r"II([1-5])\(", r"II_{\1}(", text).replace(" -> ", " → ")
