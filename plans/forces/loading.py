"""Loading (нагружение): every load of a machine in each position of a motion, whichever road found it."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from plans.forces.stroke import KAPPA, ROUNDING, Stroke, asks
from plans.model.kinetostatics import Applied, Loading, Twist
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, WORKING, Force, Machine, Moment, Spring, Track
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats, LinkMotion, Motion, PointMotion

APART = 8 * 2.0**-52  # share of two places: points nearer to each other than their rounding are in one place


def loading(machine: Machine, motion: Motion, strokes: Mapping[Track, Stroke]) -> Loading:
    """Give all loads over the positions of a motion of order 2; NaN at gaps."""
    forces = [end for force in machine.forces for end in _acting(force, motion, strokes)]
    forces += [end for spring in machine.springs for end in _ends(spring, motion)]
    moments = tuple(
        Twist(moment.name, moment.link, _moment(moment, motion, strokes), moment.useful) for moment in machine.moments
    )
    return Loading(tuple(forces), moments)


def _acting(force: Force, motion: Motion, strokes: Mapping[Track, Stroke]) -> Iterator[Applied]:
    """Give a force at its point, and of one between two links the opposite at the other, where that moves."""
    value = _force(force, motion, strokes)
    yield Applied(force.name, force.link, force.point, force.at, value, force.useful)
    if force.other is not None and force.other.link != FRAME:
        yield Applied(f"{force.name}′", *force.other, 0.0 - value, force.useful)  # of a zero no -0


def _force(force: Force, motion: Motion, strokes: Mapping[Track, Stroke]) -> Complexes:
    r = motion.points[force.point].r
    course = _direction(force, motion)
    return np.where(np.isnan(r), np.nan, size_of(force, motion, strokes) * course + 0.0)  # of a zero no -0


def _direction(force: Force, motion: Motion) -> Any:
    """Give the unit direction of a force; 0 where what it acts against does not move."""
    if force.direction is not None:
        return force.direction
    if force.line is None:
        return -_course(motion, force.point)
    apart, length = _apart(motion, force.line)
    with np.errstate(invalid="ignore"):  # a gap is NaN
        along = apart / length
    if force.other is None or not force.resists:
        return along
    return -_parting(motion, force.point, force.other.point, force.line) * along


def _moment(moment: Moment, motion: Motion, strokes: Mapping[Track, Stroke]) -> Floats:
    sense = -_sense(motion, moment.link) if moment.against else 1.0
    angle = motion.links[moment.link].angle
    return np.where(np.isnan(angle), np.nan, size_of(moment, motion, strokes) * sense + 0.0)


def size_of(load: Force | Moment, motion: Motion, strokes: Mapping[Track, Stroke]) -> Floats:
    """Give the size of a load, N or N*m: nothing on a stroke that is not its own, nor in the overruns at the ends."""
    if not asks(load):
        return np.full(motion.phi.shape, load.size)
    stroke = strokes[load.stroke]
    share, working = stroke.share(motion), working_of(load, stroke, motion)
    size = np.full(share.shape, load.size)
    if isinstance(load, Force) and load.diagram is not None:
        travel, there, back, _ = load.diagram
        size *= np.where(working, np.interp(share, travel, there), np.interp(share, travel, back or there))
    acts = (share >= load.overrun[0]) & (share <= 1 - load.overrun[1])
    if load.during != ALWAYS:
        acts &= working == (load.during in (WORKING, FORWARD))
    return np.where(acts | np.isnan(share), size + 0 * share, 0.0)


def working_of(load: Force | Moment, stroke: Stroke, motion: Motion) -> npt.NDArray[np.bool_]:
    """Tell the positions that a load counts as of the working stroke: by the crank, or by the way the output goes."""
    if load.during not in (FORWARD, BACKWARD):
        return stroke.working(motion.phi)
    sense = 1.0 if stroke.reach[1] > stroke.reach[0] else -1.0
    return np.asarray(sense * _going(stroke, motion) > 0)


def _going(stroke: Stroke, motion: Motion) -> Floats:
    """Give the sense in which the coordinate of a stroke changes; from a rest that in which it will."""
    if stroke.parting is not None:
        return _parting(motion, stroke.point, stroke.parting.other, stroke.parting.line)
    if stroke.way is None:
        return _sense(motion, stroke.link)
    along, (_, v, a) = stroke.way.direction.conjugate(), motion.points[stroke.point]
    return np.asarray(np.sign(_moving((along * v).real, (along * a).real, motion.points.values())))


def _course(motion: Motion, point: str) -> Complexes:
    """Give the unit direction in which a point moves, from a rest that in which it will; 0 where it stands for good."""
    _, v, a = motion.points[point]
    along = _moving(v, a, motion.points.values())
    speed = np.abs(along)
    with np.errstate(invalid="ignore"):  # a gap is NaN
        return np.asarray(along / np.where(speed == 0, 1, speed))


def _sense(motion: Motion, link: int) -> Floats:
    """Give the sense in which a link turns, +1 counter-clockwise, from a rest that in which it will."""
    _, omega, epsilon = motion.links[link]
    links = motion.links.values()
    steady = _largest(one.omega for one in links) ** 2  # rad/s2: what a crank gives that turns evenly
    return np.asarray(np.sign(_moving(omega, epsilon, links, steady)))


def _parting(motion: Motion, point: str, other: str, line: tuple[str, str]) -> Floats:
    """Give the sense +1 or -1 in which a point goes along a line from another; from a rest that in which it will.

    The line turns with the points: d2s/dt2 = a along it + its turning times v across it, from the other point.
    """
    own, far, start, end = (motion.points[name] for name in (point, other, *line))
    apart, length = _apart(motion, line)
    with np.errstate(invalid="ignore"):  # a gap is NaN
        along = (apart / length).conj()
    v, turning = along * (own.v - far.v), along * (end.v - start.v)
    growth = (along * (own.a - far.a)).real + turning.imag / length * v.imag
    return np.asarray(np.sign(_moving(v.real, growth, motion.points.values())))


def _apart(motion: Motion, points: tuple[str, str]) -> tuple[Complexes, Floats]:
    """Give the way m from one point to another, and its length, NaN where both are in one place: it has no line."""
    first, second = (motion.points[point].r for point in points)
    apart = second - first
    return apart, np.where(np.abs(apart) <= APART * (np.abs(first) + np.abs(second)), np.nan, np.abs(apart))


def _moving(speed: Any, growth: Any, motions: Collection[PointMotion | LinkMotion], usual: float = 0.0) -> Any:
    """Give a velocity; where it is zero but for rounding, the acceleration, to which the next velocity is parallel.

    Rounding is that of the largest velocity and the largest acceleration, which is the usual one or more.
    """
    rests = np.abs(speed) <= ROUNDING * _largest(one[1] for one in motions)
    if not rests.any():
        return speed
    largest = max(usual, _largest(one[2] for one in motions))
    stays = np.abs(growth) <= KAPPA * ROUNDING * largest  # kappa once more for every order
    return np.where(rests, np.where(stays, 0.0, growth), speed)


def _largest(rows: Iterable[Any]) -> float:
    """Give the largest of some vectors over all positions: what is less than its rounding is zero."""
    return max((float(np.fmax.reduce(np.abs(row), initial=0.0)) for row in rows), default=0.0)


def _ends(spring: Spring, motion: Motion) -> Iterator[Applied]:
    """Give the force at each end of a spring that moves: along the line of its ends, to the other end where it pulls.

    Ends in one place have no line: only a spring without free length then has a force, none.
    """
    apart, length = _apart(motion, spring.points)
    stretched = 1.0 - spring.free / length if spring.free else 1.0
    pull = spring.stiffness * stretched * apart
    moving = [k for k in (0, 1) if spring.links[k] != FRAME]
    for k in moving:
        name = spring.name + ("′" if k != moving[0] else "")
        yield Applied(name, spring.links[k], spring.points[k], spring.at[k], np.asarray((pull, -pull)[k]), False)
