"""Random constructions: every verb of the board, on what was drawn before, near dead centres too."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, field
from typing import Any

from hypothesis import strategies as st

from geometry.board import Board, Mark
from geometry.precision import condition, errors

# A bound is of first order: it tells the truth while a mark moves little beside its distance from a dead centre.
FIRST_ORDER = 1e-3

shares = st.floats(0.2, 3)
angles = st.floats(-3.1, 3.1)
closeness = st.one_of(st.floats(0.1, 0.9), st.floats(-11, -1).map(lambda power: 10.0**power))
sides = st.sampled_from([1.0, -1.0])
coordinates = st.floats(-5, 5)
places = st.builds(complex, coordinates, coordinates)


@dataclass
class Construction:
    """Two boards with what was drawn on them, sorted by what can be done with it."""

    board: Board = field(default_factory=lambda: Board("positions"))
    other: Board = field(default_factory=lambda: Board("velocities"))
    points: list[Mark] = field(default_factory=list)
    vectors: list[Mark] = field(default_factory=list)
    units: list[Mark] = field(default_factory=list)

    @property
    def marks(self) -> list[Mark]:
        """All marks in drafting order."""
        return [*self.board, *self.other]

    def name(self) -> str:
        return f"M{len(self.board)}"

    def sure(self, mark: Mark) -> bool:
        """Tell whether a mark is drawn, of some size, and known to first order."""
        if cmath.isnan(complex(mark.point)) or abs(complex(mark.point)) < 1e-6:
            return False
        kappa = float(condition(mark)) if mark.sharpness is not None else 1.0
        return float(errors(mark)[mark].place.max()) * kappa < FIRST_ORDER * min(abs(complex(mark.point)), 1.0)


class Draughtsman:
    """Draws one act after another; `draw` takes a value from a strategy."""

    def __init__(self, draw: Any, drawn: Construction) -> None:
        self.draw, self.drawn = draw, drawn

    def one(self, marks: list[Mark]) -> Mark:
        return self.draw(st.sampled_from(marks))

    def two(self) -> tuple[Mark, Mark, float]:
        """Two points apart from each other, and how far."""
        first, second = self.one(self.drawn.points), self.one(self.drawn.points)
        return first, second, abs(complex(second.point) - complex(first.point))

    def act(self) -> None:
        """Do one act of the trade."""
        acts = (self.notch, self.guide, self.crossing, self.slot, self.chain, self.figure, self.circle, self.equation)
        self.draw(st.sampled_from(acts))()

    def notch(self) -> None:
        """Two arcs, as near to touching as the drawn closeness says."""
        first, second, apart = self.two()
        if apart < 1e-3:
            return
        board, radius, gap = self.drawn.board, apart * self.draw(shares), self.draw(closeness)
        low, high = abs(apart - radius), apart + radius
        near = self.draw(st.booleans())
        other = low + gap * (high - low) if near else high - gap * (high - low)
        loci = board.arc(board_name(board), first, radius), board.arc(board_name(board), second, other)
        self.keep(board.meet(board_name(board), *loci, side=self.draw(sides)), self.drawn.points)

    def guide(self) -> None:
        """A line through a point and an arc about another."""
        through, centre, _ = self.two()
        board, unit = self.drawn.board, self.one(self.drawn.units)
        verb = board.parallel if self.draw(st.booleans()) else board.square
        line = verb(board_name(board), through, unit)
        direction = complex(line.value.direction)
        height = abs((direction.conjugate() * (complex(centre.point) - complex(through.point))).imag)
        arc = board.arc(board_name(board), centre, (height + 0.1) * (1 + self.draw(closeness)))
        pair = (line, arc) if self.draw(st.booleans()) else (arc, line)
        self.keep(board.meet(board_name(board), *pair, side=self.draw(sides)), self.drawn.points)

    def crossing(self) -> None:
        """Two lines of the directions of two vectors."""
        first, second, _ = self.two()
        board = self.drawn.board
        lines = (
            board.parallel(board_name(board), first, self.one(self.drawn.vectors)),
            board.square(board_name(board), second, self.one(self.drawn.vectors)),
        )
        self.keep(board.meet(board_name(board), *lines), self.drawn.points)

    def slot(self) -> None:
        """The direction of a slot that passes a pivot and holds a pin."""
        pivot, pin, apart = self.two()
        board = self.drawn.board
        if apart > 1e-3:
            offset = apart * (1 - self.draw(closeness)) * self.draw(sides)
            self.keep(board.tangent(board_name(board), pivot, pin, offset, self.draw(sides)), self.drawn.units)

    def chain(self) -> None:
        """Two points joined, the vector laid off elsewhere, and the chain closed."""
        first, second, _ = self.two()
        board = self.drawn.board
        vector = board.join(board_name(board), first, second)
        self.keep(vector, self.drawn.vectors)
        self.keep(board.lay_off(board_name(board), self.one(self.drawn.points), vector), self.drawn.points)
        self.keep(board.close(board_name(board), vector, self.one(self.drawn.vectors)), self.drawn.vectors)

    def figure(self) -> None:
        """A vector carried to the other board, turned, and a figure similar to it."""
        board, other, vectors = self.drawn.board, self.drawn.other, self.drawn.vectors
        carried = other.transfer(board_name(other), self.one(vectors))
        other.turn(board_name(other), carried, cmath.rect(self.draw(shares), self.draw(angles)))
        image, of, shape = (self.one(vectors) for _ in range(3))
        self.keep(board.similar(board_name(board), image, of, shape, self.draw(shares)), vectors)

    def circle(self) -> None:
        """A circle divided at a given direction."""
        board = self.drawn.board
        circle = board.arc(board_name(board), self.one(self.drawn.points), self.draw(shares))
        direction = board.given(board_name(board), cmath.rect(1.0, self.draw(angles)))
        self.keep(direction, self.drawn.units)
        self.keep(board.divide(board_name(board), circle, direction), self.drawn.points)

    def equation(self) -> None:
        """The moments of a force and of a couple about a point, balanced by a force along a line."""
        board, vectors = self.drawn.board, self.drawn.vectors
        about, at, _ = self.two()
        through = self.one(self.drawn.points)
        line = board.square(board_name(board), through, self.one(vectors))
        moments = [board.moment(board_name(board), about, at, self.one(vectors))]
        moments.append(board.couple(board_name(board), self.one(vectors), self.one(vectors), self.draw(shares)))
        if through is not about:
            self.keep(board.balance(board_name(board), about, line, *moments), vectors)
        board.close(board_name(board), *moments)

    def keep(self, mark: Mark, among: list[Mark]) -> None:
        """Use a mark in later acts if it can be used."""
        if self.drawn.sure(mark):
            among.append(mark)
            if among is self.drawn.units:
                self.drawn.vectors.append(mark)


def board_name(board: Board) -> str:
    """Name the next mark of a board."""
    return f"M{len(board)}"


@st.composite
def constructions(draw: Any) -> Construction:
    """Draw two points, a unit vector, and up to eight acts on them."""
    drawn = Construction()
    board = drawn.board
    first = draw(places)
    second = first + cmath.rect(draw(shares), draw(angles))
    drawn.points += [board.given("A", first), board.given("C", second)]
    drawn.vectors.append(board.join("AC", *drawn.points))
    drawn.units.append(board.given("e", cmath.rect(1.0, draw(st.floats(0.1, math.pi)))))
    drawn.vectors.append(drawn.units[0])
    hand = Draughtsman(draw, drawn)
    for _ in range(draw(st.integers(1, 8))):
        hand.act()
    return drawn
