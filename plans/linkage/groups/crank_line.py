"""The crank and the coupler on it in one line: a rocker's and a slider's extremes (крайние положения; M1.2, M1.6)."""

from __future__ import annotations

from collections.abc import Callable

from geometry.board import Mark
from plans.linkage.groups import lead
from plans.linkage.plan import Plan
from plans.model.dyad import Dyad
from plans.words.words import because

# Meets an arc about the crank's pivot, on a side, with what guides the inner pin; the third is the name of the meeting.
Notch = Callable[[Mark, float, str], Mark]


def crank_end(plan: Plan, dyad: Dyad) -> int:
    """Tell by which of its two leads a group hangs on the crank."""
    return dyad.hosts.index(plan.mechanism.drive.link)


def pin(plan: Plan, dyad: Dyad) -> complex:
    """Give the vector from the crank's pivot to the pin that a group hangs on, in the crank's own frame, m."""
    points, drive = plan.mechanism.links[plan.mechanism.drive.link].points, plan.mechanism.drive
    return points[dyad.hinge(crank_end(plan, dyad))] - points[drive.pivot]


def end(plan: Plan) -> complex:
    """Give the vector from the crank's pivot to its end, in the crank's own frame, m."""
    points, drive = plan.mechanism.links[plan.mechanism.drive.link].points, plan.mechanism.drive
    return points[drive.end] - points[drive.pivot]


def extremes(plan: Plan, dyad: Dyad, side: float, notch: Notch) -> list[Mark]:
    """Notch the crank and the coupler in one line: |l2 + l1| and |l2 - l1| from O."""
    board, drive = plan.board, plan.mechanism.drive
    pivot, name = plan.point(drive.pivot), dyad.pin
    near, far = abs(pin(plan, dyad)), abs(lead.vector(plan, dyad, crank_end(plan, dyad)))
    found = []
    for number, radius in ((1, far + near), (2, abs(far - near))):
        arc = board.arc(f"{pivot.name}{name}_{number}", pivot, radius, because("in_line"))
        # Of the folded pair the coupler points away from O where it is the longer: then B sees A as before.
        flip = -1.0 if number == 2 and far < near else 1.0
        b = notch(arc, side * flip, f"{name}_{number}")
        ray = board.join(f"{pivot.name}{b.name}", pivot, b)
        sense = flip if number == 2 else -1.0
        by = -sense * near / radius * (end(plan) / pin(plan, dyad))
        arm = board.turn(f"{pivot.name}{drive.end}_{number}", ray, by, because("crank_on_line"))
        found.append(board.lay_off(f"{drive.end}_{number}", pivot, arm, because("extreme", number=number)))
    return found
