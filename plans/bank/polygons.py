"""Polygons of the bank: for every order the forces of its mechanisms, and their moments along the shaft (M7.8).

The mechanism whose crank is ahead by an angle has its vector of order n turned by n times that angle, the one that
turns against the crank as much the other way; both turn with the direction of its guide too.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.bank.harmonics import FORCE, MOMENT, Harmonics, letters
from plans.model.balance.bank import Harmonic, Member
from plans.rotor.balancing import Polygon, heading, polygon
from plans.words.words import because

MOMENTS = "bank_moments"  # the board: sums of force times place, N*m


class Total(NamedTuple):
    """A polygon over the bank, and the sum of its vectors: against what closes it."""

    polygon: Polygon
    vector: Mark

    @property
    def vanishes(self) -> bool:
        """Whether the vectors close by themselves."""
        return self.polygon.closed


@dataclass(frozen=True)
class Polygons:
    """The polygons of the bank's forces and moments by signed order."""

    forces: Mapping[int, Total]
    moments: Mapping[int, Total]
    moment_board: Board

    def force(self, order: int) -> Harmonic:
        """Read the harmonic of the bank's force."""
        return _read(self.forces, order)

    def moment(self, order: int) -> Harmonic:
        """Read the harmonic of the bank's moment about the plane of place 0."""
        return _read(self.moments, order)


def polygons(single: Harmonics, members: tuple[Member, ...]) -> Polygons:
    """Draw the polygons of every order over the mechanisms of the bank."""
    couples = Board(MOMENTS)
    pole = couples.given("0", 0j, because("moments_start"))
    forces, moments = {}, {}
    for signed, vector in single.vectors.items():
        shares = [_share(single.board, vector, signed, member) for member in members]
        carried = single.slack * len(members)
        forces[signed] = _total(single.board, single.pole, letters(FORCE, signed), shares, carried)
        turned = [_moment(couples, share, signed, member) for share, member in zip(shares, members, strict=True)]
        carried = single.slack * sum(abs(float(member.place)) for member in members)
        moments[signed] = _total(couples, pole, letters(MOMENT, signed), turned, carried)
    return Polygons(forces, moments, couples)


def _total(board: Board, pole: Mark, name: str, vectors: list[Mark], carried: float) -> Total:
    found = polygon(board, pole, f"-{name}", vectors, carried)
    return Total(found, board.turn(name, found.closing, -1.0, because("against_closing")))


def _share(board: Board, vector: Mark, signed: int, member: Member) -> Mark:
    """Turn the vector of one mechanism as it stands in the bank."""
    why = because("in_the_bank", member=member.name, order=signed, phase=_text(member.phase), axis=_text(member.axis))
    return board.turn(letters(FORCE, signed, member.name), vector, heading(signed * member.phase + member.axis), why)


def _moment(board: Board, share: Mark, signed: int, member: Member) -> Mark:
    why = because("times_place", member=member.name, place=_text(member.place))
    return board.turn(letters(MOMENT, signed, member.name), share, float(member.place), why)


def _text(value: object) -> str:
    return f"{float(value):.10g}"  # type: ignore[arg-type]


def _read(found: Mapping[int, Total], order: int) -> Harmonic:
    ahead, back = found[order], found[-order]
    slack = max(ahead.polygon.slack, back.polygon.slack)
    return Harmonic(order, complex(ahead.vector.point), complex(back.vector.point), slack)
