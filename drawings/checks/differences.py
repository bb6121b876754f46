"""Differences between what was laid out and what is seen: every line and letter is there, and nothing else (сверка)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import zip_longest

from drawings.checks.expected import Wrong
from drawings.paper.limits import CURVE_QUANTUM, DECIMALS, QUANTUM
from drawings.paper.strokes import Arc, Circle, Curve, Fill, Group, Leaf, Line, LineStyle, Polyline, Stroke, Text
from drawings.paper.walk import flat
from drawings.reading.covering import veiled
from drawings.reading.ink import Unseen
from drawings.reading.letters import NEAR
from drawings.reading.sheet import SeenSheet, uncovered
from drawings.sheet_diff.items import Item, inside
from geometry.curve import CubicPiece, Piece, RoundPiece
from plans.words.words import message

WRITTEN = 0.5000001 * 10.0**-DECIMALS  # mm: how far a written number is from the one that is meant
LETTERED = 1.5e-3  # mm: letters begin at thousandths of a millimetre, and are set by thousandths
CELL = 1.25  # of the height of letters: from corner to corner of the cell of the widest of them
# Of texts in a viewer's fonts: their narrowing is written with four decimals, of a place on an A1.
TYPESET = 0.1

NEVER = ("hidden", "clipped", "unread")  # why a stroke is unseen that no pen of ours would write so
# mm: an arc is found by two of its points and its radius, each of which was rounded.
ARCHED = 2 * QUANTUM
_BETWEEN = 8  # of an arc: no two of its points are more than an eighth of a turn apart


def differences(laid: Leaf, seen: SeenSheet) -> Iterator[Wrong]:
    """Tell where a sheet that was seen is not as it was laid out, of which all strokes are the plainest."""
    there = seen.written
    if not any(one.reason in NEVER for one in seen.unseen) and _same_paper(laid, there) and same(laid, there):
        return
    from drawings.sheet_diff.collate import Hidden, collate  # noqa: PLC0415  (only a difference pays for it)

    lost, hidden = ([Hidden(*one) for one in _unseen(own)] for own in (seen.unseen, veiled(laid)))
    told = collate(uncovered(_rounded(laid, there)), seen.leaf, lost, hidden)
    yield from told.whole
    yield from (one.told for one in told.edits)
    if told.clean:
        yield message("wrong.unlike", name=next(_unlike(laid, there), ""))


def _unseen(unseen: Iterable[Unseen]) -> Iterator[tuple[Item, str]]:
    return ((item, one.reason) for one in unseen for item in inside(one.stroke, one.group))


def _unlike(laid: Leaf, there: Leaf) -> Iterator[str]:
    """Name the groups that differ in what no line of them shows: their names, titles, data, their order."""
    even = _even(laid)
    pairs = zip_longest(laid.groups, there.groups, fillvalue=Group(()))
    return (own.name or other.name for own, other in pairs if not _same(own, other, even))


def _rounded(laid: Leaf, there: Leaf) -> Leaf:
    """Give what was laid out as it is rounded where it was written right, so that nothing is told of roundings."""
    texts = [one for one in flat(there.groups) if isinstance(one, Text)]
    shapes = [one for one in flat(there.groups) if isinstance(one, Fill | Arc)]
    even = _even(laid)

    def rounded(stroke: Stroke) -> Stroke:
        match stroke:
            case Group():
                return stroke._replace(strokes=tuple(map(rounded, stroke.strokes)))
            case Text():
                found = next((one for one in texts if _same_place(stroke, one, even)), None)
                if found is not None:
                    return stroke._replace(at=found.at, rotation=found.rotation)
                return stroke._replace(at=next((one.at for one in texts if abs(one.at - stroke.at) <= even), stroke.at))
            case Fill() | Arc():
                return next((one for one in shapes if _same(stroke, one, even)), stroke)
            case Polyline((start, end), False):
                return Line(start, end, stroke.style)
        return stroke

    return laid._replace(groups=tuple(one._replace(strokes=tuple(map(rounded, one.strokes))) for one in laid.groups))


def same(laid: Leaf, there: Leaf) -> bool:
    """Tell whether two leaves have the same groups, and in them the same strokes, one by one in their order."""
    even = _even(laid)
    return len(laid.groups) == len(there.groups) and all(
        _same(own, other, even) for own, other in zip(laid.groups, there.groups, strict=True)
    )


def _even(laid: Leaf) -> float:
    """Give how far lettering may begin from where it must, mm."""
    return TYPESET if laid.lettering == "text" else LETTERED


def _same_paper(laid: Leaf, there: Leaf) -> bool:
    sizes = abs(laid.width - there.width) <= WRITTEN and abs(laid.height - there.height) <= WRITTEN
    return sizes and (laid.title, laid.description) == (there.title, there.description)


def _same(laid: Stroke, there: Stroke, even: float) -> bool:
    """Tell whether two strokes are one and the same to the eye."""
    match laid, there:
        case Text(), Text():
            return _same_text(laid, there, even)
        case Group(), Group():
            return _same_group(laid, there, even)
        case Line(), Line():
            ends = abs(laid.start - there.start) <= QUANTUM and abs(laid.end - there.end) <= QUANTUM
        case Circle(), Circle():
            ends = abs(laid.centre - there.centre) <= QUANTUM and abs(laid.radius - there.radius) <= WRITTEN
        case Fill(), Fill():
            ends = _together(laid.points, there.points) or _together(laid.points[::-1], there.points)
        case Polyline(), Line():  # a chain of two points is a line
            ends = _together(laid.points, (there.start, there.end)) and not laid.closed
        case Polyline(), Polyline():
            ends = _together(laid.points, there.points) and laid.closed == there.closed
        case Arc(), Arc():
            ends = _together(_along(laid), _along(there), ARCHED)
        case Curve(), Curve():
            ends = _same_curve(laid, there)
        case _:
            return False
    return ends and (laid.style == there.style or _same_style(laid.style, there.style))


def _same_group(laid: Group, there: Group, even: float) -> bool:
    if (laid.name, laid.title) != (there.name, there.title) or laid.data != there.data:
        return False
    if len(laid.strokes) != len(there.strokes):
        return False
    return all(_same(own, other, even) for own, other in zip(laid.strokes, there.strokes, strict=True))


def _same_text(laid: Text, there: Text, even: float) -> bool:
    return (
        laid.runs == there.runs
        and laid.slanted == there.slanted
        and _same_place(laid, there, even)
        and abs(laid.size - there.size) <= 10 * WRITTEN
        and (laid.style == there.style or _same_style(laid.style, there.style))
    )


def _same_place(laid: Text, there: Text, even: float) -> bool:
    """Tell whether two texts begin at one place and are turned alike.

    A letter's points are rounded, which turns a small one most; its corner, where the text begins, is found from its
    first point, by that turn and at most across its cell.
    """
    if laid.rotation == there.rotation:
        return abs(laid.at - there.at) <= even
    turned = abs(math.radians((laid.rotation - there.rotation + 180) % 360 - 180))
    return turned <= 4 * NEAR / laid.size and abs(laid.at - there.at) <= even + turned * CELL * laid.size


def _same_curve(laid: Curve, there: Curve) -> bool:
    if laid.closed != there.closed or len(laid.pieces) != len(there.pieces):
        return False
    return all(
        _together(_spots(own), _spots(other), _rounding(own))
        for own, other in zip(laid.pieces, there.pieces, strict=True)
    )


def _rounding(piece: Piece) -> float:
    """Give how far rounding moves a piece, mm; an arc is found by its ends and radius: near half a turn by the root."""
    if isinstance(piece, CubicPiece):
        return CURVE_QUANTUM
    off = abs(piece.radius * math.cos(piece.sweep / 2))  # of the centre from the chord
    return CURVE_QUANTUM + math.sqrt(off**2 + 4 * piece.radius * CURVE_QUANTUM) - off


def _spots(piece: Piece) -> tuple[complex, ...]:
    return tuple(piece) if isinstance(piece, CubicPiece) else _along(piece)


def _along(arc: Arc | RoundPiece) -> tuple[complex, ...]:
    """Give points of an arc by which it is held: its ends, and between them."""
    return tuple(arc.at(k / _BETWEEN) for k in range(_BETWEEN + 1))


def _together(laid: Sequence[complex], there: Sequence[complex], within: float = QUANTUM) -> bool:
    return len(laid) == len(there) and all(abs(a - b) <= within for a, b in zip(laid, there, strict=True))


@lru_cache(maxsize=1024)
def _same_style(laid: LineStyle, there: LineStyle) -> bool:
    """Tell whether two lines are of one pen: width, dashes, colour, filling, ends."""
    sizes = zip_longest((laid.width, *laid.dash), (there.width, *there.dash), fillvalue=-1.0)
    return all(abs(a - b) <= WRITTEN for a, b in sizes) and laid[2:] == there[2:]
