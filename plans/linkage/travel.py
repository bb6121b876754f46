"""The output's travel over the turn: its coordinate, where it rests, its extreme positions (перемещение, ход звена)."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from geometry.board import Mark, at
from geometry.branch import Side
from geometry.meet import dot
from plans.linkage.dyads import KINDS
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES, CrankPositions
from plans.linkage.sweep import FAN, LOOKS, NODES, Sweep, at_angles, changes_of_sign
from plans.model.dyad import Assur
from plans.model.mechanism import FRAME, SLOWER, Mechanism, Output, Parting, Slide, by_time, output_way, works
from plans.model.motion import Complexes, Extremes, Floats, Motion, PointMotion

# An output slower than this, m/s or rad/s with the crank at 1 rad/s, stands: what is left are roundings of a true zero.
STILL = 1e-12


def frame_slide(mechanism: Mechanism, link: int) -> Slide | None:
    """Give the slide of a link on the frame, if it has one."""
    return next((s for s in mechanism.slides if {s.slider, s.owner} == {link, FRAME}), None)


class OutputTravel:
    """The output's coordinate and velocity over the crank angle: along the frame's guide, or the output link's turn.

    Of an output that parts from another point it is the way between them along a line of points.
    """

    def __init__(self, sweep: Sweep, out: Output) -> None:
        self.sweep, self.out = sweep, out
        self.way = None if out.parting else output_way(sweep.mechanism, out)

    @property
    def sliding(self) -> bool:
        """Whether the output slides, on the frame or away from another point."""
        return self.way is not None or self.out.parting is not None

    def coordinate(self, turn: CrankPositions) -> Floats:
        """Read off the plan of positions: metres along the guide from its own point, or radians."""
        motion = self.sweep.motion(turn, 0)
        if self.out.parting is not None:
            apart, along = self._parting(self.out.parting, motion)
            return np.asarray(dot(along, apart.r))
        return self.rows(motion)[0]

    def speed(self, turn: CrankPositions) -> Floats:
        """Read off the velocity plan the output's velocity, or its omega."""
        motion = self.sweep.motion(turn, 1)
        if self.out.parting is not None:  # its point and the other are on the line, so that turning moves neither along
            apart, along = self._parting(self.out.parting, motion)
            return np.asarray(dot(along, apart.v))
        return self.rows(motion)[1]

    def rows(self, motion: Motion) -> tuple[Floats, ...]:
        """Read the coordinate off a motion, with its derivatives by time; of an output that parts from no other."""
        if self.way is None:
            return tuple(motion.links[self.out.link])
        name, way = self.way
        place, *rates = motion.points[name]
        return tuple(np.asarray(dot(way.direction, row)) for row in (place - way.through, *rates))

    def _parting(self, parting: Parting, motion: Motion) -> tuple[PointMotion, Complexes]:
        """Give place and velocity of the output's point from the other, and the unit direction of their line."""
        near, far = (motion.points[name] for name in (self.out.point or "", parting.other))
        start, end = (motion.points[name].r for name in parting.line)
        with np.errstate(invalid="ignore"):  # a gap is NaN
            along = (end - start) / np.abs(end - start)
        return PointMotion(place - other for place, other in zip(near, far, strict=False)), along

    @cached_property
    def path(self) -> tuple[Floats, Floats]:
        """The way over a turn: crank angles rad and the coordinate there, an angle unwrapped."""
        nodes = 2 * np.pi * np.arange(NODES + 1) / NODES
        along = self.coordinate(at_angles(nodes))
        return nodes, along if self.sliding else np.unwrap(along)

    @property
    def turns_fully(self) -> bool:
        """Whether a turn of the crank turns the output fully, though it may reverse on the way."""
        _, along = self.path
        return not self.sliding and bool(abs(along[-1] - along[0]) > np.pi)

    def rests(self) -> Floats:
        """Find the crank angles, rad in [0, 2 pi), in which the output stands: its velocity changes sign."""
        step = 2 * np.pi / NODES
        nodes = step * np.arange(NODES, dtype=np.float64)
        speeds = self.speed(at_angles(nodes))
        none = np.isnan(speeds)  # a change point that the linkage is carried through
        speeds = np.where(none, (np.roll(speeds, 1) + np.roll(speeds, -1)) / 2, speeds)
        if not np.abs(speeds).max() > STILL:
            return np.zeros(0)
        turns = np.flatnonzero((speeds >= 0) != (np.roll(speeds, -1) >= 0))  # the last node is followed by the first
        low, high = nodes[turns], nodes[turns] + step
        for between in self._touches(nodes, speeds):
            low, high = np.append(low, (between - step, between)), np.append(high, (between, between + step))
        return np.asarray(np.mod(changes_of_sign(lambda phi: self.speed(at_angles(phi)), low, high), 2 * np.pi))

    def _touches(self, nodes: Floats, speeds: Floats) -> list[float]:
        """Find where the speed goes through zero and back between two nodes: two rests less than a node apart."""
        before, after = np.roll(speeds, 1), np.roll(speeds, -1)
        sign = np.where(speeds >= 0, 1.0, -1.0)
        bend = sign * (before + after - 2 * speeds)
        with np.errstate(invalid="ignore", divide="ignore"):
            dip = np.abs(speeds) - np.where(bend > 0, (after - before) ** 2 / (8 * bend), 0.0)
        same = (sign * before > 0) & (sign * after > 0) & (np.abs(speeds) <= np.minimum(np.abs(before), np.abs(after)))
        found = (self._dips(nodes[k], sign[k]) for k in np.flatnonzero(same & (dip < np.abs(speeds) / 2)))
        return [place for place in found if place is not None]

    def _dips(self, node: float, sign: float) -> float | None:
        """Close in on the least speed about a node; None if it stays of one sign."""
        low, high = node - 2 * np.pi / NODES, node + 2 * np.pi / NODES
        for _ in range(LOOKS):
            fan = np.linspace(low, high, FAN)
            speeds = sign * self.speed(at_angles(fan))
            least = int(np.argmin(speeds))
            if speeds[least] < 0:
                return float(fan[least])
            low, high = fan[max(least - 1, 0)], fan[min(least + 1, FAN - 1)]
        return None


