"""Carrying a linkage through its change points: another one beside it, or its inertia, does that (переход через них).

Where all links of a group fall into one line, the group alone may go on in two ways. Carried through it goes on
smoothly: its meeting comes to lie on the other side. A locomotive's coupling rod stays parallel to the frame so.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.meet import Sizes
from plans.linkage.acceleration import accelerations
from plans.linkage.angles import angle, rate
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.plan import Plan
from plans.linkage.plan_template import resting
from plans.linkage.velocity import velocities
from plans.model.group import Group
from plans.model.motion import Floats, LinkMotion, Motion, PointMotion

FULL = 2 * np.pi


class Passed(NamedTuple):
    """A change point that a group is carried through: the group's place in solving order, and the crank angle, rad."""

    group: int
    phi: float


def carried(sides: Sequence[float], passed: Sequence[Passed], phi: Floats, home: float) -> list[Sizes]:
    """Give each group's side over crank angles, rad: every change point on the way from home turns it over.

    The way is the shorter one; half a turn off, that counter-clockwise.
    """
    ahead = np.mod(phi - home, FULL)
    found: list[Sizes] = [np.full(len(phi), side) for side in sides]
    for group, at in passed:
        on = float(np.mod(at - home, FULL))
        over = np.where(ahead <= np.pi, on < ahead, on > ahead)
        found[group] = np.where(over, -1.0, 1.0) * found[group]
    return found


class Drawing:
    """Plans up to an order, drawn anew wherever they are asked for: no pattern fits sides that change."""

    def __init__(self, positions: Callable[[CrankPositions], Plan], groups: Sequence[Group], order: int) -> None:
        self._positions, self.groups, self.order = positions, groups, order

    def follow(self, turn: CrankPositions) -> list[Plan]:
        """Draw the plans at some crank positions."""
        plans = [self._positions(turn)]
        for draw in (velocities, accelerations)[: self.order]:
            plans.append(draw(plans[-1], self.groups, turn.rates))
        return plans

    def clear(self, plans: Sequence[Plan]) -> bool:
        """Tell whether no meeting of the plans is near a miss or a dead centre."""
        return all(plan.board.clear for plan in plans)

    def plans_of(self, plans: list[Plan]) -> list[Plan]:
        """Give the plans themselves."""
        return plans

    def read(self, plans: Sequence[Plan], turn: CrankPositions) -> Motion:
        """Read all named points and moving links off the plans."""
        links = plans[0].mechanism.links
        letters = sorted({point for link in links.values() for point in link.points})
        points = {
            letter: PointMotion(_row(plan.point(letter).point, len(turn)) for plan in plans) for letter in letters
        }
        moving = [link for link, image in sorted(plans[0].images.items()) if image.arm]
        turned = {
            link: LinkMotion(
                _row(row, len(turn)) for row in (angle(plans[0], link), *(rate(plan, link) for plan in plans[1:]))
            )
            for link in moving
        }
        return Motion("construction", turn.phi, points, turned, ())


def _row(values: Any, count: int) -> npt.NDArray[Any]:
    row = np.asarray(values)
    return resting(row.reshape(1), count) if row.size == 1 else row
