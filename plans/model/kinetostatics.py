"""The forces of a mechanism over its positions, whichever road found them (кинетостатика).

A reaction R_ab is the force of link a on link b. Each pair is told once, of its lower-numbered link on the other, under
the key "a-b"; the opposite reaction is its negative.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from plans.model.motion import (
    CHANGE_POINT,
    DEAD_CENTRE,
    FORCES,
    INDETERMINATE,
    NOTHING,
    VELOCITIES,
    Complexes,
    Floats,
    Gap,
)
from plans.words.words import Message, message


class Applied(NamedTuple):
    """A load over the positions: a force N on a point of a link, given by its letter and its place in the link."""

    name: str
    link: int
    point: str
    at: complex
    force: Complexes
    useful: bool = True


class Twist(NamedTuple):
    """A moment N*m on a link over the positions."""

    name: str
    link: int
    moment: Floats
    useful: bool = True


class Loading(NamedTuple):
    """All loads over the positions, without weights and inertia (схема нагружения)."""

    forces: tuple[Applied, ...]
    moments: tuple[Twist, ...]

    @property
    def served(self) -> bool:
        """Whether any load is of use: weight alone is none, and without it there is no efficiency."""
        return any(load.useful for load in self.forces) or any(twist.useful for twist in self.moments)


class Reaction(NamedTuple):
    """A reaction over the positions: force N of the giver on the taker at `r` m, and of a sliding pair its moment.

    The moment N*m is that of the pair about `r`; None of a hinge. `along` is the unit direction of the slide.
    """

    giver: int
    taker: int
    point: str
    r: Complexes
    force: Complexes
    moment: Floats | None = None
    along: Complexes | None = None

    @property
    def arm(self) -> Floats | None:
        """Distance m along the slide from `r` to the reaction's line of action; infinite where but a moment is left."""
        if self.moment is None or self.along is None:
            return None
        across = (self.along.conj() * self.force).imag
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(self.moment == 0, 0.0, self.moment / across)


class Effort(NamedTuple):
    """What the drive gives: the moment N*m about the shaft, and where it drives by a force that force N at `r` m.

    Of a slide that is pushed along the moment is that of the force on a wheel of the drive's unit as its radius.
    """

    moment: Floats
    force: Complexes | None = None
    r: Complexes | None = None


def without_forces(gap: Gap) -> str:
    """Say why a position without velocities has no forces: at a change point links share them in many ways."""
    return INDETERMINATE if gap.reason == CHANGE_POINT else DEAD_CENTRE


@dataclass(frozen=True)
class Kinetostatics:
    """All reactions and the balancing moment of a mechanism over its positions; NaN at gaps."""

    by: str  # "construction" or "analysis"
    phi: Floats
    reactions: Mapping[str, Reaction]
    balancing: Effort
    gaps: tuple[Gap, ...]
    # Positions whose forces have a true digit; beside the others, at a jam, no force of the rest may seem nothing.
    known: npt.NDArray[np.bool_] | None = None

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps of the forces: those named, and those of the velocities, where there are no forces either."""
        named = [gap for gap in self.gaps if gap.plan == FORCES]
        known = {gap.position for gap in named}
        still = [gap for gap in self.gaps if gap.plan == VELOCITIES.plan and gap.position not in known]
        return (*named, *(gap._replace(plan=FORCES, reason=without_forces(gap)) for gap in still))

    @property
    def size(self) -> float:
        """The longest arm about the shaft, m, of the pairs over the positions whose forces are known."""
        return self._largest([reaction.r for reaction in self.reactions.values()])

    @property
    def largest(self) -> float:
        """The largest force N that is known: of the reactions, or of the moments on the longest arm if that is more."""
        reactions = self.reactions.values()
        turning = [reaction.moment for reaction in reactions if reaction.moment is not None]
        most = self._largest([*turning, self.balancing.moment]) / self.size if self.size else 0.0
        return max(self._largest([reaction.force for reaction in reactions]), most)

    @property
    def nothing(self) -> tuple[float, float]:
        """The force N and the moment N*m below which there is none, but rounding of the data that a scene gives."""
        return NOTHING * self.largest, NOTHING * self.largest * self.size

    @property
    def nothing_over(self) -> tuple[Floats, Floats]:
        """The same over the positions: beside their own largest, or the usual one where that is more.

        In a position that all but jams the others' forces stay what they are: what is usual is the middle of them all.
        """
        turning = [reaction.moment for reaction in self.reactions.values() if reaction.moment is not None]
        reach = self.size or 1.0
        rows = [
            *(reaction.force for reaction in self.reactions.values()),
            *(row / reach for row in (*turning, self.balancing.moment)),
        ]
        peaks = np.nan_to_num(np.fmax.reduce([np.abs(row) for row in rows]))
        usual = self.counted(np.where(peaks > 0, peaks, np.nan))
        least = NOTHING * np.maximum(peaks, np.nanmedian(usual) if np.isfinite(usual).any() else 0.0)
        return least, least * self.size

    def nothing_at(self, position: int) -> tuple[float, float]:
        """The same of one position."""
        force, moment = self.nothing_over
        return float(force[position]), float(moment[position])

    def arm(self, key: str) -> Floats | None:
        """Give the arm m of a sliding pair's reaction: 0 where it bears nothing, NaN where it bears a moment alone."""
        reaction, (force, moment) = self.reactions[key], self.nothing
        if reaction.arm is None or reaction.moment is None:
            return None
        alone = np.where(np.abs(reaction.moment) <= moment, 0.0, np.nan)
        return np.where(np.abs(reaction.force) <= force, alone, reaction.arm)

    def counted(self, row: Any) -> Any:
        """Leave of a row over the positions only what is known; of forces that are known nowhere all of it."""
        return row if self.known is None or not self.known.any() else np.where(self.known, row, np.nan)

    def _largest(self, rows: Sequence[Any]) -> float:
        sizes = (np.abs(self.counted(row)) for row in rows)
        return max((float(np.fmax.reduce(size, axis=None, initial=0.0)) for size in sizes), default=0.0)


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
