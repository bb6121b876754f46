"""Extreme positions of the output link by analysis: the zeros of its speed over the turn (крайние положения)."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.analytic.assembly import Closure, home
from plans.analytic.closure import EPS, SQRT_EPS, Flags
from plans.analytic.ends import Station
from plans.analytic.points import TURN, Constraints, X, Y
from plans.analytic.turn import FULL, Blocks, Marched, station, stations_at, whole_turn
from plans.model.mechanism import FASTER, Mechanism, Output, Way, by_time, output_way, works
from plans.model.motion import Complexes, Extremes, Floats


class OutputCoordinate(NamedTuple):
    """The output coordinate: along the frame's guide in units of `size`, or the turn of the link."""

    place: int  # of the link in the poses
    way: Way | None
    own: complex  # the point shown, in the link's own frame, in units of `size`
    size: float

    @property
    def sliding(self) -> bool:
        """Whether it is a length."""
        return self.way is not None

    def along(self, taylor: Floats) -> Floats:
        """Give the coordinate and its two derivatives by the crank angle at N stations, (3, N)."""
        if self.way is None:
            return np.asarray(taylor[:, :, self.place, TURN])
        places = _OutputSpot(self.place, self.own).along(taylor)
        places[0] -= self.way.through / self.size
        return np.asarray((places * self.way.direction.conjugate()).real)


class _OutputSpot(NamedTuple):
    """A point of a link: the place of the link in the poses, and its own in the link's frame in units of `size`."""

    place: int
    own: complex

    def along(self, taylor: Floats) -> Complexes:
        """Give its place and two derivatives by the crank angle at N stations, (3, N), in units of `size`."""
        poses, first, second = taylor[:, :, self.place]
        arm, spin = self.own * np.exp(1j * poses[:, TURN]), 1j * first[:, TURN]
        return np.array(
            (
                poses[:, X] + 1j * poses[:, Y] + arm,
                first[:, X] + 1j * first[:, Y] + arm * spin,
                second[:, X] + 1j * second[:, Y] + arm * (spin**2 + 1j * second[:, TURN]),
            )
        )


class PartedCoordinate(NamedTuple):
    """The way of a point from another along the line of two points, which both lie on, in units of `size`."""

    spots: tuple[_OutputSpot, _OutputSpot, _OutputSpot, _OutputSpot]  # own, other, the line's start and end
    size: float

    @property
    def sliding(self) -> bool:
        """Whether it is a length: always."""
        return True

    def along(self, taylor: Floats) -> Floats:
        """Give the way and its two derivatives by the crank angle at N stations, (3, N).

        Its line turns by w: s = d along it, s' = d' along it, and s'' = d'' along it and w times d' across it.
        """
        point, other, start, end = (spot.along(taylor) for spot in self.spots)
        line, away = end - start, point - other
        unit = (line[0] / np.abs(line[0])).conj()
        turning = (unit * line[1]).imag / np.abs(line[0])
        apart = unit * away
        return np.array((apart[0].real, apart[1].real, apart[2].real + turning * apart[1].imag))


Coordinate: TypeAlias = OutputCoordinate | PartedCoordinate


def _at(coordinate: Coordinate, place: Station) -> Floats:
    """Give a coordinate and its two derivatives at one station, (3,)."""
    return coordinate.along(np.array((place.poses, place.first, place.second))[:, None])[:, 0]


def coordinate_of(mechanism: Mechanism, constraints: Constraints, output: Output) -> Coordinate:
    """Give the coordinate of an output."""
    if output.parting is not None:
        names = output.point or "", output.parting.other, *output.parting.line
        here, other, start, end = (_spot(mechanism, constraints, name) for name in names)
        return PartedCoordinate((here, other, start, end), constraints.size)
    points = mechanism.links[output.link].points
    name, way = output_way(mechanism, output) or (output.point, None)
    place, own = constraints.numbers.index(output.link), points[name or next(iter(points))]
    return OutputCoordinate(place, way, own / constraints.size, constraints.size)


def _spot(mechanism: Mechanism, constraints: Constraints, name: str) -> _OutputSpot:
    link = next(number for number in constraints.numbers if name in mechanism.links[number].points)
    return _OutputSpot(constraints.numbers.index(link), mechanism.links[link].points[name] / constraints.size)


