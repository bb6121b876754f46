"""Balancing by polygons: that of moments gives the correction in plane I, that of forces the other (8.5)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.model.rotor import Plane, Rotor, Unbalance
from plans.rotor.heading import heading
from plans.rotor.letters import moment_letters, unbalance_letters
from plans.rotor.polygon import Polygon, close, polygon, rounding
from plans.words.words import Message, because, message

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
    moments: Polygon
    forces: Polygon
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
    masses = tuple(_mass(board, one) for one in rotor.masses)
    moments = _moments(rotor, masses)
    first = (_first(board, rotor, moments),) if rotor.dynamic else ()
    laid = [one.mark for one in (*masses, *(() if moments.closed else first))]
    last = rotor.planes[-1]
    forces = polygon(board, pole, unbalance_letters(last.name), laid, sum(one.slack for one in first))
    given = [one.mark for one in masses]
    unbalance = Placed(close(board, pole, "ΣmD", given, because("against_all")), last.place, rounding(given))
    corrections = *first, Placed(forces.closing, last.place, forces.slack)
    return Balancing(rotor, masses, moments, forces, corrections, unbalance)


def _mass(board: Board, one: Unbalance) -> Placed:
    why = because("static_moment", mass=one.name, angle=f"{float(one.angle):.10g}")
    return Placed(board.given(unbalance_letters(one.name), one.moment * heading(one.angle), why), one.place)


def _moments(rotor: Rotor, masses: Sequence[Placed]) -> Polygon:
    """Draw the polygon of moments about the last plane, from which arms are measured."""
    board, last = Board(COUPLES), rotor.planes[-1]
    pole = board.given("0", 0j, because("moments_start"))
    vectors = [
        board.turn(moment_letters(one.name), placed.mark, rotor.arm(one.place), _arm(rotor, one, "times_arm"))
        for one, placed in zip(rotor.masses, masses, strict=True)
    ]
    name = moment_letters(rotor.planes[0].name) if rotor.dynamic else "ΣmDh"
    return polygon(board, pole, name, vectors, why=because("closes_about", place=_named(rotor, last)))


def _first(board: Board, rotor: Rotor, moments: Polygon) -> Placed:
    """Give the correction in plane I: what closes the moments, over its arm."""
    plane, arm = rotor.planes[0], rotor.arm(rotor.planes[0].place)
    mark = board.turn(unbalance_letters(plane.name), moments.closing, 1 / arm, _arm(rotor, plane, "over_arm"))
    return Placed(mark, plane.place, moments.slack / abs(arm))


def _arm(rotor: Rotor, one: Unbalance | Plane, how: str) -> Message:
    arm, last = f"{rotor.arm(one.place):.10g}", rotor.planes[-1]
    return because(how, mass=one.name, arm=arm, place=_named(rotor, last))


def _named(rotor: Rotor, plane: Plane) -> Message:
    return message("place.plane", plane=plane.name) if rotor.dynamic else message("place.correction")
