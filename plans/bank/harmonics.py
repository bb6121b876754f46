"""Harmonics of the shaking force of one mechanism by polygons of its ordinates (гармонический анализ).

A turn is divided evenly; each ordinate over their number, turned back by n times its crank angle, is laid off end to
end: the end is the vector of the harmonic of order n at the crank angle 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple, Protocol

import numpy as np

from geometry.board import Board, Mark
from geometry.errors import ConstructionError
from geometry.precision import errors
from plans.linkage.primary import directions, even
from plans.model.balance.bank import EPS, HARMONIC, Harmonic, Unit
from plans.model.motion import Complexes, Floats
from plans.rotor.balancing import RUN
from plans.words.words import Message, because, message

SINGLE, FORCE, MOMENT, STATIC = "f", "F", "M", "mr"
COUPLE = "mr_M,"  # of the masses that make a couple
NUMERALS = ((90, "XC"), (50, "L"), (40, "XL"), (10, "X"), (9, "IX"), (5, "V"), (4, "IV"), (1, "I"))


def roman(number: int) -> str:
    """Write an order in Roman numerals, as orders are lettered; from a hundred on in figures.

    >>> roman(6), roman(14), roman(100)
    ('VI', 'XIV', '100')
    """
    if number >= 100:
        return str(number)
    text = ""
    for size, numeral in NUMERALS:
        text += numeral * (number // size)
        number %= size
    return text


def letters(kind: str, signed: int, member: str = "") -> str:
    """Letter a harmonic's vector, or the share of one mechanism in it.

    >>> letters(FORCE, -2, "3"), letters(MOMENT, 1)
    ('F_-II,3', 'M_I')
    """
    sign = "-" if signed < 0 else ""
    return f"{kind}_{sign}{roman(abs(signed))}" + (f",{member}" if member else "")


def couple_letters(order: int) -> str:
    """Letter the static moment of each mass of the compensator of a couple.

    >>> couple_letters(1)
    'mr_M,I'
    """
    return f"{COUPLE}{roman(order)}"


SHAKING = "shaking"  # the board of the forces, N


class Shaking(NamedTuple):
    """The main vector of the inertia forces over a turn, N, and how far rounding can have moved each."""

    force: Complexes  # (N,)
    slack: Floats  # (N,)


class Shaker(Protocol):
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
        return Shaking(np.asarray(force.point), slack)


def _accelerations(engine: SliderCrank, directions: Complexes) -> tuple[Mark, Mark]:
    """Draw the three plans; give the accelerations of crank pin A and slider B."""
    places, speeds = Board("positions"), Board("velocities")
    shaft = places.given("O", 0j, because("drive_hinge"))
    along = places.given("x", 1 + 0j, because("reference_guide"))
    circle = places.arc("OA", shaft, engine.unit.crank, because("crank_circle"))
    a = places.divide("A", circle, places.given("φ", directions, because("crank_directions")), because("divided"))
    guide, reach = places.parallel("x-x", shaft, along), places.arc("AB", a, engine.unit.rod)
    b = places.meet("B", guide, reach, side=+1, why=because("on_guide", point="B", start="A"))
    crank, rod = places.join("OA", shaft, a), places.join("AB", a, b)
    pole = speeds.given("p", 0j, because("velocity_pole"))
    v_a = speeds.turn("v_A", crank, 1j * engine.speed, because("crank_velocity"))
    tip = speeds.lay_off("a", pole, v_a, because("crank_end_velocity"))
    across = speeds.square("⊥AB", tip, rod, because("square_turning", line="AB"))
    v_b = speeds.meet("b", across, speeds.parallel("p-b", pole, along, because("along_guide")))
    return _second(engine, (rod, along), v_a, speeds.join("v_BA", tip, v_b))


def _second(engine: SliderCrank, plan: tuple[Mark, Mark], v_a: Mark, v_ba: Mark) -> tuple[Mark, Mark]:
    """Draw the plan of accelerations."""
    (rod, along), rates = plan, Board("accelerations")
    pole = rates.given("π", 0j, because("acceleration_pole"))
    a_a = rates.turn("a_A", v_a, 1j * engine.speed, because("to_centre"))
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


HARMONICS = "harmonics"  # the board: forces, N
COMPENSATORS = "compensators"  # the board: static moments m*r, kg*m
FEWEST, MOST = 16, 2**14  # ordinates of a turn: begun with, and at the most
END_TO_END = because("end_to_end")


class NotSettled(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """The acceleration all but jumps within the turn, and no number of ordinates gives its harmonics."""


class Harmonics(NamedTuple):
    """The polygons of ordinates: the vector of every signed order, and how far rounding can have moved each, N."""

    board: Board
    pole: Mark
    vectors: Mapping[int, Mark]
    slack: float  # what is less is none
    bound: float  # how far a vector can be out, by the conditions of the plans that the ordinates are taken from
    ordinates: Complexes  # of the turn, N

    def harmonic(self, order: int) -> Harmonic:
        """Read the harmonic of an order."""
        ahead, back = (complex(self.vectors[signed].point) for signed in (order, -order))
        return Harmonic(order, ahead, back, self.slack)

    def beyond(self, count: int, order: int) -> float:
        """Give by how much higher orders can falsify one that is found from so few ordinates, N."""
        row = np.fft.fftshift(np.abs(np.fft.fft(self.ordinates))) / len(self.ordinates)
        orders = np.arange(len(row)) - len(row) // 2
        false = [(orders % count == signed % count) & (orders != signed) for signed in (order, -order)]
        return float(max(row[orders_alike].sum() for orders_alike in false))


def harmonics(source: Shaker, orders: Sequence[int]) -> Harmonics:
    """Divide the turn until the harmonics settle, and draw their polygons."""
    return of_ordinates(source, _settled(source, orders), orders)


def of_ordinates(source: Shaker, shaking: Shaking, orders: Sequence[int]) -> Harmonics:
    """Draw the polygons of some ordinates."""
    count, board = len(shaking.force), Board(HARMONICS)
    pole = board.given("0", 0j, because("forces_start"))
    ordinates = [
        board.given(f"Φ({k})", complex(force), because("ordinate", angle=f"{360 * k / count:.10g}"))
        for k, force in enumerate(shaking.force)
    ]
    vectors = {signed: _polygon(board, pole, ordinates, signed) for signed in _signed(orders)}
    rounding = _rounding(source, shaking)
    return Harmonics(board, pole, vectors, rounding, float(np.mean(shaking.slack)) + rounding, shaking.force)


def _rounding(source: Shaker, shaking: Shaking) -> float:
    """Give what a harmonic can be of rounding alone: more where the conditions of the plans are bad."""
    return max(HARMONIC * EPS * source.scale, float(np.mean(shaking.slack)))


def _settled(source: Shaker, orders: Sequence[int]) -> Shaking:
    """Draw the mechanism at twice as many angles until the harmonics stay where they are."""
    count = FEWEST
    while count <= 2 * max(orders):  # of fewer ordinates an order cannot be told from a lower one
        count *= 2
    while count <= MOST:
        shaking = source.shaking(Fraction(0), count)
        limit = _rounding(source, shaking)
        moved = max(abs(a - b) for a, b in _both(shaking.force, orders))
        if moved <= limit:
            return shaking
        count *= 2
    raise NotSettled(message("bank.not_settled", most=MOST))


def _both(force: Complexes, orders: Sequence[int]) -> Iterable[tuple[complex, complex]]:
    """Give every vector by all ordinates, and by every other one."""
    signed = _signed(orders)
    fine, coarse = (np.fft.fft(row) / len(row) for row in (force, force[::2]))
    return ((complex(fine[n % len(fine)]), complex(coarse[n % len(coarse)])) for n in signed)


def _signed(orders: Sequence[int]) -> list[int]:
    return [sign * order for order in orders for sign in (1, -1)]


def _polygon(board: Board, pole: Mark, ordinates: Sequence[Mark], signed: int) -> Mark:
    """Turn the ordinates back by their angles times the order, and lay them off end to end."""
    count, name, why = len(ordinates), letters(SINGLE, signed), because("turned_back", order=signed)
    backs = (directions(-360 * signed * np.arange(count), count) / count).tolist()
    turned = [
        board.turn(f"{name}({k})", ordinate, backs[k], why) for k, ordinate in enumerate(ordinates) if ordinate.point
    ]
    return end_of(board, pole, name, turned, because("harmonic_end"))


def end_of(board: Board, pole: Mark, name: str, vectors: Sequence[Mark], why: Message) -> Mark:
    """Lay vectors off end to end from a pole, many of them in runs; the end is their sum."""
    level = 0
    while len(vectors) > RUN:
        runs = [vectors[k : k + RUN] for k in range(0, len(vectors), RUN)]
        level += 1
        vectors = [_row(board, pole, (f"{name}/{level}.{k}", ""), run, END_TO_END) for k, run in enumerate(runs, 1)]
    return _row(board, pole, (f"{name}/", name), vectors, why)


def _row(board: Board, pole: Mark, names: tuple[str, str], vectors: Sequence[Mark], why: Message) -> Mark:
    stem, name = names
    end = pole
    for number, vector in enumerate(vectors, 1):
        last = number == len(vectors) and name
        end = board.lay_off(name if last else f"{stem}:{number}", end, vector, why if last else END_TO_END)
    return end
