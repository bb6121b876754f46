"""The skeleton of a linkage as it is drawn: bars and slots, masses, poses of its bodies (скелет механизма)."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.kinds.outlines import Poses
from drawings.kinds.scheme import Joints
from drawings.layout.parallel_offsets import Segment
from drawings.layout.picture import Place
from drawings.paper.strokes import TURN, Circle, Line, Stroke
from drawings.paper.walk import tied
from drawings.symbols.symbols import BLOCK, block, hinge
from drawings.symbols.trimming import Mask, trim
from geometry.board import at
from plans.linkage.plan import Plan, angle, unnamed
from plans.linkage.primary import PRIMARIES, CrankPositions
from plans.linkage.study import EXTREMES, LinkageStudy
from plans.linkage.sweep import NODES
from plans.linkage.travel import ExtremePositions, other_strokes
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Complexes, Motion
from plans.model.triad import Triad


class SpecialMark(NamedTuple):
    """A special point in the position in full lines, m, and the leads' points on the lines that meet in it."""

    name: str
    value: complex
    contacts: tuple[complex, ...]


@dataclass(frozen=True, eq=False, repr=False)
class Skeletons:
    """What the figure is drawn from: the poses in the scene's positions, on the way, and at the two extremes."""

    study: LinkageStudy
    motion: Motion
    numbered: Poses
    way: Poses  # a whole turn, densely
    extremes: Poses | None  # at the two extremes, None where there are none
    shown: int

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism."""
        return self.study.mechanism

    @property
    def links(self) -> list[int]:
        """The moving links."""
        return [number for number in sorted(self.mechanism.links) if number != FRAME]

    @property
    def poses(self) -> list[Poses]:
        """The poses that are drawn as links: those of the scene's positions, and the extremes."""
        return [self.numbered] if self.extremes is None else [self.numbered, self.extremes]

    def drive_end(self, position: int) -> complex:
        """Give the place of the crank's end, or of the slider that drives, known where nothing can be assembled too."""
        return complex(self._drive_ends[position])

    @cached_property
    def _drive_ends(self) -> Complexes:
        return PRIMARIES[self.mechanism.drive.kind].ends(self.mechanism, self.study.turn)

    @property
    def swept(self) -> tuple[float, float]:
        """Give the crank angles, rad, between which its circle is drawn: a whole turn, or what listed angles span."""
        low, high = self.study.span
        return (low, high) if high - low < TURN else (0.0, TURN)

    def sweeps(self, angle: float) -> bool:
        """Tell whether the drawn part of the crank's circle has an angle, rad."""
        low, high = self.swept
        return tied(abs(math.remainder(angle - (low + high) / 2, TURN)) - (high - low) / 2) <= 0

    def spot(self, name: str, position: int) -> complex:
        """Give a point's place; fixed points are known in every position, others are NaN at a gap."""
        fixed_points = self.mechanism.links[FRAME].points
        return fixed_points[name] if name in fixed_points else complex(self.numbered.points[name][position])

    def pivot(self, place: Place) -> complex:
        """Give the drive's fixed hinge on paper."""
        return place.on(self.mechanism.links[FRAME].points[self.mechanism.drive.pivot])

    def crank(self, place: Place) -> float:
        """Give the radius of the crank's circle on paper."""
        return abs(place.on(self.drive_end(self.shown)) - self.pivot(place))

    @cached_property
    def reach(self) -> float:
        """Give the mechanism's size, m: how far its points come from the drive's fixed hinge."""
        spots = np.concatenate(list(self.numbered.points.values()))
        return float(np.nanmax([abs(self.drive_end(0)), *map(abs, spots)]))

    @cached_property
    def masses(self) -> dict[str, tuple[int, complex]]:
        """Give the mass centres that no point names: letter, link, place in its own frame."""
        return unnamed(self.study.scene, self.mechanism.links)

    @cached_property
    def travels(self) -> dict[Slide, tuple[float, float]]:
        """Give the outermost places of each slide's block along its line, m; a slide of no known place has none."""
        ends = {}
        for slide in self.mechanism.slides:
            along = np.concatenate([poses.along(slide) for poses in (*self.poses, self.way)])
            known = along[~np.isnan(along)]
            if known.size:
                ends[slide] = float(known.min()), float(known.max())
        return ends

    @cached_property
    def strokes(self) -> dict[Slide, ExtremePositions]:
        """Give the strokes of the sliders on the frame besides the output, where extremes are asked for."""
        return other_strokes(self.study.sweep, self.study.output) if EXTREMES in self.study.plans else {}

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [*self._places, *(mark.value for mark in self.specials)]

    @cached_property
    def specials(self) -> list[SpecialMark]:
        """The special points of triads near the figure: one of leads all but parallel is far away."""
        plan, found = self.study.drafts().positions, list[SpecialMark]()
        for triad in (group for group in self.study.groups if isinstance(group, Triad)):
            letters = plan.written.specials.get(triad.basis)
            if letters is not None and letters.name in plan.board:
                value = at(plan.board[letters.name].point, self.shown)
                pair = (lead.pin for k, lead in enumerate(triad.leads) if k != letters.out)
                contacts = tuple(self.spot(pin, self.shown) for pin in pair)
                found.append(SpecialMark(letters.name, value, contacts))
        near = _near(np.array([mark.value for mark in found], dtype=np.complex128), np.array(self._places))
        return [mark for mark, place in zip(found, near, strict=True) if not math.isnan(place.real)]

    @cached_property
    def _places(self) -> list[complex]:
        """All true points of the links."""
        arrays = [places for poses in (*self.poses, self.way) for places in poses.points.values()]
        for slide, travel in self.travels.items():  # a slot reaches as far as its stone
            ends = [slide.on_owner.through + along * slide.on_owner.direction for along in travel]
            arrays += [poses.of(slide.owner, end) for end in ends for poses in self.poses]
        arrays += [poses.of(*mass) for mass in self.masses.values() for poses in (*self.poses, self.way)]
        known = [value for array in arrays for value in array]
        known += [self.drive_end(k) for k in range(len(self.numbered))]
        known += self.mechanism.links[FRAME].points.values()
        known += self._circle()
        return [complex(value) for value in known if not math.isnan(value.real)]

    def _circle(self) -> list[complex]:
        """Give the corners of the crank's circle, as far as it is drawn."""
        if self.mechanism.drive.pushed:
            return []
        pivot = self.mechanism.links[FRAME].points[self.mechanism.drive.pivot]
        radius, (low, high) = abs(self.drive_end(0) - pivot), self.swept
        return [pivot + radius * complex(np.exp(1j * angle)) for angle in np.linspace(low, high, 24)]


