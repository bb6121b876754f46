"""Friction of a machine: powers lost in its pairs, efficiency, wear, and where it jams (трение, кпд, износ; chapter 7).

Whichever road found motion and reactions; these are without friction, so that errors of the order f^2 are left in the
powers lost and in the efficiency, and of the order f in the shares of wear (M6.2).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from plans import locking, rubbing
from plans.kinetostatics import Kinetostatics, Loading
from plans.locking import Jam
from plans.machine import Machine
from plans.mechanism import Mechanism
from plans.motion import Floats, Motion
from plans.structure import Dyad

EPS = float(np.finfo(float).eps)
# Two angles of a turn, each rounded once where it was divided, once where it was started and once as radians.
ROUNDINGS = 6


@dataclass(frozen=True)
class Friction:
    """What friction takes from a machine over its positions; NaN at gaps. Pairs without friction data are left out.

    The driving force of a pair is really 1/(1 - `locking`) times the one without friction: powers are told well while
    `locking` is small, and where the machine jams they tell nothing.
    """

    by: str  # "construction" or "analysis"
    phi: Floats  # rad
    powers: Mapping[str, Floats]  # W lost in each pair, "a-b", in the order of the scene
    useful: Floats  # W that the useful loads take; 0 in idle positions
    locking: Mapping[str, Floats]  # of pairs that a group drives: friction over driving force, see plans.locking
    jams: tuple[Jam, ...]

    @cached_property
    def lost(self) -> Floats:
        """Power W lost in all pairs together (7.2)."""
        return np.asarray(sum(self.powers.values(), np.where(np.isnan(self.useful), np.nan, 0.0)))

    @property
    def efficiency(self) -> Floats:
        """Instantaneous efficiency N_us/(N_us + N_fr) (мгновенный кпд; 7.1): idle 0, and NaN where both are 0."""
        with np.errstate(invalid="ignore"):
            return np.asarray(self.useful / (self.useful + self.lost))

    @property
    def loss(self) -> Floats:
        """Loss coefficient xi = 1 - efficiency (коэффициент потерь)."""
        return 1.0 - self.efficiency

    @property
    def known(self) -> npt.NDArray[np.bool_]:
        """Positions that are no gaps."""
        return np.isfinite(self.useful + self.lost)

    @property
    def whole(self) -> bool:
        """Whether the positions divide a full turn evenly and none is a gap: at a steady omega, equal times apart."""
        if len(self.phi) < 2 or not self.known.all():
            return False
        steps = np.diff(self.phi)
        off = np.abs(steps - np.copysign(2 * np.pi / len(self.phi), steps[0])).max()
        return bool(off <= ROUNDINGS * EPS * (np.abs(self.phi).max() + 2 * np.pi))

    @property
    def cycle(self) -> float | None:
        """Efficiency over a cycle: of the mean powers, not the mean of efficiencies (цикловой кпд); None: no cycle."""
        used, all_power = float(self.useful.sum()), float((self.useful + self.lost).sum())
        return used / all_power if self.whole and all_power > 0 else None

    @cached_property
    def shares(self) -> Mapping[str, Floats]:
        """Share of each pair in the power lost, position by position (износ); NaN where nothing is lost."""
        with np.errstate(invalid="ignore"):
            return {key: power / self.lost for key, power in self.powers.items()}

    @cached_property
    def wear(self) -> Mapping[str, float]:
        """Share of each pair in the work of friction over all positions that have it, the most worn pair first.

        It is empty where nothing is lost.
        """
        known = self.known
        total = float(self.lost[known].sum())
        parts = {key: float(power[known].sum()) / total for key, power in self.powers.items()} if total > 0 else {}
        return dict(sorted(parts.items(), key=lambda part: -part[1]))


@np.errstate(divide="ignore", invalid="ignore")  # a gap is NaN inside; a ray without effect is a dead centre
def friction(
    mechanism: Mechanism,
    groups: Sequence[Dyad],
    machine: Machine,
    motion: Motion,
    loading: Loading,
    statics: Kinetostatics,
) -> Friction:
    """Find what friction takes from a machine: `motion` and `statics` are of one road, at the same positions (M6)."""
    # A hinge of several links has more pairs than those on which the groups hang, and whose reactions are told.
    pairs = {key: one for key, one in machine.friction.items() if key in statics.reactions}
    rates = {key: rubbing.rate(mechanism, motion, statics.reactions[key]) for key in pairs}
    gone = ~np.isfinite(statics.balancing.moment)
    powers = {
        key: np.where(gone, np.nan, rubbing.lost(rubs, statics.reactions[key], rates[key]))
        for key, rubs in pairs.items()
    }
    useful = np.where(gone, np.nan, rubbing.useful(mechanism, motion, loading))
    driven = {key: drive for key, drive in locking.drives(groups, statics.reactions) if key in pairs}
    jams = [jam for key, drive in driven.items() for jam in locking.jams(drive, pairs[key], rates[key], motion.phi)]
    ratios = {key: drive.ratio(pairs[key]) for key, drive in driven.items()}
    return Friction(statics.by, motion.phi, powers, useful, ratios, tuple(sorted(jams, key=lambda jam: jam.position)))
