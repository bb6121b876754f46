"""The self-check of a plan of velocities or accelerations on its sheet: heading, lines, Coriolis rules (планы)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.vectors import coriolis_rules, plan_headings, plan_lines
from drawings.checks.vectors.laid_vectors import LaidVectorPlan
from plans.words.words import Message


def faults(laid: LaidVectorPlan) -> Iterator[Message]:
    """Hold a plan that is drawn; of one that is not the figure says why."""
    yield from plan_headings.of_vectors(laid)
    yield from plan_lines.faults(laid)
    yield from coriolis_rules.faults(laid)
