"""Polygons of the bank by order, forces of its mechanisms and their moments along the shaft, and compensators (M7.8).

The mechanism whose crank is ahead by an angle has its vector of order n turned by n times that angle, the one that
turns against the crank as much the other way; both turn with the direction of its guide too.

A compensator's mass that turns n times as fast as the crank has the force m*r*(n*omega)^2 (figures 8.13, 8.14); laid
off against the vector that turns with the crank, and another against the one that turns against it, both together are
against the force of order n. Where their line is off the shaft their largest force makes a couple, as large as two
masses in antiphase on two shafts make. One mass of order 1 that turns with the crank stands on the crank itself, off
which there is no line.
"""

from __future__ import annotations

import cmath
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from geometry.board import Board, Mark
from plans.bank.harmonics import COMPENSATORS, FORCE, MOMENT, STATIC, Harmonics, couple_letters, letters
from plans.model.balance.bank import Asked, BankTask, Compensator, Harmonic, Member, plain_angle
from plans.model.motion import Complexes, Floats
from plans.rotor.balancing import VectorPolygon, heading, polygon
from plans.words.words import because

MOMENTS = "bank_moments"  # the board: sums of force times place, N*m


class Total(NamedTuple):
    """A polygon over the bank, and the sum of its vectors: against what closes it."""

    polygon: VectorPolygon
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


@dataclass(frozen=True)
class CompensatorMasses:
    """The masses of a compensator on the board: with the crank, against it, of the couple; None where not needed."""

    asked: Asked
    ahead: Mark | None
    back: Mark | None
    couple: Mark | None
    harmonic: Harmonic

    def force(self, phi: Floats, speed: float) -> Complexes:
        """Give the force of both masses at crank angles rad, N."""
        square = (self.asked.order * speed) ** 2
        ahead, back = (square * _value(mark) for mark in (self.ahead, self.back))
        return Harmonic(self.asked.order, ahead, back, 0.0).at(phi)

    @property
    def stated(self) -> Compensator:
        """What is to be put on the shafts."""
        asked, harmonic = self.asked, self.harmonic
        ahead, back, couple = (_value(mark) for mark in (self.ahead, self.back, self.couple))
        return Compensator(
            asked=asked,
            with_crank=abs(ahead),
            with_angle=_angle(self.ahead),
            against=abs(back),
            against_angle=_angle(self.back),
            residual=0.0 if _on_crank(asked, self.ahead, self.back) else harmonic.size * abs(asked.offset),
            couple=None if asked.shafts is None else abs(couple),
            couple_angle=_angle(self.couple),
        )


def compensators(task: BankTask, found: Polygons) -> tuple[Board, tuple[CompensatorMasses, ...]]:
    """Read the masses of all compensators that are asked for."""
    board = Board(COMPENSATORS)
    return board, tuple(_weights(board, task, found, asked) for asked in task.asked)


def _weights(board: Board, task: BankTask, found: Polygons, asked: Asked) -> CompensatorMasses:
    harmonic, ways = found.force(asked.order), (asked.order, -asked.order)
    ahead, back = (_weight(board, task.speed, found, signed) for signed in ways)
    return CompensatorMasses(asked, ahead, back, _couple(board, asked, (ahead, back)), harmonic)


def _weight(board: Board, speed: float, found: Polygons, signed: int) -> Mark | None:
    """Divide what closes a polygon by the square of the angular speed; nothing of a polygon that closes by itself."""
    total = found.forces[signed]
    if total.vanishes:
        return None
    why = because("over_square_speed", order=abs(signed))
    return board.turn(letters(STATIC, signed), total.polygon.closing, 1 / (signed * speed) ** 2, why)


def _couple(board: Board, asked: Asked, weights: tuple[Mark | None, Mark | None]) -> Mark | None:
    """Give the mass on the shaft that is farther along the line of the force, against the couple of the offset.

    With the masses at angles alpha and beta their force is along (alpha + beta)/2 and is largest where n*phi =
    (beta - alpha)/2. Offset to the left of this line it turns clockwise then. The mass must be a quarter turn ahead of
    the line there, and so it stands a quarter turn ahead of the first mass. The force of one mass goes round, and the
    line is the reference guide: one against the crank passes it as its mirror image does that turns with the crank.
    """
    there = [weight for weight in weights if weight is not None]
    if not there or not asked.offset or not asked.shafts or _on_crank(asked, *weights):
        return None
    first = there[0] if weights[0] is not None else _mirrored(board, there[0])
    ratio = asked.offset / (asked.shafts or 1.0)
    share = sum(abs(_value(mark)) for mark in there) / abs(_value(first)) * ratio
    why = because("couple_masses", offset=f"{asked.offset:.10g}", shafts=f"{asked.shafts:.10g}")
    return board.turn(couple_letters(asked.order), first, 1j * share, why)


def _on_crank(asked: Asked, ahead: Mark | None, back: Mark | None) -> bool:
    """Tell whether the mass is a counterweight on the crank: its polygon against the crank closes by itself."""
    return asked.order == 1 and ahead is not None and back is None


def _mirrored(board: Board, mark: Mark) -> Mark:
    """Mirror a mass about the reference guide: it is to the guide as the guide is to the mass."""
    guide = board.given(f"x,{mark.name}", complex(abs(_value(mark))), because("reference_guide"))
    return board.similar(f"{mark.name}*", guide, mark, guide, why=because("mirrored_about_guide"))


def _value(mark: Mark | None) -> complex:
    return 0j if mark is None else complex(mark.point)


def _angle(mark: Mark | None) -> float | None:
    return None if mark is None else plain_angle(cmath.phase(complex(mark.point)))


def left_over(force: Complexes, weights: Sequence[CompensatorMasses], phi: Floats, speed: float) -> Complexes:
    """Add the forces of all compensators to that of the bank."""
    return np.asarray(sum((weight.force(phi, speed) for weight in weights), start=force))
