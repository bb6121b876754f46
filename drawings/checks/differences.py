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


def differences(leaf: Leaf, sheet: SeenSheet) -> Iterator[Wrong]:
    """Tell where a sheet that was seen is not as it was laid out, of which all strokes are the plainest."""
    there = sheet.written
    if not any(lost.reason in NEVER for lost in sheet.unseen) and _same_paper(leaf, there) and same(leaf, there):
        return
    from drawings.sheet_diff.collate import Hidden, collate  # noqa: PLC0415  (only a difference pays for it)

    lost, hidden = ([Hidden(*found) for found in _unseen(unseen)] for unseen in (sheet.unseen, veiled(leaf)))
    collation = collate(uncovered(_rounded(leaf, there)), sheet.leaf, lost, hidden)
    yield from collation.whole
    yield from (edit.told for edit in collation.edits)
    if collation.clean:
        yield message("wrong.unlike", name=next(_unlike(leaf, there), ""))


def _unseen(unseen: Iterable[Unseen]) -> Iterator[tuple[Item, str]]:
    return ((item, hidden.reason) for hidden in unseen for item in inside(hidden.stroke, hidden.group))


def _unlike(leaf: Leaf, there: Leaf) -> Iterator[str]:
    """Name the groups that differ in what no line of them shows: their names, titles, data, their order."""
    even = _even(leaf)
    pairs = zip_longest(leaf.groups, there.groups, fillvalue=Group(()))
    return (group.name or other.name for group, other in pairs if not _same(group, other, even))


def _rounded(leaf: Leaf, there: Leaf) -> Leaf:
    """Give what was laid out as it is rounded where it was written right, so that nothing is told of roundings."""
    texts = [stroke for stroke in flat(there.groups) if isinstance(stroke, Text)]
    shapes = [stroke for stroke in flat(there.groups) if isinstance(stroke, Fill | Arc)]
    even = _even(leaf)

    def rounded(stroke: Stroke) -> Stroke:
        match stroke:
            case Group():
                return stroke._replace(strokes=tuple(map(rounded, stroke.strokes)))
            case Text():
                found = next((ink for ink in texts if _same_place(stroke, ink, even)), None)
                if found is not None:
                    return stroke._replace(at=found.at, rotation=found.rotation)
                return stroke._replace(at=next((ink.at for ink in texts if abs(ink.at - stroke.at) <= even), stroke.at))
            case Fill() | Arc():
                return next((shape for shape in shapes if _same(stroke, shape, even)), stroke)
            case Polyline((start, end), False):
                return Line(start, end, stroke.style)
        return stroke

    return leaf._replace(groups=tuple(part._replace(strokes=tuple(map(rounded, part.strokes))) for part in leaf.groups))


def same(leaf: Leaf, there: Leaf) -> bool:
    """Tell whether two leaves have the same groups, and in them the same strokes, one by one in their order."""
    even = _even(leaf)
    return len(leaf.groups) == len(there.groups) and all(
        _same(group, other, even) for group, other in zip(leaf.groups, there.groups, strict=True)
    )


def _even(leaf: Leaf) -> float:
    """Give how far lettering may begin from where it must, mm."""
    return TYPESET if leaf.lettering == "text" else LETTERED


def _same_paper(leaf: Leaf, there: Leaf) -> bool:
    sizes = abs(leaf.width - there.width) <= WRITTEN and abs(leaf.height - there.height) <= WRITTEN
    return sizes and (leaf.title, leaf.description) == (there.title, there.description)


def _same(stroke: Stroke, there: Stroke, even: float) -> bool:
    """Tell whether two strokes are one and the same to the eye."""
    match stroke, there:
        case Text(), Text():
            return _same_text(stroke, there, even)
        case Group(), Group():
            return _same_group(stroke, there, even)
        case Line(), Line():
            ends = abs(stroke.start - there.start) <= QUANTUM and abs(stroke.end - there.end) <= QUANTUM
        case Circle(), Circle():
            ends = abs(stroke.centre - there.centre) <= QUANTUM and abs(stroke.radius - there.radius) <= WRITTEN
        case Fill(), Fill():
            ends = _together(stroke.points, there.points) or _together(stroke.points[::-1], there.points)
        case Polyline(), Line():  # a chain of two points is a line
            ends = _together(stroke.points, (there.start, there.end)) and not stroke.closed
        case Polyline(), Polyline():
            ends = _together(stroke.points, there.points) and stroke.closed == there.closed
        case Arc(), Arc():
            ends = _together(_along(stroke), _along(there), ARCHED)
        case Curve(), Curve():
            ends = _same_curve(stroke, there)
        case _:
            return False
    return ends and (stroke.style == there.style or _same_style(stroke.style, there.style))


def _same_group(group: Group, there: Group, even: float) -> bool:
    if (group.name, group.title) != (there.name, there.title) or group.data != there.data:
        return False
    if len(group.strokes) != len(there.strokes):
        return False
    return all(_same(stroke, other, even) for stroke, other in zip(group.strokes, there.strokes, strict=True))


def _same_text(text: Text, there: Text, even: float) -> bool:
    return (
        text.runs == there.runs
        and text.slanted == there.slanted
        and _same_place(text, there, even)
        and abs(text.size - there.size) <= 10 * WRITTEN
        and (text.style == there.style or _same_style(text.style, there.style))
    )


def _same_place(text: Text, there: Text, even: float) -> bool:
    """Tell whether two texts begin at one place and are turned alike.

    A letter's points are rounded, which turns a small one most; its corner, where the text begins, is found from its
    first point, by that turn and at most across its cell.
    """
    if text.rotation == there.rotation:
        return abs(text.at - there.at) <= even
    turned = abs(math.radians((text.rotation - there.rotation + 180) % 360 - 180))
    return turned <= 4 * NEAR / text.size and abs(text.at - there.at) <= even + turned * CELL * text.size


def _same_curve(curve: Curve, there: Curve) -> bool:
    if curve.closed != there.closed or len(curve.pieces) != len(there.pieces):
        return False
    return all(
        _together(_spots(piece), _spots(other), _rounding(piece))
        for piece, other in zip(curve.pieces, there.pieces, strict=True)
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


def _together(spots: Sequence[complex], there: Sequence[complex], within: float = QUANTUM) -> bool:
    return len(spots) == len(there) and all(abs(a - b) <= within for a, b in zip(spots, there, strict=True))


@lru_cache(maxsize=1024)
def _same_style(style: LineStyle, there: LineStyle) -> bool:
    """Tell whether two lines are of one pen: width, dashes, colour, filling, ends."""
    sizes = zip_longest((style.width, *style.dash), (there.width, *there.dash), fillvalue=-1.0)
    return all(abs(a - b) <= WRITTEN for a, b in sizes) and style[2:] == there[2:]
