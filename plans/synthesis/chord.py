"""The chord between two extreme places, the loci of O that demands give, and the lengths read from O (хорда B1B2)."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

import numpy as np

from geometry.board import Arc, Board, Mark, Reading, between
from geometry.meet import Sizes
from plans.model.synthesis.design import LocusCircle
from plans.words.words import because

SYNTHESIS = "synthesis"  # the board


class ExtremeChord(NamedTuple):
    """The extreme places of the driven point on a board, B1 with crank and coupler stretched, and their middle E."""

    board: Board
    stretched: Mark
    folded: Mark
    middle: Mark
    along: Mark  # the direction from B2 to B1

    @classmethod
    def between(cls, board: Board, stretched: Mark, folded: Mark) -> ExtremeChord:
        """Halve the chord of two places."""
        half = board.turn("E:h", board.join("B_2B_1", folded, stretched), 0.5, because("half_chord"))
        middle = board.lay_off("E", folded, half, because("middle_chord"))
        along = board.turn("E:u", half, 1 / abs(complex(half.point)), because("chord_way"))
        return cls(board, stretched, folded, middle, along)

    @property
    def bisector(self) -> Mark:
        """The line square to the chord in its middle."""
        return self.board["E:n"] if "E:n" in self.board else self.board.square("E:n", self.middle, self.along)

    def seen(self, overlap: float, sense: int, name: str = "M") -> Mark:
        """Draw the circle that sees the chord under an angle; +1: its centre left of the way from B1 to B2."""
        board, turned = self.board, math.pi / 2 - overlap
        to = -complex(math.cos(turned), sense * math.sin(turned))
        ray = board.turn(f"{name}:b", self.along, to, because("ray_overlap", angle=f"{math.degrees(turned):.6g}"))
        line = board.parallel(f"{name}:c", self.stretched, ray)
        centre = board.meet(name, self.bisector, line, why=because("centre_overlap"))
        radius = np.abs(between(centre, self.stretched))
        return board.arc(f"{name}:o", centre, radius, because("sees_chord", angle=f"{math.degrees(overlap):.6g}"))

    def proportioned(self, ratio: float) -> Mark:
        """Draw the circle of Apollonius: of its points the distances of B1 and B2 are as l2 + l1 to l2 - l1."""
        board, why = self.board, because("apollonius", ratio=f"{ratio:.6g}")
        inner = board.lay_off("D_1", self.folded, board.turn("N:D_1", board["E:h"], (ratio - 1) / ratio, why))
        outer = board.lay_off("D_2", self.folded, board.turn("N:D_2", board["E:h"], 1 - ratio, why))
        half = board.turn("D_2N", board.join("D_2D_1", outer, inner), 0.5)
        centre = board.lay_off("N", outer, half, because("middle_chord"))
        return board.arc("N:o", centre, np.abs(half.point), because("sees_ratio"))

    def offset(self, offset: float) -> Mark:
        """Draw the parallel at an offset right of the way from B2 to B1."""
        board = self.board
        away = board.turn("e", self.along, -1j * offset, because("offset_away"))
        return board.parallel("e:l", board.lay_off("E_e", self.middle, away), self.along, because("offset_line"))


class DrawnCrank(NamedTuple):
    """Crank and coupler read from O: the vectors of l1 and l2, both pins, how the overlap is read."""

    pivot: Mark
    crank: Mark
    coupler: Mark
    pins: tuple[Mark, Mark]
    chord: ExtremeChord
    seen: Reading

    @property
    def lengths(self) -> tuple[Sizes, Sizes]:
        """The lengths l1 and l2, m."""
        return np.abs(self.crank.point), np.abs(self.coupler.point)

    @property
    def overlap(self) -> tuple[float, float]:
        """The angle rad that the chord is seen under from O, and over which arm m it is measured."""
        far, near = (complex(between(self.pivot, end)) for end in (self.chord.stretched, self.chord.folded))
        return abs(cmath.phase(near / far)), abs(near)

    @property
    def places(self) -> dict[str, complex]:
        """O, the pins and the ends of the chord."""
        found = {"O": self.pivot, "A_1": self.pins[0], "B_1": self.chord.stretched}
        found |= {"A_2": self.pins[1], "B_2": self.chord.folded}
        return {name: complex(mark.point) for name, mark in found.items()}


def read(chord: ExtremeChord, pivot: Mark) -> DrawnCrank:
    """Read crank and coupler: OB2 is laid off on OB1, and what is left of it halved is the crank."""
    board, name = chord.board, pivot.name
    far, near = (board.join(f"{name}{one.name}", pivot, one) for one in (chord.stretched, chord.folded))
    ahead, back = (
        board.turn(f"{name}:{one}", way, np.abs(way.point) ** -1 + 0j)
        for one, way in zip("uw", (far, near), strict=True)
    )
    line = board.parallel(f"{name}:f", pivot, ahead)
    arc = board.arc(f"{name}:n", pivot, np.abs(near.point), because("near_length"))
    end = board.meet(f"{name}:D", line, arc, 1.0, because("near_on_far"))
    crank = board.turn(f"{name}:l_1", board.join(f"{name}:DB_1", end, chord.stretched), 0.5, because("half_left"))
    beyond = board.turn(f"{name}:OA_2", back, -np.abs(crank.point), because("crank_beyond"))
    pins = board.lay_off(f"{name}:A_1", pivot, crank), board.lay_off(f"{name}:A_2", pivot, beyond)
    coupler = board.join(f"{name}:l_2", pins[0], chord.stretched, because("rest_coupler"))
    turned = board.turn(f"{name}:θ", far, back.point / far.point)
    return DrawnCrank(pivot, crank, coupler, pins, chord, Reading(turned, back))


def circle_of(mark: Mark) -> LocusCircle:
    """Give a circle that is drawn."""
    assert isinstance(mark.value, Arc)  # a locus that is a circle
    return LocusCircle(complex(np.asarray(mark.value.centre)), float(np.asarray(mark.value.radius)))