# A notched extreme and a velocity of zero are one position when their crank angles agree to half the digits: the
# coordinate of an extreme is stationary, so half its digits is all that a root found by its value could tell.
SAME = 1e-7
# Strokes whose crank arcs differ by less than this (rad) are equal: rounding of two notches, each with a root.
EQUAL = 1e-7
CLEAR = 64 * 2 * np.pi * np.finfo(float).eps  # rad: what roundings leave of an angle that is none
ANY_ANGLE = CrankPositions(np.zeros(1), np.ones(1, dtype=complex))  # a crank to draw extremes over: at any angle


class ExtremePositions(NamedTuple):
    """Extremes with the crank's directions there, for a turn that starts exactly at one of them."""

    extremes: Extremes
    directions: tuple[complex, complex]
    notched: Plan | None  # the construction that found them, None where the velocity plan did
    rests: tuple[float, ...]  # all crank angles, rad, in which the output reverses: more than two have no time ratio


def output(mechanism: Mechanism, groups: Sequence[Assur]) -> Output:
    """Give the output link: the scene's own, or the last link on the frame of the last group, or else its last link."""
    if mechanism.output is not None:
        return mechanism.output
    link = mechanism.drive.link
    if groups:
        link = max([lead for host, lead, _ in groups[-1].outer_pairs if host == FRAME] or groups[-1].links)
    slide = frame_slide(mechanism, link)
    return Output(link, slide.point if slide else None, mechanism.working)


def notches(mechanism: Mechanism, groups: Sequence[Assur], sides: Sequence[Side]) -> tuple[Plan, list[Mark]] | None:
    """Construct the crank's two extreme directions for the first group that joins crank and frame; None for others.

    The marks are the crank's end in both extremes.
    """
    for group, side in zip(groups, sides, strict=True):
        construct = KINDS[group.kind].extremes
        if construct is not None and {pair.giver for pair in group.outer_pairs} == {mechanism.drive.link, FRAME}:
            plan = PRIMARIES[mechanism.drive.kind].positions(mechanism, ANY_ANGLE)
            if marks := construct(plan, group, side):
                return plan, marks
    return None


def extremes(sweep: Sweep, out: Output) -> ExtremePositions | None:
    """Find the output's two extreme positions over a free turn; None where it has none, as a link that turns fully.

    The working stroke comes first (рабочий ход): that to which the crank gives the larger angle, or as the output says.
    """
    turns = out.link == sweep.mechanism.drive.link and out.parting is None and out.along is None
    if turns or not sweep.mechanism.drive.turns or sweep.barred:
        return None
    travel = OutputTravel(_resting(sweep), out)
    rests = travel.rests()
    if len(rests) < 2 or travel.turns_fully:
        return None
    drawn = notches(sweep.mechanism, sweep.groups, sweep.sides)
    directions = [_notched(drawn, rest) for rest in rests.tolist()]
    exact = CrankPositions(rests, np.array([d for d, _ in directions]))
    reach = _reaches(travel, exact)
    if not np.isfinite(reach).all():  # a pin in the pivot of its slot: crank and frame are equal
        return None
    places: list[float] = rests.tolist()
    low, high = _farthest(places, -reach), _farthest(places, reach)
    if not reach[low] < reach[high]:
        return None
    order = _slower(places, low, high, sweep.mechanism.drive.omega)
    phi = [_cleared(float(np.angle(exact.directions[k]) % (2 * np.pi))) for k in order]
    sense = -1.0 if sweep.mechanism.drive.omega < 0 else 1.0
    more = (sense * (phi[1] - phi[0])) % (2 * np.pi) - np.pi
    back = _turned(sweep.mechanism, out, [float(reach[k]) for k in order], equal=more < EQUAL)
    first, second = order[::-1] if back else order
    begun = (phi[1], phi[0]) if back else (phi[0], phi[1])
    reached = float(reach[first]), float(reach[second])
    found = Extremes(begun, reached, travel.sliding, _cleared(max(more, 0.0)), back and more >= EQUAL)
    by_notch = drawn[0] if drawn and all(directions[k][1] for k in (first, second)) else None
    ends = complex(exact.directions[first]), complex(exact.directions[second])
    return ExtremePositions(found, ends, by_notch, tuple(places))


