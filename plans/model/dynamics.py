"""The motion of a machine under its forces: the task, the account of a steady turn, the flywheel (динамика машины).

Angles `turned` run from 0 at position 0 to 2 pi in the sense in which the crank turns, rad; moments and rates are
positive in that sense. Both roads give these values: by construction on strips, by analysis on the same strips or
exactly.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from plans.model.motion import Floats, Gap

SAME = 1e-9  # of a strip: an edge so near a position is that position


def edge_names(turned: Floats, divisions: int) -> tuple[str, ...]:
    """Name edges at angles turned, rad, of a turn of so many divisions.

    >>> import numpy as np
    >>> edge_names(TURN / 8 * np.array([0.0, 1.0, 1.3, 1.7, 2.0]), 8)
    ('0', '1', "1'", "1''", '2')
    """
    names: list[str] = []
    for place in turned * divisions / TURN:
        near = round(float(place))
        if abs(place - near) <= SAME:
            names.append(str(near))
        else:
            whole = str(int(place))
            names.append(whole + "'" * (1 + sum(name.startswith(f"{whole}'") for name in names)))
    return tuple(names)


class Methods(NamedTuple):
    """The inertia J0 kg*m2 at position 0 by each method, and the range of energy J that Mertsalov's evens out.

    `book` is by tangents at slopes 1 -+ delta; `touches` are the least and the greatest of Mertsalov's curve.
    """

    book: float
    mertsalov: float
    gutyar: float
    height: float
    touches: tuple[Touch, Touch]


THICKEST = 0.5  # of the mean diameter: a thicker rim leaves no room for shaft, hub and spokes
CHOSEN = 0.125  # likewise, at most, of a diameter that is chosen
RA10 = (1.0, 1.2, 1.6, 2.0, 2.5, 3.2, 4.0, 5.0, 6.3, 8.0, 10.0)  # preferred sizes (GOST 6636)


class Wheel(NamedTuple):
    """A flywheel's rim on its own shaft: inertia kg*m2, mean diameter m, mass kg, section's thickness and breadth m."""

    inertia: float
    diameter: float
    mass: float
    thickness: float  # along the radius
    breadth: float  # along the shaft
    ratio: float = 1.0  # turns of its shaft for one of the crank

    @property
    def outer(self) -> float:
        """Its outer diameter, m."""
        return self.diameter + self.thickness

    @property
    def inner(self) -> float:
        """Its inner diameter, m; not above zero where no rim of this mean diameter is heavy enough."""
        return self.diameter - self.thickness

    @property
    def added(self) -> float:
        """The share of the inertia that the thickness adds: a ring of thickness t has m (D^2 + t^2)/4."""
        return (self.thickness / self.diameter) ** 2

    @property
    def fits(self) -> bool:
        """Whether a wheel can have it: a ring so thick that no shaft goes through it is none."""
        return self.thickness <= THICKEST * self.diameter

    @property
    def least_diameter(self) -> float:
        """The least mean diameter m of a rim of this inertia, material and shape that fits: t/D falls as D^(-5/2)."""
        return float(self.diameter * (self.thickness / (THICKEST * self.diameter)) ** 0.4)

    def at_speed(self, omega: float) -> float:
        """Give the speed of the mean circle, m/s, of a shaft that turns at rad/s."""
        return abs(omega) * self.diameter / 2


CONSTRUCTION, ANALYSIS = "construction", "analysis"
TURN = 2 * np.pi
ROUNDED = 1e-12  # of what is subtracted: less is its rounding over the strips of a turn, magnified by a sharp notch


class Shaft(NamedTuple):
    """A rotating mass of the machine unit (вал): inertia kg*m2, and its turns for one turn of the crank."""

    name: str
    inertia: float
    ratio: float

    @property
    def reduced(self) -> float:
        """Its inertia reduced to the crank's shaft, kg*m2 (6.4, 6.5)."""
        return self.inertia * self.ratio**2


