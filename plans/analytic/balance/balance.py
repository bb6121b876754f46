"""A mechanism balanced by analysis: counterweights, the machine before and after, the share (уравновешивание)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np

from plans.analytic.balance.counterweights import Course, FoundWeights, carrying, counterweights, shared, sought, state
from plans.analytic.balance.mass_centre import bodies, mass_centre
from plans.model.balance.linkage import (
    ANALYSIS,
    EPS,
    NONE,
    ROUNDING,
    SHARE,
    SHARES,
    Balance,
    BalanceTask,
    Choice,
    Counterweight,
    Shares,
)
from plans.model.dyad import Assur, pair
from plans.model.machine import GEAR
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats

STRAIGHT = 64.0  # so many eps of the largest are what three force analyses differ by where the forces are straight

Forces = Callable[[float], Complexes]  # of a share to the forces N in all positions


class Weighing:
    """Shares of the reciprocating mass, weighed by the shaking force and by the reaction of the shaft.

    `partial` are the counterweights at share 0; with the share the crank's loses the static moment `step` kg*m.
    """

    def __init__(self, course: Course, partial: Sequence[Counterweight], step: complex) -> None:
        before = mass_centre(course.mechanism, bodies(course.machine, partial), course.turn).force
        given = step * _turning(course)
        self.forces: Forces = lambda share: np.asarray(before + share * given)
        self.reactions = _bearing(course, partial, step)
        self.lightest = _lightest(course, partial, step)

    def force(self, share: float) -> float:
        """Give the largest shaking force N of a share."""
        return _largest(self.forces(share))

    def reaction(self, share: float) -> float:
        """Give the largest reaction N of the shaft of a share."""
        return _largest(self.reactions(share))

    def choice(self, share: float) -> Choice:
        """Weigh a share."""
        return Choice(share, self.force(share), self.reaction(share))

    @property
    def shares(self) -> Shares:
        """The curve, and the two best."""
        curve = tuple(self.choice(float(share)) for share in np.linspace(0, 1, SHARES))
        return Shares(curve, self.choice(least(self.forces)), self.choice(least(self.reactions, self.lightest)))


def shifted(course: Course, partial: Sequence[Counterweight], step: complex, share: float) -> tuple[Counterweight, ...]:
    """Give the counterweights at a share of the reciprocating mass."""
    crank = course.mechanism.drive.link
    return tuple(_less(weight, share * step) if weight.link == crank else weight for weight in partial)


def _less(weight: Counterweight, given: complex) -> Counterweight:
    """Take a static moment kg*m off a counterweight; a difference within rounding is none."""
    left = weight.moment - given
    return carrying(weight, 0j if abs(left) <= ROUNDING * EPS * abs(given) else left)


def _largest(forces: Complexes) -> float:
    return float(np.fmax.reduce(np.abs(forces)))


def _turning(course: Course) -> Complexes:
    """Give the acceleration m/s2 of a point of the crank 1 m from its shaft, in the crank's own frame."""
    turn, omega, epsilon = course.turn.links[course.mechanism.drive.link]
    return np.asarray((1j * epsilon - omega**2) * np.exp(1j * turn))


def _bearing(course: Course, partial: Sequence[Counterweight], step: complex) -> Forces:
    """Give the shaft's reaction on the crank of a share: without the crank's counterweight, and what that one adds.

    Forces add up but for what teeth press the shafts apart with: that has one sense, whichever flank bears.
    """
    drive, how = course.mechanism.drive, course.machine.transmission
    apart = np.exp(1j * how.at) * math.tan(how.pressure) / how.radius if how.kind == GEAR else 0.0
    course = replace(course, machine=replace(course.machine, transmission=how._replace(pressure=0.0)))
    key = pair(FRAME, drive.link, drive.pivot).key
    bare = course.forces([weight for weight in partial if weight.link != drive.link])
    without, asked = bare.reactions[key].force, bare.balancing.moment
    twisted = course.twisted().reactions[key].force
    turning, gravity = _turning(course), course.machine.gravity
    turn, epsilon = np.exp(1j * course.turn.links[drive.link].angle), course.turn.links[drive.link].epsilon

    def reaction(share: float) -> Complexes:
        (weight,) = (weight for weight in shifted(course, partial, step, share) if weight.link == drive.link)
        about = weight.inertia + weight.mass * weight.distance**2 if weight.needed else 0.0
        moment = (np.conj(weight.moment * turn) * gravity).imag - about * epsilon
        added = weight.moment * turning - weight.mass * gravity + moment * twisted
        return np.asarray(without + added + apart * np.abs(asked - moment))

    return reaction


def _lightest(course: Course, partial: Sequence[Counterweight], step: complex) -> tuple[float, ...]:
    """Give the share at which a crank's counterweight whose mass follows is lightest: the weights bend there."""
    crank = next(weight for weight in partial if weight.link == course.mechanism.drive.link)
    if crank.place.mass is not None or not step:
        return ()
    share = (crank.moment * step.conjugate()).real / abs(step) ** 2
    return (share,) if 0 < share < 1 else ()


