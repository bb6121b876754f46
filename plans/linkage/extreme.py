"""Extreme positions of the output link, its stroke and time ratio (крайние положения, ход, угол перекрытия).

Where the group on the crank is a rocker, a slider or a slotted link, its extremes are notched (M1.2, M1.6, M1.7);
elsewhere, and as a check, they are the positions in which the velocity plan gives the output no velocity.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from geometry.board import Mark, at
from plans.linkage.assembly_limits import Sweep
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.groups import guide, lead
from plans.linkage.plan import Plan
from plans.linkage.position import crank
from plans.linkage.travel import Travel, frame_slide
from plans.model.mechanism import FRAME, Mechanism, Output
from plans.model.motion import Extremes, Floats
from plans.model.structure import Dyad
from plans.words.words import because

# A notched extreme and a velocity of zero are one position when their crank angles agree to half the digits: the
# coordinate of an extreme is stationary, so half its digits is all that a root found by its value could tell.
SAME = 1e-7
# Strokes whose crank arcs differ by less than this (rad) are equal: rounding of two notches, each with a root.
EQUAL = 1e-7


class Found(NamedTuple):
    """Extremes with the crank's directions there, for a turn that starts exactly at one of them."""

    extremes: Extremes
    directions: tuple[complex, complex]
    notched: Plan | None  # the construction that found them, None where the velocity plan did
    rests: tuple[float, ...]  # all crank angles, rad, in which the output reverses: more than two have no time ratio


def output(mechanism: Mechanism, groups: Sequence[Dyad]) -> Output:
    """Give the output link: the scene's own, or the last link on the frame of the last group, or else its last link."""
    if mechanism.output is not None:
        return mechanism.output
    link = mechanism.drive.link
    if groups:
        leads = list(zip(groups[-1].links, groups[-1].hosts, strict=True))
        link = max([lead for lead, host in leads if host == FRAME] or groups[-1].links)
    slide = frame_slide(mechanism, link)
    return Output(link, slide.point if slide else None)


def notches(mechanism: Mechanism, groups: Sequence[Dyad], sides: Sequence[float]) -> tuple[Plan, list[Mark]] | None:
    """Construct the crank's two extreme directions for the first group that joins crank and frame; None for others.

    The marks are the crank's end in both extremes.
    """
    drive = mechanism.drive
    for group, side in zip(groups, sides, strict=True):
        on_crank = set(group.hosts) == {drive.link, FRAME}
        if on_crank and (group.kind in ("RRR", "RPR") or (group.kind == "RRP" and group.hosts[0] == drive.link)):
            plan = crank(mechanism, CrankPositions(np.zeros(1), np.ones(1, dtype=complex)))
            draw = _slot_tangents if group.kind == "RPR" else _stretched_and_folded
            return plan, draw(plan, group, side)
    return None


def _stretched_and_folded(plan: Plan, group: Dyad, side: float) -> list[Mark]:
    """Notch the crank and the coupler in one line: |l2 + l1| and |l2 - l1| from O (M1.2, M1.6)."""
    board, drive = plan.board, plan.mechanism.drive
    end = group.hosts.index(drive.link)
    pivot, name = plan.point(drive.pivot), group.pin
    radius_of_pin = _pin(plan, group, end)
    near, far = abs(radius_of_pin), abs(lead.vector(plan, group, end))
    found = []
    for number, radius in ((1, far + near), (2, abs(far - near))):
        arc = board.arc(f"{pivot.name}{name}_{number}", pivot, radius, because("in_line"))
        # Of the folded pair the coupler points away from O where it is the longer: then B sees A as before.
        flip = -1.0 if number == 2 and far < near else 1.0
        b = _notch(plan, group, end, arc, side * flip, f"{name}_{number}")
        ray = board.join(f"{pivot.name}{b.name}", pivot, b)
        sense = flip if number == 2 else -1.0
        by = -sense * near / radius * (_end(plan) / radius_of_pin)
        arm = board.turn(f"{pivot.name}{drive.end}_{number}", ray, by, because("crank_on_line"))
        found.append(board.lay_off(f"{drive.end}_{number}", pivot, arm, because("extreme", number=number)))
    return found


def _notch(plan: Plan, group: Dyad, end: int, arc: Mark, side: float, name: str) -> Mark:
    """Meet an arc about the crank's pivot with what guides the inner pin: an arc about C, or a guide."""
    board = plan.board
    if group.kind == "RRP":
        left = guide.offset(plan, group.slide(1), group.links[1], group.pin).left
        return board.meet(name, guide.line(plan, group.slide(1), FRAME, left), arc, side, because("arc_guide"))
    fixed = plan.point(group.hinge(1 - end))
    other = board.arc(f"{fixed.name}{name}", fixed, abs(lead.vector(plan, group, 1 - end)), because("rocker_end"))
    return board.meet(name, arc, other, side if end == 0 else -side, because("arcs"))


