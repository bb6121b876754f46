"""Compensators of the bank's forces: masses on counter-rotating shafts, read off the polygons (figures 8.13, 8.14).

A mass that turns n times as fast as the crank has the force m*r*(n*omega)^2; laid off against the vector that turns
with the crank, and another against the one that turns against it, both together are against the force of order n. Where
their line is off the shaft their largest force makes a couple, as large as two masses in antiphase on two shafts make.
One mass of order 1 that turns with the crank stands on the crank itself, off which there is no line.
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from geometry.board import Board, Mark
from plans.bank.harmonics import STATIC, couple_letters, letters
from plans.bank.polygons import Polygons
from plans.model.balance.bank import Asked, BankTask, Compensator, Harmonic, plain_angle
from plans.model.motion import Complexes, Floats
from plans.words.words import because

COMPENSATORS = "compensators"  # the board: static moments m*r, kg*m


@dataclass(frozen=True)
class Weights:
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
    def told(self) -> Compensator:
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


def compensators(task: BankTask, found: Polygons) -> tuple[Board, tuple[Weights, ...]]:
    """Read the masses of all compensators that are asked for."""
    board = Board(COMPENSATORS)
    return board, tuple(_weights(board, task, found, asked) for asked in task.asked)


def _weights(board: Board, task: BankTask, found: Polygons, asked: Asked) -> Weights:
    harmonic, ways = found.force(asked.order), (asked.order, -asked.order)
    ahead, back = (_weight(board, task.speed, found, signed) for signed in ways)
    return Weights(asked, ahead, back, _couple(board, asked, (ahead, back)), harmonic)


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
    return _antiphase(board, asked, first, sum(abs(_value(mark)) for mark in there))


def _on_crank(asked: Asked, ahead: Mark | None, back: Mark | None) -> bool:
    """Tell whether the mass is a counterweight on the crank: its polygon against the crank closes by itself."""
    return asked.order == 1 and ahead is not None and back is None


def _mirrored(board: Board, mark: Mark) -> Mark:
    """Mirror a mass about the reference guide: it is to the guide as the guide is to the mass."""
    guide = board.given(f"x,{mark.name}", complex(abs(_value(mark))), because("reference_guide"))
    return board.similar(f"{mark.name}*", guide, mark, guide, why=because("mirrored_about_guide"))


def _antiphase(board: Board, asked: Asked, first: Mark, total: float) -> Mark:
    ratio = asked.offset / (asked.shafts or 1.0)
    share = total / abs(_value(first)) * ratio
    why = because("couple_masses", offset=f"{asked.offset:.10g}", shafts=f"{asked.shafts:.10g}")
    return board.turn(couple_letters(asked.order), first, 1j * share, why)


def _value(mark: Mark | None) -> complex:
    return 0j if mark is None else complex(mark.point)


def _angle(mark: Mark | None) -> float | None:
    return None if mark is None else plain_angle(cmath.phase(complex(mark.point)))


def left_over(force: Complexes, weights: Sequence[Weights], phi: Floats, speed: float) -> Complexes:
    """Add the forces of all compensators to that of the bank."""
    return np.asarray(sum((weight.force(phi, speed) for weight in weights), start=force))
