"""Series of a cam: graphical laws by strips, the profile by three ways, its pieces (испытание кулачков).

shapely offsets the pitch curve that it is given by points; only this file imports it, and it may be missing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial
from importlib.util import find_spec
from typing import Any, Final

import numpy as np

from geometry.replay import exact
from plans.analytic.cam.contour import ContourValues, mirrored
from plans.bench.trial import Demand, Errors, Timing
from plans.cam.course import FollowerCourse
from plans.cam.diagrams import MIDDLE, THREE, TRUE, LawDiagrams, law_diagrams
from plans.cam.path import path
from plans.cam.profile.profile import profile
from plans.cam.study import CamDrawing, CamStudy
from plans.model.cam_motion import CamSizes, Points
from plans.model.motion import Floats
from plans.study import Study

STRIPS: Final = (8, 16, 64, 256, 1024)  # of a phase that moves the follower
TURNS: Final = (72, 360, 3600)  # of the cam
CUBICS: Final = (36, 72, 144, 288)  # to the turn
LOOKED_AT: Final = 24  # turns at which the exact envelope is judged in 50 digits
LAWS: Final = {MIDDLE: "laws: mid ordinates", THREE: "laws: three ordinates", TRUE: "laws: true mean ordinates"}
INVERSION, OFFSET, ENVELOPE = "profile: N inversions", "profile: shapely offset", "profile: exact envelope"
PIECES, POINT = "profile: arcs and cubics", "Q"
DEFINED = (
    "of the first cam. Laws: the largest differences of S' and S from the exact ones at the strips' edges, in shares "
    "of the largest of each; positions are the strips of one phase. Profile: of N inversions and of shapely's offset "
    "of as many points of the pitch curve, how far the exact profile is at most from their chords half way between; "
    "of the exact envelope, how far it is from the record in 50 digits; in shares of the largest radius. Arcs and "
    "cubics: how far at most from the exact profile, in shares of the base radius or of the lift, by their number"
)


def cams(study: Study, order: Demand) -> Iterator[Timing]:
    """List the ways to the law and the profile of the first cam of a scene."""
    drawing: CamDrawing = next(iter(study.of(CamStudy).drawings.values()))
    cam, sizes, roller = drawing.cam, drawing.sizing.sizes, drawing.found.roller
    for means, name in LAWS.items():
        for count in STRIPS if order.startup else STRIPS[:3]:
            yield Timing(partial(law_diagrams, replace(cam, divisions=count), means), count, {name: _departures})
    for count in TURNS if order.startup else TURNS[:2]:
        yield from Judged(drawing.course, sizes, roller, count).roads()
    size = sizes.base or cam.lift
    judged = {PIECES: lambda found: Errors.alone(found.deviation / size)}
    for count in CUBICS:
        yield Timing(partial(path, cam, sizes, -roller, count, exact=False), count, judged)


def _departures(found: LawDiagrams) -> Errors | None:
    return Errors.of({"S'": found.slope_departure.share, "S": found.travel_departure.share})


@dataclass(frozen=True)
class Judged:
    """One cam and a number of turns, and what each way makes of them."""

    course: FollowerCourse
    sizes: CamSizes
    roller: float  # m
    count: int

    @cached_property
    def turned(self) -> Floats:
        """The turns, the last of them the first one again."""
        return np.linspace(0.0, self.course.cam.turn, self.count + 1)

    @cached_property
    def between(self) -> Points:
        """The exact profile half way between the turns, m."""
        return self.envelope((self.turned[1:] + self.turned[:-1]) / 2)

    @cached_property
    def pitch(self) -> Any:
        """The pitch curve by points, as shapely takes it."""
        import shapely  # noqa: PLC0415  (only the bench pays for it)

        return shapely.LineString(_pairs(self.envelope(self.turned, 0.0)))

    def envelope(self, turned: Floats, roller: float | None = None) -> Points:
        """Give the exact profile by closed forms."""
        cam = self.course.cam
        return mirrored(cam, ContourValues(cam, self.sizes, turned).edge(-(self.roller if roller is None else roller)))

    def roads(self) -> list[Timing]:
        """List the ways; each begins anew with every run, shapely's with the points it is given."""
        ways: dict[str, tuple[Callable[[], Any], Callable[[Any], float]]] = {
            INVERSION: (
                lambda: profile(self.course, self.sizes, self.roller, self.turned).contour.profile,
                self._chords,
            )
        }
        if find_spec("mpmath"):  # which judges it
            ways[ENVELOPE] = lambda: self.envelope(self.turned), self._digits
        if find_spec("shapely") and self.pitch and self.roller:
            away = -self.course.cam.sense * self.roller  # to the side of the cam
            ways[OFFSET] = (lambda: self.pitch.offset_curve(away), self._offset)
        return [Timing(run, self.count, {name: partial(self._errors, judge)}) for name, (run, judge) in ways.items()]

    def _errors(self, judge: Callable[[Any], float], found: Any) -> Errors:
        return Errors.alone(judge(found) / float(np.abs(self.between).max()))

    def _chords(self, points: Points) -> float:
        start, way = points[:-1], np.diff(points)
        along = np.clip(((self.between - start) / way).real, 0.0, 1.0)
        return float(np.abs(self.between - start - along * way).max())

    def _offset(self, found: Any) -> float:
        import shapely  # noqa: PLC0415  (only the bench pays for it)

        return float(shapely.distance(found, shapely.points(_pairs(self.between))).max())

    def _digits(self, _: Points) -> float:
        turned = self.turned[:: max(self.count // LOOKED_AT, 1)]
        drawing = profile(self.course, self.sizes, self.roller, turned).drawing
        mark = drawing.board[POINT] if self.roller else drawing.point
        found = self.envelope(turned)
        return max(float(abs(exact([mark], k)[mark] - complex(place))) for k, place in enumerate(found.tolist()))


def _pairs(points: Points) -> Floats:
    return np.column_stack([points.real, points.imag])
