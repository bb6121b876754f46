"""Zhukovsky's lever: the velocity plan turned by a quarter, with the forces at the images of their points (M5.8).

No reaction enters: the turned plan is a rigid lever hinged at its pole; the forces on it balance (рычаг Жуковского).
Drawn by drawings/forces/lever.py; held by `balancing` of quantities.py, its ink by drawings/forces/due_lever.py.
"""

from __future__ import annotations

from typing import NamedTuple

from geometry.board import Board, Mark, Reading
from plans.forces.cut import REACTION, Couple, ForcePlan, Load
from plans.forces.drive import BALANCING, DRIVING
from plans.linkage import leads
from plans.model.mechanism import FRAME
from plans.words.words import because


class LeverCouple(NamedTuple):
    """A couple on the lever: two forces at the turned images of a link's points, square to it."""

    name: str
    start: Mark
    end: Mark
    force: Mark  # at the end; its opposite acts at the start


class Lever(NamedTuple):
    """The lever with all that hangs on it, and the force at the drive's image that balances it."""

    board: Board
    pole: Mark
    loads: tuple[Load, ...]  # at the turned images of their points
    pairs: tuple[LeverCouple, ...]
    moments: tuple[tuple[str, Mark], ...]  # about the pole, of each load and each pair by its letters
    driven: Mark  # turned image of the point where the drive's force acts
    force: Mark  # balancing force there
    moment: Mark  # its moment about the shaft


def lever(plan: ForcePlan) -> Lever | None:
    """Hang all loads, weights and inertia forces on the turned velocity plan and balance it; None: nothing moves."""
    if plan.mechanism.drive.omega == 0:
        return None
    board = Board("lever")
    pole = board.given("p", 0j, because("lever_pole"))
    links = sorted(plan.mechanism.links)
    loads, pairs, moments = list[Load](), list[LeverCouple](), list[tuple[str, Mark]]()
    for load in (load for link in links for load in plan.loads[link] if load.kind != REACTION):
        image = plan.image(load)
        if image is not plan.velocities.pole:  # at a fixed point a load does no work
            loads.append(load._replace(at=_turned(board, image)))
            why = because("moment")
            moments.append((load.name, board.moment(f"p({load.name})", pole, loads[-1].at, load.force, why)))
    known = (couple for link in links for couple in plan.couples[link] if couple.kind != REACTION)
    readings = ((couple, plan.velocities.readings.get(couple.link)) for couple in known)
    for pair in (_pair(plan, board, couple, arm) for couple, arm in readings if arm is not None):  # its link turns
        pairs.append(pair)
        why = because("couple_moment")
        moments.append((pair.name, board.moment(f"p({pair.name})", pair.start, pair.end, pair.force, why)))
    image, point, line = _drive(plan, board)
    if not moments:
        return None
    terms = [moment for _, moment in moments]
    force = board.balance(DRIVING, pole, line, *terms, why=because("lever_balance"))
    moment = board.moment(BALANCING, plan.shaft, point, force, because("shaft_moment"))
    return Lever(board, pole, tuple(loads), tuple(pairs), tuple(moments), image, force, moment)


def _pair(plan: ForcePlan, board: Board, couple: Couple, reading: Reading) -> LeverCouple:
    """Replace a couple by two forces at the ends of a vector of its link."""
    arm = reading.arm.step.inputs[0] if reading.arm.step.op == "transfer" else reading.arm
    start, end = arm.step.inputs
    base = plan.positions.board
    line = base.square(f"⊥{arm.name}", end, arm, because("square", line=arm.name))
    holding = board.balance(f"-{couple.name}/{arm.name}", start, line, couple.moment, why=because("against_couple"))
    force = board.turn(f"{couple.name}/{arm.name}", holding, -1.0, because("couple", line=arm.name))
    images = [_turned(board, image) for image in reading.turning.step.inputs]
    return LeverCouple(couple.name, images[0], images[1], force)


def _drive(plan: ForcePlan, board: Board) -> tuple[Mark, Mark, Mark]:
    """Give the turned image of the point where the drive acts, that point, and the line of its force on the lever."""
    base, speeds, drive = plan.positions, plan.velocities, plan.mechanism.drive
    if drive.guide is not None and plan.driven is not None:
        along, turned = leads.direction(base, drive.guide, FRAME), _turned(board, speeds.point(drive.end))
        return turned, plan.driven, board.parallel(f"∥{along.name}", turned, along, because("pushed_along"))
    if plan.driven is None or plan.driven is base.point(drive.end):
        point, image, arm = base.point(drive.end), speeds.point(drive.end), base.arm(drive.link)
        turned = _turned(board, image)
        return turned, point, board.square(f"⊥{arm.name}", turned, arm, because("balancing_square"))
    image = speeds.transport(drive.link, plan.driven, plan.driven.name.lower())
    turned = _turned(board, image)
    along = plan.board["line of action"]
    return turned, plan.driven, board.parallel("line of action", turned, along, because("teeth"))


def _turned(board: Board, image: Mark) -> Mark:
    """Turn an image by a quarter clockwise about the pole; once turned it is used again."""
    if image.name in board and board[image.name].step.inputs in ((image,), ()):
        return board[image.name]
    return board.turn(image.name, image, -1j, because("quarter"))
