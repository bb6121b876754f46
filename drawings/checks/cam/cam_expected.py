"""What the analysis alone says that the sheet of a cam must show (чего ждать от листа кулачка)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.page.drafting import Drafting
from plans.analytic.cam.contour import contour
from plans.analytic.cam.laws import travel
from plans.cam.study import CamDrawing
from plans.checks.cam.comparison import Compared
from plans.model.cam import Cam
from plans.model.cam_motion import CamFound, Contour, Sizes, Travel
from plans.model.motion import Complexes, Floats

DIGITS = 5  # of the angle of a phase
EQUAL = 1e-9  # of a turn: what is so near to an edge is on it


@dataclass(frozen=True)
class Expected:
    """One cam by the analysis; of the construction only where its strips end and which of equal extremes it names."""

    found: CamFound
    drawing: CamDrawing

    @property
    def cam(self) -> Cam:
        """The cam as it is asked for."""
        return self.found.cam

    @property
    def sizes(self) -> Sizes:
        """Its main sizes."""
        return self.found.sizes

    @property
    def contour(self) -> Contour:
        """The profile at the numbered positions."""
        return self.found.contour

    @property
    def axis(self) -> complex:
        """The foot of the axis of a follower that translates, m; of a rocker its pivot."""
        return self.sizes.pivot if self.cam.rocks else complex(self.cam.sense * self.sizes.offset)

    def back(self, places: Complexes | complex, turned: Floats | float) -> Complexes:
        """Carry places of the frame against the motion of the cam, m."""
        if self.cam.translates:
            return np.asarray(places + self.cam.sense * np.asarray(turned))
        return np.asarray(places * np.exp(-1j * self.cam.sense * np.asarray(turned)))

    def ways(self, directions: Complexes | complex, turned: Floats | float) -> Complexes:
        """Turn directions of the frame so."""
        own = self.back(directions, turned) if not self.cam.translates else directions + 0 * np.asarray(turned)
        return np.asarray(own)

    @cached_property
    def normals(self) -> Complexes:
        """The unit normals out of the cam at the numbered positions, in the cam, (N,)."""
        lever = self.contour.lever
        return self.ways(lever / np.abs(lever), self.contour.turned)

    def at(self, turned: float) -> complex:
        """Give the point of the pitch curve at a turn of the cam, m."""
        return complex(contour(self.cam, self.sizes, self.found.roller, np.array([turned])).pitch[0])

    @cached_property
    def compared(self) -> Compared:
        """Both roads of the cam."""
        return Compared(self.drawing, self.found)

    @cached_property
    def edges(self) -> Floats:
        """The edges of the strips of the law's diagrams, rad."""
        return self.drawing.diagrams.strips.edges

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What the edges are called: numbered positions by their numbers, others by the one before with primes."""
        numbered, last = self.contour.turned.tolist(), self.cam.turn
        names: list[str] = []
        for edge in self.edges.tolist():
            k = int(np.abs(self.contour.turned - edge).argmin())
            if math.isclose(edge, last, rel_tol=EQUAL) and not self.cam.translates:
                names.append("0")
            elif math.isclose(edge, numbered[k], rel_tol=EQUAL, abs_tol=EQUAL * last):
                names.append(str(k))
            else:
                before = sum(one < edge for one in numbered) - 1
                names.append(f"{before}" + "'" * (1 + sum(one.startswith(f"{before}'") for one in names)))
        return tuple(names)

    @cached_property
    def after(self) -> Travel:
        """S, S', S'' at the edges, after what jumps there."""
        return travel(self.cam, self.edges)

    @cached_property
    def before(self) -> Travel:
        """S, S', S'' at the edges, before what jumps there."""
        return travel(self.cam, self.edges, before=True)


def phase_name(cam: Cam, number: int, drafting: Drafting) -> str:
    """Letter a phase with its angle in degrees or its travel in mm: a dwell at the lowest level is a rest."""
    lowest = min(level for one in cam.phases for level in (one.level, one.level + one.change))
    kinds = ["rest" if one.change == 0 and one.level == lowest else one.kind for one in cam.phases]
    own, phase = kinds[number], cam.phases[number]
    index = own if kinds.count(own) == 1 else f"{own}\N{NO-BREAK SPACE}{kinds[: number + 1].count(own)}"
    size = phase.end - phase.start
    if cam.translates:
        return drafting.letter(f"x_{{{index}}} = {drafting.number(1000 * size, DIGITS)}")
    return drafting.letter(f"φ_{{{index}}} = {drafting.number(math.degrees(size), DIGITS)}°")
