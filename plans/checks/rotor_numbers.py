"""The numbers of a balanced rotor as plain data, for `solve`: SI units, radians, null for what is not there."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plans.analytic import rotor as analysis
from plans.model.balance_quality import MILLIMETRES, grade_of, letters, permissible
from plans.model.rotor import ANALYSIS, Balance, Correction, Resultant, Rotor
from plans.rotor.balancing import COUPLES, UNBALANCES
from plans.rotor.bearings import BEARINGS, REACTIONS

if TYPE_CHECKING:
    from plans.rotor.study import RotorStudy
    from plans.study import Study


@dataclass(frozen=True)
class RotorNumbers:
    """What balances a rotor, by one road, and which of it is told."""

    title: str
    rotor: Rotor
    balance: Balance
    plans: frozenset[str]

    @property
    def flawed(self) -> bool:
        """Whether something has no numbers: every rotor can be balanced."""
        return False

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        data: dict[str, Any] = {}
        if COUPLES in self.plans:
            data["couple"] = _vector(self.balance.couple)
        if UNBALANCES in self.plans:
            data["unbalance"] = _vector(self.balance.unbalance)
            data["corrections"] = {one.plane.name: _correction(one) for one in self.balance.corrections}
            data |= self._quality()
        if REACTIONS in self.plans and self.balance.before:
            data["reactions"] = {"before": _reactions(self.balance.before), "after": _reactions(self.balance.after)}
        return {"scene": self.title, "by": self.balance.by, "rotor": data}

    def _quality(self) -> dict[str, Any]:
        """Give e*omega m/s before the correction, its grade, and the unbalance kg*m that the asked grade permits."""
        rotor, before = self.rotor, self.rotor.quality(*self.balance.sizes)
        if before is None or rotor.mass is None or rotor.speed is None:
            return {}
        grade = grade_of(before)
        data: dict[str, Any] = {"before": before / MILLIMETRES, "grade": letters(grade) if grade else None}
        if rotor.grade is not None:
            data["permissible"] = permissible(rotor.grade, rotor.mass, rotor.speed)
        return {"quality": data}


def numbers(study: Study, by: str) -> RotorNumbers:
    """Balance the rotor of a scene by a road."""
    rotor = study["rotor"]
    borne = REACTIONS in study.plans
    found = analysis.balance(rotor.rotor, borne) if by == ANALYSIS else _constructed(rotor, borne)
    return RotorNumbers(study.scene.heading(), rotor.rotor, found, study.plans)


def _constructed(rotor: RotorStudy, borne: bool) -> Balance:
    return rotor.balance if borne else rotor.corrected


def _correction(one: Correction) -> dict[str, Any]:
    return {"moment": _vector(one.moment), "mass": one.mass, "radius": one.radius, "place": float(one.plane.place)}


def _reactions(found: tuple[Resultant, ...]) -> dict[str, Any]:
    return {name: _vector(one) for name, one in zip(BEARINGS, found, strict=True)}


def _vector(one: Resultant) -> dict[str, Any]:
    """Give a vector by its components, size and direction; one that vanishes has none."""
    value = 0j if one.vanishes else one.value + 0.0
    angle = None if one.angle is None else math.radians(one.angle)
    return {"vector": [value.real, value.imag], "size": one.size, "angle": angle}
