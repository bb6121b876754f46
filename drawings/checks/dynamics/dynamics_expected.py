"""What the analysis says that a sheet of dynamics must show: each graph by its edges, the loop, speeds (ожидаемое)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from plans.model.account import Account
from plans.model.dynamics import Cycle, Flywheel, Task
from plans.model.motion import Floats

MOMENTS, WORKS, SURPLUS, INERTIA, SPEEDS = "moments", "works", "surplus", "inertia", "speeds"
# A break is known to half the digits of an angle, however it is found; work and inertia beside it, to that share.
KNOWN = 1e-7


@dataclass(frozen=True)
class Expected:
    """The motion of a machine by analysis on the strips of the construction."""

    task: Task
    found: Account

    @property
    def account(self) -> Account:
        """All of it."""
        return self.found

    @property
    def cycle(self) -> Cycle:
        """The account of the turn."""
        assert self.found.cycle is not None  # else no sheet is drawn
        return self.found.cycle

    @property
    def wheel(self) -> Flywheel | None:
        """The flywheel that the corners of the loop ask for."""
        return self.found.flywheel

    @property
    def omega(self) -> Floats | None:
        """The speed at the edges, rad/s; None where no fluctuation is asked for, or the machine would stop."""
        return None if self.account.speeds is None else self.account.speeds.omega

    @property
    def mean(self) -> float:
        """The mean of the least and the greatest speed, rad/s."""
        return 0.0 if self.account.speeds is None else self.account.speeds.mean

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
