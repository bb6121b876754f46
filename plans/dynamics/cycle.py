"""The works of a steady turn by graphical integration (M4.7, figure 6.6); the flywheel by other methods (M4.10)."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Board, Mark
from geometry.calculus import Integral, integral
from geometry.strips import middles, strips
from plans.dynamics.reduction import Reducing, Reduction
from plans.dynamics.touch import touched
from plans.forces.loading import ROUNDING, OutputStroke, asks, working_of
from plans.linkage.sweep import NODES, at_angles, changes_of_sign
from plans.model.dynamics import CHOSEN, CONSTRUCTION, TURN, Cycle, Methods, Rim, Task, Wheel, settled
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, WORKING, Force, Moment
from plans.model.motion import Floats, LinkMotion, Motion, PointMotion
from plans.words.calculus import REASONS
from plans.words.words import because


def rim_of(inertia: float, rim: Rim) -> Wheel | None:
    """Size the rim of a flywheel of kg*m2 at the crank's shaft; None without a flywheel.

    The ring is thin: J = rho pi D s (D/2)^2 of a section s, on a shaft that turns u times as fast J/u^2.
    """
    if not inertia > 0:
        return None
    on_shaft = inertia / rim.ratio**2
    thin = 4 * on_shaft / (rim.density * math.pi * rim.breadth * CHOSEN**2)  # D^5 of a rim that is just thin
    diameter = rim.sized(thin**0.2)
    around = rim.density * math.pi * diameter  # kg for a square metre of the section
    section = on_shaft / (around * (diameter / 2) ** 2)
    breadth = math.sqrt(section * rim.breadth)
    return Wheel(on_shaft, diameter, around * section, section / breadth, breadth, rim.ratio)


def methods(cycle: Cycle, task: Task) -> Methods | None:
    """Find J0 by each method; None where no fluctuation is asked for.

    Mertsalov's curve is the energy of all that turns evenly, were the links to move at the mean speed. Gutyar's has
    the greatest speed in it where it is highest and the least where it is lowest. The book leaves delta^2 out.
    """
    if not task.delta:
        return None
    square, delta = task.speed**2, task.delta
    gutyar = _range(cycle, *((1 + s * delta / 2) ** 2 * square / 2 for s in (-1, 1)))
    book = _range(cycle, (1 - delta) * square / 2, (1 + delta) * square / 2)
    touches = touched(cycle, square / 2, -1), touched(cycle, square / 2, 1)
    whole = touches[1].above(square / 2) - touches[0].above(square / 2)
    over = square * delta
    return Methods(book / over, whole / over, gutyar / over, whole, touches)


def _range(cycle: Cycle, low: float, high: float) -> float:
    """Give the range of energy of what turns evenly, J, the links at half the squares of two speeds at its ends."""
    return touched(cycle, high, 1).above(high) - touched(cycle, low, -1).above(low)


# Two breaks are one if they are nearer than an extreme is known by its notch or a root: half the digits of an angle.
SAME = 1e-7

Height = Callable[[Motion], Floats]


class Level(NamedTuple):
    """What changes its sign at a break, and the load over a stroke that changes there, if it acts there."""

    height: Height
    load: Force | Moment | None = None
    stroke: OutputStroke | None = None
    point: str = ""  # that must be at rest there, and not only go square to the way that it had before

    def counts(self, motion: Motion) -> npt.NDArray[np.bool_]:
        """Tell at which positions of a motion the load changes: not on the stroke on which it rests."""
        found = np.ones(len(motion.phi), dtype=bool)
        if self.load is not None and self.stroke is not None and self.load.during != ALWAYS:
            found &= working_of(self.load, self.stroke, motion) == (self.load.during in (WORKING, FORWARD))
        if self.point:
            fastest = max(float(np.nanmax(np.abs(point.v), initial=0.0)) for point in motion.points.values())
            found &= np.abs(motion.points[self.point].v) <= ROUNDING * fastest
        return found


def breaks(reduction: Reduction) -> Floats:
    """Give the angles turned since position 0, rad in [0, 2 pi), at which the reduced moment jumps or bends."""
    zeros = _within([place for level in _levels(reduction) for place in _zeros(reduction, level)])
    # An extreme position is known to half its digits: where a point reverses there, its own zero is known better.
    ends = [end for end in _within(_ends(reduction)) if np.all(np.abs(np.angle(np.exp(1j * (zeros - end)))) > SAME)]
    return _distinct(np.append(zeros, ends))


def _within(places: Iterable[float]) -> Floats:
    """Bring angles into one turn."""
    return np.asarray(np.mod(np.array([*places], dtype=np.float64), TURN))


def _ends(reduction: Reduction) -> Iterator[float]:
    """Give the ends of all strokes over which a load changes."""
    sense = reduction.study.sense
    for stroke in reduction.statics.strokes.values():
        yield from (sense * (end - reduction.start) for end in (stroke.begin, stroke.end))


def _levels(reduction: Reduction) -> Iterator[Level]:
    machine, strokes = reduction.statics.machine, reduction.statics.strokes
    loads: tuple[Force | Moment, ...] = (*machine.forces, *machine.moments)
    for load in loads:
        if asks(load):
            stroke = strokes[load.stroke]
            yield from (Level(_passing(stroke, share), load, stroke) for share in _shares(load))
            if load.during in (FORWARD, BACKWARD):
                yield Level(_going(stroke))
        if isinstance(load, Moment) and load.against:
            yield Level(_turning(load.link))
        if isinstance(load, Force) and load.resists and load.other is not None and load.line is not None:
            yield Level(_away(load.point, load.other.point, load.line))
        elif isinstance(load, Force) and load.direction is None and load.line is None:
            yield from _moving(reduction, load.point)


def _shares(load: Force | Moment) -> list[float]:
    """Give the shares of the stroke, inside it, at which a load changes its course."""
    begin, end = load.overrun
    places = {begin, 1.0 - end, *(load.diagram.travel if isinstance(load, Force) and load.diagram else ())}
    return sorted(place for place in places if 0.0 < place < 1.0)


def _going(stroke: OutputStroke) -> Height:
    """Tell how fast the coordinate of a stroke changes: its zero is known better than an end, by all its digits."""
    if stroke.parting is not None:
        return _away(stroke.point, stroke.parting.other, stroke.parting.line)
    if stroke.way is None:
        return _turning(stroke.link)
    return _along(stroke.point, stroke.way.direction)


def _passing(stroke: OutputStroke, share: float) -> Height:
    return lambda motion: stroke.share(motion) - share


def _turning(link: int) -> Height:
    return lambda motion: _without_rounding(motion.links[link].omega, motion.links.values())


def _away(point: str, far: str, line: tuple[str, str]) -> Height:
    """Tell the speed at which a point goes away from another along a line that both lie on."""
    start, end = line

    def height(motion: Motion) -> Floats:
        along = motion.points[end].r - motion.points[start].r
        with np.errstate(invalid="ignore"):  # a gap is NaN, and so is the way between points that coincide
            parting = np.asarray((along.conj() * (motion.points[point].v - motion.points[far].v)).real / np.abs(along))
        return _without_rounding(parting, motion.points.values())

    return height


def _without_rounding(speed: Floats, motions: Collection[PointMotion | LinkMotion]) -> Floats:
    """Give no speed at all where it is but rounding over the whole turn: what does not move does not reverse."""
    fastest = max(float(np.nanmax(np.abs(motion[1]), initial=0.0)) for motion in motions)
    return speed if np.nanmax(np.abs(speed), initial=0.0) > ROUNDING * fastest else np.zeros_like(speed)


def _moving(reduction: Reduction, point: str) -> Iterator[Level]:
    """Tell where a point reverses: its speed along the way that it had a node before changes its sign."""
    speed = _motion(reduction, TURN * np.arange(NODES) / NODES).points[point].v
    with np.errstate(invalid="ignore"):
        turns = np.flatnonzero((speed.conj() * np.roll(speed, -1)).real < 0)
    for way in {complex(np.round(speed[k] / np.abs(speed[k]), 6)) for k in turns}:
        yield Level(_along(point, way), point=point)


def _along(point: str, way: complex) -> Height:
    return lambda motion: np.asarray((way.conjugate() * motion.points[point].v).real)


def _motion(reduction: Reduction, turned: Floats) -> Motion:
    return reduction.sweep.motion(at_angles(reduction.start + reduction.study.sense * turned), 2)


def _zeros(reduction: Reduction, level: Level) -> Floats:
    """Close in on all changes of sign of a level over the turn, by fans of crank angles between two neighbours."""
    step = TURN / NODES
    # Between the nodes of a turn that begins beside position 0: a break at position 0 itself is between two of them.
    nodes = np.asarray(step * (np.arange(NODES + 1) - 0.5), dtype=np.float64)
    above = level.height(_motion(reduction, nodes)) >= 0
    low = nodes[:-1][above[1:] != above[:-1]]
    found = changes_of_sign(lambda turned: level.height(_motion(reduction, turned)), low, low + step)
    return found[level.counts(_motion(reduction, found))]


def _distinct(places: Floats) -> Floats:
    """Leave one of each that are the same; one that a rounding leaves short of a whole turn is at its beginning."""
    within = np.sort(np.where(TURN - places < SAME, 0.0, places))
    kept = [place for before, place in pairwise([-TURN, *within.tolist()]) if place - before > SAME]
    return np.array(kept, dtype=np.float64)


WORKS = "works"
# Both sides of a jump are read off plans beside it, at this part of a strip, at twice and thrice it, and carried on to
# the edge: what that leaves out is the cube of the part, far below the width of any line, and rounding grows by seven.
BESIDE = 2.0**-20
# rad: what a stroke takes for its end, four times over; a position nearer to an edge may count as of the other stroke.
APART = 4 * ROUNDING * TURN


@dataclass(frozen=True)
class WorkDiagram:
    """The curve of work by chords, the straight line of the drive's work, and what the strips are made of."""

    curve: Integral
    drive: Mark  # the straight line of the work that the drive must give, or what an engine drives takes
    cycle: Cycle
    middle: Reducing  # the levers at the middles of the strips
    edge: Reducing  # and at their edges
    bent: Floats  # (n, 2) N*m: by how much those at the edges may be off, as they were carried on
    loads: Floats  # (n, 2) N*m: what the cycle's moments are without the weights

    @property
    def board(self) -> Board:
        """The board that they are drawn on."""
        return self.curve.board


