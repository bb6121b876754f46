"""Kinematic diagrams of an output: S, v, a over the crank angle, v and a by chords (кинематические диаграммы).

Angles `turned` run from 0 in the sense in which the crank turns, rad. Units are m, m/s, m/s2 of an output that slides,
rad, rad/s, rad/s2 of one that turns.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from plans.model.motion import Floats, Gap
from plans.words.words import Message, message

TURN = 2 * math.pi
FEWEST = 4  # positions in a row: two chords of chords, so that there is a course of a
STILL = 1e-12  # m/s or rad/s with the crank at 1 rad/s: an output that is slower stands, but for roundings
EXACT = 1e-9  # a share: less is roundings, by which neither road tells one error from another
ROUNDED = 1e-9  # rad: far more than a rounding of an angle, and far less than two positions are apart
MOST = 360  # positions: of more a chord is shorter than the line it is drawn with


class OutputRates(NamedTuple):
    """The output's coordinate, velocity and acceleration at some angles, (N,) each."""

    s: Floats
    v: Floats
    a: Floats

    def even(self, lead: float) -> Floats:
        """Give the acceleration without what the crank's own one adds to it, a share 1/s of the velocity."""
        return self.a - lead * self.v


class Count(NamedTuple):
    """How the output's way is counted: from where, in which sense, which turns for one of the crank are left out.

    An output that turns fully is shown by what it is ahead of an even turn.
    """

    zero: float
    sense: float = 1.0
    turns: float = 0.0

    def course(self, turned: Floats, rows: Sequence[Floats], omega: float) -> OutputRates:
        """Count a coordinate, its velocity and acceleration at angles; the crank turns with omega > 0, rad/s."""
        s, v, a = rows
        return OutputRates(
            self.sense * (s - self.zero) - self.turns * turned, self.sense * v - self.turns * omega, self.sense * a
        )


class Axis(NamedTuple):
    """The axis of the diagrams: positions in the order in which the crank passes them, and which of them follow.

    Where the crank passes a whole turn the first position stands again at the end.
    """

    numbers: tuple[int, ...]  # (M,) of the positions
    turned: Floats  # (M,) rad, rising from 0
    joined: npt.NDArray[np.bool_]  # (M - 1,): whether the crank passes from a position to the next one
    closed: bool  # whether the end is the beginning
    start: float = 0.0  # rad: the crank angle of its first position

    @property
    def middles(self) -> Floats:
        """The middles of the parts, (M - 1,) rad."""
        return np.asarray(self.turned[:-1] + np.diff(self.turned) / 2)

    @property
    def places(self) -> Floats:
        """Where a value by two chords side by side belongs, (M,) rad: midway between their middles; NaN at an end."""
        spots = np.full(len(self.turned), np.nan)
        spots[1:-1] = (self.middles[1:] + self.middles[:-1]) / 2
        if self.closed:
            spots[[0, -1]] = (self.middles[0] + self.middles[-1] - self.turned[-1]) / 2 + np.array([0, self.turned[-1]])
        return spots

    @property
    def between(self) -> npt.NDArray[np.bool_]:
        """Whether a position has a part on either side, (M,)."""
        ends = self.closed & self.joined[0] & self.joined[-1]
        return np.asarray(np.concatenate([[ends], self.joined[1:] & self.joined[:-1], [ends]]), dtype=np.bool_)

    def fine(self, count: int) -> Floats:
        """Divide the parts that the crank passes, each evenly, into so many of a turn at least; rad, rising."""
        return np.concatenate([np.zeros(0), *self.nodes(count)])

    def nodes(self, count: int) -> tuple[Floats, ...]:
        """Divide each run of positions so; the positions themselves are among the nodes."""
        shares = np.linspace(0.0, 1.0, 1 + max(2, math.ceil(count / max(len(self.joined), 1))))[:-1]
        turned = [self.turned[run] for run in self.runs]
        parts = (angles[:-1, None] + np.diff(angles)[:, None] * shares for angles in turned)
        return tuple(np.append(row.ravel(), angles[-1]) for row, angles in zip(parts, turned, strict=True))

    @property
    def runs(self) -> tuple[slice, ...]:
        """The positions that follow one another without a gap, two at least."""
        bounds = np.flatnonzero(np.diff(np.concatenate([[0], self.joined.astype(int), [0]])))
        return tuple(slice(low, high + 1) for low, high in bounds.reshape(-1, 2).tolist())


