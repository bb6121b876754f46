"""Instant centres by both roads, and the rates by them as a third one beside plans and analysis (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from geometry.board import Mark, at, behind
from geometry.meet import EPS, cross
from geometry.precision import errors
from plans.analytic.kinematics import Analysis
from plans.centres.centrodes import Flags, own
from plans.centres.kennedy import CENTRES, Pair, hinge_of, letter, pairs
from plans.centres.study import CentresStudy
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.linkage.marks import UNITS, position_of, title
from plans.linkage.quantities import ANALYSIS, MotionComparison, compare, read_bound, road_of
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import POSITIONS, VELOCITIES, Complexes, Floats, Motion, evenly
from plans.quantity import Comparison, Quantity
from plans.words.words import message

if TYPE_CHECKING:
    from plans.study import Study


@dataclass(frozen=True, eq=False, repr=False)
class CentresComparison(Comparison):
    """Instant centres by both roads, over a motion."""

    construction: Motion
    analysis: Motion
    findings: tuple[Quantity, ...]
    plans: MotionComparison  # the motion up to velocities by plans and analysis
    moving: MotionComparison  # the same, or of a drive that rests one at 1 rad/s: its centres are the same


def spin(mechanism: Mechanism, motion: Motion, link: int) -> tuple[Complexes, Floats]:
    """Give the velocity that a link would have in the datum, m/s, and its rate rad/s, (N,): all of its motion."""
    name = next(iter(mechanism.links[link].points))
    none = np.zeros(len(motion.phi))
    omega = none if link == FRAME else motion.links[link].omega
    return (motion.points[name].v if link != FRAME else none + 0j) - 1j * omega * motion.points[name].r, omega


@np.errstate(invalid="ignore", divide="ignore")  # links that turn alike have none
def common(mechanism: Mechanism, motion: Motion, pair: Pair) -> Complexes:
    """Give by analysis the places in which two links have one velocity, (N,) m: their hinge, or far where they turn."""
    if (hinge := hinge_of(mechanism, pair)) is not None:
        return motion.points[hinge].r
    (first, one), (second, two) = (spin(mechanism, motion, link) for link in pair)
    return np.asarray(-(first - second) / (1j * (one - two)))


SURE = 1e-3  # a radius known to no more than this share is that of a path all but straight


class Solved(NamedTuple):
    """The centre of two links by analysis over a motion, (N,) m each, and how far off it may be."""

    place: Complexes
    allowed: Floats
    sure: Flags  # whether the links move against each other: two that move as one have a centre anywhere
    start: Complexes | float = 0.0  # from where its distance is told


@np.errstate(invalid="ignore", divide="ignore")
def solved(mechanism: Mechanism, motion: Motion, pair: Pair, kappa: Floats) -> Solved:
    """Find a centre by analysis; kappa bounds the rounding of its rates, as a share of the largest."""
    fastest = max(float(np.nanmax(np.abs(point.v), initial=0.0)) for point in motion.points.values())
    (_, one), (_, two) = (spin(mechanism, motion, link) for link in pair)
    place, fast = common(mechanism, motion, pair), np.maximum(np.abs(one), np.abs(two))
    apart = np.abs(one - two) if hinge_of(mechanism, pair) is None else fast
    return Solved(place, kappa * (fast * np.abs(place) + fastest) / apart, apart > kappa * fast)


class Curving(NamedTuple):
    """Velocities and accelerations by analysis, of a drive that turns evenly: how paths curve hangs on no rate."""

    motion: Motion
    road: Analysis

    @property
    def kappa(self) -> Floats:
        """What bounds the rounding of accelerations, as a share of the largest."""
        return np.asarray(ANALYSIS * EPS * self.road.conditions(self.motion) ** 3)

    def _largest(self, order: int) -> float:
        return max(float(np.nanmax(np.abs(point[order]), initial=0.0)) for point in self.motion.points.values())

    @np.errstate(invalid="ignore", divide="ignore")  # a link that only translates for a moment
    def inflection(self, mechanism: Mechanism, link: int) -> Solved:
        """Find the inflection pole: from the pole by its acceleration over ω²."""
        moved, turned = self.motion.points[next(iter(mechanism.links[link].points))], self.motion.links[link]
        arm, omega = 1j * moved.v / turned.omega, np.abs(turned.omega)
        pole = moved.r + arm
        way = (moved.a + (1j * turned.epsilon - omega**2) * arm) / omega**2
        fastest, most = self._largest(1), self._largest(2)
        swift = float(np.nanmax(omega, initial=0.0)) + float(np.nanmax(np.abs(turned.epsilon), initial=0.0))
        off = fastest / omega + most / omega**2 + (np.abs(way) + np.abs(arm)) * (swift / omega + swift / omega**2)
        return Solved(pole + way, self.kappa * off, omega > self.kappa * swift, pole)

    @np.errstate(invalid="ignore", divide="ignore")  # a path without curvature in a position, or a point that rests
    def centre(self, point: str) -> Solved:
        """Find the centre of curvature of a point's path: on its normal, as far as |v|³/|v × a|."""
        r, v, a = self.motion.points[point][:3]
        turning, speed = np.asarray(cross(v, a)), np.abs(v)
        fastest, most = self._largest(1), self._largest(2)
        radius = speed**3 / np.abs(turning)
        off = 3 * fastest / speed + (speed * most + np.abs(a) * fastest) / np.abs(turning)
        allowed = self.kappa * (radius * off + np.abs(r))
        return Solved(r + 1j * v * speed**2 / turning, allowed, self.kappa * off < SURE, r)


