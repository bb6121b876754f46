"""A lead of a group: a link that turns about its outer hinge; what its plans have in common (поводок)."""

from __future__ import annotations

from collections.abc import Callable

from geometry.board import Mark
from geometry.steps import Reading
from plans.linkage.groups.vectors import Turning
from plans.linkage.plan import Image, Plan
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
    near, far = abs(pin(plan, dyad)), abs(vector(plan, dyad, crank_end(plan, dyad)))
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


def vector(plan: Plan, dyad: Dyad, end: int) -> complex:
    """Give the vector from a lead's outer hinge to the inner one in the link's own frame."""
    points = plan.mechanism.links[dyad.links[end]].points
    return points[dyad.pin] - points[dyad.hinge(end)]


def meeting(plan: Plan, dyad: Dyad) -> Mark:
    """Give the inner hinge: where it has no place, the group has none."""
    return plan.letters[dyad.pin]


def turning(dyad: Dyad, end: int) -> Turning:
    """Tell the vectors of the plans that a lead's turning about its outer hinge gives."""
    return Turning(dyad.links[end], dyad.hinge(end), dyad.pin)


def arm(plan: Plan, link: int) -> Mark:
    """Carry a lead's vector from the plan of positions."""
    return plan.carry(plan.arm(link))


def keep_place(plan: Plan, dyad: Dyad, end: int, start: Mark, tip: Mark) -> None:
    """Keep a lead on the plan of positions by the vector between its hinges."""
    link = plan.mechanism.links[dyad.links[end]]
    drawn = plan.board.join(f"{start.name}{tip.name}", start, tip, because("link", link=link.number))
    plan.images[link.number] = Image(start, drawn, link.points[dyad.hinge(end)], vector(plan, dyad, end))


def about(plan: Plan, link: int, start: Mark) -> Mark:
    """Draw the line of a lead's turning part: through a start, square to the lead."""
    along = arm(plan, link)
    return plan.board.square(f"⊥{along.name}", start, along, because("square_turning", line=along.name))


def normal(plan: Plan, link: int, start: Mark, ends: tuple[str, str]) -> Mark:
    """Lay off from an image a lead's normal acceleration, the third proportional v2/l, towards its start (M3.2).

    `ends` are the letters of the lead's start and tip: on the plan a start that translates may share another's image.
    """
    along, turning = arm(plan, link), plan.carry(plan.velocities.readings[link].turning)
    name = plan.written.normal(ends[1], "" if start is plan.pole else ends[0])
    part = plan.board.similar(f"a^{name}", turning, along, turning, why=because("normal", line=along.name))
    return plan.board.lay_off(name, start, part, because("to_centre"))


def meet_directions(plan: Plan, point: str, first: Mark, second: Mark) -> Mark:
    """Meet the two known directions in the image of the inner pair's point."""
    name = plan.letter(point)
    return plan.name(point, plan.board.meet(name, first, second, why=because("both_directions", point=name)))


def keep_turning(plan: Plan, link: int, start: Mark, turning_from: Mark, tip: Mark) -> None:
    """Keep a lead's image from start to tip, and the turning part that its omega or epsilon is read from."""
    base = plan.positions.images[link]
    relative = plan.board.join(f"{start.name}{tip.name}", start, tip)
    plan.images[link] = Image(start, relative, base.at, base.span)
    turning = relative
    if turning_from is not start:
        turning = plan.board.join(f"{turning_from.name}{tip.name}", turning_from, tip, because("tangential"))
    plan.readings[link] = Reading(arm(plan, link), turning)
