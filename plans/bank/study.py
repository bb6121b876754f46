"""The study of a bank: harmonics, polygons and compensators, each made once (взаимоуравновешивание)."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property
from typing import TYPE_CHECKING

from geometry.board import Board
from plans.bank.compensators import COMPENSATORS, Weights, compensators, left_over
from plans.bank.harmonics import HARMONICS, Harmonics, NotSettled, harmonics
from plans.bank.linkage import linkage_of
from plans.bank.polygons import Polygons, polygons
from plans.bank.shaking import SliderCrank, Source
from plans.bank.whole import Whole, whole
from plans.model.balance.bank import CONSTRUCTION, BankBalance, BankTask
from plans.words.words import placed

if TYPE_CHECKING:
    from plans.study import Study


class BankStudy:
    """A bank, by construction; nothing is made before it is asked for."""

    def __init__(self, task: BankTask, source: Source, place: str = "") -> None:
        self.task, self.source = task, source
        self.place = place  # of the bank in the scene's file
        self.made: dict[str, None] = {}  # what was made, in order

    def construct(self, plans: Collection[str]) -> None:
        """Draw what is asked for."""
        _ = self.drawing
        if COMPENSATORS in plans:
            _ = self.weights

    @cached_property
    def single(self) -> Harmonics:
        """The harmonics of one mechanism."""
        try:
            return harmonics(self.source, self.orders)
        except NotSettled as error:
            raise NotSettled(placed(self.place, error.args[0]) if self.place else error.args[0]) from None

    @property
    def orders(self) -> tuple[int, ...]:
        """The orders that are told, with those that compensators are asked of."""
        return orders_of(self.task)

    @cached_property
    def drawing(self) -> Polygons:
        """The polygons of the bank's forces and moments."""
        self.made.setdefault(HARMONICS)
        return polygons(self.single, self.task.members)

    @cached_property
    def whole(self) -> Whole:
        """The whole force and moment over a turn."""
        return whole(self.source, self.task.members)

    @cached_property
    def weights(self) -> tuple[Weights, ...]:
        """The masses of the compensators."""
        return self._read[1]

    @cached_property
    def _read(self) -> tuple[Board, tuple[Weights, ...]]:
        self.made.setdefault(COMPENSATORS)
        return compensators(self.task, self.drawing)

    @property
    def boards(self) -> tuple[Board, ...]:
        """All boards in the order of drawing."""
        return self.single.board, self.drawing.moment_board, self._read[0]

    @cached_property
    def balance(self) -> BankBalance:
        """The bank as it is told."""
        found, drawing, orders = self.whole, self.drawing, self.orders
        return BankBalance(
            by=CONSTRUCTION,
            task=self.task,
            single={order: self.single.harmonic(order) for order in orders},
            forces={order: drawing.force(order) for order in orders},
            moments={order: drawing.moment(order) for order in orders},
            compensators=tuple(one.told for one in self.weights),
            phi=found.phi,
            force=found.force,
            left=left_over(found.force, self.weights, found.phi, self.task.speed),
            moment=found.moment,
            force_slack=found.force_slack,
            moment_slack=found.moment_slack,
        )


def orders_of(task: BankTask) -> tuple[int, ...]:
    """Give the orders that are told, with those that compensators are asked of."""
    return tuple(dict.fromkeys((*task.orders, *(one.order for one in task.asked))))


def study_of(study: Study) -> BankStudy:
    """Make the study of a scene's bank (row of the table of techniques)."""
    task: BankTask = study.scene.meaning["bank"].task
    unit, speed = task.unit, task.speed
    line, _ = study.scene.place(("bank",))
    source = linkage_of(study, speed) if unit is None else SliderCrank(unit, speed)
    return BankStudy(task, source, f"{study.scene.file}:{line}")
