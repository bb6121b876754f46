"""The works of a steady turn by graphical integration of the reduced moment (графики работ, M4.7, figure 6.6)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from geometry.board import Board, Mark
from geometry.calculus import Integral, integral
from geometry.strips import middles, strips
from plans.dynamics.breaks import breaks
from plans.dynamics.reduction import Reducing, Reduction
from plans.forces.stroke import ROUNDING
from plans.model.dynamics import CONSTRUCTION, TURN, Cycle, settled
from plans.model.motion import Floats
from plans.words.calculus import REASONS
from plans.words.words import because

WORKS = "works"
# Both sides of a jump are read off plans beside it, at this part of a strip and at twice it, and carried on to the
# edge: what that leaves out is the square of the part, far below the width of any line, and rounding grows by three.
BESIDE = 2.0**-20
# rad: what a stroke takes for its end, four times over; a position nearer to an edge may count as of the other stroke.
APART = 4 * ROUNDING * TURN


@dataclass(frozen=True)
class Works:
    """The curve of work by chords, the straight line of the drive's work, and what the strips are made of."""

    curve: Integral
    drive: Mark  # from the beginning to the end of the curve, turned over: the work that the drive must give
    cycle: Cycle
    middle: Reducing  # the levers at the middles of the strips
    edge: Reducing  # and at their edges

    @property
    def board(self) -> Board:
        """The board that they are drawn on."""
        return self.curve.board


class Turn:
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
    def works(self) -> Works:
        """Draw the curve of work from the moments at the middles of all strips."""
        middle, edge = self.reduction.at(middles(self.edges)), self.reduction.at(self.edges)
        means = settled(middle.moment, middle.size)
        board = Board(WORKS)
        curve = integral(board, "A", self.edges, means, why=REASONS)
        whole = board.join("A_us", curve.points[0], curve.points[-1], because("work_of_loads"))
        drive = board.turn("A_dr", board.given("φ", complex(TURN), because("whole_turn")), 1.0, because("steady"))
        drive = board.lay_off("A_dr", drive, board.turn("-A_us", whole, -1.0, because("steady")), because("steady"))
        cycle = Cycle(CONSTRUCTION, self.edges, self.breaks, self._sides, means, curve.values, edge.inertia)
        return Works(curve, drive, cycle, middle, edge)

    @property
    def _sides(self) -> Floats:
        """The moments at the beginning and at the end of each strip, from inside it."""
        low, high = self.edges[:-1], self.edges[1:]
        near = np.minimum(np.maximum(BESIDE * (high - low), APART), (high - low) / 4)
        read = self.reduction.at(np.concatenate([low + near, low + 2 * near, high - near, high - 2 * near]))
        first, second, last, before = read.moment.reshape(4, -1)
        return settled(np.stack([2 * first - second, 2 * last - before], axis=1), read.size)