class Rim(NamedTuple):
    """What is known of the flywheel's rim (обод): its shaft's turns for one of the crank, mean diameter m, material.

    Without a diameter it is of the least preferred one at which it is thin. `density` is kg/m3, `breadth` the axial
    breadth over the radial thickness of the rim's section.
    """

    ratio: float = 1.0
    diameter: float | None = None
    density: float = 7200.0
    breadth: float = 1.5

    def sized(self, least: float) -> float:
        """Give its mean diameter m; without one the least preferred size that is not less than one m.

        >>> [Rim().sized(least) for least in (0.81, 1.0, 3.3)], Rim(diameter=0.7).sized(1.0)
        ([1.0, 1.0, 4.0], 0.7)
        """
        power = 10.0 ** np.floor(np.log10(least))
        return self.diameter or float(next(power * size for size in RA10 if power * size >= least))


class Task(NamedTuple):
    """What is asked of the machine's motion: mean speed rad/s above 0, coefficient of fluctuation, strips of a turn."""

    speed: float
    delta: float | None
    divisions: int
    shafts: tuple[Shaft, ...] = ()
    rim: Rim = Rim()

    @property
    def present(self) -> float:
        """The constant inertias that are there beside the linkage, reduced to the crank's shaft, kg*m2."""
        return float(sum(shaft.reduced for shaft in self.shafts))


@dataclass(frozen=True)
class Reduced:
    """Loads and masses reduced to the crank at the positions of a scene, by one road; NaN at gaps (приведение)."""

    by: str
    phi: Floats  # (N,) rad
    moment: Floats  # (N,) N*m, of loads and weights, positive in the sense of rotation
    inertia: Floats  # (N,) kg*m2, of the linkage alone
    slope: Floats  # (N,) kg*m2: its derivative by the angle turned
    gaps: tuple[Gap, ...] = ()

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps, as a comparison asks for them."""
        return self.gaps


@dataclass(frozen=True)
class Cycle:
    """The account of one turn of steady motion on n strips, by one road (цикл установившегося движения).

    Moments are those of the loads and weights, reduced to the crank: a resistance is negative.
    """

    by: str
    turned: Floats  # (n + 1,) rad: edges of the strips, among them all of `breaks`
    breaks: Floats  # (b,) rad: where the reduced moment jumps or bends
    moments: Floats  # (n, 2) N*m: at the beginning and at the end of each strip; sides of an edge differ at a jump
    means: Floats  # (n,) N*m: ordinate at the middle of each strip
    work: Floats  # (n + 1,) J: of loads and weights since position 0
    inertia: Floats  # (n + 1,) kg*m2: of the linkage, reduced to the crank
    gaps: tuple[Gap, ...] = ()

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps, as a comparison asks for them."""
        return self.gaps

    @property
    def net(self) -> float:
        """Work of loads and weights over the turn, J: none where it is but the rounding of what comes and goes."""
        return float(settled(self.work[-1:], self.gross)[0])

    @property
    def gross(self) -> float:
        """Work of loads and weights, J, what they take and what they give alike."""
        return float(np.abs(self.means) @ np.diff(self.turned))

    @property
    def driving(self) -> float:
        """The constant moment N*m of the drive that keeps the motion steady (движущий момент)."""
        return -self.net / TURN + 0.0

    @property
    def engine(self) -> bool:
        """Whether the loads drive, and the other side is a constant resistance (двигатель)."""
        return self.driving < 0

    @property
    def indices(self) -> tuple[str, str]:
        """The indices of letters of the loads and of the constant other side: M_us, M_dr; of an engine M_dr, M_us."""
        return ("dr", "us") if self.engine else ("us", "dr")

    @property
    def way(self) -> float:
        """The sign with which moment and work of the loads are drawn: a resistance and a drive alike upwards."""
        return 1.0 if self.engine else -1.0

    @property
    def surplus(self) -> Floats:
        """Change of the kinetic energy since position 0, J (избыточная работа): of the drive and of the loads."""
        return settled(self.driving * self.turned + self.work, self.gross)

    @property
    def own(self) -> float:
        """The linkage's reduced inertia at position 0, kg*m2; where it does not move but for rounding, nothing."""
        return float(settled(self.inertia[:1], float(np.abs(self.inertia).max()))[0])

    @property
    def varying(self) -> Floats:
        """The part of the reduced inertia that changes, kg*m2: that above its value at position 0."""
        return settled(self.inertia - self.inertia[0], float(np.abs(self.inertia).max()))

    @property
    def leaning(self) -> Floats:
        """The slopes with which its curve is drawn through the edges: of the parabola through each and both beside."""
        x, y = self.turned, self.varying
        return np.gradient(np.r_[y[-2], y, y[1]], np.r_[x[-2] - TURN, x, x[1] + TURN])[1:-1]


