"""The report beside a set of sheets, in Markdown: the chapters of its techniques, and both roads compared (отчёт)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from drawings.lettering.words import runs
from drawings.report.chapters import Chapters
from drawings.report.table import REPORTS
from plans.checks.comparison import Comparison, Finding
from plans.study import Study
from plans.techniques import TECHNIQUES, named

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def report(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> str:
    """Write the report beside the sheets, whose leaves are given by kind."""
    told: list[Chapters] = [named(REPORTS[name].chapters)(study, leaves) for name in study.techniques]
    parts = [
        f"# {study.scene.title}: {', '.join(leaves)}",
        *(line for one in told for line in one.subject),
        *_comparison(study.comparisons),
        *(line for one in told for line in one.values),
        *(line for one in told for line in one.conditions),
        "\n## Left out\n",
        *(line for one in told for line in one.left_out),
        *(line for name in _idle(study) for line in named(REPORTS[name].idle)(study.scene)),
    ]
    return "\n".join(parts) + "\n"


def _idle(study: Study) -> Iterator[str]:
    """Give the techniques that rest on what is studied, and are not asked for."""
    rest = (name for name in REPORTS if name not in study.techniques)
    return (name for name in rest if not set(TECHNIQUES[name].needs).isdisjoint(study.techniques))


def headlines(study: Study) -> Iterator[str]:
    """Give what each technique says first of a study."""
    yield from filter(None, (named(REPORTS[name].headline)(study) for name in study.techniques))


def remarks(study: Study) -> list[str]:
    """Give what is not whole about a study: gaps, positions that are not for grading, pairs that jam."""
    return [line for name in study.techniques for line in named(REPORTS[name].remarks)(study)]


def faults(text: str, study: Study) -> Iterator[str]:
    """Give what a report tells otherwise than the analysis."""
    return (fault for name in study.techniques for fault in named(REPORTS[name].faults)(text, study))


def summary(comparisons: Iterable[Comparison]) -> str:
    """Give the short comparison: the worst difference of each plan in per cent of its largest, and of the allowed."""
    lines = [f"{'plan':<14} {'worst difference':>18} {'% of the largest':>18} {'of the allowed':>15}   in"]
    told = list(comparisons)
    for comparison in told:
        lines += [_worst(plan, comparison.of(plan)) for plan in _plans(comparison)]
    return "\n".join([*lines, *left_out(told)])


def _plans(comparison: Comparison) -> dict[str, None]:
    return dict.fromkeys(finding.plan for finding in comparison.findings)


def _worst(plan: str, findings: Sequence[Finding]) -> str:
    worst = max(findings, key=lambda finding: (peak(finding.excess), peak(finding.difference)))
    per_cent = max(finding.per_cent for finding in findings)
    return (
        f"{plan:<14} {peak(worst.difference):>13.2e} {worst.unit:<4} {per_cent:>18.2e} "
        f"{peak(worst.excess):>15.3f}   {worst.name}"
    )


def left_out(comparisons: Iterable[Comparison]) -> list[str]:
    """Tell which positions the comparisons leave out, as both roads give them up, and how many they are."""
    return [
        f"left out, given up by both roads ({plan}): {count_of(positions)} ({runs(positions, '-')})"
        for comparison in comparisons
        for plan, positions in comparison.left_out.items()
    ]


def count_of(positions: Sequence[int]) -> str:
    """Count positions in words."""
    return f"{len(positions)} position{'s' if len(positions) != 1 else ''}"


def _comparison(comparisons: Iterable[Comparison]) -> Iterator[str]:
    yield "\n## Comparison of construction and analysis\n"
    yield "Differences are per cent of the largest of their kind on the plan; the allowed one is derived from the"
    yield "conditions of the construction's steps and of the analytic Jacobian.\n"
    yield "| plan | quantity | worst difference | % of the largest | of the allowed |"
    yield "|---|---|---|---|---|"
    for finding in (finding for comparison in comparisons for finding in comparison.findings):
        yield (
            f"| {finding.plan} | {finding.name}, {finding.unit} | {peak(finding.difference):.2e} "
            f"| {finding.per_cent:.2e} | {peak(finding.excess):.3f} |"
        )


def peak(values: np.ndarray[tuple[int, ...], np.dtype[Any]]) -> float:
    """Give the largest of some numbers, gaps left out."""
    return float(np.nanmax(values)) if np.isfinite(values).any() else float(np.max(np.nan_to_num(values, nan=0.0)))
