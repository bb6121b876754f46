"""The numbers of a motion as plain data: points, links and extremes by either road (движение в числах).

SI units and radians, null at gaps; places are coordinates of the scene.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from plans.analytic.kinematics import Analysis
from plans.checks.compare import road_of
from plans.checks.plain_numbers import gap_numbers, pairs, plain
from plans.linkage.primaries import stroke
from plans.linkage.study import EXTREMES, LinkageStudy
from plans.model.motion import Extremes, Floats, Motion
from plans.model.order import ACCELERATIONS, ORDERS, numbers_of

if TYPE_CHECKING:
    from plans.study import Study


@dataclass(frozen=True)
class MotionNumbers:
    """The motion of a linkage by one road, its extremes where they are told, and the orders that are."""

    title: str
    datum: complex
    motion: Motion
    extremes: Extremes | None
    orders: Sequence[int]
    road: Analysis | None = None  # by which it was found, if not by construction
    ways: Floats | None = None  # m: of a drive over a stroke, its way or its length

    @property
    def flawed(self) -> bool:
        """Whether some position has no numbers."""
        return bool(self.motion.gaps)

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        result: dict[str, Any] = {
            "scene": self.title,
            "by": self.motion.by,
            "phi": plain(self.motion.phi),
            **({} if self.ways is None else {"s": plain(self.ways)}),
            "gaps": [gap_numbers(gap) for gap in self.motion.gaps],
            "points": self._points(),
            "links": self._links(),
        }
        return result if self.extremes is None else result | {"extremes": _extremes(self.extremes)}

    def _points(self) -> dict[str, Any]:
        points = sorted(self.motion.points.items())
        places = {k: self.datum if k == 0 else 0 for k in self.orders}
        return {
            name: {ORDERS[k].point.key: pairs(point[k] + place) for k, place in places.items()}
            for name, point in points
        }

    def _links(self) -> dict[str, Any]:
        links = sorted(self.motion.links.items())
        return {str(number): {ORDERS[k].link.key: plain(link[k]) for k in self.orders} for number, link in links}


def _extremes(extremes: Extremes) -> dict[str, Any]:
    return {
        "phi": list(extremes.phi),
        "reach": list(extremes.reach),
        "stroke": extremes.stroke,
        "overlap": extremes.overlap,
        "ratio": extremes.ratio,
        "faster": extremes.faster,
    }


def numbers(study: Study, by: str) -> MotionNumbers:
    """Find the motion of a scene by a road: what is asked for of it, and what the forces rest on."""
    linkage = study["linkage"]
    orders = numbers_of(study.plans)
    borne = any("linkage" in row.needs for row in study.rows)
    order = ACCELERATIONS.number if borne else max(orders, default=0)
    datum = complex(*(float(x) for x in linkage.mechanism.datum))
    told = linkage.form.drive.first is None or (study.chosen and EXTREMES in study.plans)
    found = (solved if by == "analysis" else _constructed)(linkage, order, told)
    ways = stroke.ways(linkage.mechanism, found[0].phi)
    return MotionNumbers(study.scene.heading(), datum, found[0], found[1], orders, found[2], ways)


def _constructed(study: LinkageStudy, order: int, told: bool) -> tuple[Motion, Extremes | None, None]:
    motion = study.motion(order)
    found = study.extreme_positions if told else None
    return motion, found.extremes if found else None, None


def solved(study: LinkageStudy, order: int, told: bool) -> tuple[Motion, Extremes | None, Analysis]:
    """Solve by analysis alone: a start at an extreme is found by analysis too."""
    road = road_of(study)
    extremes = road.extremes(study.output) if told or not road.first else None
    if extremes is None or road.first:  # of a start at an extreme that is none the turn says why
        return road.motion(study.turn.phi, order), extremes, road
    count = study.form.drive.count
    phi = extremes.phi[0] + study.sense * 2 * np.pi * np.arange(count) / count
    return road.motion(phi, order), extremes, road
