"""Which powers that friction takes are none: but rounding, also beside a position that all but jams (потери)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import indices
from plans.model.losses import Friction
from plans.model.motion import NOTHING, Floats


class Least(NamedTuple):
    """The powers W over the positions up to which there are none: lost in each pair, in all, and of useful loads."""

    pairs: tuple[Floats, ...]
    lost: Floats
    useful: Floats


def least(comparison: ForceComparison, found: Friction) -> Least:
    """Give what is but rounding.

    Beside a position that all but jams much seems nothing: it is so only if the two roads cannot tell it from none.
    """
    most = NOTHING * max(float(np.nanmax(np.abs(one), initial=0.0)) for one in (found.lost, found.useful))
    slack = {one.name: np.minimum(one.allowed, most) for one in comparison.of("friction")}
    own = tuple(slack[f"N_{indices(*map(int, key.split('-')))}"] for key in found.powers)
    return Least(own, np.minimum(np.sum(own, axis=0), most), slack["N_us"])
