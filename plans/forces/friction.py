"""Friction of a machine by construction: powers lost in its pairs, efficiency, wear, jams (chapter 7).

It rests on reactions without friction, so that errors of the order f^2 are left in the powers lost and in the
efficiency, and of the order f in the shares of wear (M6.2). The other road is plans.analytic.friction.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from plans.forces import locking, rubbing
from plans.model.group import Group
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.losses import Friction
from plans.model.machine import Machine
from plans.model.mechanism import Mechanism
from plans.model.motion import Floats, Motion

EPS = float(np.finfo(float).eps)
# Two angles of a turn, each rounded once where it was divided, once where it was started and once as radians.
ROUNDINGS = 6


@np.errstate(divide="ignore", invalid="ignore")  # a gap is NaN inside; a ray without effect is a dead centre
def friction(
    mechanism: Mechanism,
    groups: Sequence[Group],
    machine: Machine,
    motion: Motion,
    loading: Loading,
    statics: Kinetostatics,
    times: Floats | float = 1.0,
) -> Friction:
    """Find what friction takes from a machine: `motion` and `statics` are of one road, at the same positions (M6).

    `times` are what the positions take of even ones over a turn, in one measure.
    """
    # A hinge of several links has more pairs than those on which the groups hang, and whose reactions are told.
    pairs = {key: one for key, one in machine.friction.items() if key in statics.reactions}
    rates = {key: rubbing.rate(mechanism, motion, statics.reactions[key]) for key in pairs}
    gone = ~np.isfinite(statics.balancing.moment)
    powers = {
        key: np.where(gone, np.nan, rubbing.lost(rubs, statics.reactions[key], rates[key]))
        for key, rubs in pairs.items()
    }
    useful = np.where(gone, np.nan, rubbing.useful(mechanism, motion, loading))
    lost = np.asarray(sum(powers.values(), np.where(np.isnan(useful), np.nan, 0.0)))
    driven = {key: drive for key, drive in locking.drives(groups, statics.reactions) if key in pairs}
    jams = [jam for key, drive in driven.items() for jam in locking.jams(drive, pairs[key], rates[key], motion.phi)]
    return Friction(
        by=statics.by,
        phi=motion.phi,
        powers=powers,
        useful=useful,
        lost=lost,
        efficiency=np.asarray(useful / (useful + lost)),
        cycle=_cycle(motion.phi, times * useful, times * lost),
        wear=_wear({key: times * power for key, power in powers.items()}, times * lost),
        locking={key: drive.ratio(pairs[key]) for key, drive in driven.items()},
        driving={key: drive.power(pairs[key], rates[key]) for key, drive in driven.items()},
        jams=tuple(sorted(jams, key=lambda jam: jam.position)),
    )


def whole(phi: Floats, known: npt.NDArray[np.bool_]) -> bool:
    """Tell whether positions divide a full turn evenly and none is a gap."""
    if len(phi) < 2 or not known.all():
        return False
    steps = np.diff(phi)
    off = np.abs(steps - np.copysign(2 * np.pi / len(phi), steps[0])).max()
    return bool(off <= ROUNDINGS * EPS * (np.abs(phi).max() + 2 * np.pi))


def _cycle(phi: Floats, useful: Floats, lost: Floats) -> float | None:
    used, all_power = float(useful.sum()), float((useful + lost).sum())
    return used / all_power if whole(phi, np.isfinite(useful + lost)) and all_power > 0 else None


def _wear(powers: Mapping[str, Floats], lost: Floats) -> dict[str, float]:
    known = np.isfinite(lost)
    total = float(lost[known].sum())
    parts = {key: float(power[known].sum()) / total for key, power in powers.items()} if total > 0 else {}
    return dict(sorted(parts.items(), key=lambda part: -part[1]))