def skeletons(study: LinkageStudy, motion: Motion, shown: int) -> Skeletons:
    """Gather the poses that the figure needs: the way between positions is computed densely, not splined."""
    turns = {FRAME: np.ones(len(motion.phi), dtype=np.complex128)}
    turns |= {number: np.exp(1j * turning.angle) for number, turning in motion.links.items()}
    numbered = Poses(study.mechanism.links, {name: turning.r for name, turning in motion.points.items()}, turns)
    extremes = None
    if study.travel is not None:
        turn = CrankPositions(np.array(study.travel.extremes.phi), np.array(study.travel.directions))
        extremes = poses(study.mechanism, study.sweep.positions(turn), 2)
    round_way = way(study, [numbered] if extremes is None else [numbered, extremes])
    return Skeletons(study, motion, numbered, round_way, extremes, shown)


def reference(mechanism: Mechanism) -> str:
    """Give the point that places on paper are measured from: the drive's fixed hinge, or of a slider another one."""
    drive, fixed = mechanism.drive, mechanism.links[FRAME].points
    hinges = [name for name in fixed if name in mechanism.hinges]
    return [*hinges, *fixed][0] if drive.pushed else drive.pivot


BEYOND = 0.25  # share of the mechanism's size that a path between numbered positions may run past them


def way(study: LinkageStudy, drawn: Sequence[Poses]) -> Poses:
    """Give the poses of a whole turn, half a degree apart, NaN where the mechanism does not come."""
    # The coordinates of the drive between which the way is shown: a turn, what listed angles span, or its stroke
    first, last = float(study.turn.phi[0]), float(study.turn.phi[-1])
    if study.mechanism.drive.turns:
        low, high = study.span
        first, last = (low, high) if 0.0 < high - low < 2 * np.pi else (first, first + 2 * np.pi)
    nodes = np.linspace(first, last, NODES + 1)
    dense = poses(study.mechanism, study.sweep.plan(nodes), len(nodes))
    known = [values for known_poses in drawn for values in known_poses.points.values()]
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


