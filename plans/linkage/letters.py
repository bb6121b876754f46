"""The letters of plans: of velocities and accelerations small ones of points, those of parts; of mass centres (буквы).

No two are the same. The poles are p and π: a point named P has the letter p'.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Protocol, TypeAlias, cast

from plans.model.mechanism import FRAME, Link, Mechanism
from plans.scene.scene import Scene

POLES = {"positions": "datum", "velocities": "p", "accelerations": "π"}
Sliding = tuple[int, int]  # a sliding pair by its two links


class Letters:
    """How the plans of a mechanism letter its points, those that lie under them, and ends of normal and Coriolis parts.

    A letter that another point or a pole has gets a prime.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        named = dict.fromkeys(point for link in mechanism.links.values() for point in link.points)
        self._small: dict[str, str] = {}
        # A point that is named by a small letter keeps it, and one with a prime its own: P' is p', so P is p''.
        for point in sorted(named, key=lambda name: (name != name.lower(), -len(name))):
            self._small[point] = apart(point.lower(), {*POLES.values(), *self._small.values()})
        self._taken = {*POLES.values(), *self._small.values()}
        self.pins: dict[Sliding, tuple[str, int]] = {}  # that slide along a guide of a host, by their pairs

    def small(self, point: str) -> str:
        """Write a point's letter small: B as b."""
        return self._small[point] if point in self._small else apart(point.lower(), self._taken)

    def under(self, point: str, link: int) -> str:
        """Name the point of a link that lies under another's, such as a3; a_(3) where a point A3 has that letter."""
        small = self.small(point)
        return f"{small}_({link})" if f"{small}{link}" in self._taken else f"{small}{link}"

    def normal(self, tip: str, about: str = "") -> str:
        """Name the end of the normal part of a tip's acceleration about a point: n_BA, or about one at rest n_B."""
        return apart(f"n_{tip}{about}", self._taken)

    def slides(self, pair: Sliding, pin: str, host: int) -> None:
        """Keep the pin whose velocity along its guide on a host a sliding pair gives."""
        self.pins[pair] = pin, host

    def coriolis(self, pin: str, host: int, pair: Sliding | None = None) -> str:
        """Name the end of a pin's Coriolis part: k_A; k_A3 over link 3 where the pin has such parts over several.

        What slides there in a later pair, as a yoke's point under the pin does, has a prime: k_A3'.
        """
        several = sum(one == pin and FRAME not in other for other, (one, _) in self.pins.items()) > 1
        alike = [other for other, own in self.pins.items() if own == (pin, host)]
        primes = "'" * (alike.index(pair) if pair in alike else 0)
        return apart(f"k_{pin}{host}" if several else f"k_{pin}", self._taken) + primes

    def own(self, symbol: str, link: int) -> str:
        """Name a point that a link has besides its named ones, such as n3."""
        lettered = {self.small(point) + str(link) for point in self._small}
        return f"{symbol}_({link})" if f"{symbol}{link}" in lettered | self._taken else f"{symbol}{link}"


def apart(letter: str, taken: Iterable[str]) -> str:
    """Give a letter that is not among those taken, with as many primes as it needs.

    >>> apart("p", ["p", "p'"])
    "p''"
    """
    known = set(taken)
    while letter in known:
        letter += "'"
    return letter


NEAR = 1e-3  # share of a link's length: a mass centre nearer to a named point than this is that point
Masses: TypeAlias = Mapping[str, tuple[int, complex]]  # by their letters: link, and place in its own frame
NONE: Masses = MappingProxyType({})


class _Mass(Protocol):
    def place(self, link: Link) -> complex: ...


class _Weighed(Protocol):
    """What a scene says of forces: the masses of its links."""

    masses: Mapping[int, _Mass]


def unnamed(scene: Scene, links: Mapping[int, Link]) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that no point of the scene names, by their letters."""
    taken = {name for link in links.values() for name in link.points}
    form, centres = cast("_Weighed | None", scene.part("forces")), {}
    for number, mass in sorted(form.masses.items()) if form else ():
        places, centre = links[number].points.values(), mass.place(links[number])
        size = max(abs(place - centre) for place in places)
        if number != FRAME and f"S{number}" not in taken and min(abs(p - centre) for p in places) > NEAR * size:
            centres[f"S{number}"] = number, centre
    return centres
