"""Agreement of the two roads: no sheet is drawn of what construction and analysis tell otherwise (согласие)."""

from __future__ import annotations

from drawings.checks.verify import SelfCheckFailed
from plans.checks.comparison import Comparison, Lone
from plans.words.words import Message, message


def agree(comparison: Comparison) -> None:
    """See that both roads find the same within what is allowed, and name the same gaps."""
    for lone in comparison.alone[:1]:
        raise SelfCheckFailed(_alone(lone))
    if comparison.worst > 1.0:
        raise SelfCheckFailed(comparison.apart)


def _alone(lone: Lone) -> Message:
    return message(f"check.{lone.by}", position=lone.gap.position, plan=lone.gap.plan, reason=lone.gap.reason)
