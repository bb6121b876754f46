"""plandraft compare: construction against analysis, quantity by quantity."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.commands.talk import noted
from drawings.files.json_text import print_json
from drawings.report.report import left_out
from plans.checks.comparison import Comparison, Finding
from plans.scene.scene import read_scene
from plans.study import Study

GAPS, FAILED = 4, 5


def run(options: argparse.Namespace) -> int:
    """Print the comparison; give the exit code."""
    study = Study(read_scene(options.scene))
    noted(study)
    comparisons = study.comparisons
    if options.json:
        print_json(_plain(study.scene.title, comparisons))
    else:
        print("\n".join(_table(comparisons)))
    if not all(comparison.agrees for comparison in comparisons):
        return FAILED
    return GAPS if comparisons[-1].construction.gaps else 0


def _plain(title: str, comparisons: Sequence[Comparison]) -> dict[str, object]:
    missing: dict[str, list[int]] = {}
    for comparison in comparisons:
        missing |= comparison.left_out
    return {
        "scene": title,
        "findings": [_plain_finding(finding) for comparison in comparisons for finding in comparison.findings],
        "left_out": missing,
        "alone": [
            {"position": lone.gap.position, "by": lone.by, "plan": lone.gap.plan, "reason": lone.gap.reason}
            for comparison in comparisons
            for lone in comparison.alone
        ],
    }


def _table(comparisons: Sequence[Comparison]) -> Iterator[str]:
    yield f"{'plan':<14} {'quantity':<10} {'of its plan':>14} {'worst difference':>17} {'%':>10} {'of allowed':>11}"
    for comparison in comparisons:
        yield from map(_line, comparison.findings)
    yield from left_out(comparisons)
    for lone in (lone for comparison in comparisons for lone in comparison.alone):
        yield f"position {lone.gap.position}: the {lone.by} alone says {lone.gap.plan}: {lone.gap.reason}"
    verdict = "agree" if all(comparison.agrees for comparison in comparisons) else "DIFFER"
    worst = max(comparison.worst for comparison in comparisons)
    yield f"construction and analysis {verdict}: worst {worst:.3f} of the allowed difference"


def _line(finding: Finding) -> str:
    return (
        f"{finding.plan:<14} {finding.name:<10} {finding.largest:>14.6g} {_worst(finding):>12.2e} {finding.unit:<6}"
        f"{finding.per_cent:>8.1e} {float(finding.excess.max()):>11.3f}"
    )


def _plain_finding(finding: Finding) -> dict[str, object]:
    excess = float(finding.excess.max())
    return {
        "plan": finding.plan,
        "name": finding.name,
        "unit": finding.unit,
        "largest": finding.largest,
        "difference": _worst(finding),
        "per_cent": finding.per_cent,
        "of_allowed": excess if np.isfinite(excess) else None,
    }


def _worst(finding: Finding) -> float:
    return float(np.nanmax(finding.difference)) if np.isfinite(finding.difference).any() else 0.0
