"""The course of a follower over the whole turn: S, S', S'' at any turn of the cam, its shocks (движение толкателя)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np

from geometry.strips import SLIVER
from plans.cam.tables import AccelerationPiece, LawShares, Pieces, bends, shares, table
from plans.model.cam import CUBICS, MM, SHAPE, TABLE, Cam, Law, Phase
from plans.model.cam_motion import FollowerTravel, Shock
from plans.model.motion import Floats

EIGHTH: Final = 1 / 8  # of the phase: a ramp of the trapezoids and of the modified sine
PI = math.pi


def _constant(law: Law) -> LawShares:
    """Give constant accelerations: areas alike, so that the speed ends where it began, at none."""
    first, rest = law.first, 1 - law.first
    return shares([AccelerationPiece(first, (1 / first,)), AccelerationPiece(rest, (-1 / rest,))])


def _wave(size: float, rate: float, phase: float = 0.0, length: float = 1.0) -> AccelerationPiece:
    return AccelerationPiece(length, (), size, rate, phase)


def _polynomial(first: tuple[float, ...], second: tuple[float, ...]) -> LawShares:
    """Give a law whose acceleration is one polynomial: from the start, and from the middle, where its powers are odd.

    Powers of the whole phase would lose two digits at its end.
    """
    return shares([AccelerationPiece(0.5, first), AccelerationPiece(0.5, second)])


def _trapezoid() -> LawShares:
    ramp, flat = AccelerationPiece(EIGHTH, (0.0, 1 / EIGHTH)), 2 * EIGHTH
    down, up = AccelerationPiece(2 * EIGHTH, (1.0, -1 / EIGHTH)), AccelerationPiece(EIGHTH, (-1.0, 1 / EIGHTH))
    return shares([ramp, AccelerationPiece(flat, (1.0,)), down, AccelerationPiece(flat, (-1.0,)), up])


def _modified_trapezoid() -> LawShares:
    flat = 2 * EIGHTH
    middle = _wave(1.0, 4 * PI, PI / 2, 2 * EIGHTH)  # a half wave from the greatest to the least
    ramps = _wave(1.0, 4 * PI, 0.0, EIGHTH), _wave(-1.0, 4 * PI, PI / 2, EIGHTH)
    return shares([ramps[0], AccelerationPiece(flat, (1.0,)), middle, AccelerationPiece(flat, (-1.0,)), ramps[1]])


def _modified_sine() -> LawShares:
    slow = _wave(1.0, 4 * PI / 3, PI / 2, 6 * EIGHTH)  # from the greatest to the least
    return shares([_wave(1.0, 4 * PI, 0.0, EIGHTH), slow, _wave(-1.0, 4 * PI, PI / 2, EIGHTH)])


def _shape(law: Law) -> LawShares:
    """Give a law by the shape of its acceleration, of which the areas cancel and the lift is above 0."""
    parts = ((end - k, a, b - a) for (k, a), (end, b) in pairwise(law.points) if end > k)
    return shares([AccelerationPiece(length, (a, rise / length)) for length, a, rise in parts])


_LAWS: Final[Mapping[str, Callable[[Law], LawShares]]] = {
    "constant velocity": lambda _: shares([AccelerationPiece(1.0)], slope=1.0),
    "constant acceleration": _constant,
    "cosine": lambda _: shares([_wave(1.0, PI, PI / 2)]),
    "sine": lambda _: shares([_wave(1.0, 2 * PI)]),
    "3-4-5": lambda _: _polynomial((0.0, 1.0, -3.0, 2.0), (0.0, -0.5, 0.0, 2.0)),  # k(1 - k)(1 - 2k)
    "4-5-6-7": lambda _: _polynomial(  # k2(1 - k)2(1 - 2k)
        (0.0, 0.0, 1.0, -4.0, 5.0, -2.0), (0.0, -0.125, 0.0, 1.0, 0.0, -2.0)
    ),
    "trapezoid": lambda _: _trapezoid(),
    "modified trapezoid": lambda _: _modified_trapezoid(),
    "modified sine": lambda _: _modified_sine(),
    TABLE: table,
    SHAPE: _shape,
}


@lru_cache(maxsize=64)
def law_of(law: Law) -> LawShares:
    """Give a law in shares of phase and lift.

    >>> import numpy as np
    >>> round(float(law_of(Law("sine")).at(np.array([0.3]), 0)[0]), 10)
    0.1486346543
    """
    return _LAWS[law.name](law)


ROUNDED = 1e-12  # of the largest value of its order: less is the rounding of a law's coefficients, and no shock


class LawStretch(NamedTuple):
    """A phase over one piece of its law: its start, rad, the numbers of phase and piece, the share where it starts."""

    start: float
    phase: int
    piece: int = 0
    share: float = 0.0


@dataclass(frozen=True)
class FollowerCourse:
    """The motion of a cam's follower, phase by phase."""

    cam: Cam

    @cached_property
    def stretches(self) -> tuple[LawStretch, ...]:
        """The pieces of all phases, in their order."""
        return tuple(stretch for number, phase in enumerate(self.cam.phases) for stretch in _stretches(number, phase))

    @cached_property
    def _columns(self) -> tuple[Floats, Floats]:
        """The starts of the stretches, and the rest of each by columns."""
        rows = np.array(self.stretches)
        return rows[:, 0], rows[:, 1:].T

    def at(self, turned: Floats, before: bool = False) -> FollowerTravel:
        """Give S, S', S'' at turns of the cam from 0 to a whole one, (N,); at a joint after it, or before it.

        Before the beginning of a turn is the end of the last one; a cam that translates has none before.
        """
        phi = np.asarray(turned, dtype=float)
        if before and not self.cam.translates:
            phi = np.where(phi == 0.0, self.cam.turn, phi)
        starts, columns = self._columns
        interval = np.clip(np.searchsorted(starts, phi, side="left" if before else "right") - 1, 0, None)
        (numbers, pieces, shares), gone = columns[:, interval], phi - starts[interval]
        found = np.empty((3, len(phi)))
        for number, phase in enumerate(self.cam.phases):
            here = numbers == number
            found[:, here] = _follow(phase, pieces[here].astype(int), gone[here], shares[here])
        return FollowerTravel(*found)

    @cached_property
    def joints(self) -> tuple[float, ...]:
        """Where a phase or a piece of a law begins or ends, rad, rising from 0 to the whole turn."""
        return tuple(sorted({0.0, *self._columns[0].tolist(), self.cam.turn}))

    def with_joints(self, turned: Floats) -> Floats:
        """Add the joints to turns of the cam, rad, (N,), rising: no chord cuts off a corner of what is drawn."""
        return np.union1d(settled(turned, self), self.joints)

    @cached_property
    def corners(self) -> tuple[float, ...]:
        """The ends of the phases, and the joints at which S'' jumps or has a corner, rad: no strip goes beyond one."""
        return tuple(sorted({0.0, *(phase.start for phase in self.cam.phases), *self._bends(), self.cam.turn}))

    def _bends(self) -> Iterator[float]:
        for phase in self.cam.moving():
            if phase.law is not None and (phase.law.name, phase.law.through) != (TABLE, CUBICS):
                yield from (phase.start + phase.angle * share for share in bends(law_of(phase.law)))

    @cached_property
    def shocks(self) -> tuple[Shock, ...]:
        """Where S' jumps (жёсткий удар), or S'' with S' whole (мягкий удар)."""
        return tuple(self._shocks())

    def _shocks(self) -> Iterator[Shock]:
        joints, after, before = self._sides
        sizes = [(abs(phase.change) / phase.angle, abs(phase.change) / phase.angle**2) for phase in self.cam.moving()]
        usual = np.asarray(np.array([(0.0, 0.0), *sizes]).max(axis=0))
        largest = np.maximum(usual, np.maximum(np.abs(after), np.abs(before)).max(axis=1, initial=0.0))
        for turned, jumps in zip(joints.tolist(), (after - before).T.tolist(), strict=True):
            real = [order for order in (1, 2) if abs(jumps[order - 1]) > ROUNDED * largest[order - 1]]
            yield from (Shock(turned, order, jumps[order - 1]) for order in real[:1])

    @property
    def _sides(self) -> tuple[Floats, Floats, Floats]:
        """Give the joints, once each, and S' and S'' after and before them, (2, N): rest beyond the ends of a cam."""
        joints = np.array(self.joints if self.cam.translates else self.joints[:-1])
        after, before = (np.array(self.at(joints, side)[1:]) for side in (False, True))
        if self.cam.translates:
            before[:, 0] = after[:, -1] = 0.0
        return joints, after, before


