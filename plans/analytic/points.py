"""The joints and the drive of a mechanism as equations of the poses of its links, and points of links by these poses.

The drive's coordinate is the angle of a crank, rad, or the way of a slide in units of the drive's `unit` (уравнения
связей, уравнение привода, точки звеньев).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from collections.abc import Set as AbstractSet
from itertools import combinations
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from plans.model.mechanism import FRAME, Mechanism, StructureError, Way
from plans.model.motion import Complexes, Floats, Motion
from plans.words.words import message

Indices = npt.NDArray[np.intp]
X, Y, TURN = range(3)  # of a pose
_SIGNS = np.array([[1.0], [-1.0]])  # a hinge is the first link's point less the second's


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


class Constraints(NamedTuple):
    """The joints of a mechanism, or of some of its links, as equations of the poses.

    Rows: hinges x, hinges y, directions, lines, and the drive where it gives a pose that is sought.
    """

    size: float  # m, the unit of length
    numbers: tuple[int, ...]  # the links in order of number, the frame first
    hinges: int  # their number H; the joints after them are the S slides
    links: Indices  # (2, joints): the two links of each joint, by place in `numbers`; of a slide slider and owner
    points: Complexes  # (2, joints): the hinge, or a point of the common line, in either link's own frame
    slide_ways: Complexes  # (2, S): unit directions of the common line in either
    crank: int  # place of the primary link in `numbers`
    drive: DriveEquation
    driven: bool  # whether the drive's equation is among them
    pattern: Floats  # (rows, 3 links): the entries of the Jacobian that never change
    changing: Indices  # the places of those that do, in the order in which `jacobian` makes them
    sought: Indices  # places of the links whose poses the equations are to give

    @classmethod
    def of(cls, mechanism: Mechanism) -> Constraints:
        """Write down the equations of a mechanism of mobility 1."""
        if mechanism.mobility != 1:
            raise StructureError(message("structure.mobility"), found=mechanism.mobility)
        numbers, size = tuple(sorted(mechanism.links)), _size(mechanism)
        local = {number: mechanism.links[number].points for number in numbers}
        slides, count = mechanism.slides, mechanism.lower_pairs - len(mechanism.slides)
        drive_row = drive_equation(mechanism, numbers, count, size)
        order = _placing(mechanism, {numbers[place] for place in drive_row.moved})
        # Every link of a hinge is tied to the one that is placed first, lest links rest on such as come after them.
        tied = [(point, sorted(links, key=order.index)) for point, links in mechanism.hinges.items()]
        pairs = [(first, link, point) for point, (first, *others) in tied for link in others]
        joined = [(a, b) for a, b, _ in pairs] + [(s.slider, s.owner) for s in slides]
        feet = [(_foot(s.on_slider), _foot(s.on_owner)) for s in slides]
        links = _indices((numbers.index(a), numbers.index(b)) for a, b in joined)
        ways = _places((s.on_slider.direction, s.on_owner.direction) for s in slides)
        return cls(
            size=size,
            numbers=numbers,
            hinges=count,
            links=links,
            points=_places([(local[a][p], local[b][p]) for a, b, p in pairs] + feet) / size,
            slide_ways=ways / np.abs(ways),
            crank=numbers.index(mechanism.drive.link),
            drive=drive_row,
            driven=True,
            pattern=_pattern(len(numbers), links, count),
            changing=_changing(len(numbers), links, count),
            sought=np.arange(1, len(numbers)),
        )

    def part(self, sought: Sequence[int], joints: Sequence[int], driven: bool) -> Constraints:
        """Give the equations of some joints alone, perhaps of the drive, for some links; the others are given."""
        chosen = np.array(sorted(joints), dtype=np.intp)
        count, links = int((chosen < self.hinges).sum()), self.links[:, chosen]
        drive, pattern = self.drive, _pattern(len(self.numbers), links, count)
        if driven and isinstance(drive, SlidingDrive):
            joint = int(np.searchsorted(chosen, drive.joint))
            drive = drive._replace(slide=joint - count, joint=joint)
        return self._replace(
            hinges=count,
            links=links,
            points=self.points[:, chosen],
            slide_ways=self.slide_ways[:, chosen[count:] - self.hinges],
            drive=drive,
            driven=driven,
            pattern=pattern if driven else pattern[:-1],
            changing=_changing(len(self.numbers), links, count),
            sought=np.array(sorted(sought), dtype=np.intp),
        )

    @property
    def columns(self) -> Indices:
        """Places of the unknowns among the entries of all poses."""
        return np.asarray((3 * self.sought[:, None] + np.arange(3)).ravel())

    def moved(self, poses: Floats, step: Floats) -> Floats:
        """Move poses (N, links, 3) by a step of the unknowns (N, 3 sought)."""
        there = poses.reshape(len(poses), 3 * len(self.numbers)).copy()
        there[:, self.columns] += step
        return there.reshape(poses.shape)

    def place(self, poses: Floats) -> Placement:
        """Lay out the joints of N poses."""
        turns = np.exp(1j * poses[:, :, TURN])
        turned = turns[:, self.links]
        arms = self.points * turned
        points = (poses[:, :, X] + 1j * poses[:, :, Y])[:, self.links] + arms
        return Placement(turns, arms, points[:, 0] - points[:, 1], self.slide_ways * turned[:, :, self.hinges :])

    def residual(self, at: Placement, phi: Floats) -> Floats:
        """Tell by how much every equation fails, (N, rows); angles rad, lengths in units of `size`."""
        apart, off = at.apart[:, : self.hinges], at.apart[:, self.hinges :]
        slider, owner = at.ways[:, 0], at.ways[:, 1].conj()
        # The angle between the two directions, not its sine: a slider turned end for end is no solution.
        askew = -np.angle(slider * owner)
        joints = (apart.real, apart.imag, askew, (owner * off).imag)
        if not self.driven:
            return np.concatenate(joints, axis=1)
        return np.concatenate((*joints, self.drive.lag(at, phi)[:, None]), axis=1)

    def jacobian(self, at: Placement) -> Floats:
        """Differentiate the equations by the poses that are sought, (N, rows, 3 sought)."""
        count = len(at.turns)
        hinged = (_SIGNS * at.arms[:, :, : self.hinges]).reshape(count, 2 * self.hinges)
        arms, off, way = at.arms[:, :, self.hinges :], at.apart[:, self.hinges :], at.ways[:, 1]
        levers = ((way.conj() * arms[:, 0]).real, -(way.conj() * (arms[:, 1] + off)).real)
        full = np.empty((count, self.pattern.size))
        full[:] = self.pattern.ravel()
        # A vector that turns by a small angle moves by so much of itself, square to itself.
        columns = (-hinged.imag, hinged.real, -way.imag, way.real, way.imag, -way.real, *levers)
        full[:, self.changing] = np.concatenate(columns, axis=1)
        shaped = full.reshape(count, *self.pattern.shape)
        if self.driven:
            shaped[:, -1] = self.drive.row(at, self.pattern.shape[1])
        return shaped[:, :, 3:] if len(self.sought) == len(self.numbers) - 1 else shaped[:, :, self.columns]

    def convective(self, at: Placement, rates: Floats) -> Floats:
        """Give the part of the equations' second derivative that is quadratic in the rates, (N, rows)."""
        spins, sliding = rates[:, :, TURN][:, self.links], self.links[:, self.hinges :]
        bent = -(spins**2) * at.arms
        apart = bent[:, 0] - bent[:, 1]
        still, turning = apart[:, : self.hinges], spins[:, 1, self.hinges :]
        moving = (rates[:, :, X] + 1j * rates[:, :, Y])[:, sliding] + 1j * (spins * at.arms)[:, :, self.hinges :]
        off = at.apart[:, self.hinges :]
        lines = apart[:, self.hinges :] - 2j * turning * (moving[:, 0] - moving[:, 1]) - turning**2 * off
        rows = (still.real, still.imag, np.zeros_like(turning), (at.ways[:, 1].conj() * lines).imag)
        return np.concatenate((*rows, self.drive.bend(at, lines)[:, None]) if self.driven else rows, axis=1)


