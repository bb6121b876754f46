"""The reactions of two bearings on a rotor that turns at its speed: moments about one bearing, then forces (реакции).

They turn with the rotor; weights are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.model.rotor import Resultant, Rotor
from plans.rotor.balancing import Balancing, Placed
from plans.rotor.polygon import close, rounding
from plans.words.words import because

REACTIONS = "reactions"  # the board, N
BEARINGS = "A", "B"


class Reactions(NamedTuple):
    """The reactions of bearings A and B on the rotor, and how far rounding can have moved each, N."""

    board: Board | None = None
    marks: tuple[Mark, ...] = ()
    slacks: tuple[float, ...] = ()

    @property
    def resultants(self) -> tuple[Resultant, ...]:
        """The reactions as they are told."""
        return tuple(Resultant(complex(one.point), slack) for one, slack in zip(self.marks, self.slacks, strict=True))


def reactions(balancing: Balancing) -> tuple[Reactions, Reactions]:
    """Give the reactions before and after the correction; none where the rotor has no bearings or no speed."""
    rotor = balancing.rotor
    if not rotor.bearings or rotor.speed is None:
        return Reactions(), Reactions()
    board = Board(REACTIONS)
    board.given("0", 0j, because("forces_start"))
    after = (*balancing.masses, *balancing.corrections)
    return _reactions(board, rotor, balancing.masses, ""), _reactions(board, rotor, after, "'")


def _reactions(board: Board, rotor: Rotor, acting: Sequence[Placed], prime: str) -> Reactions:
    """Find each bearing's reaction by moments about the other: each force by its share of the span."""
    found = [_reaction(board, rotor, acting, end, prime) for end in (0, 1)]
    return Reactions(board, *zip(*found, strict=True))


def _reaction(board: Board, rotor: Rotor, acting: Sequence[Placed], end: int, prime: str) -> tuple[Mark, float]:
    here, other = rotor.bearings[end], rotor.bearings[1 - end]
    assert rotor.speed is not None  # asked before
    shares = [float((one.place - other) / (here - other)) * rotor.speed**2 for one in acting]
    name = f"R_{BEARINGS[end]}{prime}"
    parts = [
        board.turn(f"{name}({one.mark.name})", one.mark, share, because("share", bearing=BEARINGS[end]))
        for one, share in zip(acting, shares, strict=True)
    ]
    mark = close(board, board["0"], name, parts, because("bearing_moments", bearing=BEARINGS[1 - end]))
    carried = sum(abs(share) * one.slack for one, share in zip(acting, shares, strict=True))
    return mark, rounding(parts) + carried