def _stretches(number: int, phase: Phase) -> Iterator[LawStretch]:
    if phase.law is None:
        yield LawStretch(phase.start, number)
        return
    for piece, share in enumerate(law_of(phase.law).starts):
        yield LawStretch(phase.start + phase.angle * share, number, piece, share)


def _follow(phase: Phase, pieces: Pieces, turned: Floats, shares: Floats) -> Floats:
    """Give S, S', S'' within a phase, (3, N), by pieces of its law, turned rad since their starts at some shares."""
    if phase.law is None:
        return np.array([np.full_like(turned, phase.level), 0 * turned, 0 * turned])
    gone = np.clip(turned / phase.angle, 0.0, 1.0 - shares)
    rows = [phase.change / phase.angle**k * law_of(phase.law).of(pieces, gone, k) for k in range(3)]
    return np.array([phase.level + rows[0], *rows[1:]])


def positions(cam: Cam) -> Floats:
    """Give the turns of the numbered positions, rad: each phase that moves in equal parts, a dwell by its ends."""
    edges = [np.linspace(phase.start, phase.end, cam.divisions + 1)[:-1] for phase in cam.moving()]
    edges += [np.array([phase.start]) for phase in cam.phases if phase.law is None]
    found = np.unique(np.concatenate([*edges, *([np.array([cam.turn])] if cam.translates else [])]))
    return settled(found, FollowerCourse(cam))


