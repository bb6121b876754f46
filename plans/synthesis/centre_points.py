"""Places of a hinge seen from a body, the pivot on their perpendicular bisectors, and whether a link leads there."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from geometry.board import Board, Mark, between
from geometry.meet import cross
from plans.model.synthesis.positions import MOST_TIMES, TOUCH, TWO
from plans.words.words import because


def centres(
    board: Board, name: str, places: Sequence[Mark], arm: float | None, about: Mark | None = None
) -> Iterator[Mark]:
    """Draw the centre of the circle through three places; of two the centres at a length from the first, or another."""
    lines = [_bisector(board, *pair) for pair in pairwise(places) if _apart(*pair)]
    if len(lines) < len(places) - 1:
        return
    if len(places) == TWO:
        assert arm is not None  # asked before
        yield from _at_length(board, name, lines[0], about or places[0], arm)
        return
    found = board.meet(name, lines[0], lines[1], why=because("bisectors_meet"))
    chords = [abs(complex(between(places[0], place))) for place in places[1:]]
    if min(chords) > 0 and abs(complex(between(places[0], found))) < MOST_TIMES * max(chords):
        yield found


def _at_length(board: Board, name: str, line: Mark, about: Mark, arm: float) -> Iterator[Mark]:
    arc = board.arc(f"{name}:o", about, arm, because("arm_length"))
    for prime, sense in (("", 1.0), ("'", -1.0)):
        found = board.meet(f"{name}{prime}", line, arc, sense, because("bisector_arm"))
        if found.sharpness is not None and float(found.sharpness) > TOUCH:  # not where there is none
            yield found


def _apart(first: Mark, second: Mark) -> bool:
    return abs(complex(between(first, second))) > 0


def _bisector(board: Board, first: Mark, second: Mark) -> Mark:
    """Draw the perpendicular bisector of two places, directed left of the way from one to the other."""
    name = f"{first.name}{second.name}"
    if f"{name}:n" in board:
        return board[f"{name}:n"]
    chord = board.join(name, first, second)
    along = board.turn(f"{name}:u", chord, 1 / abs(complex(chord.point)))
    middle = board.lay_off(f"{name}:m", first, board.turn(f"{name}:h", chord, 0.5))
    return board.square(f"{name}:n", middle, along, because("bisector", way=name))


def middles(board: Board, letter: str, places: Sequence[Mark]) -> dict[str, Mark]:
    """Give the middles of the ways between places, from which their bisectors go."""
    pairs = enumerate(pairwise(places), 1)
    return {f"{letter}_{k}{k + 1}": board[f"{first.name}{second.name}:m"] for k, (first, second) in pairs}


def pole(board: Board, name: str, first: Mark, second: Mark, turn: float) -> Mark:
    """Draw the pole of two positions: it sees the way of each point under the turn, from the bisector."""
    line = _bisector(board, first, second)
    ray = board.turn(f"{name}:b", board[f"{first.name}{second.name}"], 1j * cmath.rect(1.0, -turn / 2))
    through = board.parallel(f"{name}:c", first, ray, because("pole_ray"))
    return board.meet(name, line, through, why=because("pole"))


class Bars(NamedTuple):
    """A four-bar in its positions on a board: the pivot of the link that leads, its ends, those of the other."""

    board: Board
    pivot: Mark
    hinges: Sequence[Mark]
    ends: Sequence[Mark]
    other: Mark

    @property
    def turned(self) -> Bars:
        """The same led by its other link."""
        return Bars(self.board, self.other, self.ends, self.hinges, self.pivot)

    @property
    def lengths(self) -> tuple[float, float, float, float]:
        """The lengths of leading link, coupler, driven link and frame, m."""
        pairs = (self.pivot, self.hinges[0]), (self.hinges[0], self.ends[0]), (self.other, self.ends[0])
        crank, coupler, rocker, frame = (abs(complex(between(*pair))) for pair in (*pairs, (self.pivot, self.other)))
        return crank, coupler, rocker, frame

    @property
    def tightest(self) -> float:
        """The least of the angles rad between coupler and driven link."""
        angles = [
            crossing(complex(between(hinge, end)), complex(between(self.other, end)))
            for hinge, end in zip(self.hinges, self.ends, strict=True)
        ]
        return min(angles)

    def led(self) -> list[float] | None:
        """Give the turns rad of the leading link from the first position, in its sense; None where it cannot lead."""
        hands = [
            float(cross(between(a, self.other), between(a, b))) for a, b in zip(self.hinges, self.ends, strict=True)
        ]
        angles = [cmath.phase(complex(between(self.pivot, a))) for a in self.hinges]
        sense = sense_of(angles, self._dead())
        if not sense or min(hands) < 0 < max(hands) or self.tightest < TOUCH:
            return None
        return [sense * way for way in ways(angles, sense)]

    def _dead(self) -> Iterator[float]:
        """Notch where coupler and driven link are in one line, and give the angles of the leading link there."""
        crank, coupler, rocker, _ = self.lengths
        circle = self.board.arc("lead:o", self.pivot, crank)
        for reach in (coupler + rocker, abs(coupler - rocker)):
            arc = self.board.arc("reach:o", self.other, reach, because("dead_reach"))
            for side in (1.0, -1.0):
                met = complex(between(self.pivot, self.board.meet("dead", circle, arc, side)))
                if abs(met) >= 0:  # it does meet
                    yield cmath.phase(met)


def sense_of(angles: Sequence[float], dead: Iterable[float]) -> int:
    """Tell in which sense a crank goes through its angles rad in their order, and over no dead one: +1, -1, or 0.

    >>> sense_of([0.0, 1.0, 2.0], [3.0]), sense_of([0.0, 2.0, 1.0], [3.0]), sense_of([0.0, 1.0], [0.5, 5.0])
    (1, 0, 0)
    """
    barred = [*dead]
    for sense in (1, -1):
        way = [*ways(angles, sense)]
        if all(one < other for one, other in pairwise(way)) and all(
            (sense * (one - angles[0])) % math.tau > way[-1] for one in barred
        ):
            return sense
    return 0


def ways(angles: Sequence[float], sense: int) -> Iterator[float]:
    """Give how far a crank has turned from the first of its angles, in a sense: rad, not negative.

    >>> [round(one, 6) for one in ways([3.0, -3.0], 1)]
    [0.0, 0.283185]
    """
    return ((sense * (one - angles[0])) % math.tau for one in angles)


def crossing(one: complex, other: complex) -> float:
    """Give the angle rad between two lines, at most a right one."""
    angle = abs(cmath.phase(other / one))
    return min(angle, math.pi - angle)
