"""Matching: which strokes of a sheet are those that must be there, and which are left on either side (сличение)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator, Sequence
from itertools import product
from typing import NamedTuple

from drawings.collation.items import Ink, Item, spots
from drawings.paper.strokes import Arc, Circle, Line, LineStyle, Polyline, Text

WIDTH = 1e-3  # mm: far under the steps of the widths that a pen has, and over what an editor rounds of them


class Matching(NamedTuple):
    """What is there as it must be, in pairs; what is left of what must be there, and of what is there."""

    same: tuple[tuple[Item, Item], ...]
    missing: tuple[Item, ...]
    added: tuple[Item, ...]
    copies: tuple[Item, ...] = ()  # of what is there as it must be, once more


def match(right: Sequence[Item], there: Sequence[Item], rounding: float) -> Matching:
    """Match strokes that lie within the rounding (mm) of each other and look alike; each is matched once."""
    cells: dict[Hashable, list[int]] = defaultdict(list)
    for place, item in enumerate(there):
        cells[_cell(item.stroke, rounding)].append(place)
    taken: dict[int, Item] = {}
    missing = list(right)
    for own in (True, False):  # two marks may lie on one place: each stroke has that of its own mark first
        left: list[Item] = []
        for item in missing:
            near = (one for one in _near(item.stroke, cells, rounding) if one not in taken)
            near = (one for one in near if not own or there[one].home.mark == item.home.mark)
            fitting = next((one for one in near if same(item.stroke, there[one].stroke, rounding)), None)
            if fitting is None:
                left.append(item)
            else:
                taken[fitting] = item
        missing = left
    pairs = tuple((item, there[place]) for place, item in taken.items())
    others = [item for place, item in enumerate(there) if place not in taken]
    return Matching(pairs, tuple(missing), *_added(right, others, rounding))


def _added(right: Sequence[Item], left: Iterable[Item], rounding: float) -> tuple[tuple[Item, ...], tuple[Item, ...]]:
    """Tell what is added from copies of what must be there."""
    cells: dict[Hashable, list[int]] = defaultdict(list)
    for place, item in enumerate(right):
        cells[_cell(item.stroke, rounding)].append(place)
    added: list[Item] = []
    copies: list[Item] = []
    for item in left:
        own = any(same(right[one].stroke, item.stroke, rounding) for one in _near(item.stroke, cells, rounding))
        (copies if own else added).append(item)
    return tuple(added), tuple(copies)


def _cell(stroke: Ink, rounding: float) -> tuple[str, int, int]:
    """Give the square of the paper where a stroke begins; its side is twice the rounding."""
    first = spots(stroke)[0]
    return type(stroke).__name__, round(first.real / (2 * rounding)), round(first.imag / (2 * rounding))


def _near(stroke: Ink, cells: dict[Hashable, list[int]], rounding: float) -> Iterator[int]:
    """Give what begins in the same square or one beside it, the same square first."""
    kind, across, up = _cell(stroke, rounding)
    for right, high in product((0, -1, 1), repeat=2):
        yield from cells.get((kind, across + right, up + high), ())


def same(right: Ink, there: Ink, rounding: float) -> bool:
    """Tell whether two strokes are one and the same to the eye."""
    return alike(right, there) and lies(right, there, rounding)


def lies(right: Ink, there: Ink, rounding: float) -> bool:
    """Tell whether two strokes of one kind lie within a rounding of each other, mm."""
    ours, theirs = spots(right), spots(there)
    if isinstance(right, Circle) and isinstance(there, Circle) and not abs(right.radius - there.radius) <= rounding:
        return False
    return len(ours) == len(theirs) and all(abs(a - b) <= rounding for a, b in zip(ours, theirs, strict=True))


def alike(right: Ink, there: Ink) -> bool:
    """Tell whether two strokes look alike, wherever they lie."""
    if type(right) is not type(there) or not alike_in_style(right.style, there.style):
        return False
    if isinstance(right, Text) and isinstance(there, Text):
        return right.runs == there.runs and right.slanted == there.slanted
    return not isinstance(right, Polyline) or not isinstance(there, Polyline) or right.closed == there.closed


def alike_in_style(right: LineStyle, there: LineStyle) -> bool:
    """Tell whether two lines are drawn in one pen: width, dashes, colour, filling, ends."""
    dashes = len(right.dash) == len(there.dash) and all(
        abs(a - b) <= WIDTH for a, b in zip(right.dash, there.dash, strict=True)
    )
    return dashes and abs(right.width - there.width) <= WIDTH and right[2:] == there[2:]


def reversed_lies(right: Ink, there: Ink, rounding: float) -> bool:
    """Tell whether a line or an arc lies where it must, but end for end."""
    turned = isinstance(right, Line | Arc) and type(right) is type(there)
    return turned and all(abs(a - b) <= rounding for a, b in zip(spots(right), reversed(spots(there)), strict=True))
