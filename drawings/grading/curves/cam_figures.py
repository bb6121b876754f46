"""The record of the sheets of cams: the law, sizes, pressure angles, the profile by points (графики кулачка)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np

from drawings.cam.due_notes import PLAN as RADII
from drawings.cam.due_values import ACCELERATION, TRAVEL, VELOCITY, CamValues, law_named
from drawings.cam.pressure_graph import NAME as ANGLES
from drawings.cam.profile_view import NAME as PROFILE
from drawings.cam.size_view import NAME as SIZES
from drawings.grading import verdict
from drawings.grading.curves.diagram_figures import figures_of_cyclogram
from drawings.grading.curves.dynamics_figures import moved_means
from drawings.grading.curves.figure_judge import SHORT
from drawings.grading.curves.figure_records import (
    LENGTHS,
    ORDINATES,
    PRICKED,
    STEP,
    FigureAsked,
    Mistake,
    Place,
    SceneSheet,
    by_number,
)
from plans.analytic.cam.contour import contour
from plans.analytic.cam.laws import travel
from plans.analytic.cam.sizes import LimitLine, least, sides_of, sizes
from plans.cam.study import CamStudy
from plans.cyclogram.rows import EVERY
from plans.model.cam import RETURN, RISE, Cam
from plans.model.cam_motion import CamSizes, Contour
from plans.model.motion import Complexes, Floats
from plans.study import Study
from plans.words.words import because

DIAGRAM, PRESSURE, POINTS = "sizes", "pressure", "profile points"
ABOVE = {VELOCITY: ACCELERATION, TRAVEL: VELOCITY}


def figures_of_cam(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the figures of a sheet of a cam (row of the table of records)."""
    cams = {cam.cam.name: cam for cam in study.comparison("cam").analysis.cams}
    name = sheet.leaf.metadata.get("cam")
    if name == EVERY:
        yield from figures_of_cyclogram(study, sheet)
    if name is not None and name in cams:
        drawn = _CamSheet(cams[name], study.of(CamStudy).drawings[name], sheet)
        yield from drawn.law_figures()
        yield from drawn.size_figure()
        yield from drawn.pressure_graph()
        yield from drawn.profile_figures()
        yield from drawn.radii_figure()


