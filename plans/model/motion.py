"""The motion of a mechanism over its positions, whichever road found it: construction or analysis."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from plans.words.words import Message

CHANGE_POINT = "change point"  # why a position that is assembled may have no velocities
# The three orders of a motion: its plan, the keys, symbols and units of a point's and of a link's values on it.
ORDERS = ("positions", "velocities", "accelerations")
POINT_KEYS = ("r", "v", "a")
POINT_UNITS = ("m", "m/s", "m/s2")
LINK_KEYS = ("angle", "omega", "epsilon")
LINK_SYMBOLS = ("φ", "ω", "ε")
LINK_UNITS = ("rad", "rad/s", "rad/s2")

Complexes = npt.NDArray[np.complex128]
Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Gap:
    """A position that cannot be assembled or has no result (разрыв); never interpolated across."""

    position: int
    phi: float  # rad
    plan: str  # "positions", "velocities" or "accelerations": the first plan that has no result here
    reason: str  # "out of reach", "dead centre", "change point", "beyond a change point", "not reachable", ...
    where: str | Message  # the meeting or link it failed at: "B", "group 2-3"
    miss: float  # m, by how much the loci miss each other; 0 where that is not the reason
    advice: Message  # one sentence: what would mend it


class PointMotion(NamedTuple):
    """A point over the positions: r from the datum m, v m/s, a m/s2; NaN at gaps, None where not asked for."""

    r: Complexes
    v: Complexes | None = None
    a: Complexes | None = None


class LinkMotion(NamedTuple):
    """A link over the positions: direction of its own +x axis rad in (-pi, pi], omega rad/s, epsilon rad/s2."""

    angle: Floats
    omega: Floats | None = None
    epsilon: Floats | None = None


@dataclass(frozen=True)
class Motion:
    """All points and moving links of a mechanism over its positions."""

    by: str  # "construction" or "analysis"
    phi: Floats  # rad, not reduced: position k of a turn continues position k - 1
    points: Mapping[str, PointMotion]
    links: Mapping[int, LinkMotion]
    gaps: tuple[Gap, ...]

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps of the motion: all of them are its own."""
        return self.gaps

    def rows(self) -> Iterator[npt.NDArray[Any]]:
        """Give the values of all points and links that were asked for, row by row."""
        for rows in (*self.points.values(), *self.links.values()):
            yield from (row for row in rows if row is not None)

    def made(self, phi: Floats, row: Callable[[Any], Any]) -> Motion:
        """Give this motion with each of its rows made another."""

        def all_made(rows: Iterable[Any]) -> Iterator[Any]:
            return (None if values is None else row(values) for values in rows)

        points = {name: PointMotion(*all_made(rows)) for name, rows in self.points.items()}
        links = {link: LinkMotion(*all_made(rows)) for link, rows in self.links.items()}
        return replace(self, phi=phi, points=points, links=links)

    def own(self) -> Motion:
        """Give this motion with rows of its own, in which places can be left out; else they are those of the plans."""
        return self.made(self.phi, np.array)


@dataclass(frozen=True)
class Extremes:
    """The two extreme positions of the output link (крайние положения), the slower (working) stroke first."""

    phi: tuple[float, float]  # rad in [0, 2 pi): crank where the working stroke begins, and where it ends
    reach: tuple[float, float]  # output coordinate there: m along the guide, or rad of the output link's +x axis
    sliding: bool  # True: reach and stroke are metres; False: radians
    overlap: float  # rad, theta: working angle of the crank less pi (угол перекрытия)

    @property
    def stroke(self) -> float:
        """Stroke H of a slider m, or swing of a rocker rad (ход, размах)."""
        return abs(self.reach[1] - self.reach[0])

    @property
    def ratio(self) -> float:
        """Coefficient of mean speeds K = (pi + theta)/(pi - theta) (коэффициент изменения средней скорости)."""
        return float((np.pi + self.overlap) / (np.pi - self.overlap))
