"""How the figures of a cam go on from each other: S'' to S' to S, sizes, pressure angles, the profile (кулачок)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from drawings.cam.due_values import ACCELERATION, TRAVEL, VELOCITY, CamValues, LawCourse
from drawings.grading.curves.dynamics_figures import moved_means
from plans.analytic.cam.contour import contour
from plans.analytic.cam.laws import travel
from plans.analytic.cam.sizes import LimitLine, least, sides_of, sizes
from plans.model.cam import RETURN, RISE, Cam
from plans.model.cam_motion import CamSizes, Contour
from plans.model.motion import Complexes, Floats


def ruled(cam: Cam, sizes: CamSizes, drawn: tuple[Floats, Floats], true: tuple[Floats, Floats]) -> complex:
    """Give A as it is seen from O, where S' and S at some places are drawn otherwise than they are.

    Floats that are given stay where they are, and so do all where rulers leave no room for O.
    """
    offset, level = sizes.offset, math.sqrt(max(sizes.base**2 - sizes.offset**2, 0.0))
    if cam.given.base is None and cam.given.offset is None and not cam.translates:
        sides = tuple(side._replace(most=side.most + _moved(side, drawn, true)) for side in sides_of(cam))
        if all(side.most > 0 for side in sides):
            offset, level = least(sides)
    return complex(cam.sense * offset, level)


def _moved(side: LimitLine, drawn: tuple[Floats, Floats], true: tuple[Floats, Floats]) -> float:
    """Give by how much a ruler has moved along the axis of S', m: at the point that it touches then and now."""
    touches = [float((side.sign * velocity - side.tangent * way).max()) for velocity, way in (drawn, true)]
    return touches[0] - touches[1]


DIAGRAM, PRESSURE, POINTS = "sizes", "pressure", "profile points"


