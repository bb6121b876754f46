"""Extreme positions of the output link by analysis: the zeros of its speed over the turn (крайние положения)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from plans.analytic.assembly import assemble_anywhere
from plans.analytic.closure import SQRT_EPS
from plans.analytic.constraints import TURN, Constraints, X, Y
from plans.analytic.turn import FULL, Station, station_at, whole_turn
from plans.mechanism import FRAME, Mechanism, Output, Slide
from plans.motion import Extremes, Floats

ROUNDS = 64  # bisection alone makes 53 digits of a stride
EQUAL = 1e-7  # rad: strokes whose crank arcs differ by less are equal on paper and in any machine


@dataclass(frozen=True)
class _Coordinate:
    """The output coordinate of a station: along the frame's guide in units of `size`, or the turn of the link."""

    place: int  # of the link in the poses
    guide: Slide | None
    own: complex  # the point shown, in the link's own frame, in units of `size`
    size: float

    def at(self, station: Station) -> Floats:
        """Give the coordinate and its two derivatives by the crank angle, (3,)."""
        poses = np.array((station.poses[self.place], station.first[self.place], station.second[self.place]))
        if self.guide is None:
            return np.asarray(poses[:, TURN])
        way = self.guide.way(FRAME)
        arm, spin = self.own * np.exp(1j * poses[0, TURN]), 1j * poses[1, TURN]
        arms = arm * np.array((1.0, spin, spin**2 + 1j * poses[2, TURN]))
        start = np.array((way.through / self.size, 0.0, 0.0))
        return np.asarray(((poses[:, X] + 1j * poses[:, Y] + arms - start) * way.direction.conjugate()).real)


def extremes(mechanism: Mechanism, output: Output) -> Extremes | None:
    """Find the extreme positions; None if the output link turns fully or stands still, or the crank cannot turn fully.

    A slider's reach is counted along the frame's guide from the point that gives the guide. Strokes that take equal
    crank angles have no slower one: then the working stroke is taken to begin at the smaller crank angle.
    """
    constraints = Constraints.of(mechanism)
    start = assemble_anywhere(mechanism, constraints)
    turn = whole_turn(constraints, start) if start else None
    if turn is None:
        return None
    coordinate = _coordinate(mechanism, constraints, output)
    values = np.array([coordinate.at(station) for station in turn.stations])
    speed = values[:, 1]
    full_turn = abs(values[-1, 0] - values[0, 0]) > np.pi and coordinate.guide is None
    if full_turn or np.abs(speed).max() <= SQRT_EPS:
        return None
    signs = np.where(speed >= 0.0, 1.0, -1.0)
    signs[-1] = signs[0]  # one position: a rounding of a rest there is no second rest
    found = []
    for k in np.flatnonzero(signs[1:] != signs[:-1]):
        found.append(_refined(constraints, coordinate, turn.stations[k], turn.stations[k + 1]))
    sense = -1.0 if mechanism.drive.omega < 0.0 else 1.0
    return _strokes(found, sense, coordinate)


def _coordinate(mechanism: Mechanism, constraints: Constraints, output: Output) -> _Coordinate:
    guides = [s for s in mechanism.slides if {s.slider, s.owner} == {FRAME, output.link}]
    guide = guides[0] if guides else None
    points = mechanism.links[output.link].points
    named = (output.point or "", guide.point if guide else "", next(iter(points)))
    point = next(name for name in named if name in points)
    own = points[point] / constraints.size
    return _Coordinate(constraints.numbers.index(output.link), guide, own, constraints.size)


def _refined(constraints: Constraints, coordinate: _Coordinate, low: Station, high: Station) -> tuple[float, float]:
    """Find the zero of the output's speed between two stations: its crank angle and the coordinate there."""
    rising = coordinate.at(high)[1] >= 0.0
    near = min(low, high, key=lambda station: abs(coordinate.at(station)[1]))
    bottom, top, last = low.phi, high.phi, np.inf
    for _ in range(ROUNDS):
        _, speed, growth = coordinate.at(near)
        bottom, top = (bottom, near.phi) if (speed >= 0.0) == rising else (near.phi, top)
        step = float(-speed / growth) if growth else np.inf
        fine = abs(step) <= SQRT_EPS  # Newton squares the error: after such a step only rounding is left
        if fine and abs(step) >= last / 2.0:
            break
        if not fine and not bottom <= near.phi + step <= top:
            step = (bottom + top) / 2.0 - near.phi
        near, last = station_at(constraints, near, near.phi + step), abs(step)
    return near.phi, float(coordinate.at(near)[0])


def _strokes(found: list[tuple[float, float]], sense: float, coordinate: _Coordinate) -> Extremes | None:
    """Order the farthest two of the extremes so that the slower stroke comes first."""
    if len(found) < 2:
        return None
    reach = [e[1] for e in found]
    blur = EQUAL * (max(reach) - min(reach))  # an output that stands equally far twice in a turn: its first time counts
    most = min((e for e in found if e[1] >= max(reach) - blur), key=lambda e: (e[0] + EQUAL) % FULL)
    least = min((e for e in found if e[1] <= min(reach) + blur), key=lambda e: (e[0] + EQUAL) % FULL)
    arc = float(sense * (least[0] - most[0]) % FULL)
    begin, end = (most, least) if arc > np.pi else (least, most)
    if abs(arc - np.pi) < EQUAL:  # an angle a rounding short of a full turn counts as 0
        begin, end = sorted((begin, end), key=lambda e: (e[0] + EQUAL) % FULL)
    unit = coordinate.size if coordinate.guide else 1.0
    phi = tuple(float(angle % FULL) % FULL for angle in (begin[0], end[0]))
    return Extremes((phi[0], phi[1]), (begin[1] * unit, end[1] * unit), coordinate.guide is not None, abs(arc - np.pi))
