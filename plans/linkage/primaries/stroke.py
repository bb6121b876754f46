"""A drive over a stroke, of a slider or of a cylinder: its positions and its law (ход привода)."""

from __future__ import annotations

from fractions import Fraction

from plans.linkage import crank_positions
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.primaries import ram, slider
from plans.linkage.reading.stroke import StrokeTable
from plans.model.mechanism import Mechanism
from plans.model.motion import Floats, Pace


def positions(mechanism: Mechanism, told: StrokeTable | None, steps: int) -> CrankPositions:
    """Divide a stroke into equal steps, and give the drive's positions there."""
    assert told is not None  # asked only of a stroke
    begin, end = Fraction(told.from_), Fraction(told.to)
    if mechanism.drive.ram is not None:
        return ram.positions(mechanism, crank_positions.stroke(begin, end, steps, 1.0).phi)
    return crank_positions.stroke(begin, end, steps, mechanism.drive.unit)


def pace(mechanism: Mechanism) -> Pace | None:
    """Give the rates of a drive over a stroke at its coordinate; None where they are steady."""
    if mechanism.drive.ram is not None:
        return ram.pace(mechanism)
    return slider.pace(mechanism) if mechanism.drive.law else None


def ways(mechanism: Mechanism, phi: Floats) -> Floats | None:
    """Give the way of a slider or the length of a cylinder that drives, (N,) m, at its coordinates; None of a crank."""
    if mechanism.drive.ram is not None:
        return ram.ways(mechanism, phi)
    return mechanism.drive.unit * phi if mechanism.drive.pushed else None