@dataclass(frozen=True)
class _CamSheet(CamValues):
    """A sheet of one cam with what the analysis says of it, and how its figures follow from one another."""

    sheet: SceneSheet

    @property
    def turned(self) -> Floats:
        """The turns of the numbered positions, rad."""
        return self.contour.turned

    @cached_property
    def numbered(self) -> np.ndarray[tuple[int, ...], np.dtype[np.intp]]:
        """Which edge of the strips each numbered position is."""
        return np.asarray(np.abs(self.edges[:, None] - self.turned).argmin(axis=0))

    @property
    def drawable(self) -> bool:
        """Whether the sizes are found by a diagram: the face of a rocker has none."""
        return not (self.cam.flat and self.cam.rocks)

    def integral(self, sum_: str, drawn: Mapping[str, Complexes]) -> Complexes:
        """Add up the areas under the analogue of acceleration, or of velocity."""
        name = ABOVE[sum_]
        row, true = self.rows[name], self.means(name)
        moved = moved_means(drawn[name].imag, row.after, row.before, true) - true
        areas = np.concatenate(([0.0], np.cumsum(moved * np.diff(self.edges))))
        return np.asarray(1j * (self.rows[sum_].after + areas))

    @cached_property
    def corners(self) -> Complexes:
        """The places of the diagram: D at the numbered positions, O, the end of R0, the end of L."""
        aside = np.array([-self.zero, self.base(self.zero, self.sizes.base), self.zero])
        return np.concatenate((self.ends(self.contour), aside))

    def base(self, zero: complex, size: float) -> complex:
        """Give R0 as a vector of the diagram whose A or O1 is seen from O so."""
        if not self.cam.flat:
            return zero if not self.cam.rocks else self.lowest + zero - self.zero
        lever = complex(self.contour.lever[0])
        return lever * self.turned_back * size if self.cam.rocks else 1j * size

    def sizes_points(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Lay D off by S and S', of a flat face by S and S''; O is where the rulers to them meet."""
        found, count = self.corners.copy(), len(self.turned)
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
            zero = ruled(self.cam, self.sizes, (velocity, way), (true[0], true[1]))
            found[count], found[count + 1] = -zero, self.base(zero, abs(zero))
        return found

    def sizes_of(self, points: Complexes) -> CamSizes:
        """Give the main sizes from where O stands on a diagram."""
        zero, found = -points[len(self.turned)], self.sizes
        if self.cam.rocks:
            return found._replace(pivot=zero, centre=abs(zero))
        if self.cam.flat:
            return found._replace(base=zero.imag)
        return found._replace(base=abs(zero), offset=self.cam.sense * zero.real)

    def pressed(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Give the pressure angles by the diagram of the sizes, degrees: where OD shows."""
        points, count = drawn[DIAGRAM], len(self.turned)
        lever = points[:count] - points[count]
        true = self.corners[:count] - self.corners[count]
        turn = self.cam.sense * np.degrees(np.angle(lever / true))
        extremes = list(self.found.pressure.values())
        at = [int(np.abs(self.turned - extreme.turned).argmin()) for extreme in extremes]
        return np.asarray(1j * (self.angles + np.concatenate((turn, turn[at]))))

    @cached_property
    def angles(self) -> Floats:
        """The pressure angles at the numbered positions and the largest ones, degrees."""
        found = self.found.pressure.values()
        return np.degrees(np.concatenate((self.contour.pressure, [extreme.value for extreme in found])))

    def profiled(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Give the points of the profile, or of the roller's centre, by the sizes of the diagram and by S."""
        way = drawn[TRAVEL].imag[self.numbered] - self.rows[TRAVEL].after[self.numbered]
        found = self.inverted(self.sizes_of(drawn[DIAGRAM])).pitch
        return np.asarray(found + (0 if self.cam.rocks else self.ways(np.asarray(1j * way), self.turned)))

    def inverted(self, main: CamSizes, cam: Cam | None = None) -> Contour:
        """Give the profile at the numbered positions, of other sizes or another law."""
        return contour(cam or self.cam, main, self.found.roller, self.turned)

    def turned_with(self, points: Complexes) -> Complexes:
        """Give places in the cam if the follower is turned with it, and not against it."""
        turned = 2 * self.cam.sense * self.turned
        return np.asarray(points - turned if self.cam.translates else points * np.exp(1j * turned))

    @property
    def other_side(self) -> CamSizes | None:
        """The sizes with the offset to the other side; None where there is none, or none is to be seen."""
        main = self.sizes
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
        found = travel(cam, self.edges)
        return {ACCELERATION: found.bend, VELOCITY: found.slope, TRAVEL: found.s}[name]

    def law_figures(self) -> Iterator[FigureAsked]:
        """Give the diagrams of the law, each integrated from the one before."""
        other = self.swapped
        for key, row in self.rows.items():
            plan = law_named(self.cam, key)
            marks = self.sheet.vectors(plan)
            if marks:
                chorded, law = key in ABOVE, None if other is None else np.asarray(1j * self.law(other, key))
                swapped = () if law is None else (Mistake(verdict.PHASES, law),)
                yield from self.sheet.figure(
                    key, plan, by_number(marks), np.asarray(1j * row.after), kind=ORDINATES, stepped=chorded,
                    slack=np.abs(row.after - self.law(self.cam, key)), linear=chorded,
                    paper=self.sheet.paper(plan, self.edges), behind=(ABOVE[key],) if chorded else (),
                    course=partial(self.integral, key) if chorded else None,
                    why=because("integral_chord") if chorded else None, mistakes=swapped,
                )  # fmt: skip

    @property
    def _ends(self) -> dict[Place, int]:
        places: list[Place] = [*(("D", k) for k in range(len(self.turned))), ("O", None), ("R_0", None), ("L", None)]
        return {place: k for k, place in enumerate(places)}

    def size_figure(self) -> Iterator[FigureAsked]:
        """Give the diagram of the main sizes."""
        behind = (VELOCITY, TRAVEL) if not self.cam.flat else (ACCELERATION, TRAVEL)
        has_travel = bool(self.sheet.vectors(law_named(self.cam, TRAVEL)))
        yield from self.sheet.figure(
            DIAGRAM, SIZES, self._ends, self.corners, behind=behind if has_travel else (),
            course=self.sizes_points if has_travel else None, error=self._laid_by_hand(SIZES, VELOCITY, TRAVEL),
            slack=self._sized(), why=because("cam_laid"), mistakes=tuple(self._wrong_sizes()),
            curved=tuple(range(len(self.turned))),
        )  # fmt: skip

    def _laid_by_hand(self, plan: str, *laws: str) -> Floats:
        """Give how far points are out that are laid off as they are measured on diagrams of the law, mm.

        To the profile the sizes are carried over too.
        """
        mu, carried = self._scale(plan), self.sheet.marks(SIZES)
        length = (self.cam.follower.length or 1.0) if self.cam.rocks else 1.0
        slips = [1.0, *(length * slip / mu for key in laws for slip in self._read_by_hand(key))]
        slips += [np.sqrt(2) * self._scale(SIZES) / mu] if plan != SIZES and carried else []
        return np.full(len(self.corners), PRICKED * float(np.sqrt(np.square(slips).sum())))

    def _scale(self, plan: str) -> float:
        return next((mark.scale for mark in self.sheet.marks(plan).values()), 1.0)

    def _read_by_hand(self, key: str) -> Iterator[float]:
        """Give how far a value is out that is read off a diagram of the law, true units a mm of slip in pricking.

        Where not all its places are marked, it may be read off a chord between two that are.
        """
        marks, values = self.sheet.vectors(law_named(self.cam, key)), self.rows[key].after
        if marks:
            mu = next(iter(marks.values())).scale
            bare = set(np.flatnonzero(np.abs(values) > SHORT * mu).tolist()) - marks.keys()
            yield mu * float(np.hypot(1.0, STEP if bare else 0.0))

    def _sized(self) -> Floats:
        """Give by how much D is out that is laid off by the chords of the law."""
        off = (self.rows[key].after - self.law(self.cam, key) for key in (VELOCITY, TRAVEL))
        size = np.hypot(*(row[self.numbered] for row in off))
        length = self.cam.follower.length if self.cam.rocks else 1.0
        return np.concatenate((size * (length or 1.0), np.zeros(3)))

    def _wrong_sizes(self) -> Iterator[Mistake]:
        """Give the diagram with rulers at each other's limits, and with the offset to the other side."""
        for kind, main in ((verdict.EXCHANGED, self.limits_swapped), (verdict.SIDE, self.other_side)):
            if main is not None:
                values, count = self.corners.copy(), len(self.turned)
                zero = complex(self.cam.sense * main.offset, np.sqrt(main.base**2 - main.offset**2))
                values[count], values[count + 1] = -zero, self.base(zero, main.base)
                yield Mistake(kind, values)

    def pressure_graph(self) -> Iterator[FigureAsked]:
        """Give the graph of the pressure angle."""
        count, found = len(self.turned), self.found.pressure
        names: dict[Place, int] = {(str(k), k): k for k in range(count)}
        names |= {(kind, None): count + k for k, kind in enumerate(found)}
        paper = self.sheet.paper(ANGLES, np.append(self.turned, [extreme.turned for extreme in found.values()]))
        sized = bool(self.sheet.marks(SIZES)) and self.drawable
        yield from self.sheet.figure(
            PRESSURE, ANGLES, names, np.asarray(1j * self.angles), kind=ORDINATES, paper=paper,
            behind=(DIAGRAM,) if sized else (), course=self.pressed if sized else None,
        )  # fmt: skip

    def profile_figures(self) -> Iterator[FigureAsked]:
        """Give the profile by inversion: its points, sizes, the follower's places, the roller's normals."""
        count = len(self.turned)
        known, sized = self.points(), bool(self.sheet.marks(SIZES)) and self.drawable
        curve = "P" if "P" in known else "Q"
        yield from self.sheet.figure(
            POINTS, PROFILE, {(curve, k): k for k in range(count)}, known[curve],
            behind=(DIAGRAM, TRAVEL) if sized else (), course=self.profiled if sized else None,
            error=self._laid_by_hand(PROFILE, TRAVEL)[:count], mistakes=tuple(self._inverted()),
            why=because("cam_back"), curved=tuple(range(count)),
        )  # fmt: skip
        turned = Mistake(verdict.BACKWARDS, self.turned_with(known["O_1"]))
        pivots, lengths = {("O_1", k): k for k in range(count)}, {("R_0", None): 0, ("ρ_min", None): 1}
        yield from self.sheet.figure("profile O_1", PROFILE, pivots, known["O_1"], mistakes=(turned,))
        yield from self.sheet.figure("profile lengths", PROFILE, lengths, kind=LENGTHS)
        told = (curve, "O_1", "R_0", "ρ_min")
        rest = [place for place in self.sheet.marks(PROFILE) if place[0] not in told]
        others = {place: k for k, place in enumerate(rest)}
        yield from self.sheet.figure("profile marks", PROFILE, others, error=2 * PRICKED)

    def radii_figure(self) -> Iterator[FigureAsked]:
        """Give the radii of the finished profile, of a cam that translates its ordinates."""
        yield from self.sheet.figure(RADII, RADII, curved=tuple(range(len(self.sheet.marks(RADII)))))

    def _inverted(self) -> Iterator[Mistake]:
        """Give the profile inverted the wrong way, mirrored, of another side, other phases or another least radius."""
        true = self.contour.pitch
        yield Mistake(verdict.BACKWARDS, self.turned_with(true))
        yield Mistake(verdict.MIRRORED, -true.conj())
        side, other = self.other_side, self.swapped
        if side is not None:
            yield Mistake(verdict.SIDE, self.inverted(side).pitch)
        if other is not None:
            yield Mistake(verdict.PHASES, self.inverted(self.sizes, other).pitch)
        if not self.cam.rocks:
            ways = self.ways(1j, self.turned)
            yield Mistake(verdict.BASE, true, np.broadcast_to(ways, true.shape))


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
