"""What presses the follower on the cam: force at the contact, lift-off, the spring needed, wear (силы, износ, M6.2)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from plans.cam.profile.profile import slip, slip_slope
from plans.cam.profile.remedy import pressure, pressure_slope
from plans.cam.profile.stretches import Stretches
from plans.cam.profile.tip import Tip
from plans.cam.profile.touch import Touch
from plans.model.cam import Cam, Load
from plans.model.cam_motion import Extreme, Pressing
from plans.model.motion import Floats

NOTHING = Extreme(np.nan, 0.0)  # of a force that no turn bears: the normal stands across the follower's way


@dataclass(frozen=True)
class Contact:
    """The contact of a loaded follower with a cam that goes at its speed, without friction."""

    load: Load
    speed: float
    roller: float  # m

    def resistance(self, tip: Tip) -> Floats:
        """Give what the cam overcomes along the follower's way, N; of a rocker its moment, N*m."""
        s, _, bend = tip.travel
        own = self.load
        return own.mass * self.speed**2 * bend + own.preload + own.stiffness * s + own.force

    def resistance_slope(self, tip: Tip) -> Floats:
        """Give its derivative by the turn."""
        return self.load.mass * self.speed**2 * tip.jerk + self.load.stiffness * tip.travel.slope

    def force(self, tip: Tip) -> Floats:
        """Give the force on the follower along the normal, N: below 0 the cam would have to pull."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return self.resistance(tip) / _arm(tip)

    def force_slope(self, tip: Tip) -> Floats:
        """Give its derivative by the turn."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return (self.resistance_slope(tip) - self.force(tip) * _arm_slope(tip)) / _arm(tip)

    def wear(self, tip: Tip) -> Floats:
        """Give force times sliding speed, W: friction takes it times its coefficient, and what wears goes by it."""
        return np.abs(self.force(tip) * self._slip(tip)) * self.speed

    def wear_slope(self, tip: Tip) -> Floats:
        """Give the derivative of that by the turn, of any sign and in any scale: where it vanishes matters."""
        return self.force_slope(tip) * self._slip(tip) + self.force(tip) * self._slip_slope(tip)

    def _slip(self, tip: Tip) -> Floats:
        return Touch(tip).slip if tip.cam.flat else slip(tip, tip.lever, self.roller)

    def _slip_slope(self, tip: Tip) -> Floats:
        return Touch(tip).slip_slope if tip.cam.flat else slip_slope(tip, self.roller)


def contact_of(cam: Cam, roller: float) -> Contact | None:
    """Give the contact, where the scene asks for it: with a load and a speed."""
    return None if cam.load is None or cam.speed is None else Contact(cam.load, cam.speed, roller)


def pressing(contact: Contact, stretches: Stretches) -> Pressing:
    """Give the extremes of the force and of the wear, and the preload that holds the follower on the cam."""
    forces = stretches.places(contact.force_slope)
    low = stretches.most(lambda tip: -contact.force(tip), forces)
    lack = stretches.most(lambda tip: -contact.resistance(tip), stretches.places(contact.resistance_slope))
    return Pressing(
        least=Extreme(-low.value, low.turned) if low else NOTHING,
        most=stretches.most(contact.force, forces) or NOTHING,
        wear=stretches.most(contact.wear, stretches.places(contact.wear_slope)) or NOTHING,
        preload=contact.load.preload + max(lack.value if lack else 0.0, 0.0),
    )


def _arm(tip: Tip) -> Floats:
    """Give what the force is multiplied by along the follower's way: cos α, of a rocker its arm about the pivot, m."""
    if tip.cam.flat:
        return Touch(tip).place if tip.cam.rocks else np.ones_like(tip.turned)
    return _length(tip) * np.cos(pressure(tip))


def _arm_slope(tip: Tip) -> Floats:
    if tip.cam.flat:
        return Touch(tip).place_slope if tip.cam.rocks else np.zeros_like(tip.turned)
    return -_length(tip) * np.sin(pressure(tip)) * pressure_slope(tip)


def _length(tip: Tip) -> float:
    return tip.cam.follower.length or 0.0 if tip.cam.rocks else 1.0
