"""The profile of a cam timed and judged: by N inversions, by shapely's offset, by the exact envelope (профиль).

shapely offsets the pitch curve that it is given by points; only this file imports it, and it may be missing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib.util import find_spec
from typing import Any, Final

import numpy as np

from geometry.replay import exact
from plans.analytic.cam.contour import Curve, mirrored
from plans.bench.clock import interleaved
from plans.bench.error import Errors
from plans.bench.result import Goal, Ratio, Row
from plans.cam.course import Course
from plans.cam.profile.profile import profile
from plans.model.cam_motion import Points, Sizes
from plans.model.motion import Floats

COUNTS: Final = (72, 360, 3600)  # turns of the cam
LOOKED_AT: Final = 24  # turns at which the exact envelope is judged in 50 digits
INVERSION, OFFSET, ENVELOPE = "profile: N inversions", "profile: shapely offset", "profile: exact envelope"
POINT = "Q"
GOAL: Final = Goal(1.0, least=False)
NOT_INSTALLED = "not installed: python -m pip install '.[bench]'"
DEFINED = (
    "profile: of N inversions and of shapely's offset of as many points of the pitch curve, how far the exact profile "
    "is at most from their chords at turns half way between; of the exact envelope by closed forms, how far its points "
    "are from the record carried out in 50 digits; both in shares of the profile's largest radius"
)


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

    def inverted(self) -> Points:
        """Find the profile by inversions."""
        return profile(self.course, self.sizes, self.roller, self.turned).contour.profile

    def offset(self) -> Any:
        """Have shapely offset the pitch curve to the side of the cam."""
        return self.pitch.offset_curve(-self.course.cam.sense * self.roller)

    def errors(self, way: str) -> Errors:
        """Judge a way."""
        error = {INVERSION: self._chords, OFFSET: self._offset, ENVELOPE: self._digits}[way]()
        return Errors({POINT: error / float(np.abs(self.between).max())}, POINT)

    def _chords(self) -> float:
        points = self.inverted()
        start, way = points[:-1], np.diff(points)
        along = np.clip(((self.between - start) / way).real, 0.0, 1.0)
        return float(np.abs(self.between - start - along * way).max())

    def _offset(self) -> float:
        import shapely  # noqa: PLC0415  (only the bench pays for it)

        return float(shapely.distance(self.offset(), shapely.points(_pairs(self.between))).max())

    def _digits(self) -> float:
        turned = self.turned[:: max(self.count // LOOKED_AT, 1)]
        drawing = profile(self.course, self.sizes, self.roller, turned).drawing
        mark = drawing.board[POINT] if self.roller else drawing.point
        found = self.envelope(turned)
        return max(float(abs(exact([mark], k)[mark] - complex(one))) for k, one in enumerate(found.tolist()))

    def runs(self) -> dict[str, Callable[[], Any]]:
        """List the ways; each begins anew with every run, shapely's with the points it is given."""
        ways: dict[str, Callable[[], Any]] = {INVERSION: self.inverted, ENVELOPE: lambda: self.envelope(self.turned)}
        return ways | ({OFFSET: self.offset} if find_spec("shapely") and self.pitch and self.roller else {})


def rows(
    course: Course, sizes: Sizes, roller: float, rounds: int, budget: float, counts: Sequence[int] = COUNTS
) -> tuple[list[Row], list[Ratio], list[str]]:
    """Time and judge the ways at several numbers of turns; give rows, how long the exact profile takes, and words."""
    judged = [(Judged(course, sizes, roller, count), count) for count in counts]
    runs = [(one, count, name, run) for one, count in judged for name, run in one.runs().items()]
    times = interleaved([run for *_, run in runs], rounds, budget)
    taken = {(name, count): time for (_, count, name, _), time in zip(runs, times, strict=True)}
    made = [Row(name, n, n, one.errors(name), times=taken[name, n]) for one, n, name, _ in runs]
    note, most = "" if find_spec("shapely") else NOT_INSTALLED, counts[-1]
    made += [Row(OFFSET, None, note=note)] if note else []
    ends = taken[ENVELOPE, most], taken.get((OFFSET, most))
    return made, [Ratio(f"{ENVELOPE} / {OFFSET}", most, *ends, GOAL, note)], [DEFINED]


def _pairs(points: Points) -> Floats:
    return np.column_stack([points.real, points.imag])
