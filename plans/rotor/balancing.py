"""Balancing by polygons laid off end to end: of moments for plane I, of forces for the other (8.5)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.model.rotor import EPS, ROUNDING, Plane, Resultant, Rotor, Unbalance
from plans.words.words import Message, because, message

QUARTERS = (1 + 0j, 1j, -1 + 0j, -1j)


def heading(angle: Fraction) -> complex:
    """Give the direction at an angle; taken from the nearest quarter turn it loses no digit.

    >>> heading(Fraction(90)), heading(Fraction(540))
    (1j, (-1+0j))
    """
    quarter = round(angle / 90)
    rest = float(angle - 90 * quarter)
    return QUARTERS[quarter % 4] * cmath.rect(1.0, math.radians(rest)) if rest else QUARTERS[quarter % 4]


def unbalance_letters(name: str) -> str:
    """Letter a static moment.

    >>> unbalance_letters("II")
    'm_IID_II'
    """
    return f"m_{name}D_{name}"


def moment_letters(name: str) -> str:
    """Letter the moment of a static moment about the last plane of correction.

    >>> moment_letters("2")
    'm_2D_2h_2'
    """
    return f"{unbalance_letters(name)}h_{name}"


CLOSES = because("closes_polygon")
RUN = 8  # vectors laid off in one row: a row of a thousand like ones would lose digits with each


class Laid(NamedTuple):
    """A side of a polygon: its vector, and the corners between which it lies."""

    vector: Mark
    start: Mark
    end: Mark


class VectorPolygon(NamedTuple):
    """A polygon of vectors: its sides in order, what closes it, and how far rounding can have moved that."""

    board: Board
    sides: tuple[Laid, ...]
    closing: Mark
    slack: float

    @property
    def resultant(self) -> Resultant:
        """What closes the polygon."""
        return Resultant(complex(self.closing.point), self.slack)

    @property
    def closed(self) -> bool:
        """Whether the vectors close by themselves."""
        return self.resultant.vanishes


def polygon(
    board: Board, pole: Mark, name: str, vectors: Sequence[Mark], carried: float = 0.0, why: Message = CLOSES
) -> VectorPolygon:
    """Lay vectors off one after another from a pole and close them; a vector of no length has no side.

    `carried` is how far rounding can have moved the vectors themselves.
    """
    kept = [vector for vector in vectors if vector.point]
    sides = _row(board, pole, name, kept)
    closing = close(board, pole, name, kept, why) if len(kept) > RUN else board.join(name, _end(pole, sides), pole, why)
    return VectorPolygon(board, sides, closing, rounding(kept) + carried)


def close(board: Board, pole: Mark, name: str, vectors: Sequence[Mark], why: Message) -> Mark:
    """Close any number of vectors: laid off in runs, and the ends of the runs likewise."""
    level = 0
    while len(vectors) > RUN:
        runs = [vectors[k : k + RUN] for k in range(0, len(vectors), RUN)]
        level += 1
        vectors = [_end(pole, _row(board, pole, f"{name}/{level}.{k}", run)) for k, run in enumerate(runs, 1)]
    return board.close(name, *vectors, why=why)


def rounding(vectors: Sequence[Mark]) -> float:
    """Give how far rounding can have moved the sum of some vectors."""
    return ROUNDING * EPS * sum(abs(complex(vector.point)) for vector in vectors)


def _row(board: Board, pole: Mark, name: str, vectors: Sequence[Mark]) -> tuple[Laid, ...]:
    sides: list[Laid] = []
    for number, vector in enumerate(vectors, 1):
        start = _end(pole, sides)
        sides.append(Laid(vector, start, board.lay_off(f"{name}:{number}", start, vector, because("end_to_end"))))
    return tuple(sides)


def _end(pole: Mark, sides: Sequence[Laid]) -> Mark:
    return sides[-1].end if sides else pole


COUPLES, UNBALANCES = "couples", "unbalances"  # the boards: vectors m*D*h kg*m2, and m*D kg*m


class Placed(NamedTuple):
    """A static moment on the board, its place m along the shaft, and how far rounding can have moved it, kg*m."""

    mark: Mark
    place: Fraction
    slack: float = 0.0


@dataclass(frozen=True)
class Balancing:
    """The polygons that balance a rotor: of moments about the last plane, and of static moments.

    `corrections` are the static moments to be put in the planes, in their order; one that vanishes is among them.
    """

    rotor: Rotor
    masses: tuple[Placed, ...]
    moments: VectorPolygon
    forces: VectorPolygon
    corrections: tuple[Placed, ...]
    unbalance: Placed  # against the sum of the static moments, before any correction

    @property
    def boards(self) -> tuple[Board, ...]:
        """The boards in the order of drawing."""
        return self.moments.board, self.forces.board


def balancing(rotor: Rotor) -> Balancing:
    """Draw the polygon of moments, then that of static moments; one plane takes the second alone."""
    board = Board(UNBALANCES)
    pole = board.given("0", 0j, because("static_start"))
    masses = tuple(_mass(board, mass) for mass in rotor.masses)
    moments = _moments(rotor, masses)
    first = (_first(board, rotor, moments),) if rotor.dynamic else ()
    vectors = [placed.mark for placed in (*masses, *(() if moments.closed else first))]
    last = rotor.planes[-1]
    forces = polygon(board, pole, unbalance_letters(last.name), vectors, sum(placed.slack for placed in first))
    given = [placed.mark for placed in masses]
    unbalance = Placed(close(board, pole, "ΣmD", given, because("against_all")), last.place, rounding(given))
    corrections = *first, Placed(forces.closing, last.place, forces.slack)
    return Balancing(rotor, masses, moments, forces, corrections, unbalance)


def _mass(board: Board, mass: Unbalance) -> Placed:
    why = because("static_moment", mass=mass.name, angle=f"{float(mass.angle):.10g}")
    return Placed(board.given(unbalance_letters(mass.name), mass.moment * heading(mass.angle), why), mass.place)


def _moments(rotor: Rotor, masses: Sequence[Placed]) -> VectorPolygon:
    """Draw the polygon of moments about the last plane, from which arms are measured."""
    board, last = Board(COUPLES), rotor.planes[-1]
    pole = board.given("0", 0j, because("moments_start"))
    vectors = [
        board.turn(moment_letters(mass.name), placed.mark, rotor.arm(mass.place), _arm(rotor, mass, "times_arm"))
        for mass, placed in zip(rotor.masses, masses, strict=True)
    ]
    name = moment_letters(rotor.planes[0].name) if rotor.dynamic else "ΣmDh"
    return polygon(board, pole, name, vectors, why=because("closes_about", place=_named(rotor, last)))


def _first(board: Board, rotor: Rotor, moments: VectorPolygon) -> Placed:
    """Give the correction in plane I: what closes the moments, over its arm."""
    plane, arm = rotor.planes[0], rotor.arm(rotor.planes[0].place)
    mark = board.turn(unbalance_letters(plane.name), moments.closing, 1 / arm, _arm(rotor, plane, "over_arm"))
    return Placed(mark, plane.place, moments.slack / abs(arm))


def _arm(rotor: Rotor, part: Unbalance | Plane, how: str) -> Message:
    arm, last = f"{rotor.arm(part.place):.10g}", rotor.planes[-1]
    return because(how, mass=part.name, arm=arm, place=_named(rotor, last))


def _named(rotor: Rotor, plane: Plane) -> Message:
    return message("place.plane", plane=plane.name) if rotor.dynamic else message("place.correction")
