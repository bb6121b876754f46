"""Agreement of the two roads: no sheet is drawn of what construction and analysis tell otherwise (согласие)."""

from __future__ import annotations

from drawings.checks.verify import SelfCheckFailed
from plans.checks.comparison import Comparison, Lone
from plans.words.words import Message, message


def agree(comparison: Comparison) -> None:
    """See that both roads find the same within what is allowed, and name the same gaps."""
    told = disagreement(comparison)
    if told is not None:
        raise told


def disagreement(comparison: Comparison) -> SelfCheckFailed | None:
    """Say in what both roads differ by more than is allowed, or which gap one of them alone names."""
    for lone in comparison.alone[:1]:
        return SelfCheckFailed(_alone(lone))
    return SelfCheckFailed(comparison.apart) if comparison.worst > 1.0 else None


def _alone(lone: Lone) -> Message:
    return message(f"check.{lone.by}", position=lone.gap.position, plan=lone.gap.plan, reason=lone.gap.reason)