def poses(mechanism: Mechanism, plan: Plan, count: int) -> Poses:
    """Read the poses off a plan of positions."""
    names = sorted({name for link in mechanism.links.values() for name in link.points})
    points = {name: np.asarray(plan.point(name).point, dtype=np.complex128) for name in names}
    turns = {number: np.exp(1j * angle(plan, number)) for number in sorted(mechanism.links)}
    places = {name: np.array(np.broadcast_to(values, count)) for name, values in points.items()}
    turned = {number: np.array(np.broadcast_to(values, count)) for number, values in turns.items()}
    return Poses(mechanism.links, places, turned)


def _near(path: Complexes, places: Complexes) -> Complexes:
    """Break a path where it runs far off the positions that are drawn, as a tangent mechanism's does to infinity."""
    if not places.size:
        return path
    middle = complex(places.real.min() + places.real.max(), places.imag.min() + places.imag.max()) / 2
    reach = (1 + BEYOND) * max(float(np.ptp(places.real)), float(np.ptp(places.imag))) / 2
    off = path - middle
    with np.errstate(invalid="ignore"):
        return np.where(np.maximum(np.abs(off.real), np.abs(off.imag)) <= reach, path, np.nan)


BARREL = (0.2, 0.8)  # of a cylinder's shortest length: where along it its barrel begins and ends


@dataclass(frozen=True, eq=False, repr=False)
class Pairs(Joints):
    """The pairs of a mechanism's shown position, with the cylinder that drives it."""

    bones: Skeletons

    @cached_property
    def hinges(self) -> dict[str, tuple[Circle, ...]]:
        """The hinges by their letters, those of the cylinder's ends too."""
        joined, found = self.bones.mechanism.hinges, dict(super().hinges)
        for name in self.named.keys() & self.bones.mechanism.cylinder:
            found[name] = hinge(self.place.on(self.named[name]), self.hand, len(joined.get(name, (FRAME,))) + 1)
        return found

    @cached_property
    def barrel(self) -> list[Mask]:
        """The cylinder's barrel, as its shortest length lets it be; none where it would be no longer than wide."""
        ram, barrels = self.bones.mechanism.drive.ram, list[Mask]()
        for foot, point in self._cylinder:
            assert ram is not None  # it has the ends
            low, high = (share * self.place.length(min(ram.begin, ram.end)) for share in BARREL)
            along, size = (point - foot) / abs(point - foot), ((high - low) / self.hand.symbol, BLOCK[1])
            barrels += [block(foot + (low + high) / 2 * along, along, self.hand, size)] if size[0] > size[1] else []
        return barrels

    @property
    def _cylinder(self) -> list[Segment]:
        """The ends of the cylinder on paper, as far as it is known."""
        ends = [self.place.on(self.named[name]) for name in self.bones.mechanism.cylinder if name in self.named]
        return [(ends[0], ends[1])] if len({*ends}) == 2 else []

    @property
    def masks(self) -> list[Mask]:
        """What no line of another position enters: all symbols of the shown one."""
        return [*super().masks, *self.barrel]

    def bars(self) -> Iterator[Stroke]:
        """Draw the links of the shown position, and the cylinder: its barrel, and its rod from there."""
        yield from super().bars()
        rods = (Line(*ends, self.hand.result) for ends in self._cylinder)
        yield from trim(rods, [*self.rounds, *self.barrel])
        yield from self.barrel

    def _ways(self, name: str) -> Iterator[complex]:
        yield from super()._ways(name)
        cylinder = self._cylinder if name in self.bones.mechanism.cylinder[:1] else ()
        yield from ((point - foot) / abs(point - foot) for foot, point in cylinder)


def cylinders(bones: Skeletons, poses: Poses) -> Iterator[Segment]:
    """Give the true ends of the cylinder that drives in every pose; nothing of one that links are."""
    links, link_of = bones.mechanism.links, bones.mechanism.link_of
    ends = [poses.of(link_of(name), links[link_of(name)].points[name]) for name in bones.mechanism.cylinder]
    yield from zip(*(end.tolist() for end in ends), strict=True) if ends else ()