def settled(turned: Floats, course: FollowerCourse) -> Floats:
    """Put turns that are joints of phases or laws but for a rounding on them, (N,), rising."""
    joints = np.array(course.joints)
    near = joints[np.abs(turned[:, None] - joints).argmin(axis=1)]
    width = float(np.diff(turned).min(initial=course.cam.turn))
    return np.where(np.abs(turned - near) <= SLIVER * width, near, turned)


STATIONS = 72  # turns that a workshop is told: every 5 degrees; of a cam that translates so many at most, and its end
RAYS, ORDINATES = 6, 10  # stations from one drawn radius to the next, 30 degrees; from one drawn ordinate
MANTISSAS = (1.0, 2.0, 2.5, 5.0, 10.0)  # of the travel in mm from one station to the next
QUOTIENT = 1e-12  # of a step: what a division leaves of one that is as long as it must be
DECIMALS = 9  # of a station's name, degrees or mm: far above rounding, far below any step


class WorkshopTurns(NamedTuple):
    """The turns of a cam that a workshop is told, rad: every 5 degrees, or by a round length of travel m."""

    cam: Cam
    turned: Floats

    @property
    def names(self) -> list[float]:
        """The turns in degrees; of a cam that translates its travels, mm."""
        shown = MM * self.turned if self.cam.translates else np.degrees(self.turned)
        return [float(name) for name in shown.round(DECIMALS)]

    def rays(self) -> Iterator[tuple[int, float]]:
        """Give the stations whose radii, or ordinates, are drawn, with their names."""
        every = ORDINATES if self.cam.translates else RAYS
        yield from ((k, self.names[k]) for k in range(every, len(self.names), every))


def stations(cam: Cam) -> WorkshopTurns:
    """Give the turns of a cam that a workshop is told."""
    turned = np.linspace(0.0, cam.turn, STATIONS, endpoint=False)
    if cam.translates:
        least = MM * cam.turn / STATIONS
        power = 10.0 ** math.floor(math.log10(least))
        step = next(part * power for part in MANTISSAS if part * power >= least * (1 - QUOTIENT)) / MM
        turned = np.append(np.arange(0.0, cam.turn - step / 2, step), cam.turn)
    return WorkshopTurns(cam, settled(turned, FollowerCourse(cam)))
