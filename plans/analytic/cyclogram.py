"""Characteristic positions by analysis: roots of the tool's coordinate over the turn (характерные положения; M2.1)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.analytic.assembly import Closure, home
from plans.analytic.closure import EPS
from plans.analytic.extremes import Coordinate, coordinate_of, extremes
from plans.analytic.kinematics import Analysis
from plans.analytic.points import TURN, place
from plans.analytic.turn import FULL, Marched, station, stations_at, whole_turn
from plans.model.cyclogram import (
    ANALYSIS,
    BACK,
    BEGIN,
    BESIDE,
    BREAK,
    END,
    ENTRY,
    EXIT,
    LEAVE,
    PRESSURE,
    Cyclogram,
    CyclogramTask,
    Position,
    Stop,
    Watched,
    within,
)
from plans.model.mechanism import FRAME, Output
from plans.model.motion import Extremes, Floats

ROUNDS = 64  # bisection alone makes 53 digits of a stride
ROUNDINGS = 2.0  # of a crank angle: a step of so much is none

# Of stations (3, N, links, 3) to a quantity and its slope by the crank angle, (2, N).
Measure: TypeAlias = Callable[[Floats], Floats]


def cyclogram(road: Analysis, task: CyclogramTask, output: Output, watched: Watched | None) -> Cyclogram | None:
    """Find the characteristic positions of the output's point; None where it has no two extreme positions."""
    shape = road.shape
    start = home(shape, None, road.looks)
    begun = start and Marched((station(shape.constraints, shape.blocks, start),), None, None)
    turn = whole_turn(shape, begun) if begun else None
    found = extremes(shape, output, road.looks, turn) if turn else None
    if turn is None or found is None:
        return None
    around = _Around(shape, turn, coordinate_of(shape.mechanism, shape.constraints, output), found)
    positions = [*around.ends(), *around.stops(task), *(around.watch(watched) if watched else ())]
    ordered = sorted(positions, key=lambda position: (around.sense * position.turned - around.begin) % FULL)
    placed = tuple(position._replace(turned=within(around.sense * position.turned)) for position in ordered)
    return Cyclogram(ANALYSIS, output, int(around.sense), around.stroke, around.extremes.sliding, found.overlap, placed)


class _ExactStroke(NamedTuple):
    """A stroke of the output: crank angles rad from its begin to its end, rising or falling; whether the way back."""

    begin: float
    end: float
    back: bool


