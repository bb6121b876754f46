"""The equations of all joints at once, with their exact first and second derivatives.

The unknowns are the poses of the links: x and y of the origin of the link's own frame and the turn of that frame, an
array (N, links, 3) for N positions whose link 0 is the frame, at rest. Lengths are counted in units of `size`, a power
of two metres near the largest length of the mechanism: the equations are of one order, and scaling rounds nothing.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from plans.mechanism import Mechanism, StructureError, Way
from plans.motion import Complexes, Floats

Indices = npt.NDArray[np.intp]
X, Y, TURN = range(3)


@dataclass(frozen=True, slots=True)
class Placement:
    """Where N poses put the joints; arms run from a link's origin to the joint."""

    origins: Complexes  # (N, links)
    turns: Complexes  # (N, links): unit directions of the links' own +x axes
    arms: Complexes  # (N, 2, H): hinges
    ways: Complexes  # (N, 2, S): directions of slider's and owner's line
    slide_arms: Complexes  # (N, 2, S): points of the two lines
    off: Complexes  # (N, S): from the owner's point to the slider's


@dataclass(frozen=True)
class Constraints:
    """The joints of a mechanism as equations of the poses, rows: hinges x, hinges y, directions, lines, drive."""

    size: float  # m, the unit of length
    numbers: tuple[int, ...]  # the links in order of number, the frame first
    hinge_links: Indices  # (2, H): the two links of each coincidence, by place in `numbers`
    hinge_points: Complexes  # (2, H): the hinge in either link's own frame
    slide_links: Indices  # (2, S): slider and owner
    slide_points: Complexes  # (2, S): a point of the common line in either
    slide_ways: Complexes  # (2, S): unit directions of the common line in either
    crank: int  # place of the crank in `numbers`
    crank_way: complex  # unit direction from pivot to end in the crank's own frame
    pattern: Floats  # (rows, 3 links): the entries of the Jacobian that never change

    @classmethod
    def of(cls, mechanism: Mechanism) -> Constraints:
        """Write down the equations of a mechanism of mobility 1."""
        if mechanism.mobility != 1:
            raise StructureError("one drive moves a mechanism of mobility 1 only", found=mechanism.mobility)
        numbers, size, drive = tuple(sorted(mechanism.links)), _size(mechanism), mechanism.drive
        own = {number: mechanism.links[number].points for number in numbers}
        pairs = [(links[0], link, point) for point, links in mechanism.hinges.items() for link in links[1:]]
        hinge_links = _indices((numbers.index(a), numbers.index(b)) for a, b, _ in pairs)
        slides = mechanism.slides
        slide_links = _indices((numbers.index(s.slider), numbers.index(s.owner)) for s in slides)
        ways = _places((s.on_slider.direction, s.on_owner.direction) for s in slides)
        arm = own[drive.link][drive.end] - own[drive.link][drive.pivot]
        crank = numbers.index(drive.link)
        return cls(
            size=size,
            numbers=numbers,
            hinge_links=hinge_links,
            hinge_points=_places((own[a][p], own[b][p]) for a, b, p in pairs) / size,
            slide_links=slide_links,
            slide_points=_places((_foot(s.on_slider), _foot(s.on_owner)) for s in slides) / size,
            slide_ways=ways / np.abs(ways),
            crank=crank,
            crank_way=arm / abs(arm),
            pattern=_pattern(len(numbers), hinge_links, slide_links, crank),
        )

    def place(self, poses: Floats) -> Placement:
        """Lay out the joints of N poses."""
        turns = np.exp(1j * poses[:, :, TURN])
        origins = poses[:, :, X] + 1j * poses[:, :, Y]
        on_slides = turns[:, self.slide_links]
        slide_arms = self.slide_points * on_slides
        points = origins[:, self.slide_links] + slide_arms
        return Placement(
            origins=origins,
            turns=turns,
            arms=self.hinge_points * turns[:, self.hinge_links],
            ways=self.slide_ways * on_slides,
            slide_arms=slide_arms,
            off=points[:, 0] - points[:, 1],
        )

    def residual(self, at: Placement, phi: Floats) -> Floats:
        """Tell by how much every equation fails, (N, rows); angles rad, lengths in units of `size`."""
        hinges = at.origins[:, self.hinge_links] + at.arms
        apart = hinges[:, 0] - hinges[:, 1]
        slider, owner = at.ways[:, 0], at.ways[:, 1].conj()
        # The angle between the two directions, not its sine: a slider turned end for end is no solution.
        askew = -np.angle(slider * owner)
        lag = np.angle(at.turns[:, self.crank] * self.crank_way * np.exp(-1j * phi))
        return np.concatenate((apart.real, apart.imag, askew, (owner * at.off).imag, lag[:, None]), axis=1)

    def jacobian(self, at: Placement) -> Floats:
        """Differentiate the equations by the poses of the moving links, (N, rows, 3 n)."""
        full = np.repeat(self.pattern[None], len(at.turns), axis=0)
        columns, count = 3 * self.hinge_links + TURN, self.hinge_links.shape[1]
        rows = np.arange(count)
        for side, sign in ((0, 1.0), (1, -1.0)):
            full[:, rows, columns[side]] = -sign * at.arms[:, side].imag
            full[:, rows + count, columns[side]] = sign * at.arms[:, side].real
        if self.slide_links.size:
            self._differentiate_lines(full, at)
        return full[:, :, 3:]

    def convective(self, at: Placement, rates: Floats) -> Floats:
        """Give the part of the equations' second derivative that is quadratic in the rates, (N, rows)."""
        spin, flow = rates[:, :, TURN], rates[:, :, X] + 1j * rates[:, :, Y]
        bent = -(spin[:, self.hinge_links] ** 2) * at.arms
        apart = bent[:, 0] - bent[:, 1]
        spins = spin[:, self.slide_links]
        moving = flow[:, self.slide_links] + 1j * spins * at.slide_arms
        bent = -(spins**2) * at.slide_arms
        turning, still = spins[:, 1], np.zeros_like(spins[:, 1])
        lines = bent[:, 0] - bent[:, 1] - 2j * turning * (moving[:, 0] - moving[:, 1]) - turning**2 * at.off
        bends = (at.ways[:, 1].conj() * lines).imag
        return np.concatenate((apart.real, apart.imag, still, bends, np.zeros((len(rates), 1))), axis=1)

    def _differentiate_lines(self, full: Floats, at: Placement) -> None:
        way = at.ways[:, 1]
        count = self.slide_links.shape[1]
        rows = 2 * self.hinge_links.shape[1] + count + np.arange(count)
        slider, owner = 3 * self.slide_links
        full[:, rows, slider + X], full[:, rows, slider + Y] = -way.imag, way.real
        full[:, rows, owner + X], full[:, rows, owner + Y] = way.imag, -way.real
        full[:, rows, slider + TURN] = (way.conj() * at.slide_arms[:, 0]).real
        full[:, rows, owner + TURN] = -(way.conj() * (at.slide_arms[:, 1] + at.off)).real


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


def _pattern(links: int, hinges: Indices, slides: Indices, crank: int) -> Floats:
    count, lines = hinges.shape[1], slides.shape[1]
    pattern = np.zeros((2 * count + 2 * lines + 1, 3 * links))
    rows, directions = np.arange(count), 2 * count + np.arange(lines)
    for side, sign in ((0, 1.0), (1, -1.0)):
        pattern[rows, 3 * hinges[side] + X] = sign
        pattern[rows + count, 3 * hinges[side] + Y] = sign
        pattern[directions, 3 * slides[side] + TURN] = -sign
    pattern[-1, 3 * crank + TURN] = 1.0
    return pattern
