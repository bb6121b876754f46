"""Mechanisms to be balanced, by hand: the textbook's masses, the places for counterweights, and both ends of a turn."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from plans.analytic.balance.balance import balance
from plans.analytic.balance.counterweights import Course
from plans.analytic.kinematics import Analysis
from plans.model.balance.linkage import STEPS, Balance, BalanceTask
from plans.model.decomposition import decompose
from plans.model.dyad import Assur, pairs
from plans.model.kinetostatics import Loading
from plans.model.machine import Body, Machine
from plans.model.mechanism import Mechanism
from tests.plans import linkages
from tests.plans.machines import machine

NOTHING = Loading((), ())


class Case(NamedTuple):
    """A mechanism with its masses."""

    mechanism: Mechanism
    machine: Machine

    @property
    def groups(self) -> tuple[Assur, ...]:
        return decompose(self.mechanism)

    def balance(self, task: BalanceTask, *phi: float) -> Balance:
        """Balance it by analysis."""
        return balance(self.course(phi or (np.pi / 3,)), task, self.groups)

    def course(self, phi: Sequence[float] = (0.0,), steps: int = STEPS, sense: int = 1) -> Course:
        road, start = Analysis(self.mechanism), np.asarray(phi, float)
        told = pairs(self.mechanism, self.groups)
        motion = road.motion(start)
        turn = road.around(start[0] + sense * 2 * np.pi * np.arange(steps + 1) / steps)
        return Course(road, self.machine, told, motion, turn, NOTHING)


def bodies(*rows: tuple[int, float, complex]) -> Machine:
    """Give masses kg and their centres in the links' own frames."""
    return machine({link: Body(link, mass, mass * 1e-3, centre) for link, mass, centre in rows}, gravity=0j)


def four_bar(sense: int = 1) -> Case:
    """Methods M7.4: the four-bar of M1.1."""
    links = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, omega=10.0 * sense, epsilon=0.0)
    return Case(links, bodies((1, 2, 0.04), (2, 4, 0.18), (3, 5, 0.3 - 0.12)))


def engine(offset: float = 0.0) -> Case:
    """Methods M7.6: the slider-crank of M4.2."""
    links = linkages.slider_crank(0.1, 0.4, offset, omega=20.0, epsilon=0.0)
    return Case(links, bodies((1, 3, 0.04), (2, 4, 0.15), (3, 8, 0)))
