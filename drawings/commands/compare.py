"""plandraft compare: construction against analysis, quantity by quantity."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.commands.stderr import noted
from drawings.files.atomic_files import print_json
from drawings.lettering.words import decimal
from drawings.report.report import left_out, plan_width, quantity
from plans.quantity import Comparison, Quantity, together
from plans.scene.scene import read_scene
from plans.study import Study
from plans.words.words import term, word

GAPS, FAILED = 4, 5
NAMED = 10  # letters of a quantity's name at the least


def run(options: argparse.Namespace) -> int:
    """Print the comparison; give the exit code."""
    study = Study(read_scene(options.scene))
    noted(study)
    comparisons = study.comparisons
    if options.json:
        print_json(_plain(study.scene.heading(), comparisons))
    else:
        print("\n".join(_table(comparisons, study.scene.sheet.language)))
    if not all(comparison.agrees for comparison in comparisons):
        return FAILED
    return GAPS if any(comparison.left_out for comparison in comparisons) else 0


def _plain(title: str, comparisons: Sequence[Comparison]) -> dict[str, object]:
    missing = {name: lost for comparison in comparisons for name, lost in comparison.left_out.items()}
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


def _table(comparisons: Sequence[Comparison], language: str) -> Iterator[str]:
    findings = together(comparisons)
    wide = plan_width((finding.plan for finding in findings), language)
    heads = [word(language, f"table.{head}") for head in ("plan", "quantity", "of_plan", "difference", "allowed_short")]
    named = max([NAMED, *(len(quantity(finding.name, language)) for finding in findings)])
    yield f"{heads[0]:<{wide}} {heads[1]:<{named}} {heads[2]:>14} {heads[3]:>17} {'%':>10} {heads[4]:>11}"
    for finding in findings:
        yield f"{term(language, 'plan', finding.plan):<{wide}} {_line(finding, named, language)}"
    yield from left_out(comparisons, language)
    for lone in (lone for comparison in comparisons for lone in comparison.alone):
        parts = {"position": lone.gap.position, "plan": lone.gap.plan, "reason": lone.gap.reason}
        yield word(language, f"compare.alone_{lone.by}", **parts)
    verdict = "agree" if all(comparison.agrees for comparison in comparisons) else "differ"
    worst = max(comparison.worst for comparison in comparisons)
    yield word(language, f"compare.{verdict}", worst=decimal(f"{worst:.3f}", language))


def _line(finding: Quantity, named: int, language: str) -> str:
    name, unit = quantity(finding.name, language), term(language, "unit", finding.unit)
    sizes = f"{finding.largest:>14.6g} {_worst(finding):>12.2e}"
    shares = f"{finding.per_cent:>8.1e} {float(finding.excess.max()):>11.3f}"
    return f"{name:<{named}} {decimal(sizes, language)} {unit:<6}{decimal(shares, language)}"


def _plain_finding(finding: Quantity) -> dict[str, object]:
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


def _worst(finding: Quantity) -> float:
    return float(np.nanmax(finding.difference)) if np.isfinite(finding.difference).any() else 0.0
