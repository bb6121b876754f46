"""Differences between what was laid out and what is seen: every line and letter is there, and nothing else (сверка)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import zip_longest

from drawings.checks.wrong import Wrong
from drawings.collation.collate import collate
from drawings.eye.letters import NEAR
from drawings.eye.sheet import SeenSheet
from drawings.paper.limits import CURVE_QUANTUM, DECIMALS, QUANTUM
from drawings.paper.strokes import Arc, Circle, Curve, Fill, Group, Leaf, Line, LineStyle, Polyline, Stroke, Text
from geometry.curve import CubicPiece, Piece, RoundPiece
from plans.words.words import message

WRITTEN = 0.5000001 * 10.0**-DECIMALS  # mm: how far a written number is from the one that is meant
LETTERED = 1.5e-3  # mm: letters begin at thousandths of a millimetre, and are set by thousandths
# Of texts in a viewer's fonts: their narrowing is written with four decimals, of a place on an A1.
TYPESET = 0.1

_BETWEEN = 8  # of an arc: no two of its points are more than an eighth of a turn apart


def differences(laid: Leaf, seen: SeenSheet) -> Iterator[Wrong]:
    """Tell where a sheet that was seen is not as it was laid out, of which all strokes are the plainest."""
    there = seen.written
    if _same_paper(laid, there) and same(laid, there):
        return
    told = collate(laid, there)
    yield from told.whole
    yield from (one.told for one in told.edits)
    if told.clean:
        yield message("wrong.unlike")


def same(laid: Leaf, there: Leaf) -> bool:
    """Tell whether two leaves have the same groups, and in them the same strokes, one by one in their order."""
    even = TYPESET if laid.lettering == "text" else LETTERED
    return all(map(_same, laid.groups, there.groups, [even] * len(laid.groups))) and len(laid.groups) == len(
        there.groups
    )


def _same_paper(laid: Leaf, there: Leaf) -> bool:
    sizes = abs(laid.width - there.width) <= WRITTEN and abs(laid.height - there.height) <= WRITTEN
    return sizes and (laid.title, laid.description) == (there.title, there.description)


def _same(laid: Stroke, there: Stroke, even: float) -> bool:
    """Tell whether two strokes are one and the same to the eye."""
    match laid, there:
        case Group(), Group():
            return _same_group(laid, there, even)
        case Text(), Text():
            return _same_text(laid, there, even)
        case Line(), Line():
            ends = abs(laid.start - there.start) <= QUANTUM and abs(laid.end - there.end) <= QUANTUM
        case Circle(), Circle():
            ends = abs(laid.centre - there.centre) <= QUANTUM and abs(laid.radius - there.radius) <= WRITTEN
        case Fill(), Fill():
            ends = _together(laid.points, there.points) or _together(laid.points[::-1], there.points)
        case Polyline(), Polyline():
            ends = _together(laid.points, there.points) and laid.closed == there.closed
        case Arc(), Arc():
            ends = _together(_along(laid), _along(there))
        case Curve(), Curve():
            ends = _same_curve(laid, there)
        case _:
            return False
    return ends and _same_style(laid.style, there.style)


def _same_group(laid: Group, there: Group, even: float) -> bool:
    if (laid.name, laid.title) != (there.name, there.title) or laid.data != there.data:
        return False
    if len(laid.strokes) != len(there.strokes):
        return False
    return all(_same(own, other, even) for own, other in zip(laid.strokes, there.strokes, strict=True))


def _same_text(laid: Text, there: Text, even: float) -> bool:
    turned = math.radians((laid.rotation - there.rotation + 180) % 360 - 180)
    return (
        laid.runs == there.runs
        and laid.slanted == there.slanted
        and abs(laid.at - there.at) <= even
        and abs(laid.size - there.size) <= 10 * WRITTEN
        and abs(turned) <= 4 * NEAR / laid.size
        and _same_style(laid.style, there.style)
    )


def _same_curve(laid: Curve, there: Curve) -> bool:
    if laid.closed != there.closed or len(laid.pieces) != len(there.pieces):
        return False
    return all(
        _together(_spots(own), _spots(other), CURVE_QUANTUM)
        for own, other in zip(laid.pieces, there.pieces, strict=True)
    )


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
