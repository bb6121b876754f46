"""The S-S' diagram: the follower's point K with KD = S' turned with the cam, wherever O will be (диаграмма S - dS/dφ).

Its own frame: of a follower that translates the start A is the origin, of one that rocks its pivot O1.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass

import numpy as np

from plans.cam.centre.instants import Instant
from plans.cam.profile.tip import arm
from plans.model.cam import RISE, Cam
from plans.model.cam_motion import Points
from plans.model.motion import Floats


@dataclass(frozen=True)
class SlopeDiagram:
    """K and D of a cam's follower, in m."""

    cam: Cam

    @property
    def length(self) -> float:
        """The rocker's length l, m."""
        length = self.cam.follower.length
        assert length is not None  # asked of each rocker by the reader
        return length

    def leaning(self, s: Floats) -> Points:
        """Give how the way of K leans at some S: a unit vector, 1 where it goes straight up."""
        if not self.cam.rocks:
            return np.ones_like(s, dtype=complex)
        return self.cam.rising * arm(self.cam, s)

    def tip(self, motion: Instant) -> Points:
        """Give K: (N,) complex, m."""
        if not self.cam.rocks:
            return np.asarray(1j * motion.s)
        return np.asarray(self.cam.rising * self.length * self.leaning(motion.s))

    def end(self, motion: Instant) -> Points:
        """Give D: (N,) complex, m."""
        if not self.cam.rocks:
            return np.asarray(1j * motion.s - self.cam.sense * motion.slope)
        return np.asarray(self.tip(motion) * (1 - self.cam.follower.sense * motion.slope))

    def drift(self, motion: Instant) -> Points:
        """Give D', the derivative of D by the cam's turn."""
        if not self.cam.rocks:
            return np.asarray(1j * motion.slope - self.cam.sense * motion.bend)
        tip, sense = self.tip(motion), self.cam.follower.sense
        return np.asarray(
            tip * (1j * self.cam.rising * motion.slope * (1 - sense * motion.slope) - sense * motion.bend)
        )

    def turning(self, motion: Instant) -> Floats:
        """Give how fast the way of K turns, by the cam's turn."""
        return self.cam.rising * motion.slope if self.cam.rocks else np.zeros_like(motion.slope)

    def limit(self, side: int, angle: float) -> complex:
        """Give the direction of a limiting line beside a way that goes straight up: up, leaning by the angle.

        `side` is +1 for pressure angles up to the limit, -1 for those down to the limit below 0.
        """
        return 1j * cmath.exp(1j * self.cam.sense * side * angle)


def side_of(kind: str) -> int:
    """Give on which side a phase presses: rises above 0, returns below."""
    return 1 if kind == RISE else -1