ROUNDS = 64  # bisection alone makes 53 digits of a stride
ROUNDINGS = 2.0  # of a crank angle: a step of so much is none
CLOSEST = 1e-6  # rad: two rests that are closer are one, in which the output only touches its extreme
EQUAL = 1e-7  # rad: strokes whose crank arcs differ by less are equal on paper and in any machine


class _Rest:
    """A rest of the output that is closed in on: the crank angles around it, the nearest station, the next step."""

    def __init__(self, coordinate: Coordinate, low: Station, high: Station) -> None:
        self.coordinate, self.bottom, self.top = coordinate, low.phi, high.phi
        self.rising = _at(coordinate, high)[1] >= 0.0
        self.near = min(low, high, key=lambda end: abs(float(_at(coordinate, end)[1])))
        self.step, self.newton = np.inf, False

    def aims(self) -> bool:
        """Find the next step: Newton's, or the middle where that leads out; none where only rounding is left."""
        here, last = self.near.phi, abs(self.step) if self.newton else np.inf
        _, speed, growth = map(float, _at(self.coordinate, self.near))
        self.bottom, self.top = (self.bottom, here) if (speed >= 0.0) == self.rising else (here, self.top)
        self.step, self.newton = (-speed / growth if growth else np.inf), True
        if abs(self.step) <= ROUNDINGS * EPS * max(abs(here), 1.0):
            return False
        if abs(self.step) <= SQRT_EPS and abs(self.step) >= last / 2.0:
            return bool(last > SQRT_EPS)  # Newton squares the error: what does not shrink from there on is rounding
        if abs(self.step) > SQRT_EPS and not self.bottom <= here + self.step <= self.top:
            self.step, self.newton = (self.bottom + self.top) / 2.0 - here, False
        return True


def extremes(shape: Closure, output: Output, looks: Floats, turn: Marched | None = None) -> Extremes | None:
    """Find the extreme positions; None if the output link turns fully or stands still, or the crank cannot turn fully.

    What of the `turn` has been marched already is not marched again. A slider's reach is counted along the frame's
    guide from the point that gives the guide. Strokes that take equal crank angles have no slower one: then the working
    stroke is taken to begin at the smaller crank angle.
    """
    mechanism, constraints, blocks = shape
    begun = turn or _begun(shape, looks)
    turn = whole_turn(shape, begun) if begun else None
    if turn is None:
        return None
    coordinate = coordinate_of(mechanism, constraints, output)
    coordinates, speed, _ = coordinate.along(turn.taylor)
    full_turn = abs(coordinates[-1] - coordinates[0]) > np.pi and not coordinate.sliding
    if full_turn or np.abs(speed).max() <= SQRT_EPS:
        return None
    turn = _dense(constraints, blocks, turn, coordinate)
    speed = coordinate.along(turn.taylor)[1]
    signs = np.where(speed >= 0.0, 1.0, -1.0)
    signs[-1] = signs[0]  # one position: a rounding of a rest there is no second rest
    changes = np.flatnonzero(signs[1:] != signs[:-1])
    found = _refine(constraints, blocks, [_Rest(coordinate, turn.stations[k], turn.stations[k + 1]) for k in changes])
    return _strokes(found, mechanism, output, coordinate)


def _begun(shape: Closure, looks: Floats) -> Marched | None:
    start = home(shape, None, looks)
    return Marched((station(shape.constraints, shape.blocks, start),), None, None) if start else None


def _dense(constraints: Constraints, blocks: Blocks, turn: Marched, coordinate: Coordinate) -> Marched:
    """Put stations between those of a turn until the speed has at most one zero between any two of them."""
    stations, pending = list(turn.stations), list(pairwise(turn.stations))
    while pending:
        lows, highs = zip(*pending, strict=True)
        phi = np.array([(low.phi + high.phi) / 2.0 for low, high in pending])
        middles = stations_at(constraints, blocks, lows, phi)
        low, middle, high = (coordinate.along(_taylor(row))[1:] for row in (lows, middles, highs))
        step = np.array([high.phi - low.phi for low, high in pending])
        doubtful = _doubtful(low, middle, high, step) & (step > CLOSEST)
        halves = [((low, k), (k, high)) for (low, high), k in zip(pending, middles, strict=True)]
        pending = [half for both, more in zip(halves, doubtful.tolist(), strict=True) if more for half in both]
        stations += middles
    return replace(turn, stations=tuple(sorted(stations, key=lambda station: station.phi)))