def least(forces: Forces, bends: tuple[float, ...] = ()) -> float:
    """Find the share in [0, 1] whose largest force is least, on either side of its bends; 0 where there is none."""
    if np.isnan(_largest(forces(0.0))):  # a mechanism that cannot be assembled
        return 0.0
    ends, middle = (forces(0.0), forces(1.0)), forces(0.5)
    most = max(_largest(end) for end in ends)
    if _largest((ends[0] + ends[1]) / 2 - middle) <= STRAIGHT * EPS * most:
        start = forces(0.0)
        return lowest(start, forces(1.0) - start)
    sides = pairwise((0.0, *bends, 1.0))
    return min((_valley(forces, *side) for side in sides), key=lambda share: _largest(forces(share)))


def _valley(forces: Forces, start: float, end: float) -> float:
    """Find the lowest place between two shares, by a row of them and golden sections."""
    between = np.linspace(0, 1, SHARES)
    row = np.array([start, *between[(between > start) & (between < end)], end])
    best = int(np.argmin([_largest(forces(float(share))) for share in row]))
    low, high = row[max(best - 1, 0)], row[min(best + 1, len(row) - 1)]
    return _golden(lambda share: _largest(forces(share)), float(low), float(high))


def _golden(height: Callable[[float], float], low: float, high: float) -> float:
    """Close in on the lowest place of a valley by golden sections (золотое сечение)."""
    section = (math.sqrt(5) - 1) / 2
    places = [high - section * (high - low), low + section * (high - low)]
    heights = [height(place) for place in places]
    while high - low > 4 * EPS:
        if heights[0] <= heights[1]:
            high, places = places[1], [places[1] - section * (places[1] - low), places[0]]
            heights = [height(places[0]), heights[0]]
        else:
            low, places = places[0], [places[1], places[0] + section * (high - places[0])]
            heights = [heights[1], height(places[1])]
    return min((low, *places, high), key=height)


def lowest(start: Complexes, slope: Complexes) -> float:
    """Find the share in [0, 1] whose largest |F0 + k F1| is least."""
    known = np.flatnonzero(np.isfinite(start))
    start, slope = start[known], slope[known]
    chosen = [int(np.argmax(np.abs(start)))]
    while True:
        best = _lowest_of(start[chosen], slope[chosen])
        highest = int(np.argmax(np.abs(start + best * slope)))
        if highest in chosen:
            return best
        chosen.append(highest)


def _lowest_of(start: Complexes, slope: Complexes) -> float:
    """Take the lowest of where the envelope of a few parabolas can be lowest: ends, bottoms, meetings."""
    # The parabolas are |F0|^2 + 2 k F0.F1 + k^2 |F1|^2.
    rows = np.stack([np.abs(slope) ** 2, 2 * (start.conj() * slope).real, np.abs(start) ** 2], axis=1)
    meetings = [root for row, other in combinations(rows, 2) for root in _roots(*(row - other)) if np.isfinite(root)]
    points = np.clip([0.0, 1.0, *_bottoms(start, slope), *meetings], 0.0, 1.0)
    return float(points[int(np.argmin(np.abs(start[:, None] + slope[:, None] * points).max(axis=0)))])


def _bottoms(start: Complexes, slope: Complexes) -> Floats:
    moving = np.abs(slope) > 0
    start, slope = start[moving], slope[moving]
    return np.asarray(-(start.conj() * slope).real / np.abs(slope) ** 2)


def _roots(a: float, b: float, c: float) -> list[float]:
    """Solve a k^2 + b k + c = 0 without loss of digits."""
    under = b * b - 4 * a * c
    if under < 0:
        return []
    q = -(b + np.copysign(np.sqrt(under), b)) / 2
    with np.errstate(divide="ignore", invalid="ignore"):
        return [float(np.divide(q, a)), float(np.divide(c, q))]


def balance(course: Course, task: BalanceTask, groups: Sequence[Assur], share: float | None = None) -> Balance:
    """Balance a mechanism; a `share` that is given is taken for one that the task seeks."""
    mechanism = course.mechanism
    before = state(course)
    if task.aim == NONE:
        return Balance(ANALYSIS, task, (), {}, before, None, None, course.motion.gaps)
    found = counterweights(mechanism, course.machine, sought(mechanism, groups, task))
    found, chosen = _chosen(course, task, found, share)
    after = replace(state(course, found.counterweights), beside=before.forces.largest)
    return Balance(ANALYSIS, task, found.counterweights, found.left, before, after, chosen, course.motion.gaps)


def weighing(course: Course, found: FoundWeights) -> Weighing:
    """Weigh shares of the reciprocating mass, from the counterweights that leave all of it."""
    return Weighing(course, found.counterweights, shared(course.mechanism, found.left))


def _chosen(
    course: Course, task: BalanceTask, found: FoundWeights, share: float | None
) -> tuple[FoundWeights, Shares | None]:
    """Take the share of the reciprocating mass that is asked for, off the crank's counterweight."""
    if task.aim != SHARE:
        return found, None
    shares = weighing(course, found).shares
    taken = next(value for value in (share, task.share, shares.best(task.least).share) if value is not None)
    step = shared(course.mechanism, found.left)
    return replace(found, counterweights=shifted(course, found.counterweights, step, taken)), shares
