"""The primary link under its forces: what the drive must give, and what the frame (начальное звено; 6.4.5)."""

from __future__ import annotations

import cmath

from geometry.board import Mark
from plans.forces import polygon as statics
from plans.forces.cut import CLOSING, PART, Cut, Equation, Side, indices
from plans.forces.force import ForcePlan
from plans.model.machine import FORCE, GEAR, Transmission
from plans.model.mechanism import FRAME
from plans.words.words import because

DRIVING, BALANCING = "P_bal", "M_bal"
NOTHING = because("no_moment")


def primary(plan: ForcePlan) -> Cut:
    """Balance the crank by moments about its shaft, then close its polygon in the frame (figure 6.17)."""
    drive, board = plan.mechanism.drive, plan.board
    shaft, (loads, couples) = plan.positions.point(drive.pivot), plan.acting(drive.link)
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
    laid = statics.chain(plan, str(drive.link), *driving, *statics.known(loads))
    name = f"R_{indices(FRAME, drive.link)}"
    force = board.join(name, laid.end, laid.start, because("closing"))
    support = statics.support(plan, (FRAME, drive.link), drive.pivot, force)
    sides = (*laid.sides, Side(name, laid.end, laid.start, CLOSING))
    return Cut(None, (drive.link,), tuple(loads), tuple(couples), (support,), None, (equation,), sides)


def _line(plan: ForcePlan) -> Mark | None:
    """Draw the line along which the crank is driven; None where a moment drives it."""
    base, drive, how = plan.positions, plan.mechanism.drive, plan.machine.transmission
    if how.kind == FORCE:
        arm = base.images[drive.link].arm
        assert arm is not None  # the crank has an arm on the plan of positions
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
