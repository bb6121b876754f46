"""The numbers of a balanced mechanism as plain data, for `solve`: SI units, radians, null at gaps."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

from plans.analytic.balance.balance import balance
from plans.analytic.balance.main_points import vectors
from plans.analytic.balance.mass_centre import bodies
from plans.balance.states import positions_around
from plans.balance.study import CENTRE, COSTS, COUNTERWEIGHTS, BalanceStudy
from plans.checks.balance.comparison import course_of
from plans.checks.motion_numbers import MotionNumbers
from plans.checks.plain_numbers import gap_numbers, pairs, plain
from plans.model.balance.linkage import ANALYSIS, Balance, Choice, Counterweight, MassCentre, Shares, State

if TYPE_CHECKING:
    from plans.study import Study


Vectors: TypeAlias = tuple[Mapping[int, complex], Mapping[int, complex] | None]


@dataclass(frozen=True)
class BalanceNumbers:
    """What balances a mechanism, by one road; `vectors` are those of main points before and after, m by link."""

    title: str
    datum: complex
    balance: Balance
    vectors: Vectors
    plans: frozenset[str]

    @property
    def flawed(self) -> bool:
        """Whether some positions have no numbers."""
        return bool(self.balance.gaps)

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        found, (before, after) = self.balance, self.vectors
        data: dict[str, Any] = {"aim": found.task.aim}
        if CENTRE in self.plans:
            data["mass_centre"] = _centre(found.before.centre, before, self.datum)
        if COUNTERWEIGHTS in self.plans and found.after is not None:
            data["counterweights"] = [_weight(one) for one in found.counterweights]
            data["left"] = {point: _vector(mass) for point, mass in found.left.items()}
            data["balanced_centre"] = _centre(found.after.centre, after or {}, self.datum)
        if COSTS in self.plans:
            data["before"] = _state(found.before)
            data |= {} if found.after is None else {"after": _state(found.after)}
            data |= {} if found.shares is None else {"shares": _shares(found.shares)}
        gaps = [gap_numbers(gap) for gap in found.gaps]
        return {"scene": self.title, "by": found.by, "balance": data | ({"gaps": gaps} if gaps else {})}


def numbers(study: Study, by: str) -> BalanceNumbers:
    """Balance the mechanism of a scene by a road, over its motion by the same."""
    its, below = study["balance"], study.numbers("linkage", by)
    found, told = _analysed(its, below) if by == ANALYSIS else _constructed(its)
    return BalanceNumbers(study.scene.heading(), below.datum, found, told, study.plans)


def _constructed(study: BalanceStudy) -> tuple[Balance, Vectors]:
    after = study.points(after=True).vectors if study.balance.after is not None else None
    return study.balance, (study.points().vectors, after)


def _analysed(study: BalanceStudy, below: MotionNumbers) -> tuple[Balance, Vectors]:
    """Balance by analysis alone, over a turn from its own first position on; what cannot be is refused as ever."""
    _ = study.counterweights  # least squares would tell the nearest instead
    road, motion = below.road, below.motion
    assert road is not None  # the motion was found by analysis too
    turned = positions_around(study.linkage).phi - study.linkage.turn.phi[0]
    course = course_of(study, road, motion, road.around(motion.phi[0] + turned))
    found = balance(course, study.task, study.linkage.groups)
    return found, _vectors(study, found)


def _vectors(study: BalanceStudy, found: Balance) -> Vectors:
    """Give the vectors of main points before and after by analysis, the counterweights as bodies of their own."""
    stems, machine = study.tree.stems, study.machine
    before = vectors(bodies(machine), stems)
    return before, None if found.after is None else vectors(bodies(machine, found.counterweights), stems)


def _centre(one: MassCentre, told: Mapping[int, complex], datum: complex) -> dict[str, Any]:
    """Give the mass centre over the positions; the vectors h of the links are in their own frames.

    The main moment of the inertia forces is about the shaft.
    """
    return {
        "mass": one.mass,
        "r": pairs(one.r + datum),
        "a": pairs(one.a),
        "force": pairs(one.force),
        "moment": plain(one.moment),
        "vectors": {str(link): _vector(h) for link, h in sorted(told.items())},
    }


def _weight(one: Counterweight) -> dict[str, Any]:
    """Give a counterweight; one that is not needed has a mass of 0 and no place."""
    data: dict[str, Any] = {"on": one.link, "mass": one.mass, "moment": _vector(one.moment), "begin": one.begin}
    if not one.needed:
        return data
    sizes = {"shape": one.place.shape, "outer": one.outer, "inertia": one.inertia}
    return data | {"centre": _vector(one.centre), "distance": one.distance} | sizes


def _state(one: State) -> dict[str, Any]:
    """Give what is largest over a turn; null of a mechanism that reaches no position."""
    return {
        "path": _known(one.path),
        "force": _known(one.shaking),
        "moment": _known(one.rocking),
        "reactions": {key: _known(largest) for key, largest in one.reactions.items()},
        "balancing": _known(one.balancing),
    }


def _shares(found: Shares) -> dict[str, Any]:
    return {
        "curve": [_choice(one) for one in found.curve],
        "least_force": _choice(found.least_force),
        "least_reaction": _choice(found.least_reaction),
    }


def _choice(one: Choice) -> dict[str, float | None]:
    return {"share": one.share, "force": _known(one.force), "reaction": _known(one.reaction)}


def _known(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _vector(value: complex) -> list[float]:
    return [value.real + 0.0, value.imag + 0.0]
