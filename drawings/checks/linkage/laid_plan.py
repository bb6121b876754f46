"""A plan of positions on its sheet with all that must be on it, by the analysis (план положений: что должно быть)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.linkage.laid import LaidMechanism
from drawings.checks.linkage.laid_poses import Flags, LaidPoses, Segments
from drawings.checks.linkage.position_marks import EXACT, named
from drawings.paper.strokes import Leaf, Line, Stroke
from drawings.paper.walk import flat
from drawings.symbols.symbols import BLOCK, DOUBLE, MASS, SLOT
from plans.analytic.kinematics import Analysis
from plans.linkage.primary import PRIMARIES
from plans.model.mechanism import FRAME, Slide
from plans.model.motion import Complexes, Extremes, Floats

ROOM = 0.1  # mm that lines end before a symbol at the most
WAY = 180  # places on the way round, close enough to tell how far blocks come
REACH = 1.25  # a path runs on beyond the positions that are drawn by so much of their size, as to infinity, not farther


@dataclass(frozen=True, eq=False)
class LaidPlan:
    """A leaf with its plan of positions, where the analysis has the mechanism, and what is allowed on paper, mm."""

    leaf: Leaf
    laid: LaidMechanism
    road: Analysis
    allowed: float

    @property
    def position(self) -> int:
        """The position in full lines."""
        return self.laid.position

    @property
    def near(self) -> float:
        """How far a stroke may be from its true place, mm."""
        return EXACT + 2 * self.allowed

    @cached_property
    def told(self) -> Extremes | None:
        """The output's extremes, where they are asked for."""
        return None if self.laid.study.travel is None else self.road.extremes(self.laid.study.output)

    @cached_property
    def poses(self) -> LaidPoses:
        """The mechanism in the scene's positions."""
        return LaidPoses(self.laid.mechanism, self.laid.motion, self.laid.at)

    @cached_property
    def extremes(self) -> LaidPoses | None:
        """The mechanism in the output's extreme positions; None of none, or of a crank that cannot come round."""
        if self.told is None:
            return None
        motion = self.road.freely(np.array(self.told.phi))
        return None if motion is None else LaidPoses(self.laid.mechanism, motion, self.laid.at)

    @cached_property
    def way(self) -> LaidPoses | None:
        """The mechanism on its way round; None where the crank cannot come round."""
        motion = self.road.freely(self.laid.motion.phi[0] + 2 * np.pi * np.arange(WAY) / WAY)
        return None if motion is None else LaidPoses(self.laid.mechanism, motion, self.laid.at)

    @cached_property
    def crank_ends(self) -> Complexes:
        """The places of the drive's end in the scene's positions, mm, also of those that cannot be assembled."""
        ends = PRIMARIES[self.laid.mechanism.drive.kind].ends(self.laid.mechanism, self.laid.study.turn)
        return np.asarray(self.laid.at.origin + ends / self.laid.at.scale)

    def travel(self, slide: Slide) -> tuple[float, float]:
        """Give how far a block comes along its line from the point that the line goes through, mm."""
        seen = [one for one in (self.poses, self.extremes, self.way) if one is not None]
        along = np.concatenate([one.along(slide) for one in seen])
        return (float(np.nanmin(along)), float(np.nanmax(along))) if np.isfinite(along).any() else (0.0, 0.0)

    def strokes(self, name: str) -> list[Stroke]:
        """Give the strokes of the groups of a name."""
        return [stroke for group in named(self.leaf, name) for stroke in flat((group,))]

    def lines(self, name: str) -> Segments:
        """Give the straight lines of the groups of a name."""
        return Segments.of((one.start, one.end) for one in self.strokes(name) if isinstance(one, Line))

    @cached_property
    def _symbols(self) -> tuple[Complexes, Floats]:
        """The symbols of the shown position: their middles, and circles about them as large as they may be."""
        mechanism, k = self.laid.mechanism, self.position
        points = sorted({name for link in mechanism.links.values() for name in link.points})
        blocked = abs(complex(max(BLOCK[0], SLOT[0]), BLOCK[1])) / 2
        found = [(complex(self.poses.point(name)[k]), DOUBLE[0]) for name in points]
        found += [(complex(self.poses.block(slide)[k]), blocked) for slide in mechanism.slides]
        found += [(self.laid.on(link, own), MASS) for link, own in self.laid.centres.values()]
        known = [(spot, radius + ROOM) for spot, radius in found if np.isfinite(spot)]
        return np.array([spot for spot, _ in known]), np.array([radius for _, radius in known])

    @property
    def symbol(self) -> float:
        """How far the largest symbol reaches from its middle, mm."""
        return float(self._symbols[1].max(initial=0.0))

    def reached(self, spots: Complexes) -> Flags:
        """Tell of the spots of a path whether they are not too far off the positions and the drive's circle."""
        low, high = self._box
        middle, half = (low + high) / 2, REACH * max((high - low).real, (high - low).imag) / 2
        off = spots - middle
        with np.errstate(invalid="ignore"):
            return np.asarray(np.maximum(np.abs(off.real), np.abs(off.imag)) <= half - self.near)

    @cached_property
    def _box(self) -> tuple[complex, complex]:
        """The corners of the box about the positions that are drawn and the drive's circle, mm."""
        mechanism, drive = self.laid.mechanism, self.laid.mechanism.drive
        names = {name for link in mechanism.links.values() for name in link.points}
        drawn = [one for one in (self.poses, self.extremes) if one is not None]
        spots = [one.point(name) for one in drawn for name in names]
        if drive.turns:
            pivot = self.laid.on(FRAME, mechanism.links[FRAME].points[drive.pivot])
            spots.append(pivot + abs(self.crank_ends[0] - pivot) * np.array([1, 1j, -1, -1j]))
        known = np.concatenate(spots)
        known = known[np.isfinite(known)]
        return complex(known.real.min(), known.imag.min()), complex(known.real.max(), known.imag.max())

    def clear(self, spots: Complexes, by: float = 0.0) -> Flags:
        """Tell of spots whether they are clear of the symbols of the shown position, by so many mm; a gap is not."""
        middles, radii = self._symbols
        return np.asarray(np.isfinite(spots) & (np.abs(spots[:, None] - middles) > radii + by).all(axis=1))
