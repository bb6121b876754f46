"""The motion of a mechanism over its positions, whichever road found it: construction or analysis."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from plans.words.words import Message

# Why a position has no places, or no velocities; the first three are also what bars the crank.
OUT_OF_REACH, CHANGE_POINT, PARALLEL_GUIDES = "out of reach", "change point", "parallel guides"
DEAD_CENTRE, BEYOND_CHANGE_POINT, NOT_REACHABLE = "dead centre", "beyond a change point", "not reachable"
FORCES = "forces"  # the plan of gaps where a machine is assembled, but has no forces: at a dead centre, or as it is
INDETERMINATE = "statically indeterminate"
# Share of the largest force or vector: less is the rounding of numbers that a scene gives with twelve digits.
NOTHING = 1e-9

Complexes = npt.NDArray[np.complex128]
Floats = npt.NDArray[np.float64]


class Gap(NamedTuple):
    """A position that cannot be assembled or has no result (разрыв); never interpolated across."""

    position: int
    phi: float  # rad
    plan: str  # "positions", "velocities" or "accelerations": the first plan that has no result here
    reason: str  # "out of reach", "dead centre", "change point", "beyond a change point", "not reachable", ...
    where: str | Message  # the meeting or link it failed at: "B", "group 2-3"
    miss: float  # m, by how much the loci miss each other; 0 where that is not the reason
    advice: Message  # one sentence: what would mend it


class PointMotion(tuple[Complexes, ...]):
    """A point over the positions, a row (N,) for each order of its motion; NaN at gaps."""

    __slots__ = ()

    @property
    def r(self) -> Complexes:
        """Its place from the datum, m."""
        return self[0]

    @property
    def v(self) -> Complexes:
        """Its velocity, m/s."""
        return self[1]

    @property
    def a(self) -> Complexes:
        """Its acceleration, m/s2."""
        return self[2]


class LinkMotion(tuple[Floats, ...]):
    """A link over the positions, a row (N,) for each order of its motion; NaN at gaps."""

    __slots__ = ()

    @property
    def angle(self) -> Floats:
        """The direction of its own +x axis, rad in (-pi, pi]."""
        return self[0]

    @property
    def omega(self) -> Floats:
        """Its angular velocity, rad/s."""
        return self[1]

    @property
    def epsilon(self) -> Floats:
        """Its angular acceleration, rad/s2."""
        return self[2]


class Motion(NamedTuple):
    """All points and moving links of a mechanism over its positions, up to the order of derivative asked for."""

    by: str  # "construction" or "analysis"
    phi: Floats  # rad, not reduced: position k of a turn continues position k - 1
    points: Mapping[str, PointMotion]
    links: Mapping[int, LinkMotion]
    gaps: tuple[Gap, ...]

    @property
    def order(self) -> int:
        """The highest order of derivative that it has."""
        return min((len(rows) - 1 for rows in self.points.values()), default=0)

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps of the motion: all of them are its own."""
        return self.gaps

    def rows(self) -> Iterator[npt.NDArray[Any]]:
        """Give the values of all points and links, row by row."""
        for rows in (*self.points.values(), *self.links.values()):
            yield from rows

    def made(self, phi: Floats, row: Callable[[Any], Any]) -> Motion:
        """Give this motion with each of its rows made another."""
        points = {name: PointMotion(map(row, rows)) for name, rows in self.points.items()}
        links = {link: LinkMotion(map(row, rows)) for link, rows in self.links.items()}
        return self._replace(phi=phi, points=points, links=links)

    def fill(self, part: Motion, at: slice) -> None:
        """Put the motion over a part of the positions into this over them all."""
        for row, value in zip(self.rows(), part.rows(), strict=True):
            if row.flags.writeable:
                row[at] = value

    def own(self) -> Motion:
        """Give this motion with rows of its own, in which places can be left out; else they are those of the plans."""
        return self.made(self.phi, np.array)


class Extremes(NamedTuple):
    """The two extreme positions of the output link (крайние положения), the working stroke first."""

    phi: tuple[float, float]  # rad in [0, 2 pi): crank where the working stroke begins, and where it ends
    reach: tuple[float, float]  # output coordinate there: m along the guide, or rad of the output link's +x axis
    sliding: bool  # True: reach and stroke are metres; False: radians
    overlap: float  # rad, theta: the crank's angle over the slower stroke less pi (угол перекрытия)
    faster: bool = False  # whether the working stroke is the faster one

    @property
    def stroke(self) -> float:
        """Stroke H of a slider m, or swing of a rocker rad (ход, размах)."""
        return abs(self.reach[1] - self.reach[0])

    @property
    def ratio(self) -> float:
        """Coefficient of mean speeds K = (pi + theta)/(pi - theta) >= 1 (коэффициент изменения средней скорости)."""
        return float((np.pi + self.overlap) / (np.pi - self.overlap))

    @property
    def angles(self) -> tuple[float, float]:
        """The crank's angles rad over the working and over the idle stroke (фазовые углы рабочего и холостого хода)."""
        slow, fast = np.pi + self.overlap, np.pi - self.overlap
        return (fast, slow) if self.faster else (slow, fast)
