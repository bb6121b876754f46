"""The plans of positions, velocities and accelerations: drawn, or followed from a pattern (планы механизма)."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from geometry.board import Mark
from geometry.branch import Side
from geometry.tracing import Tracing
from plans.linkage.dyads import KINDS
from plans.linkage.plan import Plan, heading
from plans.linkage.primary import PRIMARIES, CrankPositions
from plans.model.dyad import Assur
from plans.model.mechanism import Mechanism
from plans.model.motion import LinkMotion, Motion, PointMotion, Rates, steady


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def positions(mechanism: Mechanism, groups: Sequence[Assur], sides: Sequence[Side], turn: CrankPositions) -> Plan:
    """Draw the plan of positions; `sides` gives each group's side of its meeting, NaN where it must stay undrawn."""
    plan = PRIMARIES[mechanism.drive.kind].positions(mechanism, turn)
    for group, side in zip(groups, sides, strict=True):
        KINDS[group.kind].positions(plan, group, side)
    return plan


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def velocities(positions: Plan, groups: Sequence[Assur], rates: Rates | None = None) -> Plan:
    """Draw the velocity plan over a plan of positions, group after group (section 6.4.2, M3.1).

    `rates` are the drive's in each of the positions; None: those that its scene gives.
    """
    plan = Plan("velocities", positions.mechanism, (positions,))
    drive = plan.mechanism.drive
    PRIMARIES[drive.kind].velocities(plan, rates or steady(drive))
    for group in groups:
        KINDS[group.kind].velocities(plan, group)
    return plan


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def accelerations(velocities: Plan, groups: Sequence[Assur], rates: Rates | None = None) -> Plan:
    """Draw the acceleration plan over the velocity plan, group after group (section 6.4.2, M3.1).

    `rates` are those by which the velocity plan was drawn.
    """
    positions = velocities.positions
    plan = Plan("accelerations", positions.mechanism, (positions, velocities))
    drive = plan.mechanism.drive
    PRIMARIES[drive.kind].accelerations(plan, rates or steady(drive))
    for group in groups:
        KINDS[group.kind].accelerations(plan, group)
    return plan


def openness(corners: Sequence[npt.NDArray[np.complex128]]) -> npt.NDArray[np.float64]:
    """Give how open figures are by their corners, a row each over the positions: 2ab/(a^2 + b^2) of their ellipse.

    >>> openness([np.array([0j, 0j]), np.array([1 + 0j, 1 + 0j]), np.array([1j, 2 + 0j])]).round(6).tolist()
    [0.866025, 0.0]
    """
    spread = np.array(corners) - np.mean(corners, axis=0)
    size, along = (np.abs(spread) ** 2).mean(axis=0), np.abs((spread**2).mean(axis=0))
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN, and a plan at rest is no figure
        return np.where(size > 0.0, np.sqrt(np.maximum(1.0 - (along / size) ** 2, 0.0)), 0.0)


UNIT = Rates(np.ones(1), np.ones(1))  # by which a pattern is drawn whose rates vary


class PlanTemplate:
    """Plans of the orders 0, 1, ... over each other, with the images of all named points on them."""

    def __init__(self, plans: Sequence[Plan]) -> None:
        self.plans = plans
        links = plans[0].mechanism.links
        letters = sorted({point for link in links.values() for point in link.points})
        images = {letter: [plan.point(letter) for plan in plans] for letter in letters}
        self.primary = PRIMARIES[plans[0].mechanism.drive.kind]
        free = plans[0].board[self.primary.free]
        tracing = Tracing((mark for plan in plans for mark in plan.board), free)
        self.tracing = tracing
        arms = {link: (image.arm, image.span) for link, image in sorted(plans[0].images.items()) if image.arm}
        self._crank = tracing.acts.fix(None)  # the heading of a link that turns with the crank
        self._points = {letter: [tracing.place(mark) for mark in marks] for letter, marks in images.items()}
        self._links = {link: [self._heading(*arm), *self._rates(link)] for link, arm in arms.items()}
        self._still = {**self._at_rest(self._points, np.complex128), **self._at_rest(self._links, np.float64)}
        self._rows: tuple[int, dict[int, npt.NDArray[Any]]] = 0, {}

    def _heading(self, arm: Mark, span: complex) -> int:
        """Tell where the direction of a link's own +x axis is, one vector of which is `span` there."""
        tracing = self.tracing
        if tracing.follows(arm, span):
            return self._crank
        return tracing.acts.do(heading, tracing.place(arm), tracing.acts.fix(span))

    def _rates(self, link: int) -> Iterator[int]:
        for readings in (plan.readings for plan in self.plans[1:]):
            if link in readings:
                yield self.tracing.acts.rate(*map(self.tracing.place, (readings[link].turning, readings[link].arm)))
            else:
                yield self.tracing.acts.fix(0.0)  # it does not turn

    def _at_rest(self, by_kind: Mapping[Any, list[int]], kind: type) -> dict[int, npt.NDArray[Any]]:
        """Give the values that are the same at all positions."""
        known = {place: self.tracing.acts.fixed(place) for places in by_kind.values() for place in places}
        return {place: np.array([value], dtype=kind) for place, value in known.items() if value is not None}

    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def follow(self, turn: CrankPositions) -> list[Any]:
        """Work out all numbers of the plans at other crank positions."""
        values = self.primary.values(self.plans[0].mechanism, turn)
        if turn.rates is None:
            return self.tracing.follow(values)
        rates = zip(self.tracing.sizes, turn.rates, strict=False)  # a pattern of velocities has no epsilon
        return self.tracing.follow(values, {mark: mark.step.size * rate for mark, rate in rates})

    def clear(self, numbers: list[Any]) -> bool:
        """Tell whether no meeting of the plans is near a miss or a dead centre."""
        return self.tracing.clear(numbers)

    def plans_of(self, numbers: list[Any]) -> list[Plan]:
        """Make the plans that have these numbers."""
        boards, made = self.tracing.boards(numbers)
        found: list[Plan] = []
        for plan in self.plans:
            found.append(plan.redraw(boards[plan.board.subject], made, tuple(found)))
        return found

    def read(self, numbers: list[Any], turn: CrankPositions) -> Motion:
        """Read all named points and moving links off the plans."""
        shown = numbers.copy()
        count = len(turn)
        if self._rows[0] != count:
            self._rows = count, {place: resting(value, count) for place, value in self._still.items()}
        for place, row in self._rows[1].items():
            shown[place] = row
        shown[self._crank] = turn.headings
        points = {letter: PointMotion([shown[place] for place in places]) for letter, places in self._points.items()}
        links = {link: LinkMotion([shown[place] for place in places]) for link, places in self._links.items()}
        return Motion("construction", turn.phi, points, links, ())


def resting(value: npt.NDArray[Any], count: int) -> npt.NDArray[Any]:
    """See a value that is the same at all positions as a row, which takes no room and cannot be written in."""
    row: npt.NDArray[Any] = np.ndarray(count, value.dtype, value, strides=(0,))
    row.flags.writeable = False
    return row
