"""The crank on the frame: the primary link that a hinge of the frame carries, and its plans (кривошип)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from geometry.steps import Reading
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.groups import lead
from plans.linkage.groups.vectors import Turning, Vector
from plans.linkage.plan import Image, Plan
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Complexes, Rates
from plans.words.words import because

FREE = "φ"


def values(mechanism: Mechanism, turn: CrankPositions) -> Complexes:
    """Give its directions, (N,)."""
    return turn.directions


def ends(mechanism: Mechanism, turn: CrankPositions) -> Complexes:
    """Give the places of its end, (N,) m."""
    drive = mechanism.drive
    points = mechanism.links[drive.link].points
    arm = abs(points[drive.end] - points[drive.pivot])
    return np.asarray(mechanism.links[FRAME].points[drive.pivot] + arm * turn.directions)


def positions(mechanism: Mechanism, turn: CrankPositions) -> Plan:
    """Start a plan of positions: the fixed hinge, the crank circle and the crank's end at every angle."""
    plan = Plan("positions", mechanism)
    drive, points = mechanism.drive, mechanism.links[mechanism.drive.link].points
    pivot = plan.point(drive.pivot)
    lead = points[drive.end] - points[drive.pivot]
    circle = plan.board.arc(f"{drive.pivot}{drive.end}", pivot, abs(lead), because("crank_circle"))
    angles = plan.board.given(FREE, turn.directions, because("crank_directions"))
    end = plan.name(drive.end, plan.board.divide(drive.end, circle, angles, because("divided")))
    arm = plan.board.join(f"{drive.pivot}{drive.end}", pivot, end, because("link", link=drive.link))
    plan.images[drive.link] = Image(pivot, arm, points[drive.pivot], lead)
    return plan


def velocities(plan: Plan, rates: Rates) -> None:
    """Lay off from the pole the velocity of the crank's end, square to the crank."""
    drive = plan.mechanism.drive
    base, arm = plan.positions.images[drive.link], plan.carry(plan.arm(drive.link))
    part = plan.board.turn(f"v_{drive.end}", arm, 1j * rates.omega, because("crank_velocity"))
    tip = plan.board.lay_off(plan.letter(drive.end), plan.pole, part, because("crank_end_velocity"))
    end = plan.name(drive.end, tip)
    relative = plan.board.join(f"{plan.pole.name}{end.name}", plan.pole, end)
    plan.images[drive.link] = Image(plan.pole, relative, base.at, base.span)
    plan.readings[drive.link] = Reading(arm, relative)


def accelerations(plan: Plan, rates: Rates) -> None:
    """Lay off from the pole the normal and the tangential acceleration of the crank's end."""
    drive = plan.mechanism.drive
    base = plan.positions.images[drive.link]
    normal = lead.normal(plan, drive.link, plan.pole, (drive.pivot, drive.end))
    arm = lead.arm(plan, drive.link)
    why = because("crank_tangential") if np.any(rates.epsilon) else because("even")
    part = plan.board.turn(f"a^t_{drive.end}", arm, 1j * rates.epsilon, why)
    tip = plan.board.lay_off(plan.letter(drive.end), normal, part, because("crank_end_acceleration"))
    end = plan.name(drive.end, tip)
    whole = plan.board.join(f"{plan.pole.name}{end.name}", plan.pole, end)
    plan.images[drive.link] = Image(plan.pole, whole, base.at, base.span)
    plan.readings[drive.link] = Reading(arm, part)


def vectors(mechanism: Mechanism) -> Iterator[Vector]:
    """Tell the vectors of its plans: its end turns about its fixed hinge."""
    yield Turning(mechanism.drive.link, mechanism.drive.pivot, mechanism.drive.end)