@dataclass(frozen=True, eq=False, repr=False)
class Diagrams:
    """The diagrams by one road: the course at the positions, by chords, and exactly where the chords' values belong.

    Chords of v over the angle know no other acceleration than that of a crank that turns evenly: `lead`, 1/s, is what
    the crank's own acceleration adds to a, in shares of v.
    """

    by: str
    axis: Axis
    count: Count
    lead: float
    at: OutputRates  # (M,)
    speeds: Floats  # (M - 1,): v by the chords of S, over the middles; NaN of a part that is not passed
    growths: Floats  # (M,): a by the chords of v, over the places
    true_speeds: Floats  # (M - 1,): v at the middles
    true_growths: Floats  # (M,): a at the places, of a crank that turns evenly

    @property
    def even(self) -> Floats:
        """The acceleration at the positions that a crank which turns evenly gives, (M,)."""
        return self.at.even(self.lead)

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """No gaps of its own: they are those of the plans."""
        return ()


class ChordError(NamedTuple):
    """How far values by chords are out at the most, as a share of the largest exact one, and at which of them."""

    share: float
    at: int


def chord_error(values: Floats, exact: Floats) -> ChordError | None:
    """Find the largest error of values by chords, of equal ones the first; None where it is but a rounding."""
    off, most = np.abs(values - exact), float(np.nanmax(np.abs(exact), initial=0.0))
    worst = float(np.nanmax(off, initial=0.0))
    if not most or worst <= EXACT * most:
        return None
    return ChordError(worst / most, int(np.argmax(np.nan_to_num(off) >= worst * (1 - EXACT))))


def axis_of(
    phi: Floats, sense: int, lost: npt.NDArray[np.bool_], barred: Sequence[float] = (), whole: bool = False
) -> Axis:
    """Put positions at crank angles phi rad, (N,), in order, from after the widest stretch in which none is reached.

    The positions of a `whole` turn that is free are a closed row. `barred` are the angles beyond which the crank cannot
    pass; `lost` positions are not reached.
    """
    if lost.all():
        return Axis((), np.zeros(0), np.zeros(0, dtype=bool), False)
    ahead = np.mod(sense * (phi - phi[0]) + ROUNDED, TURN) - ROUNDED
    order = np.argsort(ahead, kind="stable")
    if whole and not lost.any() and not len(barred):
        row, start = (*order.tolist(), int(order[0])), float(phi[0])
        return Axis(row, np.append(ahead[order], TURN), np.ones(len(order), dtype=bool), True, start)
    turned = ahead[order]
    held = np.flatnonzero(~lost[order])
    apart = np.diff(turned[held], prepend=turned[held[-1]] - TURN)
    first, last = int(held[np.argmax(apart)]), int(held[np.argmax(apart) - 1])
    count = (last - first) % len(order) + 1
    numbers, turned = np.roll(order, -first)[:count], np.roll(turned, -first)[:count]
    turned = np.mod(turned - turned[0], TURN)
    joined = np.asarray(~lost[numbers[:-1]] & ~lost[numbers[1:]])
    for spot in (np.mod(sense * (edge - phi[numbers[0]]), TURN) for edge in barred):
        joined &= ~((turned[:-1] < spot) & (spot < turned[1:]))
    return Axis(tuple(numbers.tolist()), turned, joined, False, float(phi[numbers[0]]))


def unfollowed(axis: Axis) -> Message | None:
    """See that enough positions follow one another."""
    longest = max((run.stop - run.start for run in axis.runs), default=0)
    return message("diagrams.few", least=FEWEST) if longest < FEWEST else None


def still(course: OutputRates, count: Count, omega: float, link: int) -> Message | None:
    """See that the output moves, and not evenly with the crank, which turns with omega > 0."""
    if np.nanmax(np.abs(course.v), initial=0.0) > STILL * omega:
        return None
    return message("diagrams.even" if count.turns else "diagrams.still", link=link)
