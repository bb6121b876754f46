"""The student's own places on the plans of one position, by the marks of the record (свои точки)."""

from __future__ import annotations

from collections.abc import Iterable

from drawings.grading.drawn_plan import DrawnPlan
from geometry.board import Mark
from plans.linkage.letters import POLES


def own_places(plans: Iterable[DrawnPlan]) -> dict[Mark, complex]:
    """Give where a student has the marks of the record, from the poles, true units."""
    found: dict[Mark, complex] = {}
    for plan in plans:
        for one in plan.asked.vectors:
            if one.found is not None and one.letter:
                value = plan.value(one.letters)
                found |= {} if value is None else {one.found.span.end: value}
            elif one.found is not None:
                found |= _of(plan, one.found.span.start, one.start)
                found |= _of(plan, one.found.span.end, one.end)
    return found


def scales_of(plan: DrawnPlan, beside: Iterable[DrawnPlan]) -> dict[str, float]:
    """Give the scales of a student's plans by their names and by their boards, whose coarsest counts; its own last."""
    found: dict[str, float] = {}
    for one in beside:
        board = one.asked.board or one.asked.plan
        found[board] = max(one.scale, found.get(board, 0.0))
    return found | {plan.asked.plan: plan.scale}


def left_out(plans: Iterable[DrawnPlan]) -> dict[Mark, complex]:
    """Give the free vectors that a student has left out: to him they are nothing."""
    own = ((plan, one) for plan in plans for one in plan.lacking)
    return {one.found.span.end: 0j for _, one in own if one.found is not None and one.letter}


def _of(plan: DrawnPlan, mark: Mark, letter: str) -> dict[Mark, complex]:
    """Give the place of a mark; the pole is where it is, and nothing is measured from anywhere else."""
    pole = POLES.get(plan.asked.plan, "")
    pole = pole if pole in plan.places else ""  # on the plan of positions no arrow goes from the datum
    place = plan.between(pole, letter)
    return {} if place is None or letter == pole else {mark: place}