class SteadyStrips:
    """A steady turn of the crank in strips, with what is reduced to the crank in them."""

    def __init__(self, reduction: Reduction, divisions: int) -> None:
        self.reduction, self.divisions = reduction, divisions

    @cached_property
    def breaks(self) -> Floats:
        """Where the reduced moment jumps or bends."""
        return breaks(self.reduction)

    @cached_property
    def edges(self) -> Floats:
        """The edges of the strips: equal ones, and one on every break."""
        return strips(0.0, TURN, self.divisions, self.breaks)

    @cached_property
    def works(self) -> WorkDiagram:
        """Draw the curve of work from the moments at the middles of all strips."""
        middle, edge = self.reduction.at(middles(self.edges)), self.reduction.at(self.edges)
        means = settled(middle.moment, middle.size)
        board = Board(WORKS)
        curve = integral(board, "A", self.edges, means, why=REASONS)
        sides, bent, loads = self._sides
        cycle = Cycle(CONSTRUCTION, self.edges, self.breaks, sides, means, curve.values, edge.inertia)
        return WorkDiagram(curve, _other(board, curve, cycle), cycle, middle, edge, bent, loads)

    @property
    def _sides(self) -> tuple[Floats, Floats, Floats]:
        """The moments at both ends of each strip, (n, 2), from inside it; how they bend there; those of loads alone.

        They are carried on by a parabola, which leaves out less than its own second difference; a break that is placed
        otherwise shifts them along it.
        """
        low, high = self.edges[:-1], self.edges[1:]
        near = np.minimum(np.maximum(BESIDE * (high - low), APART), (high - low) / 6)
        places = [edge + k * sense * near for edge, sense in ((low, 1), (high, -1)) for k in (1, 2, 3)]
        read = self.reduction.at(np.concatenate(places))
        near_by = np.array((read.moment, read.moment - read.weight)).reshape(2, 2, 3, -1)
        sides, loads = (settled((3 * (row[:, 0] - row[:, 1]) + row[:, 2]).T, read.size) for row in near_by)
        first, second, third = np.moveaxis(near_by[0], 1, 0)
        lag = 2 * ROUNDING * TURN / near  # by which the two roads may put one break apart
        bent = np.abs(first - 2 * second + third) + lag * np.abs(first - second)
        return sides, bent.T, loads


def _other(board: Board, curve: Integral, cycle: Cycle) -> Mark:
    """Draw the work of a constant moment, which over the turn gives what the loads take: a straight line (M4.7).

    What an engine drives takes over the turn what the loads give.
    """
    begin, end = curve.points[0], curve.points[-1]
    if cycle.engine:
        return board.join("A_us", begin, end, because("steady_engine"))
    foot = board.lay_off("2π", begin, board.given("φ", complex(TURN), because("whole_turn")), because("whole_turn"))
    taken = board.join("A_us", foot, end, because("work_of_loads"))
    given = board.turn("-A_us", taken, -1.0, because("steady"))
    return board.join("A_dr", begin, board.lay_off("A_dr(2π)", foot, given, because("steady")), because("drive_line"))