def _doubtful(low: Floats, middle: Floats, high: Floats, step: Floats) -> Flags:
    """Tell between which stations a speed may have more zeros than its signs at the ends and in the middle show.

    Speeds and growths, (2, N), of both ends make a cubic (Hermite); how far the speed is from it, the middle tells. A
    zero is plain where the cubic passes it steeply.
    """
    share = np.linspace(0.0, 1.0, 9)[:, None]
    (first, rise), (last, fall) = (low[0], low[1] * step), (high[0], high[1] * step)
    bend, twist = 3.0 * (last - first) - 2.0 * rise - fall, rise + fall - 2.0 * (last - first)
    cubic = first + share * (rise + share * (bend + share * twist))
    slope = rise + share * (2.0 * bend + share * 3.0 * twist)
    away = np.abs(middle[0] - cubic[4]) * 4.0 + np.maximum(np.abs(bend), np.abs(bend + 3.0 * twist)) / 32.0
    blunt = (np.abs(cubic) + np.abs(slope) / 4.0).min(axis=0) <= away
    return np.asarray(blunt | (_changes(cubic) != _changes(np.array((first, middle[0], last)))))


def _changes(values: Floats) -> Floats:
    return np.asarray(((values[1:] >= 0.0) != (values[:-1] >= 0.0)).sum(axis=0))


def _taylor(stations: Sequence[Station]) -> Floats:
    """Give poses, first and second transfer functions of some stations, (3, stations, links, 3)."""
    return np.array([(s.poses, s.first, s.second) for s in stations]).swapaxes(0, 1)


def _refine(constraints: Constraints, blocks: Blocks, rests: list[_Rest]) -> list[tuple[float, float]]:
    """Close in on all rests together: their crank angles and the coordinate there."""
    if not rests:
        return []
    # The rates of a marched station are less exact than its poses.
    exact = stations_at(constraints, blocks, [rest.near for rest in rests], np.array([rest.near.phi for rest in rests]))
    for rest, reached in zip(rests, exact, strict=True):
        rest.near = reached
    for _ in range(ROUNDS):
        moving = [rest for rest in rests if rest.aims()]
        if not moving:
            break
        phi = np.array([rest.near.phi + rest.step for rest in moving])
        stations = stations_at(constraints, blocks, [rest.near for rest in moving], phi)
        for rest, reached in zip(moving, stations, strict=True):
            rest.near = reached
    return [(rest.near.phi, float(_at(rest.coordinate, rest.near)[0])) for rest in rests]


def _strokes(
    found: list[tuple[float, float]], mechanism: Mechanism, output: Output, coordinate: Coordinate
) -> Extremes | None:
    """Order the farthest two of the extremes so that the working stroke comes first."""
    if len(found) < 2:
        return None
    along = [e[1] for e in found]
    blur = EQUAL * (max(along) - min(along))  # an output that stands equally far twice in a turn: its first time counts
    most = min((e for e in found if e[1] >= max(along) - blur), key=lambda e: (e[0] + EQUAL) % FULL)
    least = min((e for e in found if e[1] <= min(along) + blur), key=lambda e: (e[0] + EQUAL) % FULL)
    sense = -1.0 if mechanism.drive.omega < 0.0 else 1.0
    arc = float(sense * (least[0] - most[0]) % FULL)
    begin, end = (most, least) if arc > np.pi else (least, most)
    if abs(arc - np.pi) < EQUAL:  # an angle a rounding short of a full turn counts as 0
        begin, end = sorted((begin, end), key=lambda e: (e[0] + EQUAL) % FULL)
    unit = coordinate.size if coordinate.sliding else 1.0
    equal = abs(arc - np.pi) < EQUAL
    reach = begin[1] * unit, end[1] * unit
    turned = _turned(mechanism, output, reach, equal)
    if turned:
        begin, end, reach = end, begin, (reach[1], reach[0])
    phi = tuple(float(angle % FULL) % FULL for angle in (begin[0], end[0]))
    return Extremes((phi[0], phi[1]), reach, coordinate.sliding, abs(arc - np.pi), turned and not equal)


def _turned(mechanism: Mechanism, output: Output, reach: tuple[float, float], equal: bool) -> bool:
    """Tell whether the working stroke is the way back of the slower one; of equal strokes time tells none."""
    if by_time(output):
        return output.working == FASTER and not equal
    return not works(mechanism, output, *reach)
