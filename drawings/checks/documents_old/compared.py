"""The report's table of both roads held to what was compared: plan, quantity, unit, differences (таблица сравнения)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from drawings.checks.wrong import Wrong
from drawings.lettering.words import runs
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


def screen_faults(said: str, comparisons: Sequence[Comparison], language: str) -> Iterator[Wrong]:
    """See that the short comparison has a row for each plan, by its worst difference, and each gap of the analysis."""
    heads = [word(language, f"table.{head}") for head in ("plan", "difference", "percent", "allowed", "in")]
    due = [" ".join(heads)]
    for one in comparisons:
        due += [_short(plan, one, language) for plan in dict.fromkeys(finding.plan for finding in one.findings)]
    due += [line for one in comparisons for line in _left_out(one, language)]
    lines = [" ".join(line.split()) for line in said.splitlines()]
    yield from (message("wrong.told", text=line) for line in lines if line not in due)
    if len(lines) != len(due) or lines != due:
        lost = [line for line in due if line not in lines]
        yield from (message("wrong.row_missing", name=line) for line in lost or due[:1])


def _short(plan: str, comparison: Comparison, language: str) -> str:
    """Write a plan's row: what is worst of the allowed, of those the greatest; the greatest share of the largest."""
    own = [(_greatest(one.excess), _greatest(one.difference), one) for one in comparison.of(plan)]
    allowed, worst, finding = max(own, key=lambda one: one[:2])
    share = max(_share(one) for one in comparison.of(plan))
    unit, name = term(language, "text_unit", finding.unit), quantity(finding.name, language)
    numbers = (_decimal(text, language) for text in (f"{worst:.2e}", f"{share:.2e}", f"{allowed:.3f}"))
    size, *others = numbers
    return " ".join(" ".join((term(language, "plan", plan), size, unit, *others, name)).split())


def _left_out(comparison: Comparison, language: str) -> Iterator[str]:
    """Say which positions have no result by the analysis, plan by plan."""
    gaps: dict[str, list[int]] = {}
    for gap in comparison.analysis.unanswered:
        gaps.setdefault(gap.plan, []).append(gap.position)
    for plan, places in gaps.items():
        told = message("compare.positions", count=len(places), positions=runs(places, "-"))
        yield " ".join(word(language, "compare.left_out", plan=plan, positions=told).split())


def _share(finding: Finding) -> float:
    """Give the worst difference in per cent of the largest; of what is nowhere known there is none."""
    known = finding.largest and np.isfinite(finding.difference).any()
    return 100 * _greatest(finding.difference) / finding.largest if known else 0.0


def _decimal(text: str, language: str) -> str:
    return text.replace(".", word(language, "number.decimal"))


def _row(finding: Finding, language: str) -> str:
    """Write a row: the worst difference, its share of the largest in per cent, and of what is allowed."""
    worst = _greatest(finding.difference)
    share = _share(finding)
    allowed = _greatest(finding.excess)
    numbers = (_decimal(text, language) for text in (f"{worst:.2e}", f"{share:.2e}", f"{allowed:.3f}"))
    name = f"{quantity(finding.name, language)}, {term(language, 'text_unit', finding.unit)}"
    return "| " + " | ".join((term(language, "plan", finding.plan), name, *numbers)) + " |"


def _greatest(values: Floats) -> float:
    """Give the greatest of some numbers but gaps; an infinite one is greater than any."""
    own = values[~np.isnan(values)]
    return float(own.max(initial=0.0))
