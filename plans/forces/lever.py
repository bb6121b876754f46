"""Zhukovsky's lever: the velocity plan turned by a quarter, with the forces at the images of their points (M5.8).

No reaction enters: the turned plan is a rigid lever hinged at its pole; the forces on it balance (рычаг Жуковского).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from geometry.board import Board, Mark
from plans.forces.cut import REACTION, Couple, Load
from plans.forces.primary import BALANCING, DRIVING
from plans.words.words import because

if TYPE_CHECKING:
    from plans.forces.force import ForcePlan


class Hung(NamedTuple):
    """A force on the lever: its letters, the turned image of its point, its vector, and its moment about the pole."""

    name: str
    at: Mark
    force: Mark
    moment: Mark


class Pairing(NamedTuple):
    """A couple on the lever: two forces at the turned images of a link's points, square to it, and their moment."""

    name: str
    start: Mark
    end: Mark
    force: Mark  # at the end; its opposite acts at the start
    moment: Mark


class Lever(NamedTuple):
    """The lever with all that hangs on it, and the force at the drive's image that balances it."""

    board: Board
    pole: Mark
    hung: tuple[Hung, ...]
    pairs: tuple[Pairing, ...]
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
    hung = [_hung(plan, board, pole, load) for link in links for load in plan.loads[link] if load.kind != REACTION]
    pairs = [_paired(plan, board, one) for link in links for one in plan.couples[link] if one.kind != REACTION]
    kept, turning = [one for one in hung if one is not None], [one for one in pairs if one is not None]
    image, point, line = _drive(plan, board)
    moments = [*(one.moment for one in kept), *(one.moment for one in turning)]
    if not moments:
        return None
    force = board.balance(DRIVING, pole, line, *moments, why=because("lever_balance"))
    shaft = plan.positions.point(plan.mechanism.drive.pivot)
    moment = board.moment(BALANCING, shaft, point, force, because("shaft_moment"))
    return Lever(board, pole, tuple(kept), tuple(turning), image, force, moment)


def _hung(plan: ForcePlan, board: Board, pole: Mark, load: Load) -> Hung | None:
    """Put a force at the turned image of its point; one at a fixed point does no work."""
    image = plan.image(load)
    if image is plan.velocities.pole:
        return None
    at = _turned(board, image)
    return Hung(load.name, at, load.force, board.moment(f"p({load.name})", pole, at, load.force, because("moment")))


def _paired(plan: ForcePlan, board: Board, couple: Couple) -> Pairing | None:
    """Replace a couple by two forces at the ends of a vector of its link; one on a link that does not turn rests."""
    reading = plan.velocities.readings.get(couple.link)
    if reading is None:
        return None
    arm = reading.arm.step.inputs[0] if reading.arm.step.op == "transfer" else reading.arm
    start, end = arm.step.inputs
    base = plan.positions.board
    line = base.square(f"⊥{arm.name}", end, arm, because("square", line=arm.name))
    holding = board.balance(f"-{couple.name}/{arm.name}", start, line, couple.moment, why=because("against_couple"))
    force = board.turn(f"{couple.name}/{arm.name}", holding, -1.0, because("couple", line=arm.name))
    images = [_turned(board, image) for image in reading.turning.step.inputs]
    moment = board.moment(f"p({couple.name})", images[0], images[1], force, because("couple_moment"))
    return Pairing(couple.name, images[0], images[1], force, moment)


def _drive(plan: ForcePlan, board: Board) -> tuple[Mark, Mark, Mark]:
    """Give the turned image of the point where the drive acts, that point, and the line of its force on the lever."""
    base, speeds, drive = plan.positions, plan.velocities, plan.mechanism.drive
    if plan.driven is None or plan.driven is base.point(drive.end):
        point, image, arm = base.point(drive.end), speeds.point(drive.end), base.images[drive.link].arm
        assert arm is not None  # the crank has an arm on the plan of positions
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
