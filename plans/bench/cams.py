"""A cam timed and judged: graphical laws by strips, the profile by three ways, its pieces (испытание кулачков).

shapely offsets the pitch curve that it is given by points; only this file imports it, and it may be missing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from importlib.util import find_spec
from typing import Any, Final

import numpy as np

from geometry.replay import exact
from plans.analytic.cam.contour import Curve, mirrored
from plans.bench.error import Errors
from plans.bench.trial import NOT_INSTALLED, Found, Goal, Order, Ratio, Road, Row, orders, timed
from plans.cam.course import Course
from plans.cam.diagrams import MIDDLE, THREE, TRUE, LawDiagrams, law_diagrams
from plans.cam.path import ProfilePath, path
from plans.cam.profile.profile import profile
from plans.cam.study import CamDrawing
from plans.model.cam import Cam
from plans.model.cam_motion import Points, Sizes
from plans.model.motion import Floats
from plans.scene.scene import Scene
from plans.study import Study

STRIPS: Final = (8, 16, 64, 256, 1024)  # of a phase that moves the follower
TURNS: Final = (72, 360, 3600)  # of the cam
CUBICS: Final = (36, 72, 144, 288)  # to the turn
LOOKED_AT: Final = 24  # turns at which the exact envelope is judged in 50 digits
LAWS: Final = {MIDDLE: "laws: mid ordinates", THREE: "laws: three ordinates", TRUE: "laws: true mean ordinates"}
ROUNDING: Final = 1e-12  # shares: what is less is the rounding of the steps, and has no order
INVERSION, OFFSET, ENVELOPE = "profile: N inversions", "profile: shapely offset", "profile: exact envelope"
PIECES, POINT = "profile: arcs and cubics", "Q"
GOAL: Final = Goal(1.0, least=False)
FIRST = "of several cams the first one is judged"
LAWS_DEFINED = (
    "graphical laws: the largest differences of S' and S from the exact ones at the strips' edges, in shares of the "
    "largest of each; positions are the strips of one phase; a dwell is one strip, an edge stands on a corner of S''"
)
PROFILE_DEFINED = (
    "profile: of N inversions and of shapely's offset of as many points of the pitch curve, how far the exact profile "
    "is at most from their chords at turns half way between; of the exact envelope by closed forms, how far its points "
    "are from the record carried out in 50 digits; both in shares of the profile's largest radius"
)
PIECES_DEFINED = (
    "pieces: how far arcs and cubics are at most from the exact profile, in shares of the length of its base circle's "
    "radius or of the lift; positions are the pieces of a whole turn"
)


def cams(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge the first cam of a scene."""
    drawings = Study(scene)["cam"].drawings
    drawing: CamDrawing = next(iter(drawings.values()))
    sizes, roller = drawing.sizing.sizes, drawing.found.roller
    tell("the law")
    law = laws(drawing.cam, order.rounds, STRIPS if order.startup else STRIPS[:3])
    tell("the profile")
    edge = profiles(drawing.course, sizes, roller, order.rounds, TURNS if order.startup else TURNS[:2])
    tell("the pieces")
    last = pieces(drawing.cam, sizes, -roller, order.rounds)
    words = [FIRST] * (len(drawings) > 1) + [*law.words, *edge.words, *last.words]
    return Found([*law.rows, *edge.rows, *last.rows], words, edge.ratios)


def laws(cam: Cam, rounds: int, counts: Sequence[int] = STRIPS) -> Found:
    """Time and judge the diagrams of a law at several numbers of strips."""
    ways = [(means, count) for means in LAWS for count in counts]
    roads = [Road(partial(_diagrams, cam, count, means), count, {LAWS[means]: _departures}) for means, count in ways]
    rows = timed(roads, rounds)
    told = (line for name in LAWS.values() for line in orders(rows, name, "strips", ROUNDING))
    return Found(rows, [LAWS_DEFINED, *told])


def _diagrams(cam: Cam, count: int, means: str) -> LawDiagrams:
    return law_diagrams(replace(cam, divisions=count), means)


def _departures(found: LawDiagrams) -> Errors:
    kinds = {"S'": found.slope_departure.share, "S": found.travel_departure.share}
    return Errors(kinds, max(kinds, key=kinds.__getitem__))


@dataclass(frozen=True)
class Judged:
    """One cam and a number of turns, and what each way makes of them."""

    course: Course
    sizes: Sizes
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
        return mirrored(cam, Curve(cam, self.sizes, turned).edge(-(self.roller if roller is None else roller)))

    def roads(self) -> list[Road]:
        """List the ways; each begins anew with every run, shapely's with the points it is given."""
        ways: dict[str, tuple[Callable[[], Any], Callable[[Any], float]]] = {
            INVERSION: (
                lambda: profile(self.course, self.sizes, self.roller, self.turned).contour.profile,
                self._chords,
            ),
            ENVELOPE: (lambda: self.envelope(self.turned), self._digits),
        }
        if find_spec("shapely") and self.pitch and self.roller:
            away = -self.course.cam.sense * self.roller  # to the side of the cam
            ways[OFFSET] = (lambda: self.pitch.offset_curve(away), self._offset)
        return [Road(run, self.count, {name: partial(self._errors, judge)}) for name, (run, judge) in ways.items()]

    def _errors(self, judge: Callable[[Any], float], found: Any) -> Errors:
        return Errors({POINT: judge(found) / float(np.abs(self.between).max())}, POINT)

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
        return max(float(abs(exact([mark], k)[mark] - complex(one))) for k, one in enumerate(found.tolist()))


def profiles(course: Course, sizes: Sizes, roller: float, rounds: int, counts: Sequence[int] = TURNS) -> Found:
    """Time and judge the ways to a profile at several numbers of turns, and how long the exact one takes."""
    rows = timed([road for count in counts for road in Judged(course, sizes, roller, count).roads()], rounds)
    taken = {row.technique: row.times for row in rows if row.positions == counts[-1]}
    note = "" if find_spec("shapely") else NOT_INSTALLED
    ratio = Ratio(f"{ENVELOPE} / {OFFSET}", counts[-1], taken[ENVELOPE], taken.get(OFFSET), GOAL, note)
    return Found([*rows, *([Row(OFFSET, None, note=note)] if note else [])], [PROFILE_DEFINED], [ratio])


def _pairs(points: Points) -> Floats:
    return np.column_stack([points.real, points.imag])


def pieces(cam: Cam, sizes: Sizes, away: float, rounds: int, counts: Sequence[int] = CUBICS) -> Found:
    """Time and judge the pieces of a profile `away` m outward of the pitch curve, by their number."""

    def judge(found: ProfilePath) -> Errors:
        return Errors({POINT: found.deviation / (sizes.base or cam.lift)}, POINT)

    roads = [Road(partial(path, cam, sizes, away, count, exact=False), count, {PIECES: judge}) for count in counts]
    rows = timed(roads, rounds)
    return Found(rows, [PIECES_DEFINED, *orders(rows, PIECES, "pieces")])
