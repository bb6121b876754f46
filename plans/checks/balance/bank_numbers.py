"""The numbers of a bank as plain data, for `solve`: SI units, radians, null for what is not there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from plans.bank.compensators import COMPENSATORS
from plans.bank.harmonics import HARMONICS
from plans.model.balance.bank import ANALYSIS, BankBalance, Compensator, Harmonic
from plans.model.motion import Complexes

if TYPE_CHECKING:
    from plans.bank.study import BankStudy
    from plans.study import Study


@dataclass(frozen=True)
class BankNumbers:
    """The bank by one road, and which of it is told."""

    title: str
    balance: BankBalance
    plans: frozenset[str]

    @property
    def flawed(self) -> bool:
        """Whether something has no numbers: every bank has all."""
        return False

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        found = self.balance
        data: dict[str, Any] = {}
        if HARMONICS in self.plans:
            data["harmonics"] = {str(order): self._order(order) for order in found.forces}
            data["largest"] = {
                "force": _largest(found.force, found.force_slack),
                "moment": _largest(found.moment, found.moment_slack),
            }
        if COMPENSATORS in self.plans and found.compensators:
            data["compensators"] = [_compensator(one) for one in found.compensators]
            data["left"] = {"force": _largest(found.left, found.left_slack)}
        return {"scene": self.title, "by": found.by, "bank": data}

    def _order(self, order: int) -> Mapping[str, Any]:
        found = self.balance
        rows = {"mechanism": found.single, "force": found.forces, "moment": found.moments}
        return {name: _harmonic(row[order]) for name, row in rows.items()}


def numbers(study: Study, by: str) -> BankNumbers:
    """Find the bank of a scene by a road."""
    bank: BankStudy = study["bank"]
    found = study.comparison("bank").analysis if by == ANALYSIS else bank.balance
    return BankNumbers(study.scene.heading(), found, study.plans)


def _harmonic(one: Harmonic) -> dict[str, Any]:
    """Give a harmonic by its two vectors and the largest that it comes to; what vanishes is 0."""
    ahead, back = (0j if abs(value) <= one.slack else value + 0.0 for value in (one.ahead, one.back))
    return {"with_crank": [ahead.real, ahead.imag], "against": [back.real, back.imag], "size": one.size}


def _compensator(one: Compensator) -> dict[str, Any]:
    weights = {"with_crank": (one.with_crank, one.with_angle), "against": (one.against, one.against_angle)}
    told = {name: _weight(size, angle, one.asked.mass) for name, (size, angle) in weights.items()}
    couple = None if one.couple is None else {"moment": one.couple, "angle": one.couple_angle}
    return {"order": one.asked.order, **told, "residual": one.residual, "couple": couple}


def _weight(size: float, angle: float | None, mass: float | None) -> dict[str, Any]:
    return {"moment": size, "angle": angle, "mass": mass, "radius": size / mass if mass else None}


def _largest(values: Complexes, slack: float) -> float:
    """Give the largest size of a vector over the turn; 0 where nothing is left but rounding."""
    found = float(np.max(np.abs(values)))
    return found if found > slack else 0.0
