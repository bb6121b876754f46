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
from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES
from plans.linkage.travel import Travel, frame_slide
from plans.model.dyad import Group
from plans.model.machine import by_time, works
from plans.model.mechanism import FRAME, SLOWER, Mechanism, Output
from plans.model.motion import Extremes, Floats

# A notched extreme and a velocity of zero are one position when their crank angles agree to half the digits: the
# coordinate of an extreme is stationary, so half its digits is all that a root found by its value could tell.
SAME = 1e-7
# Strokes whose crank arcs differ by less than this (rad) are equal: rounding of two notches, each with a root.
EQUAL = 1e-7
CLEAR = 64 * 2 * np.pi * np.finfo(float).eps  # rad: what roundings leave of an angle that is none
STILL = CrankPositions(np.zeros(1), np.ones(1, dtype=complex))  # a crank to draw extremes over: at any angle


class ExtremePositions(NamedTuple):
    """Extremes with the crank's directions there, for a turn that starts exactly at one of them."""

    extremes: Extremes
    directions: tuple[complex, complex]
    notched: Plan | None  # the construction that found them, None where the velocity plan did
    rests: tuple[float, ...]  # all crank angles, rad, in which the output reverses: more than two have no time ratio


def output(mechanism: Mechanism, groups: Sequence[Group]) -> Output:
    """Give the output link: the scene's own, or the last link on the frame of the last group, or else its last link."""
    if mechanism.output is not None:
        return mechanism.output
    link = mechanism.drive.link
    if groups:
        link = max([lead for host, lead, _ in groups[-1].outer_pairs if host == FRAME] or groups[-1].links)
    slide = frame_slide(mechanism, link)
    return Output(link, slide.point if slide else None, mechanism.working)


def notches(mechanism: Mechanism, groups: Sequence[Group], sides: Sequence[float]) -> tuple[Plan, list[Mark]] | None:
    """Construct the crank's two extreme directions for the first group that joins crank and frame; None for others.

    The marks are the crank's end in both extremes.
    """
    for group, side in zip(groups, sides, strict=True):
        construct = KINDS[group.kind].extremes
        if construct is not None and {pair.giver for pair in group.outer_pairs} == {mechanism.drive.link, FRAME}:
            plan = PRIMARIES[mechanism.drive.kind].positions(mechanism, STILL)
            if marks := construct(plan, group, side):
                return plan, marks
    return None


def extremes(sweep: Sweep, out: Output) -> ExtremePositions | None:
    """Find the output's two extreme positions over a free turn; None where it has none, as a link that turns fully.

    The working stroke comes first (рабочий ход): that to which the crank gives the larger angle, or as the output says.
    """
    turns = out.link == sweep.mechanism.drive.link and out.parting is None
    if turns or not sweep.mechanism.drive.turns or sweep.barred:
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
    order = _slower(places, low, high, sweep.mechanism.drive.omega)
    phi = [_cleared(float(np.angle(exact.directions[k]) % (2 * np.pi))) for k in order]
    sense = -1.0 if sweep.mechanism.drive.omega < 0 else 1.0
    more = (sense * (phi[1] - phi[0])) % (2 * np.pi) - np.pi
    back = _turned(sweep.mechanism, out, [float(reach[k]) for k in order], equal=more < EQUAL)
    first, second = order[::-1] if back else order
    begun = (phi[1], phi[0]) if back else (phi[0], phi[1])
    reached = float(reach[first]), float(reach[second])
    found = Extremes(begun, reached, travel.sliding, _cleared(max(more, 0.0)), back and more >= EQUAL)
    by_notch = drawn[0] if drawn and all(directions[k][1] for k in (first, second)) else None
    return ExtremePositions(
        found, (complex(exact.directions[first]), complex(exact.directions[second])), by_notch, tuple(places)
    )


def _resting(sweep: Sweep) -> Sweep:
    """Give the crank a speed: extremes are the same at any speed, and must be found at rest too."""
    mechanism = sweep.mechanism
    if abs(mechanism.drive.omega) == 1:
        return sweep
    return sweep.over(replace(mechanism, drive=mechanism.drive._replace(omega=1.0, epsilon=0.0)))


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


def _turned(mechanism: Mechanism, out: Output, reach: Sequence[float], equal: bool) -> bool:
    """Tell whether the working stroke is not the slower one, by its two coordinates; of equal ones time tells none."""
    if by_time(out):
        return out.working != SLOWER and not equal
    return not works(mechanism, out, *reach)


def _slower(rests: list[float], low: int, high: int, omega: float) -> tuple[int, int]:
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


def _cleared(angle: float) -> float:
    """Count an angle that roundings leave beside nothing or beside a whole turn as zero."""
    return 0.0 if min(angle, 2 * np.pi - angle) <= CLEAR else angle
