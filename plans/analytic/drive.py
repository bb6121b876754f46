"""The drive as an equation: what a unit of its coordinate does to the link that it moves (уравнение привода).

The coordinate is the angle of a crank, rad, or the way of a slide in units of the drive's `unit`.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.model.mechanism import Mechanism, Way
from plans.model.motion import Complexes, Floats

X, Y, TURN = range(3)  # of a pose


class Placement(NamedTuple):
    """Where N poses put the joints, hinges before slides; arms run from a link's origin to the joint."""

    turns: Complexes  # (N, links): unit directions of the links' own +x axes
    arms: Complexes  # (N, 2, joints): of a slide, to a point of its line
    apart: Complexes  # (N, joints): from the second link's point to the first's
    ways: Complexes  # (N, 2, S): directions of slider's and owner's line


class TurningDrive(NamedTuple):
    """A crank that is turned: the place of the link, and the direction from pivot to end in its own frame."""

    place: int
    way: complex

    @property
    def moved(self) -> tuple[int, ...]:
        """Places of the links that its equation moves."""
        return (self.place,)

    def coordinate(self, at: Placement) -> Floats:
        """Give the crank angle, rad in (-pi, pi], at N poses."""
        return np.asarray(np.angle(at.turns[:, self.place] * self.way))

    def lag(self, at: Placement, phi: Floats) -> Floats:
        """Tell by how much the crank is ahead of the angles phi, rad."""
        return np.asarray(np.angle(at.turns[:, self.place] * self.way * np.exp(-1j * phi)))

    def row(self, at: Placement, width: int) -> Floats:
        """Differentiate its equation by the poses of all links, (N, width)."""
        row = np.zeros((len(at.turns), width))
        row[:, 3 * self.place + TURN] = 1.0
        return row

    def bend(self, at: Placement, lines: Complexes) -> Floats:
        """Give the part of its second derivative that is quadratic in the rates."""
        return np.zeros(len(at.turns))

    def stated(self, poses: Floats, size: float) -> Floats:
        """Put into derivatives of the poses, (N, links, 3), what the drive gives itself: `size`, with no rounding."""
        poses[:, self.place, TURN] = size
        return poses


class SlidingDrive(NamedTuple):
    """A slide that is pushed along: its place among the slides, its two links, where its way counts from, its unit.

    `lead` and `unit` are lengths in units of the constraints' `size`.
    """

    slide: int
    joint: int
    links: tuple[int, int]  # places of slider and owner
    lead: float
    unit: float

    @property
    def moved(self) -> tuple[int, ...]:
        """Places of the links that its equation moves."""
        return self.links

    def coordinate(self, at: Placement) -> Floats:
        """Give the way of the slide at N poses."""
        along = (at.ways[:, 1, self.slide].conj() * at.apart[:, self.joint]).real
        return np.asarray((along + self.lead) / self.unit)

    def lag(self, at: Placement, phi: Floats) -> Floats:
        """Tell by how much the slide is ahead of the ways phi."""
        return self.coordinate(at) - phi

    def row(self, at: Placement, width: int) -> Floats:
        """Differentiate its equation by the poses of all links, (N, width)."""
        way, off = at.ways[:, 1, self.slide].conj(), at.apart[:, self.joint]
        arms = at.arms[:, 0, self.joint], -(at.arms[:, 1, self.joint] + off)
        row = np.zeros((len(at.turns), width))
        for link, sign, arm in zip(self.links, (1.0, -1.0), arms, strict=True):
            moved = np.stack((sign * way.real, -sign * way.imag, -(way * arm).imag), axis=1)
            row[:, 3 * link : 3 * link + 3] += moved / self.unit
        return row

    def bend(self, at: Placement, lines: Complexes) -> Floats:
        """Give the part of its second derivative that is quadratic in the rates; `lines` are those of all slides."""
        return np.asarray((at.ways[:, 1, self.slide].conj() * lines[:, self.slide]).real / self.unit)

    def stated(self, poses: Floats, size: float) -> Floats:
        """Leave the derivatives of the poses as they are: no entry of a pose is the drive's coordinate itself."""
        return poses


DriveEquation: TypeAlias = TurningDrive | SlidingDrive


def drive_equation(mechanism: Mechanism, numbers: Sequence[int], hinges: int, size: float) -> DriveEquation:
    """Write down the equation of a mechanism's drive, whose poses are of links in order of their numbers."""
    drive = mechanism.drive
    if drive.guide is None:
        points = mechanism.links[drive.link].points
        arm = points[drive.end] - points[drive.pivot]
        return TurningDrive(numbers.index(drive.link), arm / abs(arm))
    slide, place = drive.guide, mechanism.slides.index(drive.guide)
    links = numbers.index(slide.slider), numbers.index(slide.owner)
    local = mechanism.links[slide.slider].points[slide.point]
    lead = foot_way(slide.on_slider, local) - foot_way(slide.on_owner, slide.on_owner.through)
    return SlidingDrive(place, hinges + place, links, lead / size, drive.unit / size)


def foot_way(way: Way, point: complex) -> float:
    """Give how far along a line a point lies from the line's foot of its link's origin."""
    direction = way.direction / abs(way.direction)
    return (direction.conjugate() * point).real
