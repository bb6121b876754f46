"""What the vectors of the plans must be by analysis alone: the other road's word on every named arrow (ожидаемые)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from plans.linkage.groups.kinds import KINDS
from plans.linkage.groups.vectors import Slotted, Turning, Vector
from plans.linkage.letters import Letters
from plans.linkage.primary import PRIMARIES
from plans.model.group import Group
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion

# A vector by the plan's subject and the names of its ends: ("velocities", "a", "b").
Arrow = tuple[str, str, str]


class Expected:
    """The vectors of the plans of one position, from the motion by analysis; the relative-motion formulas are M3.1."""

    def __init__(self, mechanism: Mechanism, motion: Motion, position: int, letters: Letters) -> None:
        self.mechanism, self.motion, self.k, self.letters = mechanism, motion, position, letters

    def arrows(self, groups: Sequence[Group]) -> dict[Arrow, complex]:
        """Give every arrow that a plan may show between named points, normal and Coriolis ends."""
        found = dict(self._absolute())
        told = [*PRIMARIES[self.mechanism.drive.kind].vectors(self.mechanism)]
        for group in groups:
            told += KINDS[group.kind].vectors(group)
        for vector in told:
            found.update(self._of(vector))
        return found

    def _of(self, vector: Vector) -> Iterable[tuple[Arrow, complex]]:
        match vector:
            case Turning():
                return self._turning(vector)
            case Slotted():
                return self._slotted(vector)
        return ()

    def moving(self) -> list[str]:
        """Give the points that have velocities of their own."""
        return [name for name in self.motion.points if name not in self.mechanism.links[FRAME].points]

    def _absolute(self) -> Iterator[tuple[Arrow, complex]]:
        for name in self.moving():
            yield ("velocities", "p", self.letters.small(name)), self.v(name)
            yield ("accelerations", "π", self.letters.small(name)), self.a(name)

    def r(self, name: str) -> complex:
        """Place of a point, m."""
        return complex(self.motion.points[name].r[self.k])

    def v(self, name: str) -> complex:
        """Velocity of a point, m/s."""
        return complex(self.motion.points[name].v[self.k])

    def a(self, name: str) -> complex:
        """Acceleration of a point, m/s2."""
        return complex(self.motion.points[name].a[self.k])

    def centre(self, link: int, own: complex, order: int) -> complex:
        """Velocity (order 1) or acceleration (2) of a place of a link, by that of its first point (M3.1)."""
        name, first = next(iter(self.mechanism.links[link].points.items()))
        turned, rates = (own - first) * np.exp(1j * self.motion.links[link].angle[self.k]), self.motion.links[link]
        omega, epsilon = float(rates.omega[self.k]), float(rates.epsilon[self.k])
        spun = 1j * omega if order == 1 else 1j * epsilon - omega**2
        return complex(self.motion.points[name][order][self.k] + spun * turned)

    def omega(self, link: int) -> float:
        """Angular velocity of a link, rad/s."""
        return float(self.motion.links[link].omega[self.k])

    def image(self, name: str, pole: str) -> str:
        """Name a point's image on a plan: the pole for a fixed point."""
        return pole if name in self.mechanism.links[FRAME].points else self.letters.small(name)

    def _turning(self, vector: Turning) -> Iterator[tuple[Arrow, complex]]:
        """A tip over a start: its velocity, the normal part of its acceleration, and the tangential one from there."""
        link, start, tip = vector
        yield ("velocities", self.image(start, "p"), self.letters.small(tip)), self.v(tip) - self.v(start)
        image = self.image(start, "π")
        end = self.letters.normal(tip, "" if image == "π" else start)
        normal = -(self.omega(link) ** 2) * (self.r(tip) - self.r(start))
        yield ("accelerations", image, end), normal
        yield ("accelerations", end, self.letters.small(tip)), self.a(tip) - self.a(start) - normal

    def _slotted(self, vector: Slotted) -> Iterator[tuple[Arrow, complex]]:
        """The point of the slotted link under the pin: its velocity, the slip, Coriolis and normal parts (M3.4)."""
        link, pivot, pin = vector
        under, spin = self.letters.under(pin, link), self.omega(link)
        arm = self.r(pin) - self.r(pivot)
        turning = 1j * spin * arm
        slip = self.v(pivot) + turning - self.v(pin)
        yield ("velocities", self.image(pivot, "p"), under), turning
        yield ("velocities", self.image(pin, "p"), under), slip
        yield ("velocities", "p", under), self.v(pivot) + turning
        yield ("accelerations", self.image(pin, "π"), self.letters.coriolis(pin, link)), 2j * spin * slip
        yield ("accelerations", self.image(pivot, "π"), self.letters.normal(under.upper())), -(spin**2) * arm
