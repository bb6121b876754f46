"""The primary link under its forces: what the drive must give, and what the frame (начальное звено; 6.4.5)."""

from __future__ import annotations

import cmath
from typing import NamedTuple

from geometry.board import Mark
from plans.forces import polygon as statics
from plans.forces.cut import CLOSING, PART, Cut, Equation, ForcePlan, Load, Side, indices
from plans.linkage import leads
from plans.model.machine import FORCE, GEAR, Transmission
from plans.model.mechanism import FRAME, Drive, Slide
from plans.words.words import because

DRIVING, BALANCING = "P_bal", "M_bal"
NOTHING = because("no_moment")


class BalancingQuantity(NamedTuple):
    """What the drive is told to give: its letters, its unit, and how much of it a balancing moment of 1 N*m is."""

    name: str
    unit: str
    share: float = 1.0


def balancing_quantity(drive: Drive) -> BalancingQuantity:
    """Give what is told of a drive: the moment on the shaft of a crank, the force of a slide or of a cylinder."""
    by_force = drive.pushed or drive.ram is not None
    return BalancingQuantity(DRIVING, "N", 1.0 / drive.unit) if by_force else BalancingQuantity(BALANCING, "N*m")


def primary(plan: ForcePlan) -> Cut:
    """Balance the primary link, and close its polygon in the frame: a crank by moments, a slide along its guide."""
    slide = plan.mechanism.drive.guide
    return _turned(plan) if slide is None else _pushed(plan, slide)


def _pushed(plan: ForcePlan, slide: Slide) -> Cut:
    """Close the polygon of a slide along its guide and square to it; no moment is needed for what pushes it."""
    drive, board = plan.mechanism.drive, plan.board
    (loads, couples), along = plan.acting(drive.link), leads.direction(plan.positions, slide, FRAME)
    laid = statics.chain(plan, str(drive.link), *statics.known_sides(loads))
    lead = statics.direction_on(plan, along)
    lines = (
        board.parallel(f"∥{lead.name}", laid.start, lead, because("pushed_along")),
        board.square(f"⊥{lead.name}", laid.end, lead, because("guide_presses")),
    )
    name = f"R_{indices(FRAME, drive.link)}"
    closed = statics.close(plan, laid, (DRIVING, name), lines)
    plan.driven = _foot(plan, slide, along)
    plan.drive = board.join(DRIVING, closed.corner, laid.start, because("closing"))
    plan.shaft = _wheel(plan, along, plan.driven)
    plan.balancing = board.moment(BALANCING, plan.shaft, plan.driven, plan.drive, because("wheel_moment"))
    force = board.join(name, laid.end, closed.corner, because("closing"))
    pushing = Load(DRIVING, drive.link, plan.driven, plan.drive, PART)
    support = statics.support(plan, (FRAME, drive.link), slide, force, (), [*loads, pushing], couples)
    return Cut(None, (drive.link,), tuple(loads), tuple(couples), (support,), None, (), closed.polygon)


def _foot(plan: ForcePlan, slide: Slide, along: Mark) -> Mark:
    """Give where a slide is pushed: its named point, or the foot of that on the guide's line."""
    point, board = plan.positions.point(slide.point), plan.positions.board
    left = leads.offset(plan.positions, slide, slide.slider, slide.point).left
    if not left:
        return point
    back = board.turn(f"h{slide.slider}'", along, -1j * left, because("offset"))
    return board.lay_off(f"{slide.point}''", point, back, because("pushed_along"))


def _wheel(plan: ForcePlan, along: Mark, end: Mark) -> Mark:
    """Mark the centre of the wheel that would roll on the slide, of the drive's unit as its radius."""
    board, unit = plan.positions.board, plan.mechanism.drive.unit
    arm = board.turn(f"r{plan.mechanism.drive.link}", along, 1j * unit, because("wheel_radius"))
    return board.lay_off(f"W{plan.mechanism.drive.link}", end, arm, because("wheel_centre"))


def _turned(plan: ForcePlan) -> Cut:
    """Balance the crank by moments about its shaft, then close its polygon in the frame (figure 6.17)."""
    drive, board = plan.mechanism.drive, plan.board
    shaft, (loads, couples) = plan.positions.point(drive.pivot), plan.acting(drive.link)
    plan.shaft = shaft
    terms, line = statics.moments(plan, shaft, loads, couples), _line(plan)
    why, driving = because("moments", point=shaft.name, link=drive.link), list[tuple[str, Mark, str]]()
    if line is None:
        plan.balancing = board.close(BALANCING, *terms, why=why) if terms else board.given(BALANCING, 0.0, NOTHING)
    else:
        plan.driven = line.step.inputs[0]
        plan.drive = (
            board.balance(DRIVING, shaft, line, *terms, why=why) if terms else board.given(DRIVING, 0j, NOTHING)
        )
        plan.balancing = board.moment(BALANCING, shaft, plan.driven, plan.drive, because("driving_moment"))
        driving = [(DRIVING, plan.drive, PART)]
    armed = tuple(load for load in loads if load.at is not shaft)
    equation = Equation(shaft, armed, tuple(couples), line, plan.drive or plan.balancing)
    laid = statics.chain(plan, str(drive.link), *driving, *statics.known_sides(loads))
    name = f"R_{indices(FRAME, drive.link)}"
    force = board.join(name, laid.end, laid.start, because("closing"))
    support = statics.support(plan, (FRAME, drive.link), drive.pivot, force)
    sides = (*laid.sides, Side(name, laid.end, laid.start, CLOSING))
    return Cut(None, (drive.link,), tuple(loads), tuple(couples), (support,), None, (equation,), sides)


def _line(plan: ForcePlan) -> Mark | None:
    """Draw the line along which the crank is driven; None where a moment drives it."""
    base, drive, how = plan.positions, plan.mechanism.drive, plan.machine.transmission
    if how.kind == FORCE:
        arm = base.arm(drive.link)
        return base.board.square(f"⊥{arm.name}", base.point(drive.end), arm, because("driving_square"))
    if how.kind == GEAR:
        pitch = base.board.given("W", cmath.rect(how.radius, how.at), because("pitch_point"))
        along = plan.board.given("line of action", action(how, drive.omega), because("pressure_angle"))
        return base.board.parallel("line of action", pitch, along, because("line_of_action"))
    return None


def action(gear: Transmission, omega: float) -> complex:
    """Give the direction in which the pinion's tooth presses: with the rotation, turned towards the wheel's centre.

    The pitch tangent in the sense of rotation, turned by the pressure angle (book figure 6.17, M5.7).
    """
    sense = -1.0 if omega < 0 else 1.0
    return sense * 1j * cmath.exp(1j * (gear.at + sense * gear.pressure))