def settled(values: Floats, of: float) -> Floats:
    """Give values of which those are zero that are but the rounding of what they are the difference of."""
    return np.where(np.abs(values) > ROUNDED * of, values, 0.0)


class Touch(NamedTuple):
    """A point of the loop of energy and inertia that a tangent touches: angle turned rad, kg*m2, J."""

    turned: float
    varying: float
    surplus: float

    def above(self, slope: float) -> float:
        """Give what a line of a slope J per kg*m2 through it cuts off the axis of energy, J."""
        return self.surplus - slope * self.varying

    def omega(self, inertia: float, energy: float) -> float:
        """Give the speed there, rad/s, of a machine with an inertia kg*m2 and an energy J at position 0 (6.12)."""
        return float(np.sqrt(2 * (energy + self.surplus) / (inertia + self.varying)))


@dataclass(frozen=True)
class Flywheel:
    """The flywheel by Wittenbauer's loop (маховик): tangents at psi_min and psi_max, and what they cut off.

    Pairs are of the tangent at psi_min, which touches from below, then of that at psi_max, which touches from above.
    """

    by: str
    slopes: tuple[float, float]  # J per kg*m2: omega2/2 of the least and the greatest speed
    touches: tuple[Touch, Touch]
    cuts: tuple[float, float]  # J: where they cut the axis of energy, o1l and o1k
    own: float  # kg*m2: reduced inertia of the linkage at position 0
    present: float  # kg*m2: rotor, gears and shafts, reduced

    @property
    def whole(self) -> float:
        """The inertia J0 kg*m2 that the machine must have at position 0."""
        low, high = self.slopes
        return (self.cuts[1] - self.cuts[0]) / (high - low)

    @property
    def energy(self) -> float:
        """The kinetic energy T0 J that it has there: about that of the run-up."""
        return self.whole * self.slopes[1] - self.cuts[1]

    @property
    def needed(self) -> float:
        """What is missing of J0, kg*m2; not above zero where the machine is heavy enough without a flywheel."""
        return self.whole - self.own - self.present

    @property
    def inertia(self) -> float:
        """The flywheel's moment of inertia at the crank's shaft, kg*m2 (6.16)."""
        return max(self.needed, 0.0)


class Fluctuating:
    """A motion whose speed goes to and fro between two values."""

    extremes: tuple[float, float]  # rad/s: least and greatest

    @property
    def mean(self) -> float:
        """The mean of the least and the greatest speed, rad/s (6.13)."""
        return sum(self.extremes) / 2

    @property
    def delta(self) -> float:
        """The coefficient of fluctuation of speed (6.13)."""
        return (self.extremes[1] - self.extremes[0]) / self.mean


@dataclass(frozen=True)
class Speeds(Fluctuating):
    """The crank's motion over a steady turn (закон движения): rad/s at the edges, rad/s2 on either side of them.

    `inertia` kg*m2 and `energy` J are those of the whole machine at position 0.
    """

    by: str
    turned: Floats  # (n + 1,) rad
    omega: Floats  # (n + 1,) rad/s
    epsilon: Floats  # (n, 2) rad/s2: at the beginning and at the end of each strip; sides of an edge differ at a jump
    extremes: tuple[float, float]  # rad/s: least and greatest
    inertia: float
    energy: float
