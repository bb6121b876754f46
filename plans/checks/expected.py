"""What the vectors of the plans must be by analysis alone: the other road's word on every named arrow (ожидаемые)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plans.linkage.letters import Letters
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion
from plans.model.structure import Dyad

# A vector by the plan's subject and the names of its ends: ("velocities", "a", "b").
Arrow = tuple[str, str, str]


class Expected:
    """The vectors of the plans of one position, from the motion by analysis; the relative-motion formulas are M3.1."""

    def __init__(self, mechanism: Mechanism, motion: Motion, position: int, letters: Letters) -> None:
        self.mechanism, self.motion, self.k, self.letters = mechanism, motion, position, letters

    def arrows(self, groups: Sequence[Dyad]) -> dict[Arrow, complex]:
        """Give every arrow that a plan may show between named points, normal and Coriolis ends."""
        found = dict(self._absolute())
        drive = self.mechanism.drive
        found.update(self._normal(drive.link, drive.pivot, drive.end))
        for group in groups:
            if group.kind in ("RRR", "RRP"):
                found.update(self._lead(group, 0))
            if group.kind == "RRR":
                found.update(self._lead(group, 1))
            if group.kind == "RPR":
                found.update(self._slotted(group))
        return found

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

    def omega(self, link: int) -> float:
        """Angular velocity of a link, rad/s."""
        return float(self.motion.links[link].omega[self.k])

    def image(self, name: str, pole: str) -> str:
        """Name a point's image on a plan: the pole for a fixed point."""
        return pole if name in self.mechanism.links[FRAME].points else self.letters.small(name)

    def _normal(self, link: int, start: str, tip: str) -> Iterator[tuple[Arrow, complex]]:
        """The normal part of a tip's acceleration about a start, and the tangential one from its end."""
        image = self.image(start, "π")
        end = self.letters.normal(tip, "" if image == "π" else start)
        normal = -(self.omega(link) ** 2) * (self.r(tip) - self.r(start))
        yield ("accelerations", image, end), normal
        yield ("accelerations", end, self.letters.small(tip)), self.a(tip) - self.a(start) - normal

    def _lead(self, group: Dyad, end: int) -> Iterator[tuple[Arrow, complex]]:
        start, tip = group.hinge(end), group.pin
        yield ("velocities", self.image(start, "p"), self.letters.small(tip)), self.v(tip) - self.v(start)
        yield from self._normal(group.links[end], start, tip)

    def _slotted(self, group: Dyad) -> Iterator[tuple[Arrow, complex]]:
        """The point of the slotted link under the pin: its velocity, the slip, Coriolis and normal parts (M3.4)."""
        pin, pivot, link = group.hinge(0), group.hinge(1), group.links[1]
        under, spin = self.letters.under(pin, link), self.omega(link)
        arm = self.r(pin) - self.r(pivot)
        turning = 1j * spin * arm
        slip = self.v(pivot) + turning - self.v(pin)
        yield ("velocities", self.image(pivot, "p"), under), turning
        yield ("velocities", self.image(pin, "p"), under), slip
        yield ("velocities", "p", under), self.v(pivot) + turning
        yield ("accelerations", self.image(pin, "π"), self.letters.coriolis(pin, link)), 2j * spin * slip
        yield ("accelerations", self.image(pivot, "π"), self.letters.normal(under.upper())), -(spin**2) * arm
