"""The skeleton of a mechanism: the places of its points in the scene's positions, on the way between, at extremes."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from drawings.figure import Place
from plans.mechanism import FRAME
from plans.motion import Complexes, Motion
from plans.passage import NODES
from plans.plan import Plan
from plans.study import Study
from plans.turn import Turn

MORE = 0.2  # rad of the crank's circle drawn past the outermost of some listed angles
BEYOND = 0.25  # share of the mechanism's size that a path between numbered positions may run past them


@dataclass(frozen=True)
class Skeletons:
    """What the figure is drawn from: the places of all points in the scene's positions, on the way, and at extremes."""

    study: Study
    motion: Motion
    path: dict[str, Complexes]
    extremes: dict[str, Complexes]  # at the two extremes, empty where there are none
    shown: int

    def ends(self, link: int, whole: bool) -> list[str]:
        """Give a link's points that its line runs through: all of them, or only those that bound it by its pairs."""
        points = list(self.study.mechanism.links[link].points)
        jointed = [name for name in points if name in self.study.mechanism.hinges]
        return points if whole or len(jointed) < 2 else jointed

    def crank_end(self, position: int) -> complex:
        """Give the place of the crank's end, known even where the mechanism cannot be assembled."""
        drive, links = self.study.mechanism.drive, self.study.mechanism.links
        arm = links[drive.link].points[drive.end] - links[drive.link].points[drive.pivot]
        return links[FRAME].points[drive.pivot] + abs(arm) * complex(self.study.turn.directions[position])

    def _circle(self) -> list[complex]:
        """Give the corners of the crank's circle, as far as it is drawn."""
        pivot = self.study.mechanism.links[FRAME].points[self.study.mechanism.drive.pivot]
        radius, (low, high) = abs(self.crank_end(0) - pivot), self.swept
        return [pivot + radius * complex(np.exp(1j * angle)) for angle in np.linspace(low, high, 24)]

    @property
    def swept(self) -> tuple[float, float]:
        """Give the crank angles, rad, between which its circle is drawn: a whole turn, or what listed angles span."""
        low, high = self.study.span[0] - MORE, self.study.span[1] + MORE
        return (low, high) if high - low < 2 * math.pi else (0.0, 2 * math.pi)

    def spot(self, name: str, position: int) -> complex:
        """Give a point's place; fixed points are known in every position, others are NaN at a gap."""
        fixed_points = self.study.mechanism.links[FRAME].points
        return fixed_points[name] if name in fixed_points else complex(self.motion.points[name].r[position])

    def pivot(self, place: Place) -> complex:
        """Give the drive's fixed hinge on paper."""
        return place.on(self.study.mechanism.links[FRAME].points[self.study.mechanism.drive.pivot])

    @property
    def links(self) -> list[int]:
        """The moving links."""
        return [number for number in sorted(self.study.mechanism.links) if number != FRAME]

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        known = [value for values in (*self.path.values(), *self.extremes.values()) for value in values]
        known += [value for motion in self.motion.points.values() for value in motion.r]
        known += [self.crank_end(k) for k in range(len(self.motion.phi))]
        known += self.study.mechanism.links[FRAME].points.values()
        known += self._circle()
        return [complex(value) for value in known if not math.isnan(value.real)]


def skeletons(study: Study, motion: Motion, shown: int) -> Skeletons:
    """Gather the places that the figure needs: the paths are computed densely, not splined."""
    nodes = study.turn.phi[0] + 2 * np.pi * np.arange(NODES + 1) / NODES
    dense = study.sweep.plan(nodes)
    free = study.reached(nodes)
    path = {name: np.where(free, _column(dense, name, len(nodes)), np.nan) for name in motion.points}
    box = np.array([found.r for found in motion.points.values()])
    path = {name: _near(values, box[~np.isnan(box)]) for name, values in path.items()}
    extremes: dict[str, Complexes] = {}
    if study.found is not None:
        turn = Turn(np.array(study.found.extremes.phi), np.array(study.found.directions))
        drawn = study.sweep.drawn(turn)
        extremes = {name: _column(drawn, name, 2) for name in motion.points}
    return Skeletons(study, motion, path, extremes, shown)


def _near(path: Complexes, places: Complexes) -> Complexes:
    """Break a path where it runs far off the numbered positions, as a tangent mechanism's does to infinity."""
    if not places.size:
        return path
    middle = complex(places.real.min() + places.real.max(), places.imag.min() + places.imag.max()) / 2
    reach = (1 + BEYOND) * max(float(np.ptp(places.real)), float(np.ptp(places.imag))) / 2
    off = path - middle
    with np.errstate(invalid="ignore"):
        return np.where(np.maximum(np.abs(off.real), np.abs(off.imag)) <= reach, path, np.nan)


def _column(plan: Plan, name: str, count: int) -> Complexes:
    return np.array(np.broadcast_to(np.asarray(plan.point(name).point, dtype=np.complex128), count))
