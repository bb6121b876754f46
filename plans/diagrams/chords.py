"""v by the chords of S, and a by the chords of v, each run of positions by itself (графическое дифференцирование)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from geometry.board import Board
from geometry.calculus import Derivative, derivative_by_chords
from geometry.diagram import ordinates
from plans.model.diagrams import TURN, Axis
from plans.model.motion import Floats
from plans.words.calculus import REASONS

DIAGRAMS = "diagrams"
SPEED, GROWTH = "v", "a"  # the names of the curves on the board


@dataclass(frozen=True)
class Chords:
    """The curves of v and a drawn by chords over an axis, from S at its positions; the crank turns with omega > 0.

    Abscissas are crank angles, rad, and the pole distance is the angle of a second, omega: the ordinates are v and a.
    """

    axis: Axis
    s: Floats  # (M,)
    omega: float

    @cached_property
    def board(self) -> Board:
        """The board that they are drawn on."""
        return Board(DIAGRAMS)

    @cached_property
    def speeds(self) -> tuple[Derivative, ...]:
        """The curve of v, one for each run of positions."""
        return tuple(self._speeds())

    def _speeds(self) -> Iterator[Derivative]:
        for number, run in enumerate(self.axis.runs, 1):
            name = _named(SPEED, number)
            yield derivative_by_chords(self.board, name, self.axis.turned[run], self.s[run], self.omega, why=REASONS)

    @cached_property
    def growths(self) -> tuple[Derivative | None, ...]:
        """The curve of a, one for each run; None where the run has one chord alone."""
        return tuple(self._growth(k, run) for k, run in enumerate(self.axis.runs))

    def _growth(self, k: int, run: slice) -> Derivative | None:
        x, v = self.speeds[k].middles, ordinates(self.speeds[k].points)
        if self.axis.closed:  # what the turn began with goes on beyond its end
            x, v = np.append(x, x[0] + TURN), np.append(v, v[0])
        if len(x) < 2:
            return None
        return derivative_by_chords(self.board, _named(GROWTH, k + 1), x, v, self.omega, why=REASONS)

    @property
    def of_speed(self) -> Floats:
        """v over the middles of the parts, (M - 1,); NaN where no chord is drawn."""
        values = np.full(len(self.axis.turned) - 1, np.nan)
        for run, drawn in zip(self.axis.runs, self.speeds, strict=True):
            values[run.start : run.stop - 1] = ordinates(drawn.points)
        return values

    @property
    def of_growth(self) -> Floats:
        """a over the places of the axis, (M,); NaN where no chord is drawn."""
        values = np.full(len(self.axis.turned), np.nan)
        for run, drawn in zip(self.axis.runs, self.growths, strict=True):
            if drawn is not None:
                told = ordinates(drawn.points)
                values[run.start + 1 : run.start + 1 + len(told)] = told
        if self.axis.closed:
            values[0] = values[-1]
        return values


def _named(letter: str, number: int) -> str:
    return letter if number == 1 else f"{letter}_{number}"