class _Around(NamedTuple):
    """The way round the turn, with the output's coordinate and its extremes; positions here are at crank angles rad."""

    shape: Closure
    turn: Marched
    coordinate: Coordinate
    extremes: Extremes

    @property
    def sense(self) -> float:
        """The sense of the crank's rotation."""
        return -1.0 if self.shape.mechanism.drive.omega < 0.0 else 1.0

    @property
    def begin(self) -> float:
        """The turn of the main shaft where the working stroke begins, rad."""
        return self.sense * self.extremes.phi[0]

    @property
    def stroke(self) -> float:
        """The stroke H, m or rad."""
        return self.extremes.stroke

    @property
    def unit(self) -> float:
        """Metres, or radians, of a unit of the coordinate."""
        return self.coordinate.size if self.coordinate.sliding else 1.0

    def strokes(self) -> tuple[_ExactStroke, _ExactStroke]:
        """Give the working stroke and the way back."""
        first, last = self.extremes.phi
        there = first + self.sense * ((self.sense * (last - first)) % FULL)
        return _ExactStroke(first, there, False), _ExactStroke(there, first + self.sense * FULL, True)

    def ends(self) -> Iterator[Position]:
        """Give the extreme positions."""
        for k, role in enumerate((BEGIN, END)):
            yield Position(role, self.extremes.phi[k], float(k), self.extremes.reach[k])

    def stops(self, task: CyclogramTask) -> Iterator[Position]:
        """Give where the tool comes to the ends of the work and to the changes of the load."""
        asked = list(_asked(task, self.stroke))
        begin, end = (reach / self.unit for reach in self.extremes.reach)
        wanted = np.array([begin + stop.share * (end - begin) for stop in asked])
        strokes = self.strokes()
        pairs = zip(asked, wanted, strict=True)
        brackets = [self._between(self._travel, target, strokes[stop.back])[0] for stop, target in pairs]
        roots = self._roots(lambda stations: self._travel(stations) - np.array([wanted, 0.0 * wanted]), brackets)
        values = self._at(roots, self._travel)
        for k, stop in enumerate(asked):
            travel, slope = float(values[0, k]) * self.unit, float(values[1, k]) * self.unit
            times = self.stroke / (FULL * abs(slope))
            yield Position(stop.role, float(roots[k]), stop.share, travel, stop.back, None, times)

    def watch(self, watched: Watched) -> Iterator[Position]:
        """Give where the pressure angle is extreme, away from the ends of the strokes: its links turn alike there."""
        turning = self._turning(watched)
        for stroke in self.strokes():
            near = BESIDE * self.sense
            inner = stroke._replace(begin=stroke.begin + near, end=stroke.end - near)
            roots = self._roots(turning, self._between(turning, 0.0, inner))
            travel = self._at(roots, self._travel) * self.unit
            for phi, reach, slope in zip(roots.tolist(), *travel.tolist(), strict=True):
                share = (reach - self.extremes.reach[0]) / (self.extremes.reach[1] - self.extremes.reach[0])
                times = self.stroke / (FULL * abs(slope))
                yield Position(PRESSURE, phi, share, reach, stroke.back, self._pressure(watched, phi), times)

    def _travel(self, stations: Floats) -> Floats:
        return self.coordinate.along(stations)[:2]

    def _turning(self, watched: Watched) -> Measure:
        """Give how fast two links turn against each other, or the first against the frame, by the crank angle."""
        links = watched.links if watched.way is None else (watched.links[0], FRAME)
        first, second = (self.shape.constraints.numbers.index(link) for link in links)

        def turning(stations: Floats) -> Floats:
            return np.asarray(stations[1:, :, first, TURN] - stations[1:, :, second, TURN])

        return turning

    def _pressure(self, watched: Watched, phi: float) -> float:
        """Give the pressure angle, rad: of a rod to its guide, or what two links lack of a right angle."""
        poses = self._stations(np.array([phi]))[0, 0]
        first = self._place(watched.links[0], watched.pin, poses) - self._place(
            watched.links[0], watched.hung[0], poses
        )
        if watched.way is not None:
            turned = first / watched.way.direction
            return float(np.arctan2(turned.imag, abs(turned.real)))
        other = self._place(watched.links[1], watched.pin, poses) - self._place(
            watched.links[1], watched.hung[1], poses
        )
        return float(np.pi / 2 - np.arccos((first * other.conjugate()).real / abs(first * other)))

    def _place(self, link: int, point: str, poses: Floats) -> complex:
        local = self.shape.mechanism.links[link].points[point]
        return complex(place(self.shape.constraints, poses[None], link, local)[0])

    def _between(self, quantity: Measure, target: float, stroke: _ExactStroke) -> list[tuple[float, float]]:
        """Give the neighbouring crank angles of a stroke between which a quantity passes its target."""
        way = np.sort((self.sense * (self.turn.angles - stroke.begin)) % FULL)
        inner = way[(way > 0.0) & (way < abs(stroke.end - stroke.begin))]
        phi = np.array([stroke.begin, *(stroke.begin + self.sense * inner), stroke.end])
        above = self._at(phi, quantity)[0] >= target
        return [(float(phi[k]), float(phi[k + 1])) for k in np.flatnonzero(above[1:] != above[:-1])]

    def _roots(self, quantity: Measure, brackets: list[tuple[float, float]]) -> Floats:
        """Close in on zeros between crank angles: by Newton's steps, by halves where they lead out, (N,)."""
        low, high = np.array(brackets).reshape(-1, 2).T.copy()
        rising = self._at(high, quantity)[0] >= 0.0
        phi = (low + high) / 2.0
        for _ in range(ROUNDS if len(phi) else 0):
            value, slope = self._at(phi, quantity)
            before = (value >= 0.0) != rising
            low, high = np.where(before, phi, low), np.where(before, high, phi)
            with np.errstate(divide="ignore", invalid="ignore"):
                step = phi - value / slope
            last, phi = phi, np.where(~((step - low) * (step - high) <= 0.0), (low + high) / 2.0, step)
            if (np.abs(phi - last) <= ROUNDINGS * EPS * np.maximum(np.abs(phi), 1.0)).all():
                break
        return np.asarray(phi)

    def _at(self, phi: Floats, quantity: Measure) -> Floats:
        """Give a quantity at any crank angles, rad, (2, N)."""
        return quantity(self._stations(phi)) if len(phi) else np.zeros((2, 0))

    def _stations(self, phi: Floats) -> Floats:
        """Give poses and transfer functions at any crank angles, rad, (3, N, links, 3)."""
        first = self.turn.angles[0]
        unwrapped = first + (phi - first) % FULL
        near = [self.turn.near(float(angle)) for angle in unwrapped]
        found = stations_at(self.shape.constraints, self.shape.blocks, near, unwrapped)
        return np.array([(station.poses, station.first, station.second) for station in found]).swapaxes(0, 1)


def _asked(task: CyclogramTask, stroke: float) -> Iterator[Stop]:
    """Give the places of the tool that are asked for: the ends of the work, the changes of the load between them."""
    first, last = (along.share(stroke) for along in task.overrun)
    if first > 0.0:
        yield Stop(ENTRY, first)
        yield Stop(LEAVE, first, True)
    if last > 0.0:
        yield Stop(EXIT, 1.0 - last)
    if not first > 0.0:
        yield Stop(BACK, 1.0 - last, True)
    shares = (along.share(stroke) for along in task.breaks)
    yield from (Stop(BREAK, share) for share in shares if share not in {first, 1.0 - last})