TOGETHER = 4  # links at the most whose equations are looked at by themselves: two dyads, or a group of class III


def _placing(mechanism: Mechanism, moved: AbstractSet[int]) -> list[int]:
    """Order the links as they can be placed, always as few together as have equations enough of their own."""
    order, left = [FRAME], [number for number in sorted(mechanism.links) if number != FRAME]
    if all(len(links) < 3 for links in mechanism.hinges.values()):
        return order + left
    while left:
        sets = (each for size in range(1, TOGETHER + 1) for each in combinations(left, size))
        placed = next((each for each in sets if _gives(mechanism, moved, {*order}, {*each})), tuple(left))
        order += placed
        left = [number for number in left if number not in placed]
    return order


def _gives(mechanism: Mechanism, moved: AbstractSet[int], known: AbstractSet[int], sought: AbstractSet[int]) -> bool:
    """Tell whether joints with each other and with known links, and perhaps the drive, give the poses of some links."""
    there, count = known | sought, int(moved <= known | sought and not moved <= known)
    for links in mechanism.hinges.values():
        count += 2 * max(len(there & {*links}) - max(len(known & {*links}), 1), 0)
    slides = ({slide.slider, slide.owner} for slide in mechanism.slides)
    count += 2 * sum(links <= there and not links <= known for links in slides)
    return count == 3 * len(sought)


