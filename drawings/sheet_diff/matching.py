"""Which stroke of one sheet is which of another, also where the sheet was moved, turned or scaled (соответствие)."""

from __future__ import annotations

import cmath
import math
from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator, Sequence
from itertools import product
from typing import NamedTuple

from drawings.paper.strokes import Arc, Circle, Line, LineStyle, Polyline, Text
from drawings.reading.items import Ink, Item, spots
from drawings.reading.transform import Affine

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
    for same_mark in (True, False):  # two marks may lie on one place: each stroke has that of its own mark first
        left: list[Item] = []
        for item in missing:
            near = (place for place in _near(item.stroke, cells, rounding) if place not in taken)
            near = (place for place in near if not same_mark or there[place].home.mark == item.home.mark)
            fitting = next((place for place in near if same(item.stroke, there[place].stroke, rounding)), None)
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
        copied = any(same(right[place].stroke, item.stroke, rounding) for place in _near(item.stroke, cells, rounding))
        (copies if copied else added).append(item)
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
    pairs = zip(right.dash, there.dash, strict=False)
    dashes = len(right.dash) == len(there.dash) and all(abs(a - b) <= WIDTH for a, b in pairs)
    return dashes and abs(right.width - there.width) <= WIDTH and right[2:] == there[2:]


def reversed_lies(right: Ink, there: Ink, rounding: float) -> bool:
    """Tell whether a line or an arc lies where it must, but end for end."""
    turned = isinstance(right, Line | Arc) and type(right) is type(there)
    return turned and all(abs(a - b) <= rounding for a, b in zip(spots(right), reversed(spots(there)), strict=True))


MORE = 2  # times the rounding: of what an editor wrote anew, both places are rounded

LINES = 2  # that show how they were stretched
FLAT = 1e-9  # of points as good as on one line: their spread across it is a thirty-thousandth of that along it


class Shift(NamedTuple):
    """How a part of a sheet was moved: its map, a similarity or not, and how far it moves what goes farthest, mm."""

    by: Affine
    farthest: float

    @property
    def scale(self) -> float:
        """How many times as large it makes what it moves."""
        return abs(self.by.p)

    @property
    def how(self) -> str:
        """Say whether it moves, mirrors, or stretches in one direction."""
        if not self.by.stretched and abs(self.by.p) > abs(self.by.q):
            return "moved"
        return "mirrored" if abs(self.by.q) > abs(self.by.p) else "stretched"

    @property
    def turn(self) -> float:
        """The angle by which it turns what it moves, degrees, counter-clockwise."""
        return math.degrees(cmath.phase(self.by.p))


def shift_of(right: Sequence[Item], there: Sequence[Item], rounding: float) -> Shift | None:
    """Find the similarity that brings strokes onto others, one to one in their order; None where there is none."""
    if len(right) != len(there) or not right:
        return None
    if not all(_of_one_kind(ours, theirs) for ours, theirs in zip(right, there, strict=True)):
        return None
    ours = [spot for item in right for spot in spots(item.stroke)]
    theirs = [spot for item in there for spot in spots(item.stroke)]
    centre, target = sum(ours) / len(ours), sum(theirs) / len(theirs)
    z, w = [a - centre for a in ours], [b - target for b in theirs]
    spread = sum(abs(a) ** 2 for a in z)
    p = _times(w, [a.conjugate() for a in z]) / spread if spread else 1
    by = Affine(complex(p), 0j, target - p * centre)
    off = max(abs(by(a) - b) for a, b in zip(ours, theirs, strict=True))
    allowed = MORE * rounding * max(1.0, abs(by.p))
    if not (off <= allowed and _round_off(right, there, abs(by.p)) <= allowed):
        return None
    return Shift(by, max(abs(a - b) for a, b in zip(ours, theirs, strict=True)))


def _round_off(right: Sequence[Item], there: Sequence[Item], scale: float) -> float:
    """Give how far radii of circles are off that were drawn so many times as large, mm."""
    pairs = ((ours.stroke, theirs.stroke) for ours, theirs in zip(right, there, strict=True))
    off = (abs(a.radius * scale - b.radius) for a, b in pairs if isinstance(a, Circle) and isinstance(b, Circle))
    return max(off, default=0.0)


def _of_one_kind(ours: Item, theirs: Item) -> bool:
    named = ours.what == theirs.what and ours.name == theirs.name and type(ours.stroke) is type(theirs.stroke)
    return named and len(spots(ours.stroke)) == len(spots(theirs.stroke))


def stretch_of(right: Sequence[Item], there: Sequence[Item], rounding: float) -> Shift | None:
    """Find how lines were stretched or mirrored as one, one to one in their order; None where they were not."""
    if len(right) != len(there) or len(right) < LINES:
        return None
    ours = [spot for item in right for spot in spots(item.stroke)]
    theirs = [spot for item in there for spot in spots(item.stroke)]
    by = _sheared(ours, theirs)
    if by is None:
        return None
    reach = max(1.0, abs(by.p) + abs(by.q))  # as many times as long it makes what it makes longest
    if not max(abs(by(a) - b) for a, b in zip(ours, theirs, strict=True)) <= MORE * rounding * reach:
        return None
    return Shift(by, max(abs(a - b) for a, b in zip(ours, theirs, strict=True)))


def _sheared(ours: Sequence[complex], theirs: Sequence[complex]) -> Affine | None:
    """Fit a map of the plane by least squares; None where all points are on one line."""
    centre, target = sum(ours) / len(ours), sum(theirs) / len(theirs)
    z, w = [a - centre for a in ours], [b - target for b in theirs]
    back = [a.conjugate() for a in z]
    spread, lean = sum(abs(a) ** 2 for a in z), _times(back, back)
    area = spread**2 - abs(lean) ** 2
    if not area > FLAT * spread**2:
        return None
    straight, turned = _times(w, back), _times(w, z)
    p, q = (straight * spread - turned * lean) / area, (turned * spread - straight * lean.conjugate()) / area
    return Affine(p, q, target - p * centre - q * centre.conjugate())


def _times(a: Sequence[complex], b: Sequence[complex]) -> complex:
    return sum((x * y for x, y in zip(a, b, strict=True)), 0j)


def looks_alike(right: Sequence[Item], there: Sequence[Item], scale: float) -> bool:
    """Tell whether strokes that were moved as one still look as they must, their lines as wide or scaled with them."""
    pairs = [(a.stroke, b.stroke) for a, b in zip(right, there, strict=True)]
    return all(alike(a, b) for a, b in pairs) or all(alike(_wider(a, scale), b) for a, b in pairs)


def _wider(stroke: Ink, scale: float) -> Ink:
    """Give a stroke with its line so many times as wide, and its dashes so many times as long."""
    width, dash = stroke.style.width * scale, tuple(dash * scale for dash in stroke.style.dash)
    return stroke._replace(style=stroke.style._replace(width=width, dash=dash))
