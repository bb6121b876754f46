"""How far rounding can move what is found of a cam, so that no difference of both roads is judged by a guess (допуск).

A number of a law is a sum of terms, each with a few roundings; what hangs on it is moved by as much as it hangs on it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from plans.cam.laws import law_of
from plans.cam.sizing import Sizing
from plans.model.cam import TABLE, Law
from plans.model.cam_motion import CamFound, Contour
from plans.model.motion import Floats

EPS = 2.0**-52
# What a term of a law goes through on either road: the share of the phase, its power or sine, its coefficient, which is
# itself scaled to the lift, and the sum; a tangent, a root, a product and a quotient are no more.
TERM = 16 * EPS


@dataclass(frozen=True)
class Slack:
    """How far rounding can move the numbers of one cam by either road; (N,) at the turns of a contour."""

    found: CamFound
    sizing: Sizing
    contour: Contour

    def travel(self, order: int) -> float:
        """Of S, S' or S''."""
        cam = self.found.cam
        moving = (abs(p.change) / p.angle**order * gross(p.law, order) for p in cam.moving() if p.law)
        return TERM * (max(moving, default=0.0) + (cam.lift if order == 0 else 0.0))

    def way(self, order: int) -> float:
        """Of the tip's path or a derivative of it, m."""
        cam = self.found.cam
        return self.travel(order) * ((cam.follower.length or 0.0) + self.reach if cam.rocks else 1.0)

    @cached_property
    def reach(self) -> float:
        """The longest length of the cam, m."""
        sizes, contour = self.found.sizes, self.found.contour
        known = (sizes.base, sizes.centre, abs(sizes.pivot), self.found.roller, float(np.max(np.abs(contour.pitch))))
        return max(known)

    @cached_property
    def centre(self) -> float:
        """Of the centre O, m: where limiting lines cross, it is moved by more than they are."""
        ways = [complex(one.direction.point) for one in self.sizing.binding]
        sines = [abs((a.conjugate() * b).imag) / abs(a * b) for a in ways for b in ways if a is not b]
        moved = self.way(0) + self.way(1) + TERM * self.reach
        return moved / min(sines, default=1.0)

    @property
    def point(self) -> float:
        """Of a point of the pitch curve, m."""
        return self.way(0) + self.centre + TERM * self.reach

    @property
    def lever(self) -> float:
        """Of OD, m; of a unit normal too."""
        return self.point + self.way(1)

    @property
    def angle(self) -> Floats:
        """Of the direction of OD, rad."""
        return np.asarray(self.lever / np.abs(self.contour.lever) + TERM)

    @property
    def profile(self) -> Floats:
        """Of a point of the working profile, m."""
        return np.asarray(self.point + self.found.roller * self.angle)

    @property
    def curvature(self) -> Floats:
        """Of 1/ρ, 1/m: a quotient of the second derivative and the cube of the first, OD."""
        contour = self.contour
        if self.found.cam.flat:
            return self._faced
        size, (first, second) = np.abs(contour.lever), (self.way(1), self.way(2))
        slope = np.abs(contour.travel.slope)
        bend = np.abs(contour.travel.bend) + 2 * slope + (slope**2 if self.found.cam.rocks else 0.0)
        bend = bend * (self.found.cam.follower.length or 1.0) + np.abs(contour.tip)
        moved = second + 2 * (1 + slope) * first + self.point  # of the second derivative: S'', S' and its square, S
        return np.asarray((moved + 3 * self.lever * bend / size) / size**2)

    @property
    def _faced(self) -> Floats:
        """Of 1/ρ under a flat face: the radius is a sum of lengths, of a rocker over powers of 1 - θ'."""
        cam, contour = self.found.cam, self.contour
        lead = 1 - cam.follower.sense * contour.travel.slope if cam.rocks else np.ones_like(contour.turned)
        moved = (self.point + self.way(1) + self.way(2)) / np.abs(lead) ** 3
        return np.asarray(moved / contour.radius**2)


def gross(law: Law, order: int) -> float:
    """Give what the terms of a law, or of a derivative, add up to, in shares of phase and lift.

    The slopes and bends of a table are differences of its points over its steps, all solved together.
    """
    own = law_of(law).gross(order) + law_of(law).gross(order + 1)  # the share of the phase is rounded too
    if law.name != TABLE:
        return own
    step = min(b[0] - a[0] for a, b in pairwise(law.points))
    return own + len(law.points) / step**order
