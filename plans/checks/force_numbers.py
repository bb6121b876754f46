"""The numbers of forces as plain data: reactions, balancing moment, friction, efficiency (силы в числах).

SI units, null at gaps; places are coordinates of the scene.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plans.checks.motion_numbers import MotionNumbers
from plans.checks.plain_numbers import gap_numbers, pairs, plain
from plans.forces.statics import Statics
from plans.model.kinetostatics import Kinetostatics, Reaction
from plans.model.losses import Friction
from plans.model.motion import Floats

if TYPE_CHECKING:
    from plans.study import Study


@dataclass(frozen=True)
class ForceNumbers:
    """The forces of a linkage by one road, and what friction takes; either where it is asked for."""

    datum: complex
    solved: Kinetostatics
    forces: bool
    friction: Friction | None
    push: Floats | None = None  # N: of a drive over a stroke, the force told in place of a moment

    @property
    def flawed(self) -> bool:
        """Whether some position has no forces, or some pair jams."""
        return bool(self.solved.gaps) or (self.friction is not None and bool(self.friction.jams))

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data; their gaps stand in the place of those of the motion."""
        told: dict[str, Any] = {"gaps": [gap_numbers(gap) for gap in self.solved.gaps]}
        if self.forces:
            told |= described(self.solved, self.datum)
        if self.forces and self.push is not None:
            told["balancing"] = {"push": plain(self.push)} | told["balancing"]
            told["balancing"].pop("moment")
        return told if self.friction is None else told | rubbed(self.friction)


def numbers(study: Study, by: str) -> ForceNumbers:
    """Find the forces of a scene by a road, over its motion by the same."""
    statics, below = study["forces"], study.numbers("linkage", by)
    rubs = "friction" in study.plans and (study.chosen or bool(statics.machine.friction))
    solved, friction = _analysed(statics, below, rubs) if by == "analysis" else _constructed(statics, below, rubs)
    push = None
    if not statics.study.mechanism.drive.turns:
        push = statics.given(solved, below.motion)
    return ForceNumbers(below.datum, solved, "forces" in study.plans, friction, push)


def _constructed(statics: Statics, below: MotionNumbers, rubs: bool) -> tuple[Kinetostatics, Friction | None]:
    if not rubs:
        return statics.forces, None
    from plans.forces.friction import friction  # noqa: PLC0415  (only friction pays for it)

    study, motion = statics.study, below.motion
    loads = statics.loading(motion)
    times = study.turn.times
    return statics.forces, friction(
        study.mechanism, study.groups, statics.machine, motion, loads, statics.forces, times
    )


def _analysed(statics: Statics, below: MotionNumbers, rubs: bool) -> tuple[Kinetostatics, Friction | None]:
    from plans.analytic.kinetostatics import kinetostatics  # noqa: PLC0415  (only the analysis pays for it)

    road, motion, machine = below.road, below.motion, statics.machine
    assert road is not None  # the motion was found by analysis too
    loads = statics.loading_over(motion, statics.over(road.extremes))
    solved = kinetostatics(road, machine, motion, loads, statics.pairs)
    if not rubs:
        return solved, None
    from plans.analytic.friction import friction  # noqa: PLC0415  (only friction pays for it)

    return solved, friction(road, machine, motion, loads, solved, statics.pairs)


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