def within(mechanism: Mechanism, motion: Motion, link: int, places: Complexes) -> Complexes:
    """Give places in the axes of a link, by analysis."""
    if link == FRAME:
        return places
    name, local = next(iter(mechanism.links[link].points.items()))
    return np.asarray(local + (places - motion.points[name].r) * np.exp(-1j * motion.links[link].angle))


def placed_with(mechanism: Mechanism, motion: Motion, link: int, own_places: Complexes, k: int) -> Complexes:
    """Give where places in the axes of a link lie in a position, by analysis."""
    if link == FRAME:
        return own_places
    name, local = next(iter(mechanism.links[link].points.items()))
    return np.asarray(motion.points[name].r[k] + (own_places - local) * np.exp(1j * motion.links[link].angle[k]))


class SolvedCentrodes(NamedTuple):
    """The centrodes of two links by analysis, in the axes of each, (N,) m, and how far off both roads may be."""

    paths: dict[int, Complexes]
    allowed: Floats

    @classmethod
    @np.errstate(invalid="ignore", divide="ignore")
    def of(cls, study: CentresStudy, pair: Pair) -> SolvedCentrodes:
        """Solve the motion over the turn for r + iv/ω of one link against the other."""
        linkage, made = study.linkage, study.centrodes[pair]
        road = road_of(linkage.paced(evenly))
        motion = road.motion(made.phi, VELOCITIES.number)
        kappa = ANALYSIS * EPS * road.conditions(motion) ** 2
        found = solved(linkage.mechanism, motion, pair, kappa)
        sure = np.where(found.sure & made.free, found.place, np.nan)
        paths = {link: within(linkage.mechanism, motion, link, sure) for link in pair}
        turned = [kappa * np.abs(path) for path in paths.values()]
        return cls(paths, np.asarray(found.allowed + sum(turned) + sum(made.allowed.values())))


@np.errstate(invalid="ignore", divide="ignore")  # centres at infinity, and gaps, are NaN on both roads
def compare_centres(study: CentresStudy) -> CentresComparison:
    """Put centres and rates beside those by analysis, in all positions."""
    motion = compare(study.linkage, VELOCITIES.number)
    rests = not np.any(study.linkage.rates.omega)
    moving = compare(study.linkage.paced(evenly), VELOCITIES.number) if rests else motion
    both = _Compared(study, motion, moving)
    found = (*both.places(), *both.rates(), *both.curvature())
    ours, theirs = (road._replace(gaps=()) for road in (motion.construction, motion.analysis))  # told of the motion
    return CentresComparison(ours, theirs, found, motion, moving, motion=motion)


