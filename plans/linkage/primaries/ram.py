"""A crank that a cylinder drives: its angles by notches from the cylinder's lengths, its rates (гидроцилиндр).

The boom of an excavator: the cylinder swings about a fixed point E, its rod's end F is a point of the crank. A cylinder
between other points of the linkage has its length by the linkage's own plans (plans/linkage/primaries/between.py).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from geometry.board import Board
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.primaries.between import Between
from plans.model.mechanism import FRAME, Mechanism, Ram
from plans.model.motion import Complexes, Floats, Motion, Pace, Rates, stroke_rates
from plans.words.words import because


class Triangle(NamedTuple):
    """The triangle of a cylinder: its fixed point and the crank's hinge, m, the crank's point in the crank's frame.

    `own` is that from the hinge in shares of the crank's unit direction, m.
    """

    ram: Ram
    fixed: complex
    hinge: complex
    own: complex

    def span(self, phi: Floats) -> Complexes:
        """Give the vector from the fixed point to the crank's, (N,) m, at crank angles rad."""
        return np.asarray(self.hinge + self.own * np.exp(1j * phi) - self.fixed)


def triangle(mechanism: Mechanism) -> Triangle:
    """Give the triangle of the cylinder that drives a mechanism."""
    drive, frame = mechanism.drive, mechanism.links[FRAME].points
    assert drive.ram is not None  # asked only where there is one
    points = mechanism.links[drive.link].points
    end = points[drive.end] - points[drive.pivot]
    own = (points[drive.ram.point] - points[drive.pivot]) * abs(end) / end
    return Triangle(drive.ram, frame[drive.ram.foot], frame[drive.pivot], own)


def positions(mechanism: Mechanism, ways: Floats) -> CrankPositions:
    """Notch the crank's point by the cylinder's lengths, (N,) m, and give the crank's positions there."""
    if not _held(mechanism):
        return Between(mechanism).positions(ways)
    corner, ram = triangle(mechanism), triangle(mechanism).ram
    board = Board("positions")
    fixed = board.given(ram.foot, corner.fixed, because("fixed"))
    hinge = board.given(mechanism.drive.pivot, corner.hinge, because("drive_hinge"))
    lengths = board.arc(f"{ram.foot}{ram.point}", fixed, ways, because("ram_lengths"))
    crank = board.arc(f"{mechanism.drive.pivot}{ram.point}", hinge, abs(corner.own), because("crank_circle"))
    why = because("notched", point=ram.point, start=fixed.name, end=hinge.name)
    met = board.meet(ram.point, lengths, crank, ram.side, why)
    directions = np.asarray((met.point - corner.hinge) / corner.own)
    directions = directions / np.abs(directions)
    return CrankPositions(np.unwrap(np.angle(directions)), directions)


def pace(mechanism: Mechanism) -> Pace:
    """Give the crank's rates at its angles: its point goes along the cylinder as fast as that lengthens."""
    if not _held(mechanism):
        return Between(mechanism).pace
    corner = triangle(mechanism)

    def rates(phi: Floats) -> Rates:
        arm, span = corner.own * np.exp(1j * phi), corner.span(phi)
        length = np.abs(span)
        speed, acceleration = stroke_rates(mechanism.drive, length, corner.ram.speed, corner.ram.acceleration)
        arms = arm * np.conj(span / length)  # along the cylinder, and square to it
        omega = -speed / arms.imag
        across = omega * arms.real
        epsilon = (across**2 / length - omega**2 * arms.real - acceleration) / arms.imag
        return Rates(omega, epsilon)

    return rates


def ways(mechanism: Mechanism, phi: Floats) -> Floats:
    """Give the cylinder's lengths at crank angles rad, (N,) m."""
    if not _held(mechanism):
        return Between(mechanism).growth(phi)[0]
    return np.asarray(np.abs(triangle(mechanism).span(phi)))


def law(mechanism: Mechanism, phi: Floats) -> tuple[Floats, Floats]:
    """Give how fast the cylinder lengthens at crank angles rad, (N,): m/s, and m/s2."""
    ram = mechanism.drive.ram
    assert ram is not None  # asked only where there is one
    return stroke_rates(mechanism.drive, ways(mechanism, phi), ram.speed, ram.acceleration)


def lever(mechanism: Mechanism, motion: Motion) -> Floats:
    """Give the arm m of the cylinder about the crank's hinge over a motion, (N,): what it grows by over a radian."""
    if not _held(mechanism):
        return np.asarray(np.abs(Between(mechanism).growth(motion.phi, 1)[1]))
    corner = triangle(mechanism)
    places = motion.points[corner.ram.point].r
    span = places - corner.fixed
    return np.asarray(np.abs((np.conj(span) * (places - corner.hinge)).imag) / np.abs(span))


def _held(mechanism: Mechanism) -> bool:
    """Tell whether the triangle of a fixed point, the crank's hinge and its point holds the cylinder."""
    return mechanism.drive.ram is not None and mechanism.drive.ram.links is None
