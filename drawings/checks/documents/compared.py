"""The report's table of both roads held to what was compared: plan, quantity, unit, differences (таблица сравнения)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from drawings.checks.wrong import Wrong
from drawings.report.markdown import quantity
from plans.checks.comparison import Comparison, Finding, together
from plans.model.motion import Floats
from plans.words.words import message, term, word

HEADS = ("plan", "quantity", "difference", "percent", "allowed")


def faults(text: str, comparisons: Iterable[Comparison], language: str) -> Iterator[Wrong]:
    """See that the report tells every finding in its turn, and nothing beside, by its worst difference."""
    heads = "| " + " | ".join(word(language, f"table.{head}") for head in HEADS) + " |"
    lines = text.splitlines()
    if heads not in lines:
        yield message("wrong.missing", name=heads)
        return
    first = lines.index(heads) + 2
    rows = lines[first : next((k for k in range(first, len(lines)) if not lines[k].startswith("|")), len(lines))]
    due = [_row(finding, language) for finding in together(comparisons)]
    yield from (message("wrong.told", text=row) for row in rows if row not in due)
    if len(rows) != len(due) or rows != due:
        lost = [row for row in due if row not in rows]
        yield from (message("wrong.row_missing", name=row) for row in lost or due[:1])


def _row(finding: Finding, language: str) -> str:
    """Write a row: the worst difference, its share of the largest in per cent, and of what is allowed."""
    worst = _greatest(finding.difference)
    share = 100 * worst / finding.largest if finding.largest and np.isfinite(finding.difference).any() else 0.0
    allowed = _greatest(finding.excess)
    mark = word(language, "number.decimal")
    numbers = (text.replace(".", mark) for text in (f"{worst:.2e}", f"{share:.2e}", f"{allowed:.3f}"))
    name = f"{quantity(finding.name, language)}, {term(language, 'text_unit', finding.unit)}"
    return "| " + " | ".join((term(language, "plan", finding.plan), name, *numbers)) + " |"


def _greatest(values: Floats) -> float:
    """Give the greatest of some numbers but gaps; an infinite one is greater than any."""
    own = values[~np.isnan(values)]
    return float(own.max(initial=0.0))
