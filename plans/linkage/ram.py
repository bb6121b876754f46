"""A drive over a stroke: a slider's, or a cylinder that swings about a fixed point or between two links (гидроцилиндр).

The boom of an excavator: the cylinder swings about a fixed point E, its rod's end F is a point of the crank. The
scissor lift: the cylinder stands between its two arms. How its length changes with the crank's angle, L(φ), dL/dφ and
d²L/dφ², is read off plans drawn at unit speed; the angle that belongs to a length is found by trial between two angles,
one of which has it shorter, the other longer.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property

import numpy as np

from geometry.board import Board
from geometry.branch import Side
from geometry.meet import EPS
from plans.linkage.assembly import assembly
from plans.linkage.primary import CrankPositions, divided, even
from plans.linkage.reading.fields import StrokeTable
from plans.linkage.sweep import NODES, Sweep, at_angles
from plans.model.decomposition import decompose
from plans.model.dyad import Assur
from plans.model.mechanism import FRAME, Mechanism, Passage, Ram
from plans.model.motion import Complexes, Floats, Motion, Pace, Rates, stroke_rates
from plans.words.words import because

TRIALS = 64  # halving alone comes from a whole turn below the rounding of an angle with fewer
ROUNDINGS = 4.0 * EPS  # of an angle of a turn, which is some units: a step so small is none


class Length:
    """How far two points of a linkage are apart over the crank's angle, by its plans at unit speed."""

    def __init__(self, mechanism: Mechanism, groups: Sequence[Assur], sides: Sequence[Side], home: float) -> None:
        self.mechanism = replace(mechanism, drive=mechanism.drive._replace(omega=1.0, epsilon=0.0))
        sweep = Sweep(self.mechanism, groups, sides, home)
        self._sweep = sweep.through() if mechanism.through else sweep

    def growth(self, phi: Floats, order: int = 0) -> list[Floats]:
        """Give length m, and as far as the order goes dL/dφ and d²L/dφ², (N,) each; NaN where nothing is assembled."""
        return length_of(self.mechanism, self._sweep.motion(at_angles(phi), order), order)


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


def length_of(mechanism: Mechanism, motion: Motion, order: int) -> list[Floats]:
    """Give the cylinder's length m over a motion, and as far as the order goes what it grows by, (N,) each."""
    rows = [apart(mechanism, motion, k) for k in range(order + 1)]
    length = np.abs(rows[0])
    with np.errstate(invalid="ignore"):  # one of no length has no direction
        along = np.conj(rows[0] / length)
    slope = [(along * rows[1]).real] if order > 0 else []
    bend = [(along * rows[2]).real + (along * rows[1]).imag ** 2 / length] if order > 1 else []
    return [length, *slope, *bend]


def apart(mechanism: Mechanism, motion: Motion, order: int = 0) -> Complexes:
    """Give the vector from the cylinder's foot to its point over a motion, (N,) m; of order 1, 2 its derivatives."""
    ram, frame = ram_of(mechanism), mechanism.links[FRAME].points
    row = motion.points[ram.point][order]
    if ram.foot not in frame:
        return np.asarray(row - motion.points[ram.foot][order])
    return np.asarray(row - frame[ram.foot]) if order == 0 else row


def ram_of(mechanism: Mechanism) -> Ram:
    """Give the cylinder that drives a mechanism."""
    assert mechanism.drive.ram is not None  # asked only where there is one
    return mechanism.drive.ram


class Between:
    """A cylinder between two points of a linkage: its length at crank angles, the angles at its lengths, its pace."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism, self.ram = mechanism, ram_of(mechanism)

    @cached_property
    def _passage(self) -> Passage:
        assert self.ram.passage is not None  # a linkage that cannot be assembled is refused before it is asked for
        return self.ram.passage

    @cached_property
    def _length(self) -> Length:
        return Length(self.mechanism, decompose(self.mechanism), self._passage.sides, self._passage.home)

    @property
    def arm(self) -> float:
        """The length m that the crank's turning is told by: no arm is nearer to it."""
        return min(self.ram.begin, self.ram.end)

    def positions(self, ways: Floats) -> CrankPositions:
        """Find the crank's positions at lengths, (N,) m: along the tangent, by halves where that leads away."""
        low, high = (np.full(ways.shape, end) for end in (self._passage.low, self._passage.high))
        first, last = self.ways(np.array([self._passage.low, self._passage.high]))
        phi = (low + high) / 2
        for _ in range(TRIALS):
            length, slope = self._length.growth(phi, 1)
            short = (length < ways) == (last > first)
            low, high = np.where(short, phi, low), np.where(short, high, phi)
            along = phi - (length - ways) / slope
            before, phi = phi, np.where((along >= low) & (along <= high), along, (low + high) / 2)
            if (np.abs(phi - before) <= ROUNDINGS).all():
                break
        return at_angles(phi)

    def ways(self, phi: Floats) -> Floats:
        """Give the cylinder's lengths at crank angles rad, (N,) m."""
        return self._length.growth(phi)[0]

    def pace(self, phi: Floats) -> Rates:
        """Give the crank's rates at its angles: the cylinder lengthens as its law says."""
        length, slope, bend = self._length.growth(phi, 2)
        speed, acceleration = stroke_rates(self.mechanism.drive, length, self.ram.speed, self.ram.acceleration)
        omega = speed / slope
        return Rates(omega, (acceleration - bend * omega**2) / slope)

    def lever(self, motion: Motion) -> Floats:
        """Give what the cylinder grows by over a radian of the crank, m, over a motion, (N,)."""
        return np.asarray(np.abs(self._length.growth(motion.phi, 1)[1]))


