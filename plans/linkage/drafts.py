"""Drafts: the plans over some positions of a study, as far as they are asked for (планы положений)."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from plans.linkage import gaps
from plans.linkage.assembly_limits import Drawing, Sweep
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.margin import Barrier
from plans.linkage.motion_plans import accelerations, velocities
from plans.linkage.plan import Plan
from plans.linkage.plan_template import PlanTemplate
from plans.linkage.sketch import Assembly
from plans.model.dyad import Group
from plans.model.motion import ORDERS, VELOCITIES, Motion


class Drawable(Protocol):
    """What plans are drawn of: a mechanism with its assembly; a study of it, or what answers as one."""

    made: dict[str, None]

    @property
    def sweep(self) -> Sweep:
        """The mechanism with its chosen assembly."""

    @property
    def groups(self) -> tuple[Group, ...]:
        """Its structural groups."""

    @property
    def assembly(self) -> Assembly:
        """The assembly that the sketch chooses."""

    @property
    def barriers(self) -> tuple[Barrier, ...]:
        """What bars a full turn of the crank."""


class Drafts:
    """The plans over some positions of a study: their pattern is followed, and marks are made when they are looked at.

    The record of an order of plans holds those below it; what is asked for later is drawn over what is there.
    """

    def __init__(self, study: Drawable, turn: CrankPositions) -> None:
        self.study, self.turn = study, turn
        self._plans: list[Plan] = []
        self._record: tuple[PlanTemplate | Drawing, list[Any]] | None = None

    def follow(self, order: int) -> tuple[PlanTemplate | Drawing, list[Any]]:
        """Work out the numbers of the plans up to an order by their pattern."""
        for asked in ORDERS[: order + 1]:
            self.study.made.setdefault(asked.plan)
        pattern = self.study.sweep.pattern(order, varied=self.turn.rates is not None)
        self._record = pattern, pattern.follow(self.turn)
        return self._record

    @property
    def clear(self) -> bool:
        """Whether no meeting of the plans followed last has a miss, a dead centre or anything unknown."""
        pattern, numbers = self._record or self.follow(0)
        return pattern.clear(numbers)

    @property
    def free(self) -> bool:
        """Whether nothing bars the crank, and there can be no gap."""
        study = self.study
        return not study.barriers and study.assembly.phi is not None and not study.sweep.pinned and self.clear

    def motion(self, order: int) -> Motion:
        """Read all named points and moving links off the plans up to an order, whatever is not reached."""
        pattern, numbers = self.follow(order)
        return pattern.read(numbers, self.turn)

    def plan(self, order: int) -> Plan:
        """The plan of an order: 0 positions, 1 velocities, 2 accelerations."""
        if not self._plans:
            pattern, numbers = self._record or self.follow(order)
            self._plans = pattern.plans_of(numbers)
        for asked in ORDERS[len(self._plans) : order + 1]:
            self.study.made.setdefault(asked.plan)
            draw = velocities if asked is VELOCITIES else accelerations
            self._plans.append(draw(self._plans[-1], self.study.groups, self.turn.rates))
        return self._plans[order]

    @property
    def positions(self) -> Plan:
        """The plan of positions."""
        return self.plan(0)

    @property
    def velocities(self) -> Plan:
        """The velocity plan."""
        return self.plan(1)

    @property
    def accelerations(self) -> Plan:
        """The acceleration plan."""
        return self.plan(2)

    @cached_property
    def lost(self) -> npt.NDArray[np.bool_]:
        """Positions that the mechanism does not reach, or in which it has no one place."""
        study = self.study
        if study.assembly.phi is None:
            return np.ones(len(self.turn), dtype=bool)
        if self.free:
            return np.zeros(len(self.turn), dtype=bool)
        return gaps.lost(study.sweep, self.positions, self.turn, study.assembly.phi, study.barriers)

    @cached_property
    def unborne(self) -> npt.NDArray[np.bool_]:
        """Positions whose velocities the condition does not bear."""
        if self.free or self.study.assembly.phi is None:
            return np.zeros(len(self.turn), dtype=bool)
        return gaps.unborne(self.study.sweep, self.positions, self.turn)
