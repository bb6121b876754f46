"""Coordinates of outputs by analysis: along a guide, the turn of a link, away from another point (координата)."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

import numpy as np

from plans.analytic.constraints import TURN, Constraints, X, Y
from plans.analytic.ends import Station
from plans.model.mechanism import FRAME, Mechanism, Output, Slide
from plans.model.motion import Complexes, Floats


class OutputCoordinate(NamedTuple):
    """The output coordinate: along the frame's guide in units of `size`, or the turn of the link."""

    place: int  # of the link in the poses
    guide: Slide | None
    own: complex  # the point shown, in the link's own frame, in units of `size`
    size: float

    @property
    def sliding(self) -> bool:
        """Whether it is a length."""
        return self.guide is not None

    def along(self, taylor: Floats) -> Floats:
        """Give the coordinate and its two derivatives by the crank angle at N stations, (3, N)."""
        if self.guide is None:
            return np.asarray(taylor[:, :, self.place, TURN])
        way = self.guide.way(FRAME)
        places = _Spot(self.place, self.own).along(taylor)
        places[0] -= way.through / self.size
        return np.asarray((places * way.direction.conjugate()).real)

    def at(self, place: Station) -> Floats:
        """Give the coordinate and its two derivatives at one station, (3,)."""
        return self.along(np.array((place.poses, place.first, place.second))[:, None])[:, 0]


class _Spot(NamedTuple):
    """A point of a link: the place of the link in the poses, and its own in the link's frame in units of `size`."""

    place: int
    own: complex

    def along(self, taylor: Floats) -> Complexes:
        """Give its place and two derivatives by the crank angle at N stations, (3, N), in units of `size`."""
        poses, first, second = taylor[:, :, self.place]
        arm, spin = self.own * np.exp(1j * poses[:, TURN]), 1j * first[:, TURN]
        return np.array(
            (
                poses[:, X] + 1j * poses[:, Y] + arm,
                first[:, X] + 1j * first[:, Y] + arm * spin,
                second[:, X] + 1j * second[:, Y] + arm * (spin**2 + 1j * second[:, TURN]),
            )
        )


class PartedCoordinate(NamedTuple):
    """The way of a point from another along the line of two points, which both lie on, in units of `size`."""

    spots: tuple[_Spot, _Spot, _Spot, _Spot]  # own, other, the line's start and end
    size: float

    @property
    def sliding(self) -> bool:
        """Whether it is a length: always."""
        return True

    def along(self, taylor: Floats) -> Floats:
        """Give the way and its two derivatives by the crank angle at N stations, (3, N).

        Its line turns by w: s = d along it, s' = d' along it, and s'' = d'' along it and w times d' across it.
        """
        own, other, start, end = (spot.along(taylor) for spot in self.spots)
        line, away = end - start, own - other
        unit = (line[0] / np.abs(line[0])).conj()
        turning = (unit * line[1]).imag / np.abs(line[0])
        apart = unit * away
        return np.array((apart[0].real, apart[1].real, apart[2].real + turning * apart[1].imag))

    def at(self, place: Station) -> Floats:
        """Give the way and its two derivatives at one station, (3,)."""
        return self.along(np.array((place.poses, place.first, place.second))[:, None])[:, 0]


Coordinate: TypeAlias = OutputCoordinate | PartedCoordinate


def coordinate_of(mechanism: Mechanism, constraints: Constraints, output: Output) -> Coordinate:
    """Give the coordinate of an output."""
    if output.parting is not None:
        spots = (
            _spot(mechanism, constraints, name)
            for name in (output.point or "", output.parting.other, *output.parting.line)
        )
        own, other, start, end = spots
        return PartedCoordinate((own, other, start, end), constraints.size)
    guides = [s for s in mechanism.slides if {s.slider, s.owner} == {FRAME, output.link}]
    guide = guides[0] if guides else None
    points = mechanism.links[output.link].points
    named = (output.point or "", guide.point if guide else "", next(iter(points)))
    point = next(name for name in named if name in points)
    place = constraints.numbers.index(output.link)
    return OutputCoordinate(place, guide, points[point] / constraints.size, constraints.size)


def _spot(mechanism: Mechanism, constraints: Constraints, name: str) -> _Spot:
    """Find a point on the first link that has it."""
    link = next(number for number in constraints.numbers if name in mechanism.links[number].points)
    return _Spot(constraints.numbers.index(link), mechanism.links[link].points[name] / constraints.size)
