"""Extremes of a cam's profile by roots of derivatives: pressure angle, curvature, face, forces (экстремумы)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from plans.analytic.cam.contact import Forces
from plans.analytic.cam.contour import Curve
from plans.analytic.cam.series import Place, Turn, Value
from plans.analytic.cam.shocks import shocks
from plans.model.cam import RETURN, RISE, Cam, interval_of
from plans.model.cam_motion import BEND, SLOPE, Extreme, Pressing, Sizes
from plans.model.motion import Floats

ALIKE = 1e-9  # of the largest: sizes that were found by a limit touch it twice, alike but for rounding


@dataclass(frozen=True)
class Extremes:
    """The extremes of one profile."""

    cam: Cam
    sizes: Sizes

    @cached_property
    def turn(self) -> Turn:
        """The whole turn."""
        return Turn(self.cam, self.sizes)

    @cached_property
    def outrun(self) -> Extreme | None:
        """The largest θ' of a rocker's face that is 1 or more: the cam no longer turns under it."""
        if not (self.cam.flat and self.cam.rocks):
            return None
        most = self.turn.most(lambda curve: curve.rates[0])
        return most if most and most.value >= 1 else None

    @cached_property
    def peaks(self) -> dict[str, Extreme]:
        """The largest S' and S'' by their size, signed; at a hard shock S'' has none."""
        found = {SLOPE: _largest(self.turn, lambda curve: curve.travel.slope)}
        if all(one.order == 2 for one in shocks(self.cam)):
            found[BEND] = _largest(self.turn, lambda curve: curve.travel.bend)
        return found

    @cached_property
    def pressure(self) -> dict[str, Extreme]:
        """The largest pressure angle by its size on every kind of phase that there is, rad, signed."""
        kinds = () if self.outrun else dict.fromkeys(one.kind for one in self.cam.moving())
        return {kind: _largest(Turn(self.cam, self.sizes, (kind,)), lambda curve: curve.pressure) for kind in kinds}

    @cached_property
    def bends(self) -> tuple[Place, ...]:
        """Where the curve can be sharpest."""
        if self.cam.flat:
            return self.turn.places(lambda curve: curve.radius)
        return self.turn.places(lambda curve: curve.curvature)

    @cached_property
    def sharpest(self) -> Extreme | None:
        """The least convex radius; under a flat face the least, signed."""
        if self.outrun:
            return None
        if self.cam.flat:
            least = self.turn.most(lambda curve: -curve.radius, self.bends)
            return Extreme(-least.value, least.turned) if least else None
        most = self.turn.most(lambda curve: curve.curvature, self.bends)
        return Extreme(1 / most.value, most.turned) if most and most.value > 0 else None

    @cached_property
    def hollow(self) -> Extreme | None:
        """The smallest hollow radius, below 0."""
        most = None if self.cam.flat else self.turn.most(lambda curve: -curve.curvature, self.bends)
        return Extreme(-1 / most.value, most.turned) if most and most.value > 0 else None

    @cached_property
    def face(self) -> tuple[float, float]:
        """The least and the greatest place of contact on a flat face, m."""
        if not self.cam.flat or self.outrun:
            return 0.0, 0.0
        found = self.turn.read(lambda curve: curve.place, self.turn.places(lambda curve: curve.place))
        return float(found.min()), float(found.max())

    @property
    def mending(self) -> float | None:
        """R0 that keeps the angle to its limits at the offset as it is: the largest of the positions' own, m."""
        cam, offset = self.cam, self.sizes.offset
        intervals = {kind: interval for kind in (RISE, RETURN) if (interval := interval_of(cam, kind))}
        if cam.rocks or cam.flat or cam.translates or not intervals:
            return None
        heights = [
            Turn(cam, self.sizes, (kind,)).most(partial(_height, offset, limit))
            for kind, interval in intervals.items()
            for limit in interval
        ]
        least = max(0.0, *(one.value for one in heights if one))
        return float((least * least + offset * offset) ** 0.5)

    def pressing(self, forces: Forces) -> Pressing:
        """Give the extremes of the contact's force and wear, and the preload that holds."""
        turn, nothing = self.turn, Extreme(np.nan, 0.0)
        places = turn.places(forces.normal)
        low, high = turn.most(lambda curve: -forces.normal(curve), places), turn.most(forces.normal, places)
        signed = turn.places(lambda curve: forces.normal(curve) * curve.slip(forces.roller))
        lack = turn.most(lambda curve: -forces.along(curve))
        return Pressing(
            least=Extreme(-low.value, low.turned) if low else nothing,
            most=high or nothing,
            wear=turn.most(forces.wear, signed) or nothing,
            preload=forces.load.preload + max(0.0, lack.value if lack else 0.0),
        )


def _largest(turn: Turn, value: Value) -> Extreme:
    """Give the largest of a value by its size, signed: of two alike the one above 0, and the earlier."""
    places = turn.places(value)
    pairs = [*zip(turn.read(value, places).tolist(), (one.turned for one in places), strict=True)]
    most = max(abs(size) for size, _ in pairs)
    alike = [(size, turned) for size, turned in pairs if abs(size) >= most * (1 - ALIKE)]
    return Extreme(*min(alike, key=lambda pair: (pair[0] < 0, pair[1])))


def _height(offset: float, limit: float, curve: Curve) -> Floats:
    """Give S0 with which (5.28) is just the limit, signed."""
    return np.asarray((curve.travel.slope - offset) / np.tan(limit) - curve.travel.s)
