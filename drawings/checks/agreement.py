"""Agreement of the two roads: no sheet is drawn of what construction and analysis tell otherwise (согласие)."""

from __future__ import annotations

from drawings.checks.verify import SelfCheckFailed
from plans.checks.comparison import Comparison, Lone

ROADS = ("construction", "analysis")


def agree(comparison: Comparison) -> None:
    """See that both roads find the same within what is allowed, and name the same gaps."""
    for lone in comparison.alone[:1]:
        raise SelfCheckFailed(_alone(lone))
    if comparison.worst > 1.0:
        raise SelfCheckFailed(_apart(comparison))


def _alone(lone: Lone) -> str:
    other = ROADS[1 - ROADS.index(lone.by)]
    position = f"position {lone.gap.position} ({lone.gap.plan}: {lone.gap.reason})"
    return f"{lone.by} gives up {position} and {other} does not; the sheet is withheld"


def _apart(comparison: Comparison) -> str:
    worst = max(comparison.findings, key=lambda finding: float(finding.excess.max()))
    if worst.plan == "positions":
        return (
            f"construction and analysis assemble the mechanism in two ways (they differ in {worst.name}); "
            "the sheet is withheld. Fix: show more points in mechanism.sketch, nearer to where they are at the "
            "first position"
        )
    return (
        f"construction and analysis differ in {worst.name}: {float(worst.excess.max()):.3g} times the allowed "
        "difference; the sheet is withheld"
    )
