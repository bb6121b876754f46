"""What a task asks for of a curve: its values at the places that a sheet marks, what each rests on (график задания).

A value is a complex number in true units: of a graph it goes along the way of the ordinates, of a loop or a profile it
is a point seen from the pole. The arrays of a figure have a value for each of its places, marked or not.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from geometry.hand_error import EVEN
from plans.model.dynamics import TURN
from plans.words.words import Message

Values: TypeAlias = npt.NDArray[np.complex128]
Sizes: TypeAlias = npt.NDArray[np.float64]
# Of what a student has drawn of the figures before it to what this figure is if it is drawn on from there.
Course: TypeAlias = Callable[[Mapping[str, Values]], Values]

# Of a slip of a mm: how far an ordinate is out, both of whose ends are pricked (standard deviation, mm).
PRICKED = float(EVEN * np.sqrt(2))
ORDINATES, POINTS, BEARINGS, LENGTHS = "ordinates", "points", "bearings", "lengths"
CHAIN = "chain"  # vectors each of which begins where the one before it in its row ends


class Item(NamedTuple):
    """One value that is asked for: the name and position of its mark, its place in the figure, what it is called."""

    name: str
    position: int | None
    place: int
    called: str


class Mistake(NamedTuple):
    """A mistake that has a name, and what the figure is with it; each value may go on by one size, `along`."""

    kind: str
    values: Values
    along: Values | None = None

    def fitted(self, drawn: Values) -> Mistake:
        """Give the mistake by the size that a drawn figure has it by."""
        there = ~np.isnan(drawn)
        if self.along is None or not there.any():
            return self
        apart, ways = (drawn - self.values)[there], self.along[there]
        size = float((apart * ways.conj()).real.sum() / (np.abs(ways) ** 2).sum())
        return self._replace(values=self.values + size * self.along)


class Paper(NamedTuple):
    """Where a graph lies on our own sheet, mm: its axis, the foot of each ordinate on it, and where along it that is.

    The last are in true units: angles turned, or a way; `turn` is so many of them as a turn has, if they are angles.
    """

    axis: tuple[complex, complex]
    feet: Values
    along: Sizes
    turn: float | None = TURN


@dataclass(frozen=True)
class FigureAsked:
    """A curve that is asked for: its marks' plan, its sheet, what it is in true units, and how it is drawn.

    `error` is how far a hand that slips by a mm is out in each value, mm, as its standard deviation, drawn on from what
    is before it. `slack` is what the method itself leaves out. `behind` are the figures that `course` goes on from.
    """

    key: str
    plan: str
    sheet: str
    unit: str
    scales: Mapping[str, float]  # true units a mm, by the letters that they are written with; across, then up
    items: tuple[Item, ...]
    true: Values
    slack: Sizes
    error: Sizes
    kind: str = POINTS
    way: complex = 1j  # of the ordinates on paper
    paper: Paper | None = None
    behind: tuple[str, ...] = ()
    course: Course | None = None
    linear: bool = False  # whether it is out by the factor that all before it are out by
    mistakes: tuple[Mistake, ...] = ()
    on_paper: bool = False  # whether its values are mm of paper, and its scales what these stand for
    stepped: bool = False  # whether each value is laid off from the one before it
    loose: frozenset[int] = frozenset()  # places that the curve need not reach: no velocity is known there
    why: Message | None = None
    returns: bool = False  # whether it goes there and back over its axis
    curved: tuple[int, ...] = ()  # the places that one line goes through, and may be read off it
    arms: tuple[str, ...] = ()  # the letters of masses whose arms it is of
    rings: tuple[int, ...] = ()  # in which ring each of its bearings is drawn, from the outermost, 1
    units: Mapping[str, str] = field(default_factory=dict)  # of its scales that are neither of its values nor of SI

    @property
    def scale(self) -> float:
        """The scale of the values, true units a mm; of those that are mm of paper 1."""
        return 1.0 if self.on_paper else tuple(self.scales.values())[-1]

    @property
    def largest(self) -> float:
        """The largest of its values that are known, true units: at a dead centre one may be none."""
        return float(np.nanmax(np.abs(self.true), initial=0.0))

    @property
    def stated(self) -> dict[str, str]:
        """The letters that its scales are written with, and their units, as far as these are known."""
        last = {} if self.on_paper else {tuple(self.scales)[-1]: self.unit}
        return {letter: {**last, **self.units}.get(letter, "") for letter in self.scales if letter}

    @property
    def places(self) -> npt.NDArray[np.intp]:
        """The places that are asked for."""
        return np.array([one.place for one in self.items], dtype=np.intp)

    def off(self, drawn: Values, due: Values) -> Sizes:
        """Give how far drawn values are from what they should be, true units; of a bearing across it."""
        apart = drawn - due
        if self.kind == ORDINATES:
            return np.asarray(np.abs((apart / self.way).real))
        if self.kind == LENGTHS:
            return np.asarray(np.abs(np.abs(drawn) - np.abs(due)))
        if self.kind == BEARINGS:
            long = np.maximum(np.abs(due), np.finfo(float).tiny)
            ahead = (drawn * due.conj()).real > 0
            return np.asarray(np.where(ahead, np.abs((drawn * due.conj()).imag) / long, np.abs(drawn) + np.abs(due)))
        return np.abs(apart)

    def allowed(self, slip: float, deviations: float) -> Sizes:
        """Give what each value may be out, true units, of a hand that slips by so many mm."""
        return np.asarray(deviations * slip * self.scale * self.error + self.slack)

    def step(self, start: int, end: int) -> float:
        """Give by what share of what is allowed at a place the step to it from another may be out: slips add up."""
        grown = max(float(self.error[end] ** 2 - self.error[start] ** 2), 0.0)
        return float(np.sqrt(grown + PRICKED**2)) / float(self.error[end])
