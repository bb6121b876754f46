"""The numbers of a balanced rotor as plain data, for `solve`: SI units, radians, null for what is not there."""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import Any

from plans.analytic import rotor as analysis
from plans.model.balance_quality import grade_of, letters, permissible
from plans.model.rotor import ANALYSIS, Balance, Correction, Resultant, Rotor
from plans.rotor.balancing import COUPLES, UNBALANCES
from plans.rotor.bearings import BEARINGS, REACTIONS
from plans.rotor.study import RotorStudy


def numbers(study: RotorStudy, by: str, wanted: Collection[str]) -> dict[str, Any]:
    """Give what is wanted of a rotor by one road."""
    found = analysis.balance(study.rotor) if by == ANALYSIS else study.balance
    told: dict[str, Any] = {"by": found.by}
    if COUPLES in wanted:
        told["couple"] = _vector(found.couple)
    if UNBALANCES in wanted:
        told["unbalance"] = _vector(found.unbalance)
        told["corrections"] = {one.plane.name: _correction(one) for one in found.corrections}
        told |= _quality(study.rotor, found)
    if REACTIONS in wanted and found.before:
        told["reactions"] = {"before": _reactions(found.before), "after": _reactions(found.after)}
    return told


def _correction(one: Correction) -> dict[str, Any]:
    return {"moment": _vector(one.moment), "mass": one.mass, "radius": one.radius, "place": float(one.plane.place)}


def _reactions(found: tuple[Resultant, ...]) -> dict[str, Any]:
    return {name: _vector(one) for name, one in zip(BEARINGS, found, strict=True)}


def _vector(one: Resultant) -> dict[str, Any]:
    """Give a vector by its components, size and direction; one that vanishes has none."""
    value = 0j if one.vanishes else one.value
    angle = None if one.angle is None else math.radians(one.angle)
    return {"vector": [value.real, value.imag], "size": one.size, "angle": angle}


def _quality(rotor: Rotor, found: Balance) -> dict[str, Any]:
    """Give e*omega m/s before the correction, its grade, and the unbalance kg*m that the asked grade permits."""
    before = rotor.quality(*(one.moment.size for one in found.corrections))
    if before is None or rotor.mass is None or rotor.speed is None:
        return {}
    grade = grade_of(before)
    told: dict[str, Any] = {"before": before / 1000, "grade": letters(grade) if grade else None}
    if rotor.grade is not None:
        told["permissible"] = permissible(rotor.grade, rotor.mass, rotor.speed)
    return {"quality": told}
