"""What was laid out, as an eye sees it, and what is seen: all of it is there, and nothing else (сверка)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import zip_longest

from drawings.checks.expected import Wrong
from drawings.lettering.lettering import index_size, text_width
from drawings.paper.limits import CURVE_QUANTUM, DECIMALS, QUANTUM
from drawings.paper.strokes import (
    LEAN,
    LOWERED,
    RAISED,
    Anchor,
    Arc,
    Circle,
    Curve,
    Fill,
    Group,
    Leaf,
    Line,
    LineStyle,
    Polyline,
    Run,
    Stroke,
    Text,
)
from drawings.paper.walk import flat
from drawings.reading.alphabet import NEAR, notations, regular, shape, signs
from drawings.reading.covering import veiled
from drawings.reading.items import Item, inside
from drawings.reading.outlines import merged
from drawings.reading.sheet import SeenSheet, uncovered
from drawings.reading.visibility import Unseen
from geometry.curve import CubicPiece, Piece, RoundPiece
from plans.words.words import message

_SPACES = " \u00a0\u2009\u202f"
_SHARES = {"start": 0.0, "middle": 0.5, "end": 1.0}
_RISES = {-1: -LOWERED, 1: RAISED}


def plain(leaf: Leaf, lettering: str, stating: bool = True) -> Leaf:
    """Give a leaf with the plainest strokes that look as its own do, one for one, as it is written in a lettering.

    Without `stating` what does nothing but state is its strokes alone, as it is written.
    """
    lined = lettering == "strokes"
    return leaf._replace(groups=tuple(_group(group, lined, stating) for group in leaf.groups), lettering=lettering)


def _group(group: Group, lined: bool, stating: bool) -> Group:
    strokes = tuple(_strokes(group.strokes, lined, stating))
    return Group(strokes, group.name, group.data, group.title, group.states if stating else None)


def _strokes(strokes: Iterable[Stroke], lined: bool, stating: bool) -> Iterator[Stroke]:
    """Give strokes without those that leave no trace: a chain of one point, a circle of no radius, blank lettering.

    Of texts that are written in lines, `lined`, a lone dash looks alike slanted and upright.
    """
    for stroke in strokes:
        match stroke:
            case Group():
                if stroke.name or stroke.data or stroke.title or (stroke.strokes and (stating or not stroke.states)):
                    yield _group(stroke, lined, stating)
                elif stroke.strokes:
                    yield from _strokes(stroke.strokes, lined, stating)
            case Text():
                if stroke.plain.strip(_SPACES):
                    yield _text(stroke, lined)
            case Polyline() | Fill():
                if len(stroke.points) > 1:
                    yield _chain(stroke)
            case Curve():
                yield _curve(stroke)
            case Line() | Arc() | Circle():
                if not isinstance(stroke, Circle) or stroke.radius > 0:
                    yield stroke if stroke.style.colour != "none" else stroke._replace(style=_style(stroke.style))


@lru_cache(maxsize=256)
def _style(style: LineStyle) -> LineStyle:
    return LineStyle(0.0, (), style.colour, style.fill) if style.colour == "none" else style


def _chain(stroke: Polyline | Fill) -> Stroke:
    style = _style(stroke.style)
    if style.colour == "none" and style.fill != "none":
        return Fill(stroke.points, style)
    return Polyline(stroke.points, isinstance(stroke, Fill) or stroke.closed, style)


def _curve(stroke: Curve) -> Stroke:
    pieces, style = tuple(merged(stroke.pieces)), _style(stroke.style)
    if len(pieces) == 1 and isinstance(pieces[0], RoundPiece) and pieces[0].sweep > 0 and not stroke.closed:
        start, centre, sweep = pieces[0]
        begin = cmath.phase(start - centre)
        return Arc(centre, abs(start - centre), begin, begin + sweep, style)
    return Curve(pieces, stroke.closed, style)


def _text(text: Text, lined: bool) -> Text:
    """Give lettering from where its first letter begins; all of one level, it is a text of that level's size."""
    at, content, size, anchor, slanted, rotation, style = text
    off, content, size, anchor, slanted, rotation, _ = _begun(content, size, anchor, slanted, rotation, lined)
    return Text(at + off, content, size, anchor, slanted, rotation, style)


@lru_cache(maxsize=4096)  # a sheet letters the same in many places
def _begun(
    content: str | tuple[Run, ...], size: float, anchor: Anchor, slanted: bool, rotation: float, lined: bool
) -> Text:
    """Give a text that stands at zero, from where its first letter begins."""
    text = Text(0j, content, size, anchor, slanted, rotation)
    head = text.plain[: len(text.plain) - len(text.plain.lstrip(_SPACES))]
    along = -_SHARES[anchor] * text_width(text) if anchor != "start" else 0.0
    if head:
        along += text_width(text) - text_width(text._replace(content=tuple(_headless(text.runs))))
    runs, rise = regular(text.runs), 0j
    levels = {run.level for run in runs}
    if len(levels) == 1 and 0 not in levels:
        (level,) = levels
        runs, size, rise = tuple(Run(run.text) for run in runs), index_size(size), 1j * _RISES[level] * size
    if lined and slanted and (lean := _flat(runs)) is not None:
        slanted, rise = False, rise + lean * size / 10
    turn = cmath.rect(1, math.radians(rotation)) if rotation else 1 + 0j
    return Text((along + rise) * turn, runs, size, "start", slanted, rotation % 360)


@lru_cache(maxsize=4096)
def _flat(runs: tuple[Run, ...]) -> float | None:
    """Give how far a lone dash leans, d: it looks alike slanted and upright; None of what does not."""
    spelled = [sign for run in runs for sign in signs(run.text)]
    points = shape(spelled[0].written).points if len(spelled) == 1 and spelled[0].written in notations() else ()
    heights = {point.imag for point in points}
    return LEAN * heights.pop() if len(heights) == 1 else None


def _headless(runs: Iterable[Run]) -> Iterator[Run]:
    begun = False
    for run in runs:
        rest = run.text if begun else run.text.lstrip(_SPACES)
        begun = begun or bool(rest)
        if rest:
            yield run._replace(text=rest)


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
    pairs = zip(leaf.groups, there.groups, strict=False)
    return len(leaf.groups) == len(there.groups) and all(_same(group, other, even) for group, other in pairs)


def _even(leaf: Leaf) -> float:
    """Give how far lettering may begin from where it must, mm."""
    return TYPESET if leaf.lettering == "text" else LETTERED


def _same_paper(leaf: Leaf, there: Leaf) -> bool:
    sizes = abs(leaf.width - there.width) <= WRITTEN and abs(leaf.height - there.height) <= WRITTEN
    return sizes and (leaf.title, leaf.description) == (there.title, there.description)


def _same(stroke: Stroke, there: Stroke, even: float) -> bool:
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
    sizes = zip_longest((style.width, *style.dash), (there.width, *there.dash), fillvalue=-1.0)
    return all(abs(a - b) <= WRITTEN for a, b in sizes) and style[2:] == there[2:]
