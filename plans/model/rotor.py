"""The rotor (ротор): unbalanced masses, planes of correction, bearings, and what balances it, whichever road found it.

Values alone, SI: kg, m, rad/s, N; a static moment m*D is in kg*m. Places along the shaft and angles are exact, so that
an arm, the difference of two places, is rounded once. A vector lies in a plane square to the shaft.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Final, NamedTuple

from plans.model.motion import Gap

GRADES: Final = (0.4, 1.0, 2.5, 6.3, 16.0, 40.0, 100.0, 250.0, 630.0, 1600.0, 4000.0)  # mm/s
MILLIMETRES = 1000.0


def permissible(grade: float, mass: float, speed: float) -> float:
    """Give the residual unbalance kg*m that a grade mm/s permits a rotor of a mass kg at a speed rad/s.

    >>> round(1e6 * permissible(6.3, 20.0, 314.159265), 1)
    401.1
    """
    return grade / MILLIMETRES * mass / abs(speed)


def quality(unbalance: float, mass: float, speed: float) -> float:
    """Give e*omega in mm/s of an unbalance kg*m, of a rotor of a mass kg at a speed rad/s."""
    return MILLIMETRES * unbalance / mass * abs(speed)


def grade_of(value: float) -> float | None:
    """Give the finest grade that holds e*omega mm/s; None where it is beyond the coarsest.

    >>> grade_of(0.0), grade_of(6.3), grade_of(7.0), grade_of(5000.0)
    (0.4, 6.3, 16.0, None)
    """
    return next((grade for grade in GRADES if value <= grade), None)


def nearest_grade(value: float) -> float:
    """Give the grade that a value mm/s differs from by the smallest factor; of zero the finest.

    >>> nearest_grade(7.0), nearest_grade(0.0)
    (6.3, 0.4)
    """
    return min(GRADES, key=lambda grade: abs(math.log(grade / value))) if value > 0 else GRADES[0]


def letters(grade: float) -> str:
    """Write a grade as the standard does.

    >>> letters(6.3), letters(16.0)
    ('G6.3', 'G16')
    """
    return f"G{grade:g}"


EPS = 2.0**-52
ROUNDING = 8.0  # a polygon closes within so many eps of the sum of its vectors
CONSTRUCTION, ANALYSIS = "construction", "analysis"


class Resultant(NamedTuple):
    """What closes a polygon of vectors, and by how much rounding can have moved it: below that there is none.

    >>> Resultant(3e-17 + 0j, 1e-16).size, Resultant(-2 + 0j, 1e-16).angle
    (0.0, 180.0)
    """

    value: complex
    slack: float

    @property
    def vanishes(self) -> bool:
        """Whether nothing is left but rounding."""
        return abs(self.value) <= self.slack

    @property
    def size(self) -> float:
        """The length of the vector; zero where nothing but rounding is left."""
        return 0.0 if self.vanishes else abs(self.value)

    @property
    def angle(self) -> float | None:
        """The direction in degrees, in (-180, 180]; None of a vector that vanishes."""
        found = math.degrees(cmath.phase(self.value))
        return None if self.vanishes else 180.0 if found == -180.0 else found


class Unbalance(NamedTuple):
    """An unbalanced mass (неуравновешенная масса): its static moment kg*m, angle in degrees, place along the shaft m.

    Mass kg and radius m are None where the scene gives the static moment alone.
    """

    name: str
    moment: float
    angle: Fraction
    place: Fraction
    mass: float | None = None
    radius: float | None = None


class Plane(NamedTuple):
    """A plane of correction (плоскость коррекции): its name, place m, and the radius m or mass kg there."""

    name: str
    place: Fraction
    radius: float | None = None
    mass: float | None = None


@dataclass(frozen=True)
class Rotor:
    """A rotor: unbalanced masses, one plane of correction or two, bearings, speed rad/s, mass kg, grade mm/s."""

    masses: tuple[Unbalance, ...]
    planes: tuple[Plane, ...]
    bearings: tuple[Fraction, ...] = ()  # places m of none or two
    speed: float | None = None
    mass: float | None = None
    grade: float | None = None

    @property
    def dynamic(self) -> bool:
        """Whether two planes balance the couple too; one balances the resultant alone."""
        return len(self.planes) > 1

    def arm(self, place: Fraction) -> float:
        """Give the distance m of a place from the last plane of correction, from which arms are measured."""
        return float(place - self.planes[-1].place)

    def quality(self, *unbalances: float) -> float | None:
        """Give e*omega in mm/s of unbalances kg*m in the planes, each held to an equal share of the whole."""
        if self.mass is None or self.speed is None:
            return None
        return quality(len(unbalances) * max(unbalances), self.mass, self.speed)


class Correction(NamedTuple):
    """A correction mass (противовес): its plane and its static moment kg*m."""

    plane: Plane
    moment: Resultant

    @property
    def mass(self) -> float | None:
        """The mass kg: as given, or found at the plane's radius; None where neither is given."""
        return self.plane.mass if self.plane.radius is None else self.moment.size / self.plane.radius

    @property
    def radius(self) -> float | None:
        """The radius m: as given, or found for the plane's mass; None where neither is given."""
        return self.plane.radius if self.plane.mass is None else self.moment.size / self.plane.mass


@dataclass(frozen=True)
class RotorBalance:
    """What balances a rotor, by one road: the sums before, the corrections, and the reactions before and after."""

    by: str
    couple: Resultant  # sum of m*D*h about the last plane, kg*m2
    unbalance: Resultant  # sum of m*D, kg*m
    corrections: tuple[Correction, ...]
    before: tuple[Resultant, ...] = ()  # reactions N of the bearings on the rotor, turning with it
    after: tuple[Resultant, ...] = ()

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """Where nothing is found: every rotor can be balanced."""
        return ()

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps, as a comparison asks for them."""
        return self.gaps

    @property
    def sizes(self) -> tuple[float, ...]:
        """The static moments kg*m of the corrections by their size: as much is unbalanced in each plane."""
        return tuple(correction.moment.size for correction in self.corrections)

    @property
    def moments(self) -> tuple[complex, ...]:
        """The static moments kg*m of the corrections; zero where nothing but rounding is left."""
        return tuple(0j if correction.moment.vanishes else correction.moment.value for correction in self.corrections)
