"""What one link of a group gives of its inner point, told by the structure alone (слагаемые векторных уравнений).

Of a point B that a link carries about A it is a turning: v_BA, a^n_BA, a^t_BA; of one that slides on a link, the slip
over the link's point that lies under it: v_BB3, a^k_BB3, a^r_BB3 (M3.1, M3.7).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plans.linkage.letters import Letters
from plans.model.dyad import Dyad
from plans.model.mechanism import FRAME, Mechanism, Slide


class Spot(NamedTuple):
    """A named point, or the point of a link that lies under it."""

    name: str
    link: int | None = None

    @property
    def letters(self) -> str:
        """Its letters on a note: A, or A_{3} of link 3, the prime of a name behind its number."""
        bare = self.name.rstrip("'")
        return self.name if self.link is None else f"{bare}_{{{self.link}}}{self.name[len(bare) :]}"

    def image(self, letters: Letters) -> str:
        """Its letter on a plan."""
        return letters.small(self.name) if self.link is None else letters.under(self.name, self.link)


class Leg(NamedTuple):
    """A point by a base on a link that turns, or by the base under it on a link along whose slide it slips."""

    point: Spot
    base: Spot
    link: int
    fixed: bool = False  # whether the base is a point of the frame
    slide: Slide | None = None

    @property
    def relative(self) -> str:
        """The letters of the point relative to the base."""
        return f"{self.point.letters}{self.base.letters}"

    @property
    def arm(self) -> str:
        """The letters of the line that turns."""
        return f"{self.base.name}{self.point.name}"

    @property
    def guided(self) -> bool:
        """Whether the point slides on the frame: then only its direction is told."""
        return self.slide is not None and self.link == FRAME

    def parted(self, letters: Letters) -> str:
        """The letter of the end of its normal or Coriolis part on the plan of accelerations."""
        if self.slide is not None:
            return letters.coriolis(self.point.name, self.link, (self.slide.slider, self.slide.owner))
        if self.point.link is not None:
            return letters.normal(self.point.image(letters).upper())
        return letters.normal(self.point.name, "" if self.fixed else self.base.name)


def legs(dyad: Dyad, mechanism: Mechanism) -> tuple[Leg, Leg]:
    """Give the two legs by which the inner point of a group is found."""
    if isinstance(dyad.inner, str):
        pin = Spot(dyad.inner)
        return _leg(dyad, 0, pin, mechanism), _leg(dyad, 1, pin, mechanism)
    pin = Spot(dyad.hinge(0))
    under = Spot(pin.name, dyad.links[1])
    return Leg(under, pin, dyad.links[1], slide=dyad.inner), _leg(dyad, 1, under, mechanism)


def _leg(dyad: Dyad, end: int, point: Spot, mechanism: Mechanism) -> Leg:
    """Give a point by an outer pair: a hinge about which the link turns, or a slide on the host."""
    outer = dyad.outer[end]
    if isinstance(outer, str):
        return Leg(point, Spot(outer), dyad.links[end], outer in mechanism.links[FRAME].points)
    return Leg(point, Spot(point.name, dyad.hosts[end]), dyad.hosts[end], slide=outer)


def others(dyad: Dyad, mechanism: Mechanism) -> Iterator[str]:
    """Name the points of a group's links beside its joints, once each: similarity gives them."""
    joints = {dyad.inner, *dyad.outer}
    yield from dict.fromkeys(name for one in dyad.links for name in mechanism.links[one].points if name not in joints)
