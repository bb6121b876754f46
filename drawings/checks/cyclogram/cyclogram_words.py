"""What the charts of a cyclogram must say of a span and of a row, by the analysis alone (слова циклограммы)."""

from __future__ import annotations

import math

from drawings.checks.cyclogram.due_rows import DASHED, THIN
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Arc, Line, Text
from plans.model.cyclogram import Row, Span, within

DIGITS = 5
OWN = ("strokes", "tool", "feed")  # rows of the main mechanism and of the feed; any other is a cam's


def row_name(row: Row, drafting: Drafting) -> str:
    """Write the name of a row as it is read: of a cam as the scene gives it."""
    own = row.name in OWN
    text = drafting.word(f"cyclogram {row.name}") if own else drafting.word("cyclogram cam", name=row.name)
    return Text(0j, text).plain


def doing(span: Span, drafting: Drafting) -> str:
    """Write what is done in a span as it is read: the letter of a phase, or a word."""
    if span.label:
        return Text(0j, drafting.letter(f"φ_{{{span.label}}}")).plain
    return Text(0j, drafting.word(f"cyclogram {span.kind}")).plain


def setting(row: Row, begin: float, drafting: Drafting) -> str:
    """Write what dimensions a setting angle: of one that stands before φ = 0 also what it lacks of a whole turn."""
    told = f"{row_name(row, drafting)}: {drafting.number(math.degrees(within(row.setting or 0.0)), DIGITS)}°"
    back = within(-begin) - within((row.setting or 0.0) - begin)
    return told if back <= 0 else f"{told} = 360° − {drafting.number(math.degrees(back), DIGITS)}°"


def in_style(line: Line | Arc, span: Span, drafting: Drafting) -> bool:
    """Tell whether a line is the one that a span is drawn by: main, thin, or thin and dashed."""
    wide = drafting.hand.thin if span.kind in THIN else drafting.hand.main
    return line.style.width == wide and bool(line.style.dash) == (span.kind in DASHED)


def angle(span: Span, drafting: Drafting) -> str:
    """Write the angle of a span, degrees."""
    return f"{drafting.number(math.degrees(span.end - span.start), DIGITS)}°"


def label(span: Span, drafting: Drafting) -> str:
    """Write what is done in a span, with its angle."""
    return f"{doing(span, drafting)}{' = ' if span.label else ' '}{angle(span, drafting)}"
