"""A cylinder between two points of a linkage: its length over the crank's angle, by the plans (цилиндр между звеньями).

The scissor lift: the cylinder stands between its two arms. How its length changes with the crank's angle, L(φ), dL/dφ
and d²L/dφ², is read off plans drawn at unit speed; the angle that belongs to a length is found by trial between two
angles, one of which has it shorter, the other longer.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property

import numpy as np

from geometry.meet import EPS
from plans.linkage.assembly_limits import NODES, Sweep, at_angles
from plans.linkage.crank_positions import CrankPositions, even
from plans.linkage.sketch import assembly
from plans.model.dyad import Group, decompose
from plans.model.mechanism import FRAME, Mechanism, Passage, Ram
from plans.model.motion import Complexes, Floats, Motion, Rates, stroke_rates

TRIALS = 64  # halving alone comes from a whole turn below the rounding of an angle with fewer
ROUNDINGS = 4.0 * EPS  # of an angle of a turn, which is some units: a step so small is none


class Length:
    """How far two points of a linkage are apart over the crank's angle, by its plans at unit speed."""

    def __init__(self, mechanism: Mechanism, groups: Sequence[Group], sides: Sequence[float], home: float) -> None:
        self.mechanism = replace(mechanism, drive=mechanism.drive._replace(omega=1.0, epsilon=0.0))
        sweep = Sweep(self.mechanism, groups, sides, home)
        self._sweep = sweep.through() if mechanism.through else sweep

    def growth(self, phi: Floats, order: int = 0) -> list[Floats]:
        """Give length m, and as far as the order goes dL/dφ and d²L/dφ², (N,) each; NaN where nothing is assembled."""
        motion = self._sweep.motion(at_angles(phi), order)
        rows = [apart(self.mechanism, motion, k) for k in range(order + 1)]
        length = np.abs(rows[0])
        along = np.conj(rows[0] / length)
        slope = [(along * rows[1]).real] if order > 0 else []
        bend = [(along * rows[2]).real + (along * rows[1]).imag ** 2 / length] if order > 1 else []
        return [length, *slope, *bend]


class Between:
    """A cylinder between two points of a linkage: its length at crank angles, the angles at its lengths, its pace."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism

    @cached_property
    def _ram(self) -> Ram:
        assert self.mechanism.drive.ram is not None  # asked only where there is one
        return self.mechanism.drive.ram

    @cached_property
    def _passage(self) -> Passage:
        assert self._ram.passage is not None  # a linkage that cannot be assembled is refused before it is asked for
        return self._ram.passage

    @cached_property
    def _length(self) -> Length:
        return Length(self.mechanism, decompose(self.mechanism), self._passage.sides, self._passage.home)

    def growth(self, phi: Floats, order: int = 0) -> list[Floats]:
        """Give length m, and as far as the order goes dL/dφ and d²L/dφ², (N,) each, at crank angles rad."""
        return self._length.growth(phi, order)

    def positions(self, ways: Floats) -> CrankPositions:
        """Find the crank's positions at lengths, (N,) m: along the tangent, by halves where that leads away."""
        low, high = (np.full(ways.shape, end) for end in (self._passage.low, self._passage.high))
        first, last = self.growth(np.array([self._passage.low, self._passage.high]))[0]
        phi = (low + high) / 2
        for _ in range(TRIALS):
            length, slope = self.growth(phi, 1)
            short = (length < ways) == (last > first)
            low, high = np.where(short, phi, low), np.where(short, high, phi)
            along = phi - (length - ways) / slope
            before, phi = phi, np.where((along >= low) & (along <= high), along, (low + high) / 2)
            if (np.abs(phi - before) <= ROUNDINGS).all():
                break
        return at_angles(phi)

    def pace(self, phi: Floats) -> Rates:
        """Give the crank's rates at its angles: the cylinder lengthens as its law says."""
        length, slope, bend = self.growth(phi, 2)
        speed, acceleration = stroke_rates(self.mechanism.drive, length, self._ram.speed, self._ram.acceleration)
        omega = speed / slope
        return Rates(omega, (acceleration - bend * omega**2) / slope)


def passage(mechanism: Mechanism) -> tuple[Passage, tuple[float, float]] | None:
    """Find how far a linkage goes from its sketch while its cylinder only grows or shortens, and its lengths m there.

    None: it has no position, or in that of the sketch the cylinder neither grows nor shortens.
    """
    groups = decompose(mechanism)
    found = assembly(mechanism, groups, None, even(Fraction(0), 360, 1))
    if found.phi is None:
        return None
    nodes = np.asarray(found.phi + 2 * np.pi / NODES * np.arange(-NODES, NODES + 1), dtype=np.float64)
    length, slope = Length(mechanism, groups, found.sides, found.phi).growth(nodes, 1)
    with np.errstate(invalid="ignore"):  # NaN: it is not assembled there
        other = np.flatnonzero(~(slope * slope[NODES] > 0))
    if NODES in other:
        return None
    low, high = int(other[other < NODES].max()) + 1, int(other[other > NODES].min()) - 1
    ends = sorted((float(length[low]), float(length[high])))
    return Passage(found.sides, found.phi, float(nodes[low]), float(nodes[high])), (ends[0], ends[1])


def apart(mechanism: Mechanism, motion: Motion, order: int = 0) -> Complexes:
    """Give the vector from the cylinder's foot to its point over a motion, (N,) m; of order 1, 2 its derivatives."""
    ram, frame = mechanism.drive.ram, mechanism.links[FRAME].points
    assert ram is not None  # asked only where there is one
    row = motion.points[ram.point][order]
    if ram.foot not in frame:
        return np.asarray(row - motion.points[ram.foot][order])
    return np.asarray(row - frame[ram.foot]) if order == 0 else row
