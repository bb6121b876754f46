"""The record of the sheets of cams: the law, sizes, pressure angles, the profile by points (графики кулачка)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.cam.due_notes import PLAN as RADII
from drawings.cam.due_values import ACCELERATION, TRAVEL, VELOCITY, CamValues, law_named
from drawings.cam.pressure_graph import NAME as ANGLES
from drawings.cam.profile_view import NAME as PROFILE
from drawings.cam.size_view import NAME as SIZES
from drawings.grading import verdict
from drawings.grading.curves.cam_courses import DIAGRAM, POINTS, PRESSURE, CamCourses
from drawings.grading.curves.diagram_figures import figures_of_cyclogram
from drawings.grading.curves.figure_judge import SHORT
from drawings.grading.curves.figure_records import (
    LENGTHS,
    ORDINATES,
    PRICKED,
    STEP,
    FigureAsked,
    Mistake,
    SceneSheet,
    by_number,
)
from plans.cam.study import CamStudy
from plans.cyclogram.rows import EVERY
from plans.model.motion import Floats
from plans.study import Study
from plans.words.words import because

ABOVE = {VELOCITY: ACCELERATION, TRAVEL: VELOCITY}


def figures_of_cam(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the figures of a sheet of a cam (row of the table of records)."""
    cams = {cam.cam.name: cam for cam in study.comparison("cam").analysis.cams}
    name = sheet.leaf.metadata.get("cam")
    if name == EVERY:
        yield from figures_of_cyclogram(study, sheet)
    if name is not None and name in cams:
        drawn = _CamSheet(sheet, CamCourses(CamValues(cams[name], study.of(CamStudy).drawings[name])))
        yield from drawn.laws()
        yield from drawn.sizes()
        yield from drawn.pressure()
        yield from drawn.profile()
        yield from drawn.radii()


