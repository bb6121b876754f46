"""The poses of a mechanism: the places of its points in positions, and on its way round (положения звеньев)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from plans.linkage.angles import angle
from plans.linkage.assembly_limits import NODES
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Link, Mechanism, Slide
from plans.model.motion import Complexes, Floats

BEYOND = 0.25  # share of the mechanism's size that a path between numbered positions may run past them


@dataclass(frozen=True)
class Poses:
    """A mechanism in several positions: the places of its points and the directions of its links; NaN at gaps."""

    links: Mapping[int, Link]
    points: Mapping[str, Complexes]
    turns: Mapping[int, Complexes]

    def __len__(self) -> int:
        return len(self.turns[FRAME])

    def of(self, link: int, spot: complex) -> Complexes:
        """Give the places of a spot that is fixed in a link, measured in the link's own frame."""
        if link == FRAME:
            return np.full(len(self), spot)
        name, own = next(iter(self.links[link].points.items()))
        return np.asarray(self.points[name] + self.turns[link] * (spot - own))

    def line(self, slide: Slide) -> Complexes:
        """Give the directions of a slide's line."""
        return np.asarray(self.turns[slide.owner] * slide.on_owner.direction)

    def along(self, slide: Slide) -> Floats:
        """Give how far a slide's block stands along its line, m from the point that the line goes through."""
        pins = self.points[slide.point] - self.of(slide.owner, slide.on_owner.through)
        return np.asarray((pins * np.conj(self.line(slide))).real)

    def blocks(self, slide: Slide) -> Complexes:
        """Give the places of a slide's block: the foot on its line of the slider's named point."""
        return self.of(slide.owner, slide.on_owner.through) + self.line(slide) * self.along(slide)


def way(study: LinkageStudy, drawn: Sequence[Poses]) -> Poses:
    """Give the poses of a whole turn, half a degree apart, NaN where the mechanism does not come."""
    nodes = np.linspace(*_whole(study), NODES + 1)
    dense = poses(study.mechanism, study.sweep.plan(nodes), len(nodes))
    known = [values for own in drawn for values in own.points.values()]
    box = np.concatenate([*known, _round(study)])
    free, box = study.reached(nodes), box[~np.isnan(box)]
    points = {name: _near(np.where(free, values, np.nan), box) for name, values in dense.points.items()}
    return Poses(dense.links, points, dense.turns)


def _round(study: LinkageStudy) -> Complexes:
    """Give the sides of the drive's whole circle: one listed position alone does not tell how far the links come."""
    drive = study.mechanism.drive
    if not drive.turns:
        return np.empty(0, dtype=np.complex128)
    pivot = study.mechanism.links[FRAME].points[drive.pivot]
    radius = abs(complex(PRIMARIES[drive.kind].ends(study.mechanism, study.turn)[0]) - pivot)
    return np.asarray(pivot + radius * np.array([1, 1j, -1, -1j]))


def _whole(study: LinkageStudy) -> tuple[float, float]:
    """Give the coordinates of the drive between which the way is shown: a turn, or its stroke."""
    first = float(study.turn.phi[0])
    return (first, first + 2 * np.pi) if study.mechanism.drive.turns else (first, float(study.turn.phi[-1]))


def poses(mechanism: Mechanism, plan: Plan, count: int) -> Poses:
    """Read the poses off a plan of positions."""
    names = sorted({name for link in mechanism.links.values() for name in link.points})
    points = {name: np.asarray(plan.point(name).point, dtype=np.complex128) for name in names}
    turns = {number: np.exp(1j * angle(plan, number)) for number in sorted(mechanism.links)}
    return Poses(
        mechanism.links,
        {name: np.array(np.broadcast_to(values, count)) for name, values in points.items()},
        {number: np.array(np.broadcast_to(values, count)) for number, values in turns.items()},
    )


def _near(path: Complexes, places: Complexes) -> Complexes:
    """Break a path where it runs far off the positions that are drawn, as a tangent mechanism's does to infinity."""
    if not places.size:
        return path
    middle = complex(places.real.min() + places.real.max(), places.imag.min() + places.imag.max()) / 2
    reach = (1 + BEYOND) * max(float(np.ptp(places.real)), float(np.ptp(places.imag))) / 2
    off = path - middle
    with np.errstate(invalid="ignore"):
        return np.where(np.maximum(np.abs(off.real), np.abs(off.imag)) <= reach, path, np.nan)
