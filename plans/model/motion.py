"""The motion of a mechanism over its positions by its three orders, and the rates of its drive (движение)."""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from plans.model.mechanism import Drive
from plans.words.words import Message


class Lettered(NamedTuple):
    """A quantity of a point or of a link: its key among the numbers, its symbol on a sheet, its unit."""

    key: str
    symbol: str
    unit: str


class Order(NamedTuple):
    """An order of a motion: how often it is a derivative, the name of its plan, and what that tells of each."""

    number: int
    plan: str
    point: Lettered
    link: Lettered


POSITIONS = Order(0, "positions", Lettered("r", "r", "m"), Lettered("angle", "φ", "rad"))
VELOCITIES = Order(1, "velocities", Lettered("v", "v", "m/s"), Lettered("omega", "ω", "rad/s"))
ACCELERATIONS = Order(2, "accelerations", Lettered("a", "a", "m/s2"), Lettered("epsilon", "ε", "rad/s2"))
ORDERS = (POSITIONS, VELOCITIES, ACCELERATIONS)
PLANS = tuple(order.plan for order in ORDERS)
# The orders by the keys of what their plans tell of a point, and of a link.
POINT_ORDERS = {order.point.key: order for order in ORDERS}
LINK_ORDERS = {order.link.key: order for order in ORDERS}


def numbers_of(plans: Collection[str]) -> list[int]:
    """Give the numbers of the orders whose plans are among some.

    >>> numbers_of(("extremes", "positions", "velocities"))
    [0, 1]
    """
    return [order.number for order in ORDERS if order.plan in plans]


# Why a position has no places, or no velocities; the first three are also what bars the crank.
OUT_OF_REACH, CHANGE_POINT, PARALLEL_GUIDES = "out of reach", "change point", "parallel guides"
DEAD_CENTRE, BEYOND_CHANGE_POINT, NOT_REACHABLE = "dead centre", "beyond a change point", "not reachable"
FORCES = "forces"  # the plan of gaps where a machine is assembled, but has no forces: at a dead centre, or as it is
INDETERMINATE = "statically indeterminate"
# Share of the largest force or vector: less is the rounding of numbers that a scene gives with twelve digits.
NOTHING = 1e-9

Complexes = npt.NDArray[np.complex128]
Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]


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

    def made(self, phi: Floats, row: Callable[[Any], Any]) -> "Motion":
        """Give this motion with each of its rows made another."""
        points = {name: PointMotion(map(row, rows)) for name, rows in self.points.items()}
        links = {link: LinkMotion(map(row, rows)) for link, rows in self.links.items()}
        return self._replace(phi=phi, points=points, links=links)

    def fill(self, part: "Motion", at: slice) -> None:
        """Put the motion over a part of the positions into this over them all."""
        for row, value in zip(self.rows(), part.rows(), strict=True):
            if row.flags.writeable:
                row[at] = value

    def own(self) -> "Motion":
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


ROUNDINGS = 16.0 * 2.0**-52  # of a place that is a distance of two points: nearer to a corner of a law it is there


class Rates(NamedTuple):
    """Angular velocity rad/s and acceleration rad/s2 of the drive: numbers, or rows (N,) over the positions."""

    omega: Floats | float
    epsilon: Floats | float

    @property
    def vary(self) -> bool:
        """Whether they are told of each position by itself."""
        return np.ndim(self.omega) > 0

    def part(self, chosen: slice | Sequence[int] | npt.NDArray[np.int_]) -> "Rates":
        """Give those of some of the positions, in the order asked for."""
        return Rates(*(np.asarray(rate)[chosen] for rate in self)) if self.vary else self

    def against(self, axes: int) -> "Rates":
        """Give them so that they multiply rows (N, ...) with so many further axes."""
        return Rates(*(np.reshape(rate, (-1, *[1] * axes)) for rate in self)) if self.vary else self

    def at(self, position: int) -> tuple[float, float]:
        """Give omega and epsilon in one position."""
        omega, epsilon = (np.ravel(rate)[position if self.vary else 0] for rate in self)
        return float(omega), float(epsilon)

    @property
    def times(self) -> Floats | float:
        """The time between two even positions about each, in that about the first: what a mean over time weighs by."""
        return np.ravel(self.omega)[0] / self.omega if self.vary else 1.0


# The rates at crank angles rad (N,), any number of turns on. They keep the sense of rotation of the drive.
Pace: TypeAlias = Callable[[Floats], Rates]


def rates_at(pace: Pace, phi: Floats) -> Rates:
    """Give the rates at crank angles rad (N,) as rows (N,)."""
    return Rates(*(np.broadcast_to(np.asarray(rate, dtype=np.float64), phi.shape) for rate in pace(phi)))


def evenly(phi: Floats) -> Rates:
    """Turn a drive by 1 rad/s in every position: its velocities are then transfer functions."""
    return Rates(np.ones_like(phi), np.zeros_like(phi))


def steady(drive: Drive) -> Rates:
    """Give the rates of a drive that has those of its scene in every position."""
    return Rates(drive.omega, drive.epsilon)


def law_ends(law: Sequence[tuple[float, float]]) -> Rates:
    """Give the speeds m/s at the places of a stroke's law, and its accelerations m/s2 at both ends of every piece.

    Between them lie all others: along a piece a = v dv/ds goes evenly with v; from rest, and to it, it is one.
    """
    pieces = [(low, high, (high - low) / (end - start)) for (start, low), (end, high) in pairwise(law)]
    ends = ((v if low * high else (low + high) / 2) * slope for low, high, slope in pieces for v in (low, high))
    return Rates(np.array([v for _, v in law]), np.array([*ends]))


def stroke_rates(drive: Drive, ways: Floats, speed: float, acceleration: float) -> tuple[Floats, Floats]:
    """Give speed m/s and acceleration m/s2 of a stroke at places m, (N,) each: those told, or those of the drive's law.

    The law has straight lines of v over s between its places, so that a = v dv/ds; from rest, and to it, one
    acceleration and v = sqrt(2 a s), for along a straight line it would take for ever. At a place itself the piece
    ahead of it counts, at the end the last.
    """
    if not drive.law:
        return np.full(ways.shape, speed), np.full(ways.shape, acceleration)
    places, speeds = np.array(drive.law).T
    fine = ROUNDINGS * np.abs(places).max()
    corner = places[np.abs(ways[..., None] - places).argmin(axis=-1)]
    ways = np.where(np.abs(ways - corner) <= fine, corner, ways)  # the root would make much of a rounding
    ahead = ways + np.sign(speeds.sum()) * fine
    part = np.clip(np.searchsorted(places, ahead) - 1, 0, len(places) - 2)
    low, high, length = speeds[part], speeds[part + 1], np.diff(places)[part]
    share = np.clip((ways - places[part]) / length, 0.0, 1.0)
    resting = low * high == 0.0
    even = np.sign(low + high) * np.sqrt(low**2 + (high**2 - low**2) * share)
    v = np.where(resting, even, np.interp(ways, places, speeds))
    return v, np.where(resting, (high**2 - low**2) / (2 * length), v * (high - low) / length)
