"""The shaking force of the scene's linkage as one mechanism of a bank: its main vector by main points (8.7), drawn."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from geometry.errors import ConstructionError
from geometry.precision import errors
from plans.balance.main_points import MainPoints
from plans.balance.mass_centre import Drawing
from plans.balance.states import drawing, turns
from plans.balance.stems import tree_of
from plans.balance.study import BalanceStudy
from plans.bank.shaking import Shaking
from plans.forces.statics import Statics
from plans.linkage.crank_positions import even
from plans.linkage.drafts import Drafts
from plans.linkage.obstruction import obstruction
from plans.linkage.study import LinkageStudy
from plans.model.balance.linkage import NONE
from plans.model.motion import Floats
from plans.model.rates import Rates
from plans.words.words import message, placed

if TYPE_CHECKING:
    from plans.study import Study

LOOKS = 72  # positions of a turn over which the size of the forces is taken


class NoTurn(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """A bank is asked of a linkage whose crank does not turn fully."""


class Linkage:
    """A linkage whose crank turns evenly at an angular speed rad/s, with its masses or those after balancing."""

    def __init__(self, study: LinkageStudy, points: MainPoints, speed: float) -> None:
        self.study, self.points, self.speed = study, points, speed

    @cached_property
    def scale(self) -> float:
        """The largest sum of the sizes of all inertia forces, N."""
        sides = self._drawing(Fraction(0), LOOKS).shaking.sides
        sizes = sum((np.abs(np.asarray(side.vector.point)) for side in sides), start=np.zeros(1))
        return float(np.max(sizes))

    def shaking(self, start: Fraction, count: int) -> Shaking:
        """Draw the linkage over a turn, its velocities and accelerations, and its main-point vectors."""
        force = self._drawing(start, count).force
        slack = np.broadcast_to(errors(force)[force].place, count)
        return Shaking(np.array(np.broadcast_to(force.point, count)), slack, force)

    def _drawing(self, start: Fraction, count: int) -> Drawing:
        turn = even(start, count, +1).paced(self._steady)
        return drawing(self.points, Drafts(self.study, turn))

    def _steady(self, phi: Floats) -> Rates:
        return Rates(self.speed, 0.0)


def linkage_of(study: Study, speed: float) -> Linkage:
    """Take the scene's linkage, with its counterweights where the scene asks for them, for one mechanism of a bank."""
    linkage: LinkageStudy = study["linkage"]
    if not turns(linkage):
        line, _ = study.scene.place(("bank",))
        raise NoTurn(placed(f"{study.scene.file}:{line}", message("bank.no_turn", why=obstruction(linkage.sweep))))
    if study.scene.has(("balance",)):
        balance: BalanceStudy = study["balance"]
        return Linkage(linkage, balance.points(after=balance.task.aim != NONE), speed)
    statics: Statics = study["forces"]
    return Linkage(linkage, MainPoints(tree_of(linkage.mechanism), statics.machine.bodies), speed)
