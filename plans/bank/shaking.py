"""The shaking force of one mechanism of the bank at crank angles, drawn: a slider-crank by its sizes (M7.6, M7.8)."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple, Protocol

import numpy as np

from geometry.board import Board, Mark
from geometry.precision import errors
from plans.linkage.crank_positions import even
from plans.model.balance.bank import Unit
from plans.model.motion import Complexes, Floats
from plans.words.words import because

SHAKING = "shaking"  # the board of the forces, N


class Shaking(NamedTuple):
    """The main vector of the inertia forces over a turn, N, and how far rounding can have moved each."""

    force: Complexes  # (N,)
    slack: Floats  # (N,)
    mark: Mark | None = None  # of the drawing, over all angles


class Source(Protocol):
    """What one mechanism of the bank shakes its frame with; `scale` N is the size of the forces that it is made of.

    `shaking` draws it over a turn of its crank from a start in degrees on, in so many even positions.
    """

    @property
    def scale(self) -> float: ...  # noqa: D102
    def shaking(self, start: Fraction, count: int) -> Shaking: ...  # noqa: D102


class SliderCrank(NamedTuple):
    """A slider-crank of the bank, its guide along the real axis, at an angular speed rad/s."""

    unit: Unit
    speed: float

    @property
    def scale(self) -> float:
        """The inertia force of both masses at the crank pin, N."""
        return (self.unit.rotating + self.unit.reciprocating) * self.unit.crank * self.speed**2

    def shaking(self, start: Fraction, count: int) -> Shaking:
        """Draw the mechanism, its velocities and accelerations over a turn, and add the inertia forces."""
        force = _force(self.unit, *_accelerations(self, even(start, count, +1).directions))
        slack = np.broadcast_to(errors(force)[force].place, count)
        return Shaking(np.asarray(force.point), slack, force)


def _accelerations(one: SliderCrank, directions: Complexes) -> tuple[Mark, Mark]:
    """Draw the three plans; give the accelerations of crank pin A and slider B."""
    places, speeds = Board("positions"), Board("velocities")
    shaft = places.given("O", 0j, because("drive_hinge"))
    along = places.given("x", 1 + 0j, because("reference_guide"))
    circle = places.arc("OA", shaft, one.unit.crank, because("crank_circle"))
    a = places.divide("A", circle, places.given("φ", directions, because("crank_directions")), because("divided"))
    guide, reach = places.parallel("x-x", shaft, along), places.arc("AB", a, one.unit.rod)
    b = places.meet("B", guide, reach, side=+1, why=because("on_guide", point="B", start="A"))
    crank, rod = places.join("OA", shaft, a), places.join("AB", a, b)
    pole = speeds.given("p", 0j, because("velocity_pole"))
    v_a = speeds.turn("v_A", crank, 1j * one.speed, because("crank_velocity"))
    tip = speeds.lay_off("a", pole, v_a, because("crank_end_velocity"))
    across = speeds.square("⊥AB", tip, rod, because("square_turning", line="AB"))
    v_b = speeds.meet("b", across, speeds.parallel("p-b", pole, along, because("along_guide")))
    return _second(one, (rod, along), v_a, speeds.join("v_BA", tip, v_b))


def _second(one: SliderCrank, plan: tuple[Mark, Mark], v_a: Mark, v_ba: Mark) -> tuple[Mark, Mark]:
    """Draw the plan of accelerations."""
    (rod, along), rates = plan, Board("accelerations")
    pole = rates.given("π", 0j, because("acceleration_pole"))
    a_a = rates.turn("a_A", v_a, 1j * one.speed, because("to_centre"))
    tip = rates.lay_off("a", pole, a_a, because("crank_end_acceleration"))
    end = rates.lay_off("n", tip, rates.similar("a^n_BA", v_ba, rod, v_ba, why=because("normal", line="AB")))
    across = rates.square("⊥AB", end, rod, because("tangential"))
    b = rates.meet("b", across, rates.parallel("π-b", pole, along, because("along_guide")))
    return a_a, rates.join("a_B", pole, b)


def _force(unit: Unit, a_a: Mark, a_b: Mark) -> Mark:
    """Add the inertia forces of the masses at the crank pin and at the slider."""
    board = Board(SHAKING)
    parts = [
        board.turn(f"m_{point}a_{point}", rate, mass, because("mass_at", point=point))
        for point, rate, mass in (("A", a_a, unit.rotating), ("B", a_b, unit.reciprocating))
        if mass
    ]
    return board.close("Φ", *parts, why=because("against_inertia"))
