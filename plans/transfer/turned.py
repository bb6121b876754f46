"""The velocity plan of a crank that turns by 1 rad/s, turned clockwise by a quarter: pole in O, a' on A (M3.13).

Its scale is that of the scheme, so that it is drawn on it. It is drawn by the record of the velocity plan, act by act:
what is square to a link there is parallel to it here, and what goes along a guide is square to that.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from geometry.board import Board, Line, Mark, Reading, behind
from plans.linkage.plan import Plan
from plans.words.words import because

TRANSFER = "transfer"


class TurnedPlan(NamedTuple):
    """The turned plan, m: the images of the points by their names, and what each link's ratio is read from."""

    board: Board
    pole: Mark
    images: Mapping[str, Mark]
    readings: Mapping[int, Reading]
    letters: Mapping[str, str]  # of the images of the points, though several share one


def turned(plan: Plan) -> TurnedPlan:
    """Draw a velocity plan again, turned; the crank turns by 1 rad/s in it."""
    points = dict.fromkeys(name for link in plan.mechanism.links.values() for name in link.points)
    images = {name: plan.point(name) for name in points}
    again = _Redrawn(plan)
    for mark in behind(plan.pole, *images.values(), *(reading.turning for reading in plan.readings.values())):
        again.draw(mark)
    made = again.made
    readings = {link: Reading(made[arm], made[turning]) for link, (arm, turning) in plan.readings.items()}
    letters = {name: f"{plan.letter(name)}'" for name in images}
    return TurnedPlan(
        again.board, made[plan.pole], {name: made[mark] for name, mark in images.items()}, readings, letters
    )


class _Redrawn:
    """A velocity plan under way on another board; `made` are the marks by those of the plan."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.board = plan, Board(TRANSFER)
        self.made: dict[Mark, Mark] = {}

    def draw(self, mark: Mark) -> None:
        """Draw a mark of the plan again; what lies on the plan of positions is there already."""
        if mark.subject != self.plan.board.subject:
            self.made[mark] = mark
        elif mark is self.plan.pole:
            pivot = self.plan.mechanism.drive.pivot
            self.made[mark] = self.board.given(pivot, 0j, because("turned_pole", point=pivot))
        else:
            self.made[mark] = self._again(mark, [self.made[source] for source in mark.step.inputs])

    def _again(self, mark: Mark, inputs: list[Mark]) -> Mark:
        board, (op, _, size, _, why, _), name = self.board, mark.step, f"{mark.name}'"
        first, second = inputs[0], inputs[-1]
        match op:
            case "transfer":
                return first  # the scheme itself
            case "turn":  # a crank's velocity for 1 rad/s, turned back, is its own vector
                return first if first.subject != TRANSFER else board.turn(name, first, size, why)
            case "lay_off":
                crank = because("turned_crank", point=self.plan.mechanism.drive.end)
                return board.lay_off(name, first, second, why if second.subject == TRANSFER else crank)
            case "square":
                return board.parallel(f"∥{second.name}", first, second, because("turned_along", line=second.name))
            case "parallel":
                return board.square(f"⊥{second.name}", first, second, because("turned_across", line=second.name))
            case "join":
                return board.join(f"{first.name}{second.name}", first, second, why)
            case "similar":
                return board.similar(name, first, inputs[1], second, complex(np.asarray(size)).real, why)
        return board.meet(name, first, second, why=why)


def loci(mark: Mark) -> tuple[Mark, Mark] | None:
    """Give the two lines in whose meeting an image was found; None of any other."""
    lines = [locus for locus in mark.step.inputs if isinstance(locus.value, Line)]
    return (lines[0], lines[1]) if mark.step.op == "meet" and len(lines) == 2 else None