@dataclass(frozen=True)
class _CamSheet:
    """A sheet of one cam with what the analysis says of it."""

    sheet: SceneSheet
    cam: CamCourses

    @property
    def expected(self) -> CamValues:
        return self.cam.expected

    @property
    def _exact(self) -> Mapping[str, Floats]:
        law = self.expected.after
        return {ACCELERATION: law.bend, VELOCITY: law.slope, TRAVEL: law.s}

    @property
    def _drawn(self) -> bool:
        """Whether the sizes are found by a diagram: the face of a rocker has none."""
        return not (self.expected.cam.flat and self.expected.cam.rocks)

    def laws(self) -> Iterator[FigureAsked]:
        """Give the diagrams of the law, each integrated from the one before."""
        courses, other = {VELOCITY: self.cam.velocity, TRAVEL: self.cam.travel}, self.cam.swapped
        for key, row in self.cam.rows.items():
            plan = law_named(self.expected.cam, key)
            marks = self.sheet.vectors(plan)
            if marks:
                chorded, law = key in ABOVE, None if other is None else np.asarray(1j * self.cam.law(other, key))
                swapped = () if law is None else (Mistake(verdict.PHASES, law),)
                yield from self.sheet.figure(
                    key, plan, by_number(marks), np.asarray(1j * row.after), kind=ORDINATES, stepped=chorded,
                    slack=np.abs(row.after - self._exact[key]), linear=chorded,
                    paper=self.sheet.paper(plan, self.expected.edges), behind=(ABOVE[key],) if chorded else (),
                    course=courses.get(key), why=because("integral_chord") if chorded else None,
                    mistakes=swapped,
                )  # fmt: skip

    @cached_property
    def _ends(self) -> dict[tuple[str, int | None], int]:
        count = len(self.cam.turned)
        places: list[tuple[str, int | None]] = [
            *(("D", k) for k in range(count)),
            ("O", None),
            ("R_0", None),
            ("L", None),
        ]
        return {place: k for k, place in enumerate(places)}

    def sizes(self) -> Iterator[FigureAsked]:
        """Give the diagram of the main sizes."""
        behind = (VELOCITY, TRAVEL) if not self.expected.cam.flat else (ACCELERATION, TRAVEL)
        has_travel = bool(self.sheet.vectors(law_named(self.expected.cam, TRAVEL)))
        yield from self.sheet.figure(
            DIAGRAM, SIZES, self._ends, self.cam.ends, behind=behind if has_travel else (),
            course=self.cam.sizes_points if has_travel else None, error=self._laid_by_hand(SIZES, VELOCITY, TRAVEL),
            slack=self._sized(), why=because("cam_laid"), mistakes=tuple(self._wrong_sizes()),
            curved=tuple(range(len(self.cam.turned))),
        )  # fmt: skip

    def _laid_by_hand(self, plan: str, *laws: str) -> Floats:
        """Give how far points are out that are laid off as they are measured on diagrams of the law, mm.

        To the profile the sizes are carried over too.
        """
        mu, carried = self._scale(plan), self.sheet.marks(SIZES)
        length = (self.expected.cam.follower.length or 1.0) if self.expected.cam.rocks else 1.0
        slips = [1.0, *(length * slip / mu for key in laws for slip in self._read_by_hand(key))]
        slips += [np.sqrt(2) * self._scale(SIZES) / mu] if plan != SIZES and carried else []
        return np.full(len(self.cam.ends), PRICKED * float(np.sqrt(np.square(slips).sum())))

    def _scale(self, plan: str) -> float:
        return next((mark.scale for mark in self.sheet.marks(plan).values()), 1.0)

    def _read_by_hand(self, key: str) -> Iterator[float]:
        """Give how far a value is out that is read off a diagram of the law, true units a mm of slip in pricking.

        Where not all its places are marked, it may be read off a chord between two that are.
        """
        marks, values = self.sheet.vectors(law_named(self.expected.cam, key)), self.cam.rows[key].after
        if marks:
            mu = next(iter(marks.values())).scale
            bare = set(np.flatnonzero(np.abs(values) > SHORT * mu).tolist()) - marks.keys()
            yield mu * float(np.hypot(1.0, STEP if bare else 0.0))

    def _sized(self) -> Floats:
        """Give by how much D is out that is laid off by the chords of the law."""
        off = (self.cam.rows[key].after - self._exact[key] for key in (VELOCITY, TRAVEL))
        size = np.hypot(*(row[self.cam.numbered] for row in off))
        length = self.expected.cam.follower.length if self.expected.cam.rocks else 1.0
        return np.concatenate((size * (length or 1.0), np.zeros(3)))

    def _wrong_sizes(self) -> Iterator[Mistake]:
        """Give the diagram with rulers at each other's limits, and with the offset to the other side."""
        for kind, main in ((verdict.EXCHANGED, self.cam.limits_swapped), (verdict.SIDE, self.cam.other_side)):
            if main is not None:
                values, count = self.cam.ends.copy(), len(self.cam.turned)
                zero = complex(self.expected.cam.sense * main.offset, np.sqrt(main.base**2 - main.offset**2))
                values[count], values[count + 1] = -zero, self.cam.base(zero, main.base)
                yield Mistake(kind, values)

    def pressure(self) -> Iterator[FigureAsked]:
        """Give the graph of the pressure angle."""
        count, found = len(self.cam.turned), self.expected.found.pressure
        names: dict[tuple[str, int | None], int] = {(str(k), k): k for k in range(count)}
        names |= {(kind, None): count + k for k, kind in enumerate(found)}
        paper = self.sheet.paper(ANGLES, self.cam.turned) if len(self.sheet.vectors(ANGLES)) > 1 else None
        if paper is not None:
            stations = np.concatenate((self.cam.turned, [extreme.turned for extreme in found.values()]))
            paper = self.sheet.paper(ANGLES, stations)
        sized = bool(self.sheet.marks(SIZES)) and self._drawn
        yield from self.sheet.figure(
            PRESSURE, ANGLES, names, np.asarray(1j * self.cam.angles), kind=ORDINATES, paper=paper,
            behind=(DIAGRAM,) if sized else (), course=self.cam.pressure if sized else None,
        )  # fmt: skip

    def profile(self) -> Iterator[FigureAsked]:
        """Give the profile by inversion: its points, sizes, the follower's places, the roller's normals."""
        count = len(self.cam.turned)
        known, sized = self.expected.points(), bool(self.sheet.marks(SIZES)) and self._drawn
        curve = "P" if "P" in known else "Q"
        yield from self.sheet.figure(
            POINTS, PROFILE, {(curve, k): k for k in range(count)}, known[curve],
            behind=(DIAGRAM, TRAVEL) if sized else (), course=self.cam.profile if sized else None,
            error=self._laid_by_hand(PROFILE, TRAVEL)[:count], mistakes=tuple(self._inverted()),
            why=because("cam_back"), curved=tuple(range(count)),
        )  # fmt: skip
        turned = Mistake(verdict.BACKWARDS, self.cam.turned_with(known["O_1"]))
        pivots, lengths = {("O_1", k): k for k in range(count)}, {("R_0", None): 0, ("ρ_min", None): 1}
        yield from self.sheet.figure("profile O_1", PROFILE, pivots, known["O_1"], mistakes=(turned,))
        yield from self.sheet.figure("profile lengths", PROFILE, lengths, kind=LENGTHS)
        told = (curve, "O_1", "R_0", "ρ_min")
        rest = [place for place in self.sheet.marks(PROFILE) if place[0] not in told]
        others = {place: k for k, place in enumerate(rest)}
        yield from self.sheet.figure("profile marks", PROFILE, others, error=2 * PRICKED)

    def radii(self) -> Iterator[FigureAsked]:
        """Give the radii of the finished profile, of a cam that translates its ordinates."""
        yield from self.sheet.figure(RADII, RADII, curved=tuple(range(len(self.sheet.marks(RADII)))))

    def _inverted(self) -> Iterator[Mistake]:
        """Give the profile inverted the wrong way, mirrored, of another side, other phases or another least radius."""
        true = self.expected.contour.pitch
        yield Mistake(verdict.BACKWARDS, self.cam.turned_with(true))
        yield Mistake(verdict.MIRRORED, -true.conj())
        side, other = self.cam.other_side, self.cam.swapped
        if side is not None:
            yield Mistake(verdict.SIDE, self.cam.inverted(side).pitch)
        if other is not None:
            yield Mistake(verdict.PHASES, self.cam.inverted(self.expected.sizes, other).pitch)
        if not self.expected.cam.rocks:
            ways = self.expected.ways(1j, self.cam.turned)
            yield Mistake(verdict.BASE, true, np.broadcast_to(ways, true.shape))
