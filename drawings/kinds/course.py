"""What each mechanism of a cyclogram does over the turn: courses, stretches, words, angles (ход звеньев)."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from drawings.lettering.words import fixed, verbatim
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import LineStyle
from plans.cyclogram import rows as r
from plans.model.cam import DWELL, RETURN, RISE
from plans.model.cyclogram import BarRow, Period, pieces

PLACES = 2  # decimals of a degree: what a dimension of an angle has


class SpanLevels(NamedTuple):
    """From which level of a row to which a span leads, 0 the lower, and the line of the hand that draws it."""

    start: float
    end: float
    style: str = "result"


COURSES: Final = {
    RISE: SpanLevels(0.0, 1.0),
    DWELL: SpanLevels(1.0, 1.0),
    RETURN: SpanLevels(1.0, 0.0),
    r.REST: SpanLevels(0.0, 0.0),
    r.WORK: SpanLevels(0.0, 1.0),
    r.IDLE: SpanLevels(1.0, 0.0, "other"),
    r.CUT: SpanLevels(1.0, 1.0),
    r.OVERRUN: SpanLevels(0.0, 0.0, "other"),
    r.BACK_OVER: SpanLevels(0.0, 0.0, "other"),
    r.FREE: SpanLevels(1.0, 0.0, "path"),
}


class Stretch(NamedTuple):
    """A part of a span, counted from where the chart begins to a whole turn, with the levels at its ends."""

    span: Period
    start: float
    end: float
    low: float  # level at its start
    high: float  # level at its end


def stretches(span: Period, begin: float = 0.0) -> tuple[Stretch, ...]:
    """Cut a span where a turn from `begin` starts anew."""
    course, whole, found, gone = COURSES[span.kind], span.end - span.start, list[Stretch](), 0.0
    for piece in pieces(span, begin):
        ends = gone, gone + piece.end - piece.start
        levels = (course.start + (course.end - course.start) * end / whole for end in ends)
        found.append(Stretch(span, piece.start, piece.end, *levels))
        gone = ends[1]
    return tuple(found)


def style_of(span: Period, hand: Hand) -> LineStyle:
    """Give the line that draws a span."""
    style: LineStyle = getattr(hand, COURSES[span.kind].style)
    return style


def moves(span: Period) -> bool:
    """Whether something is done in a span: a main line draws it."""
    return COURSES[span.kind].style == "result" and span.kind != r.REST


def doing(span: Period, drafting: Drafting) -> str:
    """Write what is done in a span: the letter of a phase, or a word."""
    return drafting.letter(f"φ_{{{span.label}}}") if span.label else drafting.word(f"cyclogram {span.kind}")


def degrees(angle: float, drafting: Drafting) -> str:
    """Write an angle rad of a cyclogram in degrees: of two decimals those that are not zero."""
    return f"{decimals(math.degrees(angle), drafting)}°"


def decimals(value: float, drafting: Drafting) -> str:
    """Write a value of a cyclogram: of two decimals those that are not zero."""
    return fixed(value, drafting.language, PLACES).rstrip("0").rstrip(".,")


def angle(span: Period, drafting: Drafting) -> str:
    """Write the angle of a span in degrees."""
    return degrees(span.end - span.start, drafting)


def label(span: Period, drafting: Drafting) -> str:
    """Write what is done in a span with its angle."""
    return f"{doing(span, drafting)}{' = ' if span.label else ' '}{angle(span, drafting)}"


def name(row: BarRow, drafting: Drafting) -> str:
    """Write the name of a row: that of a cam as the scene gives it."""
    if row.name in (r.STROKES, r.TOOL, r.FEED):
        return drafting.word(f"cyclogram {row.name}")
    return verbatim(drafting.word("cyclogram cam", name=row.name))
