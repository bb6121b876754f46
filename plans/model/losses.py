"""What friction takes from a machine, whichever road found it: powers, efficiency, wear, jams (трение, кпд, износ)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from plans.model.motion import Floats
from plans.words.words import Message, message

SLANTED, TILTED, CENTRAL = (message(f"jam.{kind}") for kind in ("slanted", "tilted", "central"))


class Jam(NamedTuple):
    """A position in which a pair jams (заклинивание): the friction is `ratio` >= 1 times the part that drives."""

    pair: str
    position: int
    phi: float  # rad
    ratio: float
    advice: Message


@dataclass(frozen=True)
class Friction:
    """What friction takes from a machine over its positions, (N,) each; NaN at gaps.

    The driving force of a pair is really 1/(1 - `locking`) times the one without friction: powers are told well while
    `locking` is small, and where the machine jams they tell nothing. Pairs without friction data are left out.
    """

    by: str  # "construction" or "analysis"
    phi: Floats  # rad
    powers: Mapping[str, Floats]  # W lost in each pair, "a-b", in the order of the scene
    useful: Floats  # W that the useful loads take; 0 in idle positions
    lost: Floats  # W in all pairs together (7.2)
    efficiency: Floats  # instantaneous (7.1, мгновенный кпд): idle 0, and NaN where nothing is used or lost
    cycle: float | None  # of the mean powers, not the mean of efficiencies (цикловой кпд); None: no cycle
    wear: Mapping[str, float]  # share of each pair in the work of friction, the most worn first; empty: no friction
    locking: Mapping[str, Floats]  # of pairs that a group drives: friction over driving force
    driving: Mapping[str, Floats]  # W with which the group drives the link of such a pair, and the rest's friction
    jams: tuple[Jam, ...]

    @property
    def loss(self) -> Floats:
        """Loss coefficient xi = 1 - efficiency (коэффициент потерь)."""
        return 1.0 - self.efficiency

    @property
    def shares(self) -> Mapping[str, Floats]:
        """Share of each pair in the power lost, position by position (износ); NaN where nothing is lost."""
        with np.errstate(invalid="ignore"):
            return {key: power / self.lost for key, power in self.powers.items()}
