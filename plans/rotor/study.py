"""The study of a rotor: its polygons, its corrections and the reactions of its bearings, each made once."""

from __future__ import annotations

from functools import cached_property

from geometry.board import Mark
from plans.model.rotor import CONSTRUCTION, Balance, Correction, Resultant, Rotor
from plans.rotor.balancing import Balancing, Placed, balancing
from plans.rotor.bearings import Reactions, reactions
from plans.rotor.polygon import Polygon


class RotorStudy:
    """A rotor and what balances it by construction."""

    def __init__(self, rotor: Rotor) -> None:
        self.rotor = rotor

    @cached_property
    def drawing(self) -> Balancing:
        """The polygons."""
        return balancing(self.rotor)

    @cached_property
    def reactions(self) -> tuple[Reactions, Reactions]:
        """The reactions of the bearings before and after the correction."""
        return reactions(self.drawing)

    @cached_property
    def balance(self) -> Balance:
        """What balances the rotor, as it is told."""
        found, (before, after) = self.drawing, self.reactions
        pairs = zip(self.rotor.planes, found.corrections, strict=True)
        corrections = tuple(Correction(plane, _moment(one)) for plane, one in pairs)
        couple = _sum(found.moments.closing, found.moments)
        unbalance = _sum(found.unbalance, found.forces)
        return Balance(CONSTRUCTION, couple, unbalance, corrections, before.resultants, after.resultants)


def _moment(one: Placed) -> Resultant:
    return Resultant(complex(one.mark.point), one.slack)


def _sum(closing: Mark, among: Polygon) -> Resultant:
    """Give the sum of vectors that a closing vector is against."""
    return Resultant(-complex(closing.point), among.slack)
