"""A steady turn of a machine by the analysis, on the strips of the construction: values at edges, curves (цикл)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np

from plans.model.account import Account
from plans.model.dynamics import TURN, Cycle, Flywheel, Speeds, Task
from plans.model.motion import Complexes, Floats

MOMENTS, WORKS, SURPLUS, INERTIA, SPEEDS = "moments", "works", "surplus", "inertia", "speeds"
# A break is known to half the digits of an angle, however it is found; work and inertia beside it, to that share.
KNOWN = 1e-7
STEPS = 360  # of a turn at least: by these the loop is drawn

Curve: TypeAlias = Callable[[Floats], Floats]


@dataclass(frozen=True)
class Turn:
    """The motion of a machine by analysis on the strips of the construction."""

    task: Task
    account: Account

    @property
    def cycle(self) -> Cycle:
        """The account of the turn."""
        assert self.account.cycle is not None  # else no graph is drawn
        return self.account.cycle

    @property
    def wheel(self) -> Flywheel | None:
        """The flywheel that the corners of the loop ask for."""
        return self.account.flywheel

    @property
    def omega(self) -> Floats | None:
        """The speed at the edges, rad/s; None where no fluctuation is asked for, or the machine would stop."""
        return None if self.account.speeds is None else self.account.speeds.omega

    @property
    def mean(self) -> float:
        """The mean of the least and the greatest speed, rad/s."""
        return 0.0 if self.account.speeds is None else self.account.speeds.mean

    @cached_property
    def graphs(self) -> Mapping[str, Floats]:
        """The values of each graph at the edges, behind a jump; of the speed above its mean."""
        cycle = self.cycle
        after = np.append(-cycle.moments[:, 0], -cycle.moments[-1, 1])
        found = {MOMENTS: after, WORKS: -cycle.work, SURPLUS: cycle.surplus, INERTIA: cycle.varying}
        return found if self.omega is None else {**found, SPEEDS: self.omega - self.mean}

    @property
    def before(self) -> Floats:
        """The moments before each edge, N*m."""
        return np.append(-self.cycle.moments[0, 0], -self.cycle.moments[:, 1])

    def moment(self, at: Floats) -> Floats:
        """Give the moment of the loads as it is drawn: in each strip a parabola through its ends and its middle."""
        k, s, _ = self._strip(at)
        (first, last), middle = self.cycle.moments[k].T, self.cycle.means[k]
        return np.asarray(first + (last - first) * s + 4 * (middle - (first + last) / 2) * s * (1 - s))

    def energy(self, at: Floats) -> Floats:
        """Give the surplus energy as it is drawn: its slopes are those of the moments."""
        return self.cycle.driving * at + self._cubic(at, self.cycle.work, self.cycle.moments)

    def inertia(self, at: Floats) -> Floats:
        """Give the inertia that varies as it is drawn: at an edge with the slope of the parabola through three."""
        x, y = self.cycle.turned, self.cycle.varying
        around = np.gradient(np.r_[y[-2], y, y[1]], np.r_[x[-2] - TURN, x, x[1] + TURN])[1:-1]
        return self._cubic(at, y, np.column_stack([around[:-1], around[1:]]))

    def speed(self, at: Floats, speeds: Speeds) -> Floats:
        """Give the speed by the energy and the inertia of the whole machine, rad/s."""
        energy = np.maximum(speeds.energy + self.energy(at), 0.0)
        return np.asarray(np.sqrt(2 * energy / (speeds.inertia + self.inertia(at))))

    @property
    def loop(self) -> Complexes:
        """The loop: inertia kg*m2 and energy J, at the edges and between them."""
        turned, count = self.cycle.turned, -(-STEPS // len(self.cycle.means))
        at = (turned[:-1, None] + np.diff(turned)[:, None] * np.linspace(0.0, 1.0, count + 1)).ravel()
        return np.asarray(self.inertia(at) + 1j * self.energy(at))

    def _strip(self, at: Floats) -> tuple[np.ndarray[tuple[int, ...], np.dtype[np.intp]], Floats, Floats]:
        """Give the strips in which angles are, in which share of them, and how wide they are."""
        turned = self.cycle.turned
        k = np.clip(np.searchsorted(turned, at, "right") - 1, 0, len(turned) - 2)
        wide = np.diff(turned)[k]
        return k, (at - turned[k]) / wide, wide

    def _cubic(self, at: Floats, y: Floats, slopes: Floats) -> Floats:
        """Follow in each strip the cubic with given ends and slopes there (n, 2)."""
        k, s, wide = self._strip(at)
        ends = y[k] * (1 + 2 * s) * (1 - s) ** 2 + y[k + 1] * s**2 * (3 - 2 * s)
        return np.asarray(ends + wide * s * (1 - s) * (slopes[k, 0] * (1 - s) - slopes[k, 1] * s))
