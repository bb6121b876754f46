"""The study of a rotor: its polygons, its corrections and the reactions of its bearings, each made once."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import cached_property
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.model.rotor import CONSTRUCTION, Correction, Resultant, Rotor, RotorBalance
from plans.rotor.balancing import COUPLES, UNBALANCES, Balancing, Placed, balancing, close, rounding
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
        return tuple(Resultant(complex(mark.point), slack) for mark, slack in zip(self.marks, self.slacks, strict=True))


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
    shares = [float((placed.place - other) / (here - other)) * rotor.speed**2 for placed in acting]
    name = f"R_{BEARINGS[end]}{prime}"
    parts = [
        board.turn(f"{name}({placed.mark.name})", placed.mark, share, because("share", bearing=BEARINGS[end]))
        for placed, share in zip(acting, shares, strict=True)
    ]
    mark = close(board, board["0"], name, parts, because("bearing_moments", bearing=BEARINGS[1 - end]))
    carried = sum(abs(share) * placed.slack for placed, share in zip(acting, shares, strict=True))
    return mark, rounding(parts) + carried


class RotorStudy:
    """A rotor and what balances it by construction."""

    def __init__(self, rotor: Rotor) -> None:
        self.rotor = rotor
        self.made: set[str] = set()

    def construct(self, plans: Collection[str]) -> None:
        """Draw what is asked for."""
        if REACTIONS in plans:
            _ = self.reactions
        _ = self.drawing

    @cached_property
    def drawing(self) -> Balancing:
        """The polygons."""
        self.made |= {COUPLES, UNBALANCES}
        return balancing(self.rotor)

    @cached_property
    def reactions(self) -> tuple[Reactions, Reactions]:
        """The reactions of the bearings before and after the correction."""
        self.made.add(REACTIONS)
        return reactions(self.drawing)

    @property
    def boards(self) -> tuple[Board, ...]:
        """All boards in the order of drawing."""
        board = self.reactions[0].board
        return (*self.drawing.boards, *((board,) if board is not None else ()))

    @cached_property
    def corrected(self) -> RotorBalance:
        """What balances the rotor, whatever its bearings bear."""
        drawing, moments = self.drawing, self.drawing.moments
        pairs = zip(self.rotor.planes, drawing.corrections, strict=True)
        corrections = tuple(Correction(plane, _resultant(placed.mark, placed.slack)) for plane, placed in pairs)
        couple = _resultant(moments.closing, moments.slack, -1)
        unbalance = _resultant(drawing.unbalance.mark, drawing.unbalance.slack, -1)
        return RotorBalance(CONSTRUCTION, couple, unbalance, corrections)

    @cached_property
    def balance(self) -> RotorBalance:
        """What balances the rotor, and what its bearings bear before and after."""
        before, after = self.reactions
        return replace(self.corrected, before=before.resultants, after=after.resultants)


def _resultant(mark: Mark, slack: float, sense: int = 1) -> Resultant:
    """Read a vector, or in the sense -1 the sum that it is against."""
    return Resultant(sense * complex(mark.point), slack)