class _Compared:
    def __init__(self, study: CentresStudy, motion: MotionComparison, moving: MotionComparison) -> None:
        self.study, self.motion, self.mechanism, self.moving = study, motion, study.linkage.mechanism, moving.analysis
        self.count = len(motion.analysis.phi)
        self.read = {k: study.rates(k) for k in study.whole}
        self.kappa = ANALYSIS * EPS * motion.kappa**2

    def places(self) -> Iterator[Quantity]:
        """Compare the centres that are not at infinity; those with centrodes in the axes of both links too."""
        for pair in pairs(self.mechanism.links):
            theirs = solved(self.mechanism, self.moving, pair, self.kappa)
            whole = {k: one for k in self.study.whole if (one := self.study.at(k).of(*pair)) and not one.infinite}
            marks = {k: one.mark for k, one in whole.items()}
            yield self._place(letter(pair), marks, theirs)
            for link in (n for n in pair if n != FRAME and pair in self.study.centrodes):
                own_place = within(self.mechanism, self.moving, link, theirs.place)
                allowed = theirs.allowed + self.kappa * np.abs(own_place)
                carried = {k: self.study.carried(k, pair, link) for k in whole}
                yield self._place(own(letter(pair), link), carried, Solved(own_place, allowed, theirs.sure))

    def _place(self, name: str, marks: dict[int, Mark], theirs: Solved) -> Quantity:
        ours, bound = np.full(self.count, np.nan + 0j), np.full(self.count, np.nan)
        for k, mark in marks.items():
            ours[k] = at(mark.point, 0)
            bound[k] = np.ravel(errors(mark)[mark].place)[0]
        found = theirs.sure & ~np.isnan(ours)
        both = np.where(found, ours, np.nan), np.where(found, theirs.place, np.nan)
        placed = Quantity.of((CENTRES, name, "m"), both, np.where(found, bound + theirs.allowed, np.nan))
        still = placed.largest <= np.nanmax(placed.allowed, initial=0.0)  # in the datum itself: no per cent of that
        size = max((self.study.at(k).size for k in self.study.whole), default=0.0)
        return placed._replace(largest=size) if still else placed

    def curvature(self) -> Iterator[Quantity]:
        """Compare inflection poles and centres of curvature, with the distances from pole and point."""
        if not self.study.curving:
            return
        linkage = self.study.linkage
        road = road_of(linkage.paced(evenly))
        curving = Curving(road.motion(linkage.turn.phi), road)
        for link in dict.fromkeys(self.study.curving.values()):
            circles = {k: circle for k in self.study.whole if (circle := self.study.inflection(k, link)) is not None}
            ends = {k: (circle.inflection, circle.diameter) for k, circle in circles.items()}
            yield from self._ended((f"W_{link}", f"δ_{link}"), ends, curving.inflection(self.mechanism, link))
        for point in self.study.curving:
            drawn = {k: (one.centre, one.radius) for k in self.study.whole if (one := self.study.curvature(k, point))}
            yield from self._ended((f"O_{point}", f"ρ_{point}"), drawn, curving.centre(point))

    def _ended(self, names: tuple[str, str], drawn: dict[int, tuple[Mark, Mark]], theirs: Solved) -> Iterator[Quantity]:
        """Compare a centre, and how far it is from where its radius or its diameter begins."""
        centres = {k: both[0] for k, both in drawn.items()}
        yield self._place(names[0], centres, theirs)
        arms = {k: both[1] for k, both in drawn.items()}
        reach = theirs._replace(place=theirs.place - theirs.start, start=0.0)
        found = self._place(names[1], arms, reach)
        sizes = np.abs(found.construction), np.abs(found.analysis)
        yield Quantity.of((CENTRES, names[1], "m"), sizes, found.allowed)

    def rates(self) -> Iterator[Quantity]:
        """Compare the rates of the links."""
        for link in (n for n in sorted(self.mechanism.links) if n not in (FRAME, self.mechanism.drive.link)):
            ours, bound = np.full(self.count, np.nan), np.full(self.count, np.nan)
            for k, rates in self.read.items():
                if link in rates:
                    ours[k], read = rates[link]
                    bound[k] = 0.0 if read is None else read_bound(read).item()
            finding = next(row for row in self.motion.of(VELOCITIES.plan) if row.name == f"ω_{link}")
            theirs = np.where(np.isnan(ours), np.nan, finding.analysis)
            named, allowed = (CENTRES, f"ω_{link}", "rad/s"), bound + self.kappa * finding.largest
            yield Quantity.of(named, (ours, theirs), allowed, finding.largest)


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a centre in a position: P_02, P_13."""
    found = study.of(CentresStudy)
    if name in (curves := _curves(found, position_of(found.linkage, position))):
        return _explained(found, name, position_of(found.linkage, position), curves[name])
    named: dict[str, tuple[Pair, int]] = {letter(pair): (pair, FRAME) for pair in pairs(found.linkage.mechanism.links)}
    named |= {own(letter(pair), link): (pair, link) for pair in found.centrodes for link in pair if link != FRAME}
    if name not in named:
        every = *named, *curves
        return NoMark(every, message("mark.marks", marks=", ".join(every)), every[:1])
    wanted, (pair, link) = position_of(found.linkage, position), named[name]
    centre = found.at(wanted).found.get(pair)
    if centre is None:
        raise UnknownMark(message("mark.open_centre", mark=name, position=wanted))
    mark = centre.mark if link == FRAME else found.carried(wanted, pair, link)
    return _explained(found, name, wanted, mark)


def _explained(found: CentresStudy, name: str, wanted: int, mark: Mark) -> Explanation:
    heading, steps = title(found.linkage, name, wanted), tuple(behind(mark))
    return Explanation(heading, steps, {**UNITS, CENTRES: "m"}, (), POSITIONS.plan)


def _curves(found: CentresStudy, k: int) -> dict[str, Mark]:
    """Give the marks of curvature in a position by their letters."""
    circles = [circle for link in {*found.curving.values()} if (circle := found.inflection(k, link)) is not None]
    marks = [mark for circle in circles for mark in (circle.inflection, circle.diameter, circle.tangent)]
    marks += [mark for point in found.curving for mark in (found.curvature(k, point) or ())[:2]]
    return {mark.name: mark for mark in marks}
