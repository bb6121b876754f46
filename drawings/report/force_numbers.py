"""The numbers of forces as plain data: reactions, balancing moment, friction, efficiency (силы в числах).

SI units, null at gaps; places are coordinates of the scene.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drawings.report.numbers import pairs, plain
from plans.model.kinetostatics import Kinetostatics, Reaction
from plans.model.losses import Friction


def described(forces: Kinetostatics, datum: complex) -> dict[str, Any]:
    """Give the reaction of link a on link b under "a-b", and what the drive gives."""
    balancing = forces.balancing
    drive: dict[str, Any] = {"moment": plain(balancing.moment)}
    if balancing.force is not None and balancing.r is not None:
        drive |= {"force": pairs(balancing.force), "at": pairs(balancing.r + datum)}
    reactions = sorted(forces.reactions.items(), key=lambda item: (item[1].giver, item[1].taker))
    return {"reactions": {key: _reaction(one, forces.arm(key), datum) for key, one in reactions}, "balancing": drive}


def _reaction(one: Reaction, arm: Any, datum: complex) -> dict[str, Any]:
    """Give a reaction where it is told; of a sliding pair its moment there, and the arm along the slide."""
    told: dict[str, Any] = {"point": one.point, "force": pairs(one.force), "at": pairs(one.r + datum)}
    if one.moment is not None:
        told |= {"moment": plain(one.moment), "arm": plain(arm)}
    return told


def rubbed(friction: Friction) -> dict[str, Any]:
    """Give what friction takes: power and share of wear of each pair, and the efficiency."""
    worn: Mapping[str, float] = friction.wear
    powers = {key: {"power": plain(power), "share": worn.get(key)} for key, power in friction.powers.items()}
    return {
        "friction": powers,
        "efficiency": {
            "instantaneous": plain(friction.efficiency),
            "cycle": friction.cycle,
            "useful": plain(friction.useful),
            "lost": plain(friction.lost),
        },
        "jams": [{**jam._asdict(), "advice": str(jam.advice)} for jam in friction.jams],
    }
