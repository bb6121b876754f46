"""The force at the contact by the work of a small turn, and the wear (сила в контакте по мощностям, M6.2)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from plans.analytic.cam.contour import Curve
from plans.model.cam import Cam, Load
from plans.model.motion import Floats


class Forces(NamedTuple):
    """A loaded follower on a cam that goes at its speed, without friction."""

    load: Load
    speed: float
    roller: float  # m

    def along(self, curve: Curve) -> Floats:
        """Give what the cam overcomes along the follower's way, N; of a rocker its moment, N*m."""
        s, _, bend = curve.travel
        spring = self.load.preload + s * self.load.stiffness
        return np.asarray(self.load.force + spring + bend * (self.load.mass * self.speed * self.speed))

    def normal(self, curve: Curve) -> Floats:
        """Give the force along the normal, N: its point goes by OD's part along the way for a unit of the normal's."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(self.along(curve) / self._gear(curve))

    @staticmethod
    def _gear(curve: Curve) -> Floats:
        """Give how far the point of contact goes along the normal while S grows by 1."""
        if curve.cam.flat:
            return curve.place if curve.cam.rocks else np.ones_like(curve.turned)
        return (curve.length if curve.cam.rocks else 1.0) * curve.parts[1] / curve.speed

    def wear(self, curve: Curve) -> Floats:
        """Give force times sliding speed, W."""
        return np.abs(self.normal(curve) * curve.slip(self.roller)) * self.speed


def forces_of(cam: Cam, roller: float) -> Forces | None:
    """Give the forces, where the scene asks for them: with a load and a speed."""
    return None if cam.load is None or cam.speed is None else Forces(cam.load, cam.speed, roller)
