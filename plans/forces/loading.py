"""Loading (нагружение): every load of a machine in each position, and the strokes over which loads change (ходы)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from plans.model.kinetostatics import Applied, Loading, Twist
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, OUTPUT, WORKING, Force, Machine, Moment, Spring, Track
from plans.model.mechanism import FRAME, Mechanism, Output, Parting, StructureError, Way, frame_way, output_way
from plans.model.motion import Complexes, Extremes, Floats, LinkMotion, Motion, PointMotion
from plans.words.words import Message, message

TURN = 2 * np.pi
# Up to kappa = 600 positions are graded, and the two roads agree in what a velocity is or where one is zero to
# 8 eps kappa2 of the largest, of an angle to that share of a turn (plans.quantity): less is zero, or the same.
KAPPA = 600.0
FIT = 0.01  # share of a stroke that a diagram's lengths may differ by: as exactly as strokes are read off drawings
ROUNDING = 8 * 2.0**-52 * KAPPA**2


class OutputStroke(NamedTuple):
    """The working and the idle stroke of an output over a turn of the crank (рабочий и холостой ход)."""

    begin: float  # rad: crank where the working stroke begins
    end: float  # rad: crank where it ends and the idle stroke begins
    sense: int  # of the crank's rotation: +1 counter-clockwise
    reach: tuple[float, float]  # output coordinate there: m along the guide, or rad of the link's +x axis
    link: int
    point: str = ""  # that slides
    way: Way | None = None  # the line of the frame that it slides along; None: the link swings, or parts
    parting: Parting | None = None  # from what the point is away

    @property
    def angles(self) -> tuple[float, float]:
        """The crank's angles rad over the working and over the idle stroke."""
        work = float(np.mod(self.sense * (self.end - self.begin), TURN))
        return work, TURN - work

    @property
    def output(self) -> Output:
        """What has the stroke."""
        return Output(self.link, self.point or None, parting=self.parting, along=self.way and self.way.direction)

    @property
    def sliding(self) -> bool:
        """Whether the output slides, on the frame or away from another point."""
        return self.way is not None or self.parting is not None

    def working(self, phi: Floats) -> npt.NDArray[np.bool_]:
        """Tell the crank angles of the working stroke; the extreme position from which it begins is of it.

        >>> OutputStroke(0.5, 4.0, 1, (0.0, 0.1), 3).working(np.array([0.5 - 1e-12, 1.0, 4.0, 6.0, 7.0])).tolist()
        [True, True, False, False, True]
        """
        slack = ROUNDING * TURN
        work = np.mod(self.sense * (self.end - self.begin), TURN)
        return np.asarray(np.mod(self.sense * (phi - self.begin) + slack, TURN) < work)

    def share(self, motion: Motion) -> Floats:
        """Give the share of the stroke between the place and that where the working stroke begins, NaN at gaps."""
        low, high = self.reach
        middle = (low + high) / 2
        if self.parting is not None:
            beyond = _away(self.parting, self.point, motion) - middle
        elif self.way is None:
            beyond = motion.links[self.link].angle - middle
            beyond -= TURN * np.round(beyond / TURN)
        else:
            r = motion.points[self.point].r - self.way.through
            beyond = (self.way.direction.conjugate() * r).real - middle
        return np.asarray(np.minimum(np.maximum(beyond / (high - low) + 0.5, 0.0), 1.0))


class NoStroke(StructureError):  # noqa: N818  (the exception tree's own word)
    """A load that changes over the stroke of a link or a point which has no two extreme positions."""

    def __init__(self, load: str, thing: Message) -> None:
        super().__init__(message("stroke.none", load=load, thing=thing))
        self.load, self.thing = load, thing


def _away(parting: Parting, point: str, motion: Motion) -> Floats:
    """Give how far m a point is from another along their line; NaN at gaps."""
    start, end = (motion.points[name].r for name in parting.line)
    along = (end - start).conj()
    with np.errstate(invalid="ignore"):  # a gap is NaN
        away = (along * (motion.points[point].r - motion.points[parting.other].r)).real / np.abs(along)
    return np.asarray(away)


