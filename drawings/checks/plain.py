"""A leaf as an eye sees it that knows no layout: the plainest strokes, lettering from where it begins (вид листа)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from functools import lru_cache

from drawings.lettering.lettering import index_size, text_width
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
from drawings.reading.alphabet import notations, regular, shape, signs
from drawings.reading.outlines import merged
from geometry.curve import RoundPiece

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
    """Give runs without the spaces before the first letter."""
    begun = False
    for run in runs:
        rest = run.text if begun else run.text.lstrip(_SPACES)
        begun = begun or bool(rest)
        if rest:
            yield run._replace(text=rest)
