"""The law of lettering: none is covered or crosses ink, nothing goes over the frame; Russian has decimal commas."""

from __future__ import annotations

import re
from collections.abc import Iterator

from drawings.checks.verify import obscured
from drawings.lettering.lettering import bounds
from drawings.paper.hand import Hand
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import flat, texts
from drawings.reading.sheet import SeenSheet
from tests.drawings.collisions import collisions
from tests.drawings.emptiness import STILL
from tests.drawings.held import seen

PEN = 0.5  # mm: the widest line
POINT = re.compile(r"(?<![\d.\w])\d+\.\d+(?![\d.]*\.\d)")  # a number with a decimal point
BLOCK = ("title-block", "extra-graphs", "sheet-numbers")  # whose designations have points
NAMES = re.compile(r"(ГОСТ|ISO|ИСО)[ \N{NO-BREAK SPACE}][\d.–-]+|\(\d+\.\d+[а-я]?\)|(рис|табл|G)\S* ?\d+\.\d+")
RUSSIAN, LATIN = re.compile("[а-яё]"), re.compile("[a-z]")


def breaches(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name lettering that nobody can read, or that has the decimal mark of another language."""
    found = seen(leaf).seen
    if isinstance(found, SeenSheet):
        yield from map(str, obscured(found))
    yield from collisions(leaf)
    for group in leaf.groups:
        for left, low, right, high in map(bounds, flat((group,) if group.name not in STILL else ())):
            if min(left - 20, min(low, leaf.width - right, leaf.height - high) - 5) < -PEN:
                yield f"{group.name} goes over the frame at {left:g}, {low:g}"
    if is_russian(leaf):
        yield from (f"{text.plain!r} has a decimal point" for text in _written(leaf) if has_point(text.plain))


def is_russian(leaf: Leaf) -> bool:
    """Tell whether most of the lettering of a sheet is Russian."""
    said = " ".join(text.plain for text in texts(leaf.groups))
    return len(RUSSIAN.findall(said)) > len(LATIN.findall(said))


def has_point(text: str) -> bool:
    """Tell whether a text has a number with a decimal point, outside designations of standards and equations."""
    return POINT.search(NAMES.sub("", text)) is not None


def _written(leaf: Leaf) -> Iterator[Text]:
    return (text for group in leaf.groups if group.name not in BLOCK for text in texts((group,)))
