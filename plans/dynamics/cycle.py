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
# Both sides of a jump are read off plans beside it, at this part of a strip, at twice and thrice it, and carried on to
# the edge: what that leaves out is the cube of the part, far below the width of any line, and rounding grows by seven.
BESIDE = 2.0**-20
# rad: what a stroke takes for its end, four times over; a position nearer to an edge may count as of the other stroke.
APART = 4 * ROUNDING * TURN


@dataclass(frozen=True)
class Works:
    """The curve of work by chords, the straight line of the drive's work, and what the strips are made of."""

    curve: Integral
    drive: Mark  # the straight line of the work that the drive must give
    cycle: Cycle
    middle: Reducing  # the levers at the middles of the strips
    edge: Reducing  # and at their edges
    bent: Floats  # (n, 2) N*m: by how much those at the edges may be off, as they were carried on

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
        sides, bent = self._sides
        cycle = Cycle(CONSTRUCTION, self.edges, self.breaks, sides, means, curve.values, edge.inertia)
        return Works(curve, _drive(board, curve), cycle, middle, edge, bent)

    @property
    def _sides(self) -> tuple[Floats, Floats]:
        """The moments at the beginning and at the end of each strip, (n, 2), from inside it, and how they bend there.

        They are carried on by a parabola, which leaves out less than its own second difference; a break that is placed
        otherwise shifts them along it.
        """
        low, high = self.edges[:-1], self.edges[1:]
        near = np.minimum(np.maximum(BESIDE * (high - low), APART), (high - low) / 6)
        places = [edge + k * sense * near for edge, sense in ((low, 1), (high, -1)) for k in (1, 2, 3)]
        read = self.reduction.at(np.concatenate(places))
        first, second, third = np.moveaxis(read.moment.reshape(2, 3, -1), 1, 0)
        carried = 3 * (first - second) + third
        lag = 2 * ROUNDING * TURN / near  # by which the two roads may put one break apart
        return settled(carried.T, read.size), (np.abs(first - 2 * second + third) + lag * np.abs(first - second)).T


def _drive(board: Board, curve: Integral) -> Mark:
    """Draw the work of a constant moment, which over the turn gives what the loads take: a straight line (M4.7)."""
    begin, end = curve.points[0], curve.points[-1]
    foot = board.lay_off("2π", begin, board.given("φ", complex(TURN), because("whole_turn")), because("whole_turn"))
    taken = board.join("A_us", foot, end, because("work_of_loads"))
    given = board.turn("-A_us", taken, -1.0, because("steady"))
    return board.join("A_dr", begin, board.lay_off("A_dr(2π)", foot, given, because("steady")), because("drive_line"))