class OtherStroke(StructureError):  # noqa: N818  (the exception tree's own word)
    """A diagram over lengths of another stroke than that of what it counts; `load` is the force that it is of."""

    def __init__(self, load: Force, why: Message) -> None:
        super().__init__(why)
        self.load = load


def asks(load: Force | Moment) -> bool:
    """Tell whether a load changes over a stroke."""
    changes = load.during != ALWAYS or load.overrun != (0.0, 0.0)
    return changes or (isinstance(load, Force) and load.diagram is not None)


def strokes(
    machine: Machine, mechanism: Mechanism, output: Output, extremes: Callable[[Output], Extremes | None]
) -> dict[Track, OutputStroke]:
    """Find the strokes that loads ask for; `extremes` is that of either road."""
    found: dict[Track, OutputStroke] = {}
    for load in machine.loads:
        if asks(load) and load.stroke not in found:
            shown = counted(mechanism, load, output)
            reached = extremes(shown) if shown else None
            if shown is None or reached is None or not (reached.sliding or reached.stroke < TURN):
                raise NoStroke(load.name, _thing(load.stroke, output))
            sense = -1 if mechanism.drive.omega < 0 else 1
            point, way = (shown.parting is None and output_way(mechanism, shown)) or ("", None)
            point = shown.point or point
            found[load.stroke] = OutputStroke(*reached.phi, sense, reached.reach, shown.link, point, way, shown.parting)
        if asks(load):
            _check_length(load, found[load.stroke], _thing(load.stroke, output))
    return found


def _check_length(load: Force | Moment, stroke: OutputStroke, thing: Message) -> None:
    if not isinstance(load, Force) or load.diagram is None or not load.diagram.length:
        return
    if not stroke.sliding:
        raise OtherStroke(load, message("stroke.swings", load=load.name, thing=thing))
    length, whole = load.diagram.length, abs(stroke.reach[1] - stroke.reach[0])
    if abs(whole - length) > FIT * whole:
        given, reached, off = (f"{1000 * size:.5g}" for size in (length, whole, abs(whole - length)))
        parts = {"load": load.name, "thing": thing, "length": given, "stroke": reached, "off": off}
        longer = length > whole
        raise OtherStroke(load, message("stroke.longer", **parts) if longer else message("stroke.shorter", **parts))


def counted(mechanism: Mechanism, load: Force | Moment, output: Output) -> Output | None:
    """Give the output whose stroke a load counts; None where its point has none."""
    track = load.stroke
    if track == OUTPUT:
        return output
    if track.parting is not None:
        return Output(load.link, track.point, track.working, track.parting)
    if track.along is not None:
        return Output(mechanism.link_of(track.point), track.point, track.working, along=track.along)
    shown = output_at(mechanism, track.point)
    return shown and shown._replace(working=track.working)


def _thing(track: Track, output: Output) -> Message:
    """Name what has a stroke, or none."""
    if track.parting is not None:
        return message("place.points", first=track.parting.other, second=track.point)
    return message("place.point", point=track.point) if track.point else message("place.link", link=output.link)


def output_at(mechanism: Mechanism, point: str) -> Output | None:
    """Give the link whose stroke is that of a point: one that slides on the frame, else swings about it; or none."""
    links = [link for link in sorted(mechanism.links) if link != FRAME and point in mechanism.links[link].points]
    sliding = [link for link in links if frame_way(mechanism, link)]
    fixed = mechanism.links[FRAME].points
    hung = [link for link in links if not fixed.keys().isdisjoint(mechanism.links[link].points)]
    return next((Output(link, point) for link in (*sliding, *hung)), None)


APART = 8 * 2.0**-52  # share of two places: points nearer to each other than their rounding are in one place


def loading(machine: Machine, motion: Motion, strokes: Mapping[Track, OutputStroke]) -> Loading:
    """Give all loads over the positions of a motion of order 2; NaN at gaps."""
    forces = [end for force in machine.forces for end in _acting(force, motion, strokes)]
    forces += [end for spring in machine.springs for end in _ends(spring, motion)]
    moments = tuple(Twist(m.name, m.link, _moment(m, motion, strokes), m.useful) for m in machine.moments)
    return Loading(tuple(forces), moments)


