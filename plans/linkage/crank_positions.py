"""The crank's turn: its angles as exact directions (деление окружности кривошипа)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

import numpy as np
import numpy.typing as npt

from plans.linkage.margin import heading
from plans.model.motion import Complexes, Floats, Pace, Rates, rates_at
from plans.scene.units import within

_INT64 = 2**62  # numerators of whole turns stay exact below this


@dataclass(frozen=True)
class CrankPositions:
    """Crank positions: angles phi, rad, that go on from each other, and the crank's unit directions."""

    phi: Floats
    directions: Complexes
    rates: Rates | None = None  # of the crank in each of them; None: those of its drive in all

    def __len__(self) -> int:
        return len(self.phi)

    @cached_property
    def headings(self) -> Floats:
        """The crank angles reduced to (-pi, pi]."""
        return heading(self.directions)

    def part(self, chosen: slice | Sequence[int]) -> CrankPositions:
        """Give some of the positions, in the order asked for."""
        rates = None if self.rates is None else self.rates.part(chosen)
        part = CrankPositions(self.phi[chosen], self.directions[chosen], rates)
        part.__dict__["headings"] = self.headings[chosen]  # reduced once for the whole turn
        return part

    @property
    def times(self) -> Floats | float:
        """The time that each of even positions takes, in that of the first."""
        return 1.0 if self.rates is None else self.rates.times

    def paced(self, pace: Pace | None) -> CrankPositions:
        """Give the same positions, passed at another pace; None: at that of the drive."""
        return self if pace is None else replace(self, rates=rates_at(pace, self.phi))


def even(start: Fraction, count: int, sense: int) -> CrankPositions:
    """Divide a turn into `count` equal steps from `start` degrees, in the sense +1 or -1 of rotation.

    >>> even(Fraction(0), 4, +1).directions.tolist()
    [(1+0j), 1j, (-1+0j), -1j]
    """
    start = within(start)
    denominator = start.denominator * count
    first, step = start.numerator * count, sense * 360 * start.denominator
    phi = np.radians(float(start)) + sense * (2 * np.pi / count) * np.arange(count)
    if abs(first) + 720 * denominator < _INT64:
        numerators = first + step * np.arange(count, dtype=np.int64)
        return CrankPositions(phi, directions(numerators, denominator))
    return from_direction(complex(directions_of([start])[0]), float(np.radians(float(start))), count, sense)


def stroke(begin: Fraction, end: Fraction, steps: int, unit: float) -> CrankPositions:
    """Divide the stroke of a slide, m, into equal steps: one position more than steps, in units of `unit` m.

    >>> stroke(Fraction(1, 10), Fraction(5, 10), 4, 2.0).phi.tolist()
    [0.05, 0.1, 0.15, 0.2, 0.25]
    """
    ways = [begin + (end - begin) * k / steps for k in range(steps + 1)]
    phi = np.array([float(way) for way in ways]) / unit
    return CrankPositions(phi, np.exp(1j * phi))


def listed(angles: Sequence[Fraction]) -> CrankPositions:
    """Take crank angles in degrees as the scene lists them, less the whole turns that they have in common.

    Of a list that spans more than a turn each angle is taken within one.

    >>> np.degrees(listed([Fraction(3950), Fraction(3970)]).phi).round(9).tolist()
    [350.0, 370.0]
    """
    least = min(angles, key=abs, default=Fraction(0))
    wide = max(angles, default=least) - min(angles, default=least) > 360
    near = [within(angle) if wide else angle - least + within(least) for angle in angles]
    return CrankPositions(np.radians(np.array([float(angle) for angle in near])), directions_of(near))


def from_direction(first: complex, phi: float, count: int, sense: int) -> CrankPositions:
    """Divide a turn from a crank direction that a construction has found."""
    whole = even(Fraction(0), count, sense)
    return CrankPositions(phi + whole.phi, first * whole.directions)


def directions_of(angles: Sequence[Fraction]) -> Complexes:
    """Give unit directions of angles in degrees, each reduced exactly."""
    reduced = [angle % 360 for angle in angles]
    octants = np.array([int(angle // 45) for angle in reduced], dtype=np.int64)
    rest = [angle % 45 if octant % 2 == 0 else 45 - angle % 45 for angle, octant in zip(reduced, octants, strict=True)]
    return _place(octants, np.array([float(angle) for angle in rest]))


def directions(numerators: npt.NDArray[np.int64], denominator: int) -> Complexes:
    """Give unit directions of the angles numerators/denominator degrees.

    Reduction to the first octant is exact, so quarter turns are exactly 1, 1j, -1, -1j and dead centres are hit.
    """
    eighth = 45 * denominator
    octants, rest = np.divmod(numerators % (8 * eighth), eighth)
    rest = np.where(octants % 2 == 0, rest, eighth - rest)
    return _place(octants, rest / denominator)


def _place(octants: npt.NDArray[np.int64], degrees: Floats) -> Complexes:
    """CrankPositions angles of the first octant, measured from its nearer axis, into directions of all eight."""
    angle = degrees * (np.pi / 180)
    near, off = np.cos(angle), np.sin(angle)
    swapped = (octants % 4 == 1) | (octants % 4 == 2)
    x, y = np.where(swapped, off, near), np.where(swapped, near, off)
    left = (octants >= 2) & (octants <= 5)
    below = octants >= 4
    return np.where(left, -x, x) + 1j * np.where(below, -y, y)
