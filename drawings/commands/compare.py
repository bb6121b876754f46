"""plandraft compare: construction against analysis, quantity by quantity."""

from __future__ import annotations

import argparse

import numpy as np

from drawings.commands.talk import noted
from drawings.files.json_text import print_json
from drawings.report.report import left_out
from plans.checks.compare import Comparison, Finding, compare, compare_extremes
from plans.linkage.study import LinkageStudy
from plans.scene.scene import read_scene

GAPS, FAILED = 4, 5


def run(options: argparse.Namespace) -> int:
    """Print the comparison; give the exit code."""
    study = LinkageStudy(noted(read_scene(options.scene)))
    comparison = compare_extremes(study, compare(study))
    if "forces" in study.scene.sheets:
        from plans.checks.force_comparison import compare_forces
        from plans.forces.statics import Statics

        comparison = compare_forces(Statics(study), comparison)
    if options.json:
        print_json(_told(study, comparison))
    else:
        print(_table(comparison))
    if not comparison.agrees:
        return FAILED
    gaps = comparison.construction.gaps if comparison.forces is None else comparison.forces[0].gaps
    return GAPS if gaps else 0


def _told(study: LinkageStudy, comparison: Comparison) -> dict[str, object]:
    alone = [
        {"position": gap.position, "by": road.by, "plan": gap.plan, "reason": gap.reason}
        for road, gap in comparison.alone
    ]
    return {
        "scene": study.scene.title,
        "findings": [_plain(finding) for finding in comparison.findings],
        "left_out": comparison.left_out,
        "alone": alone,
    }


def _table(comparison: Comparison) -> str:
    lines = [f"{'plan':<14} {'quantity':<10} {'of its plan':>14} {'worst difference':>17} {'%':>10} {'of allowed':>11}"]
    for finding in comparison.findings:
        worst = _worst(finding)
        lines.append(
            f"{finding.plan:<14} {finding.name:<10} {finding.largest:>14.6g} {worst:>12.2e} {finding.unit:<6}"
            f"{finding.per_cent:>8.1e} {float(finding.excess.max()):>11.3f}"
        )
    lines += left_out(comparison)
    lines += [
        f"position {gap.position}: the {road.by} alone says {gap.plan}: {gap.reason}" for road, gap in comparison.alone
    ]
    verdict = "agree" if comparison.agrees else "DIFFER"
    lines.append(f"construction and analysis {verdict}: worst {comparison.worst:.3f} of the allowed difference")
    return "\n".join(lines)


def _plain(finding: Finding) -> dict[str, object]:
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
