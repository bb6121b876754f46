"""What the charts of a cyclogram must say of a span and of a row, by the analysis alone (слова циклограммы)."""

from __future__ import annotations

import math

from drawings.page.drafting import Drafting
from drawings.paper.strokes import Text
from plans.model.cyclogram import Row, Span

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


def angle(span: Span, drafting: Drafting) -> str:
    """Write the angle of a span, degrees."""
    return f"{drafting.number(math.degrees(span.end - span.start), DIGITS)}°"


def label(span: Span, drafting: Drafting) -> str:
    """Write what is done in a span, with its angle."""
    return f"{doing(span, drafting)}{' = ' if span.label else ' '}{angle(span, drafting)}"