def _indices(pairs: Iterable[tuple[int, int]]) -> Indices:
    return np.array(list(pairs), dtype=np.intp).reshape(-1, 2).T


def _places(pairs: Iterable[tuple[complex, complex]]) -> Complexes:
    return np.array(list(pairs), dtype=np.complex128).reshape(-1, 2).T


def _foot(way: Way) -> complex:
    """Give a line by its point nearest to its link's origin: the scene may name it by one that is far away."""
    direction = way.direction / abs(way.direction)
    return 1j * direction * (direction.conjugate() * way.through).imag


def _size(mechanism: Mechanism) -> float:
    """Take the power of two nearest to the largest distance of a point or line from the origin of its link."""
    points = [abs(place) for link in mechanism.links.values() for place in link.points.values()]
    lines = [abs(_foot(way)) for slide in mechanism.slides for way in (slide.on_slider, slide.on_owner)]
    return float(2.0 ** round(np.log2(max(points + lines))))


def _pattern(count: int, links: Indices, hinges: int) -> Floats:
    slides = links[:, hinges:]
    pattern = np.zeros((2 * links.shape[1] + 1, 3 * count))
    rows, directions = np.arange(hinges), 2 * hinges + np.arange(slides.shape[1])
    for side, sign in ((0, 1.0), (1, -1.0)):
        pattern[rows, 3 * links[side, :hinges] + X] = sign
        pattern[rows + hinges, 3 * links[side, :hinges] + Y] = sign
        pattern[directions, 3 * slides[side] + TURN] = -sign
    return pattern


def _changing(count: int, links: Indices, hinges: int) -> Indices:
    """Give the places of the entries that depend on the poses: hinges by either turn, lines by either pose."""
    width, rows, turns = 3 * count, np.arange(hinges), 3 * links + TURN
    across = (rows * width + turns[:, :hinges]).ravel()
    lines = (2 * hinges + links.shape[1] - hinges + np.arange(links.shape[1] - hinges)) * width
    slider, owner = 3 * links[:, hinges:]
    poses = (slider + X, slider + Y, owner + X, owner + Y, slider + TURN, owner + TURN)
    return np.concatenate((across, across + hinges * width, *(lines + place for place in poses)))


def place(constraints: Constraints, poses: Floats, link: int, local: complex) -> Complexes:
    """Place a point of a link, m from the datum, at poses (..., links, 3)."""
    x, y, turn = np.moveaxis(poses[..., constraints.numbers.index(link), :], -1, 0)
    return np.asarray(constraints.size * (x + 1j * y) + local * np.exp(1j * turn))


def speed(constraints: Constraints, poses: Floats, rates: Floats, link: int, local: complex) -> Complexes:
    """Give its velocity at rates (..., links, 3) of the poses."""
    on = constraints.numbers.index(link)
    arm, (x, y, spin) = local * np.exp(1j * poses[..., on, TURN]), np.moveaxis(rates[..., on, :], -1, 0)
    return np.asarray(constraints.size * (x + 1j * y) + 1j * spin * arm)


def placed(mechanism: Mechanism, motion: Motion, link: int, local: complex) -> Complexes:
    """Place a point of a link, m from the datum, over a motion."""
    point, first = next(iter(mechanism.links[link].points.items()))
    return np.asarray(motion.points[point].r + (local - first) * np.exp(1j * motion.links[link].angle))


def acceleration(mechanism: Mechanism, motion: Motion, link: int, local: complex) -> Complexes:
    """Carry the acceleration m/s2 of the link's first point to another of its points."""
    point, first = next(iter(mechanism.links[link].points.items()))
    turn, omega, epsilon = motion.links[link]
    return np.asarray(motion.points[point].a + (1j * epsilon - omega**2) * (local - first) * np.exp(1j * turn))