@dataclass(frozen=True)
class CamCourses:
    """One cam by analysis, and how its figures follow from one another."""

    expected: CamValues

    @property
    def rows(self) -> Mapping[str, LawCourse]:
        """The diagrams of the law by their names."""
        return self.expected.rows

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.expected.cam

    @property
    def turned(self) -> Floats:
        """The turns of the numbered positions, rad."""
        return self.expected.contour.turned

    @cached_property
    def numbered(self) -> np.ndarray[tuple[int, ...], np.dtype[np.intp]]:
        """Which edge of the strips each numbered position is."""
        return np.asarray(np.abs(self.expected.edges[:, None] - self.turned).argmin(axis=0))

    def velocity(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Add up the areas under the analogue of acceleration."""
        return self._added(drawn, ACCELERATION, VELOCITY)

    def travel(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Add up the areas under the analogue of velocity."""
        return self._added(drawn, VELOCITY, TRAVEL)

    def _added(self, drawn: Mapping[str, Complexes], name: str, sum_: str) -> Complexes:
        row, true = self.rows[name], self.expected.means(name)
        moved = moved_means(drawn[name].imag, row.after, row.before, true) - true
        areas = np.concatenate(([0.0], np.cumsum(moved * np.diff(self.expected.edges))))
        return np.asarray(1j * (self.rows[sum_].after + areas))

    @cached_property
    def ends(self) -> Complexes:
        """The places of the diagram: D at the numbered positions, O, the end of R0, the end of L."""
        known = self.expected
        aside = np.array([-known.zero, self.base(known.zero, self.expected.sizes.base), known.zero])
        return np.concatenate((known.ends(self.expected.contour), aside))

    def base(self, zero: complex, size: float) -> complex:
        """Give R0 as a vector of the diagram whose A or O1 is seen from O so."""
        if not self.cam.flat:
            return zero if not self.cam.rocks else self.expected.lowest + zero - self.expected.zero
        lever = complex(self.expected.contour.lever[0])
        return lever * self.expected.turned_back * size if self.cam.rocks else 1j * size

    def sizes_points(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Lay D off by S and S', of a flat face by S and S''; O is where the rulers to them meet."""
        found, count = self.ends.copy(), len(self.turned)
        velocity, way = (drawn[name].imag[self.numbered] for name in (VELOCITY, TRAVEL))
        true = [self.rows[name].after[self.numbered] for name in (VELOCITY, TRAVEL)]
        if self.cam.rocks and not self.cam.flat:
            turn = np.exp(1j * self.cam.rising * (way - true[1]))
            sense = self.cam.follower.sense
            found[:count] *= turn * (1 - sense * velocity) / (1 - sense * true[0])
        elif self.cam.flat:
            found[:count] = drawn[ACCELERATION].imag[self.numbered] + 1j * way
        else:
            found[:count] += -self.cam.sense * (velocity - true[0]) + 1j * (way - true[1])
            zero = ruled(self.cam, self.expected.sizes, (velocity, way), (true[0], true[1]))
            found[count], found[count + 1] = -zero, self.base(zero, abs(zero))
        return found

    def sizes_of(self, points: Complexes) -> CamSizes:
        """Give the main sizes from where O stands on a diagram."""
        zero, found = -points[len(self.turned)], self.expected.sizes
        if self.cam.rocks:
            return found._replace(pivot=zero, centre=abs(zero))
        if self.cam.flat:
            return found._replace(base=zero.imag)
        return found._replace(base=abs(zero), offset=self.cam.sense * zero.real)

    def pressure(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Give the pressure angles by the diagram of the sizes, degrees: where OD shows."""
        points, count = drawn[DIAGRAM], len(self.turned)
        lever = points[:count] - points[count]
        true = self.ends[:count] - self.ends[count]
        turn = self.cam.sense * np.degrees(np.angle(lever / true))
        extremes = list(self.expected.found.pressure.values())
        at = [int(np.abs(self.turned - extreme.turned).argmin()) for extreme in extremes]
        return np.asarray(1j * (self.angles + np.concatenate((turn, turn[at]))))

    @cached_property
    def angles(self) -> Floats:
        """The pressure angles at the numbered positions and the largest ones, degrees."""
        found = self.expected.found.pressure.values()
        return np.degrees(np.concatenate((self.expected.contour.pressure, [extreme.value for extreme in found])))

    def profile(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Give the points of the profile, or of the roller's centre, by the sizes of the diagram and by S."""
        way = drawn[TRAVEL].imag[self.numbered] - self.rows[TRAVEL].after[self.numbered]
        found = self.inverted(self.sizes_of(drawn[DIAGRAM])).pitch
        return np.asarray(found + (0 if self.cam.rocks else self.expected.ways(np.asarray(1j * way), self.turned)))

    def inverted(self, main: CamSizes, cam: Cam | None = None) -> Contour:
        """Give the profile at the numbered positions, of other sizes or another law."""
        return contour(cam or self.cam, main, self.expected.found.roller, self.turned)

    def turned_with(self, points: Complexes) -> Complexes:
        """Give places in the cam if the follower is turned with it, and not against it."""
        sense = self.cam.sense
        if self.cam.translates:
            return np.asarray(points - 2 * sense * self.turned)
        return np.asarray(points * np.exp(2j * sense * self.turned))

    @property
    def other_side(self) -> CamSizes | None:
        """The sizes with the offset to the other side; None where there is none, or none is to be seen."""
        main = self.expected.sizes
        return None if self.cam.rocks or self.cam.flat or not main.offset else main._replace(offset=-main.offset)

    @property
    def swapped(self) -> Cam | None:
        """The cam with rise and return in each other's place; None where it has not one of each."""
        kinds = [phase.kind for phase in self.cam.phases]
        if kinds.count(RISE) != 1 or kinds.count(RETURN) != 1 or self.cam.translates:
            return None
        rise, back = (self.cam.phases[kinds.index(kind)] for kind in (RISE, RETURN))
        other = {RISE: (back.angle, back.law), RETURN: (rise.angle, rise.law)}
        phases, start = [], 0.0
        for phase in self.cam.phases:
            angle, law = other.get(phase.kind, (phase.angle, phase.law))
            phases.append(phase._replace(angle=angle, law=law, start=start, stop=start + angle))
            start += angle
        return replace(self.cam, phases=tuple(phases), angles=())

    @property
    def limits_swapped(self) -> CamSizes | None:
        """The sizes with the limits of rise and return in each other's place; None where that says nothing."""
        limits = self.cam.limits
        if self.cam.rocks or self.cam.flat or limits.rise is None or limits.back is None or limits.rise == limits.back:
            return None
        return sizes(replace(self.cam, limits=limits._replace(rise=limits.back, back=limits.rise)))

    def law(self, cam: Cam, name: str) -> Floats:
        """Give a diagram of the law of another cam at the edges of the strips."""
        found = travel(cam, self.expected.edges)
        return {ACCELERATION: found.bend, VELOCITY: found.slope, TRAVEL: found.s}[name]