class Triangle:
    """A cylinder that a triangle holds: its fixed point, the crank's hinge and a point of the crank.

    `arm_vector` is that from the hinge to that point in shares of the crank's unit direction, m.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism, self.ram = mechanism, ram_of(mechanism)
        drive, frame = mechanism.drive, mechanism.links[FRAME].points
        points = mechanism.links[drive.link].points
        end = points[drive.end] - points[drive.pivot]
        self.fixed, self.hinge = frame[self.ram.foot], frame[drive.pivot]
        self.arm_vector = (points[self.ram.point] - points[drive.pivot]) * abs(end) / end

    @property
    def arm(self) -> float:
        """The crank's arm m that the cylinder turns."""
        return abs(self.arm_vector)

    def _span(self, phi: Floats) -> Complexes:
        """Give the vector from the fixed point to the crank's, (N,) m, at crank angles rad."""
        return np.asarray(self.hinge + self.arm_vector * np.exp(1j * phi) - self.fixed)

    def positions(self, ways: Floats) -> CrankPositions:
        """Notch the crank's point by the cylinder's lengths, (N,) m, and give the crank's positions there."""
        board, ram, pivot = Board("positions"), self.ram, self.mechanism.drive.pivot
        fixed = board.given(ram.foot, self.fixed, because("fixed"))
        hinge = board.given(pivot, self.hinge, because("drive_hinge"))
        lengths = board.arc(f"{ram.foot}{ram.point}", fixed, ways, because("ram_lengths"))
        crank = board.arc(f"{pivot}{ram.point}", hinge, abs(self.arm_vector), because("crank_circle"))
        why = because("notched", point=ram.point, start=fixed.name, end=hinge.name)
        met = board.meet(ram.point, lengths, crank, ram.side, why)
        directions = np.asarray((met.point - self.hinge) / self.arm_vector)
        directions = directions / np.abs(directions)
        return CrankPositions(np.unwrap(np.angle(directions)), directions)

    def ways(self, phi: Floats) -> Floats:
        """Give the cylinder's lengths at crank angles rad, (N,) m."""
        return np.asarray(np.abs(self._span(phi)))

    def pace(self, phi: Floats) -> Rates:
        """Give the crank's rates at its angles: its point goes along the cylinder as fast as that lengthens."""
        arm, span = self.arm_vector * np.exp(1j * phi), self._span(phi)
        length = np.abs(span)
        speed, acceleration = stroke_rates(self.mechanism.drive, length, self.ram.speed, self.ram.acceleration)
        arms = arm * np.conj(span / length)  # along the cylinder, and square to it
        omega = -speed / arms.imag
        across = omega * arms.real
        return Rates(omega, (across**2 / length - omega**2 * arms.real - acceleration) / arms.imag)

    def lever(self, motion: Motion) -> Floats:
        """Give the cylinder's arm m about the crank's hinge over a motion, (N,)."""
        places = motion.points[self.ram.point].r
        span = places - self.fixed
        return np.asarray(np.abs((np.conj(span) * (places - self.hinge)).imag) / np.abs(span))


def cylinder(mechanism: Mechanism) -> Triangle | Between:
    """Give the cylinder that drives a mechanism, by what holds it."""
    return Triangle(mechanism) if ram_of(mechanism).links is None else Between(mechanism)


def positions(mechanism: Mechanism, stroke: StrokeTable | None, steps: int) -> CrankPositions:
    """Divide a stroke into equal steps, and give the drive's positions there."""
    assert stroke is not None  # asked only of a stroke
    begin, end = Fraction(stroke.from_), Fraction(stroke.to)
    if mechanism.drive.ram is not None:
        return cylinder(mechanism).positions(divided(begin, end, steps, 1.0).phi)
    return divided(begin, end, steps, mechanism.drive.unit)


def pace(mechanism: Mechanism) -> Pace | None:
    """Give the rates of a drive over a stroke at its coordinate; None where they are steady."""
    if mechanism.drive.ram is not None:
        return cylinder(mechanism).pace
    return _slider_pace(mechanism) if mechanism.drive.law else None


def _slider_pace(mechanism: Mechanism) -> Pace:
    """Give the slider's rates by its law over the stroke, in units of the drive."""
    drive = mechanism.drive

    def rates(phi: Floats) -> Rates:
        speeds = stroke_rates(drive, drive.unit * phi, drive.unit * drive.omega, drive.unit * drive.epsilon)
        return Rates(*(rate / drive.unit for rate in speeds))

    return rates


def ways(mechanism: Mechanism, phi: Floats) -> Floats | None:
    """Give the way of a slider or the length of a cylinder that drives, (N,) m, at its coordinates; None of a crank."""
    if mechanism.drive.ram is not None:
        return cylinder(mechanism).ways(phi)
    return mechanism.drive.unit * phi if mechanism.drive.pushed else None