def _acting(force: Force, motion: Motion, strokes: Mapping[Track, OutputStroke]) -> Iterator[Applied]:
    """Give a force at its point, and of one between two links the opposite at the other, where that moves."""
    value = _force(force, motion, strokes)
    yield Applied(force.name, force.link, force.point, force.at, value, force.useful)
    if force.other is not None and force.other.link != FRAME:
        yield Applied(f"{force.name}′", *force.other, 0.0 - value, force.useful)  # of a zero no -0


def _force(force: Force, motion: Motion, strokes: Mapping[Track, OutputStroke]) -> Complexes:
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


def _moment(moment: Moment, motion: Motion, strokes: Mapping[Track, OutputStroke]) -> Floats:
    sense = -_sense(motion, moment.link) if moment.against else 1.0
    angle = motion.links[moment.link].angle
    return np.where(np.isnan(angle), np.nan, size_of(moment, motion, strokes) * sense + 0.0)


def carried(mechanism: Mechanism, motion: Motion, link: int, spot: complex) -> PointMotion:
    """Carry the motion of a link's first named point to a spot of the link, by its place in the link's own frame."""
    name, first = next(iter(mechanism.links[link].points.items()))
    turned, point = motion.links[link], motion.points[name]
    arm = (spot - first) * np.exp(1j * turned.angle)
    bent = point.a + (1j * turned.epsilon - turned.omega**2) * arm
    return PointMotion((point.r + arm, point.v + 1j * turned.omega * arm, bent))


def size_of(load: Force | Moment, motion: Motion, strokes: Mapping[Track, OutputStroke]) -> Floats:
    """Give the size of a load, N or N*m: nothing on a stroke that is not its own, nor in the overruns at the ends."""
    if not asks(load):
        return np.full(motion.phi.shape, load.size)
    stroke = strokes[load.stroke]
    share, working = stroke.share(motion), working_of(load, stroke, motion)
    size = np.full(share.shape, load.size)
    if isinstance(load, Force) and load.diagram is not None:
        travel, there, back, *_ = load.diagram
        size *= np.where(working, np.interp(share, travel, there), np.interp(share, travel, back or there))
    acts = (share >= load.overrun[0]) & (share <= 1 - load.overrun[1])
    if load.during != ALWAYS:
        acts &= working == (load.during in (WORKING, FORWARD))
    return np.where(acts | np.isnan(share), size + 0 * share, 0.0)


def working_of(load: Force | Moment, stroke: OutputStroke, motion: Motion) -> npt.NDArray[np.bool_]:
    """Tell the positions that a load counts as of the working stroke: by the crank, or by the way the output goes."""
    if load.during not in (FORWARD, BACKWARD):
        return stroke.working(motion.phi)
    sense = 1.0 if stroke.reach[1] > stroke.reach[0] else -1.0
    return np.asarray(sense * _going(stroke, motion) > 0)


def _going(stroke: OutputStroke, motion: Motion) -> Floats:
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
    steady = _largest(turned.omega for turned in links) ** 2  # rad/s2: what a crank gives that turns evenly
    return np.asarray(np.sign(_moving(omega, epsilon, links, steady)))


def _parting(motion: Motion, point: str, other: str, line: tuple[str, str]) -> Floats:
    """Give the sense +1 or -1 in which a point goes along a line from another; from a rest that in which it will.

    The line turns with the points: d2s/dt2 = a along it + its turning times v across it, from the other point.
    """
    moved, far, start, end = (motion.points[name] for name in (point, other, *line))
    apart, length = _apart(motion, line)
    with np.errstate(invalid="ignore"):  # a gap is NaN
        along = (apart / length).conj()
    v, turning = along * (moved.v - far.v), along * (end.v - start.v)
    growth = (along * (moved.a - far.a)).real + turning.imag / length * v.imag
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
    rests = np.abs(speed) <= ROUNDING * _largest(row[1] for row in motions)
    if not rests.any():
        return speed
    largest = max(usual, _largest(row[2] for row in motions))
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
