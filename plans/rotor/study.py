"""The study of a rotor: its polygons, its corrections and the reactions of its bearings, each made once."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from geometry.board import Board, Mark
from plans.model.rotor import CONSTRUCTION, Balance, Correction, Resultant, Rotor
from plans.rotor.balancing import COUPLES, UNBALANCES, Balancing, balancing
from plans.rotor.bearings import REACTIONS, Reactions, reactions

if TYPE_CHECKING:
    from plans.study import Study


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
    def corrected(self) -> Balance:
        """What balances the rotor, whatever its bearings bear."""
        drawing, moments = self.drawing, self.drawing.moments
        pairs = zip(self.rotor.planes, drawing.corrections, strict=True)
        corrections = tuple(Correction(plane, _resultant(one.mark, one.slack)) for plane, one in pairs)
        couple = _resultant(moments.closing, moments.slack, -1)
        return Balance(
            CONSTRUCTION, couple, _resultant(drawing.unbalance.mark, drawing.unbalance.slack, -1), corrections
        )

    @cached_property
    def balance(self) -> Balance:
        """What balances the rotor, and what its bearings bear before and after."""
        before, after = self.reactions
        return replace(self.corrected, before=before.resultants, after=after.resultants)


def _resultant(mark: Mark, slack: float, sense: int = 1) -> Resultant:
    """Read a vector, or in the sense -1 the sum that it is against."""
    return Resultant(sense * complex(mark.point), slack)


def study_of(study: Study) -> RotorStudy:
    """Make the study of a scene's rotor (row of the table of techniques)."""
    return RotorStudy(study.scene.meaning["rotor"].rotor)