def _slot_tangents(plan: Plan, group: Dyad, side: float) -> list[Mark]:
    """Draw from the slotted link's pivot the tangents to the crank circle: the crank is square to the slot (M1.7)."""
    board, drive = plan.board, plan.mechanism.drive
    end = group.hosts.index(drive.link)
    sense = 1.0 if end == 0 else -1.0
    left = [guide.offset(plan, group.slide(), group.links[e], group.hinge(e)).left for e in (0, 1)]
    pivot, fixed = plan.point(drive.pivot), plan.point(group.hinge(1 - end))
    radius_of_pin = _pin(plan, group, end)
    near, found = abs(radius_of_pin), []
    for number, off in ((1, near), (2, -near)):
        slot = board.tangent(
            f"u_{number}", fixed, pivot, sense * (left[0] - left[1]) + off, sense * side, because("tangent")
        )
        by = -1j * off * (_end(plan) / radius_of_pin)
        arm = board.turn(f"{pivot.name}{drive.end}_{number}", slot, by, because("crank_square"))
        found.append(board.lay_off(f"{drive.end}_{number}", pivot, arm, because("extreme", number=number)))
    return found


def _pin(plan: Plan, group: Dyad, end: int) -> complex:
    """Give the vector from the crank's pivot to the pin that a group hangs on, in the crank's own frame."""
    points, drive = plan.mechanism.links[plan.mechanism.drive.link].points, plan.mechanism.drive
    return points[group.hinge(end)] - points[drive.pivot]


def _end(plan: Plan) -> complex:
    """Give the vector from the crank's pivot to its end, in the crank's own frame."""
    points, drive = plan.mechanism.links[plan.mechanism.drive.link].points, plan.mechanism.drive
    return points[drive.end] - points[drive.pivot]


def extremes(sweep: Sweep, out: Output) -> Found | None:
    """Find the output's two extreme positions over a free turn; None where it has none, as a link that turns fully.

    The working stroke, to which the crank gives the larger angle, comes first (рабочий ход).
    """
    if out.link == sweep.mechanism.drive.link or sweep.barred:
        return None
    travel = Travel(_resting(sweep), out)
    rests = travel.rests()
    if len(rests) < 2 or travel.turns_fully:
        return None
    drawn = notches(sweep.mechanism, sweep.groups, sweep.sides)
    directions = [_notched(drawn, rest) for rest in rests.tolist()]
    exact = CrankPositions(rests, np.array([d for d, _ in directions]))
    reach = _reaches(travel, exact)
    places: list[float] = rests.tolist()
    low, high = _farthest(places, -reach), _farthest(places, reach)
    if not reach[low] < reach[high]:
        return None
    first, second = _working(places, low, high, sweep.mechanism.drive.omega)
    phi = [float(np.angle(exact.directions[k]) % (2 * np.pi)) for k in (first, second)]
    sense = -1.0 if sweep.mechanism.drive.omega < 0 else 1.0
    work = (sense * (phi[1] - phi[0])) % (2 * np.pi)
    found = Extremes(
        (phi[0], phi[1]), (float(reach[first]), float(reach[second])), travel.sliding, max(work - np.pi, 0.0)
    )
    by_notch = drawn[0] if drawn and all(directions[k][1] for k in (first, second)) else None
    return Found(found, (complex(exact.directions[first]), complex(exact.directions[second])), by_notch, tuple(places))


def _resting(sweep: Sweep) -> Sweep:
    """Give the crank a speed: extremes are the same at any speed, and must be found at rest too."""
    mechanism = sweep.mechanism
    if abs(mechanism.drive.omega) == 1:
        return sweep
    return sweep.over(replace(mechanism, drive=replace(mechanism.drive, omega=1.0, epsilon=0.0)))


def _notched(drawn: tuple[Plan, list[Mark]] | None, rest: float) -> tuple[complex, bool]:
    """Give the crank's direction at a rest: the notched one where it is the same position."""
    if drawn is not None:
        plan, marks = drawn
        pivot = plan.point(plan.mechanism.drive.pivot)
        for mark in marks:
            ray = at(mark.point, 0) - at(pivot.point, 0)
            direction = ray / abs(ray)
            if abs(np.angle(direction * np.exp(-1j * rest))) < SAME:
                return direction, True
    return complex(np.exp(1j * rest)), False


def _reaches(travel: Travel, turn: CrankPositions) -> Floats:
    """Give the output's coordinate at some crank positions, angles unwrapped along the turn."""
    reach = travel.coordinate(turn)
    if travel.sliding:
        return reach
    near = np.interp(np.mod(turn.phi, 2 * np.pi), *travel.path)
    return np.asarray(near + np.angle(np.exp(1j * (reach - near))))


def _working(rests: list[float], low: int, high: int, omega: float) -> tuple[int, int]:
    """Order two rests so that the crank turns through the larger angle from the first to the second."""
    sense = -1.0 if omega < 0 else 1.0
    there = (sense * (rests[high] - rests[low])) % (2 * np.pi)
    if abs(there - np.pi) < EQUAL:  # equal strokes: begin where the crank angle is the smaller
        return (low, high) if _within(rests[low]) < _within(rests[high]) else (high, low)
    return (low, high) if there > np.pi else (high, low)


def _farthest(rests: list[float], reach: Floats) -> int:
    """Give the rest of the greatest reach; of several within their rounding, the first of the turn."""
    most = float(reach.max()) - EQUAL * float(np.ptp(reach))
    return min((k for k in range(len(rests)) if reach[k] >= most), key=lambda k: _within(rests[k]))


def _within(angle: float) -> float:
    """Count an angle that a rounding leaves short of a whole turn as zero."""
    return 0.0 if 2 * np.pi - angle < EQUAL else angle