def _resting(sweep: Sweep) -> Sweep:
    """Give the crank a speed: extremes are the same at any speed, and must be found at rest too."""
    mechanism = sweep.mechanism
    if abs(mechanism.drive.omega) == 1:
        return sweep
    return sweep.over(replace(mechanism, drive=mechanism.drive._replace(omega=1.0, epsilon=0.0)))


def _notched(drawn: tuple[Plan, list[Mark]] | None, rest: float) -> tuple[complex, bool]:
    """Give the crank's direction at a rest: the notched one where it is the same position."""
    if drawn is not None:
        plan, marks = drawn
        pivot = plan.point(plan.mechanism.drive.pivot)
        for mark in marks:
            ray = at(mark.point, 0) - at(pivot.point, 0)
            direction = ray / abs(ray)
            if abs(np.angle(direction * np.exp(-1j * rest))) < SAME:
                return direction, True
    return complex(np.exp(1j * rest)), False


def _reaches(travel: OutputTravel, turn: CrankPositions) -> Floats:
    """Give the output's coordinate at some crank positions, angles unwrapped along the turn."""
    reach = travel.coordinate(turn)
    if travel.sliding:
        return reach
    near = np.interp(np.mod(turn.phi, 2 * np.pi), *travel.path)
    return np.asarray(near + np.angle(np.exp(1j * (reach - near))))


def _turned(mechanism: Mechanism, out: Output, reach: Sequence[float], equal: bool) -> bool:
    """Tell whether the working stroke is not the slower one, by its two coordinates; of equal ones time tells none."""
    if by_time(out):
        return out.working != SLOWER and not equal
    return not works(mechanism, out, *reach)


def _slower(rests: list[float], low: int, high: int, omega: float) -> tuple[int, int]:
    """Order two rests so that the crank turns through the larger angle from the first to the second."""
    sense = -1.0 if omega < 0 else 1.0
    there = (sense * (rests[high] - rests[low])) % (2 * np.pi)
    if abs(there - np.pi) < EQUAL:  # equal strokes: begin where the crank angle is the smaller
        return (low, high) if _within(rests[low]) < _within(rests[high]) else (high, low)
    return (low, high) if there > np.pi else (high, low)


def _farthest(rests: list[float], reach: Floats) -> int:
    """Give the rest of the greatest reach; of several within their rounding, the first of the turn."""
    most = float(reach.max()) - EQUAL * float(np.ptp(reach))
    return min((k for k in range(len(rests)) if reach[k] >= most), key=lambda k: _within(rests[k]))


def _within(angle: float) -> float:
    """Count an angle that a rounding leaves short of a whole turn as zero."""
    return 0.0 if 2 * np.pi - angle < EQUAL else angle


def _cleared(angle: float) -> float:
    """Count an angle that roundings leave beside nothing or beside a whole turn as zero."""
    return 0.0 if min(angle, 2 * np.pi - angle) <= CLEAR else angle


def other_sliders(mechanism: Mechanism, output: Output) -> list[Slide]:
    """List the slides of links on the frame but for the output's and the primary link's."""
    known = {frame_slide(mechanism, link) for link in (output.link, mechanism.drive.link)}
    return [slide for slide in mechanism.slides if slide.owner == FRAME and slide not in known]


def other_strokes(sweep: Sweep, output: Output) -> dict[Slide, ExtremePositions]:
    """Find the extreme positions of each such slider, of which it has any."""
    if not sweep.mechanism.drive.turns:
        return {}
    sliders = other_sliders(sweep.mechanism, output)
    found = {slide: extremes(sweep, Output(slide.slider, slide.point)) for slide in sliders}
    return {slide: ends for slide, ends in found.items() if ends is not None}
