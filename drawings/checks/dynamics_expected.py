"""What the analysis says that a sheet of dynamics must show: each graph by its edges, the loop, speeds (ожидаемое)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plans.model.dynamics import Account, Cycle, Flywheel, Task
from plans.model.motion import Floats

MOMENTS, WORKS, SURPLUS, INERTIA, SPEEDS = "moments", "works", "surplus", "inertia", "speeds"
# A break is known to half the digits of an angle, however it is found; work and inertia beside it, to that share.
KNOWN = 1e-7


@dataclass(frozen=True)
class Expected:
    """The motion of a machine by analysis on the strips of the construction.

    `energy` J at position 0 is what a machine without a flywheel is said to have: its mean speed must come out of it.
    """

    task: Task
    account: Account
    energy: float | None = None

    @property
    def cycle(self) -> Cycle:
        """The account of the turn."""
        assert self.account.cycle is not None  # else no sheet is drawn
        return self.account.cycle

    @property
    def wheel(self) -> Flywheel | None:
        """The flywheel that the corners of the loop ask for."""
        return self.account.flywheel

    @cached_property
    def omega(self) -> Floats | None:
        """The speed at the edges with the flywheel, rad/s; None where no fluctuation is asked for, or it would stop."""
        wheel = self.wheel
        if wheel is None:
            return None
        inertia, energy = wheel.whole, wheel.energy
        if wheel.needed <= 0:
            if self.energy is None:
                return None
            inertia, energy = wheel.own + wheel.present, self.energy
        return np.asarray(np.sqrt(2 * (energy + self.cycle.surplus) / (inertia + self.cycle.varying)))

    @property
    def mean(self) -> float:
        """The mean of the least and the greatest speed, rad/s."""
        return 0.0 if self.omega is None else float(self.omega.min() + self.omega.max()) / 2

    @property
    def graphs(self) -> Mapping[str, Floats]:
        """The values of each graph at the edges, behind a jump; of the speed above its mean."""
        cycle = self.cycle
        after = np.append(-cycle.moments[:, 0], -cycle.moments[-1, 1])
        found = {MOMENTS: after, WORKS: -cycle.work, SURPLUS: cycle.surplus, INERTIA: cycle.varying}
        return found if self.omega is None else {**found, SPEEDS: self.omega - self.mean}

    @property
    def lines(self) -> Mapping[str, tuple[tuple[float, float], ...]]:
        """The straight lines of each graph over the turn, by their values at its ends."""
        work, driving = -float(self.cycle.work[-1]), self.cycle.driving
        found: dict[str, tuple[tuple[float, float], ...]] = {MOMENTS: ((driving, driving),), WORKS: ((0.0, work),)}
        if self.omega is not None:
            levels = (float(extreme(self.omega)) - self.mean for extreme in (np.min, np.max))
            found[SPEEDS] = tuple((level, level) for level in levels)
        return found

    @property
    def before(self) -> Floats:
        """The moments before each edge, N*m."""
        return np.append(-self.cycle.moments[0, 0], -self.cycle.moments[:, 1])

    @property
    def jumps(self) -> frozenset[int]:
        """The edges at which the moment jumps for the eye."""
        apart = np.abs(self.before - self.graphs[MOMENTS])
        return frozenset(np.flatnonzero(apart > SEEN * np.ptp(self.cycle.moments)).tolist())


SEEN = 1e-3  # of the span of the moments: a smaller jump cannot be seen
