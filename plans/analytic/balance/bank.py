"""A bank of mechanisms by harmonics of its members, each a linkage of its own (блок механизмов)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import cache, cached_property
from typing import NamedTuple, Protocol

import numpy as np

from plans.analytic.balance.mass_centre import mass_centre
from plans.analytic.kinematics import Analysis
from plans.analytic.points import acceleration
from plans.analytic.rotor import direction
from plans.model.balance.bank import (
    ANALYSIS,
    EPS,
    HARMONIC,
    ROUNDING,
    STEPS,
    Asked,
    BankBalance,
    BankTask,
    Compensator,
    Harmonic,
    Member,
    Unit,
    plain_angle,
)
from plans.model.machine import Body
from plans.model.motion import Complexes, Floats, Rates

FEWEST, MOST = 256, 2**16  # samples of a turn: what orders up to 6 need at the least, and where doubling ends


def even(count: int) -> Floats:
    """Give crank angles rad that divide a turn evenly, from 0 on, the end left out."""
    return 2 * np.pi * np.arange(count) / count


def harmonics(vector: Callable[[Floats], Complexes], orders: Iterable[int], scale: float = 0.0) -> dict[int, Harmonic]:
    """Give harmonics of a vector of crank angles rad (N,): samples are doubled until the transform settles.

    `scale` is the size of what the vector is the sum of: where all but nothing is left of it, rounding counts by that.
    """
    ordered = sorted(set(orders))
    samples = vector(even(FEWEST))
    before, now = np.fft.fft(samples) / FEWEST, _finer(vector, samples)
    while not _settled(before, now, ordered, scale) and len(now[0]) < MOST:
        before, now = now[1], _finer(vector, now[0])
    samples, row = now
    slack = ROUNDING * EPS * max(float(np.abs(samples).max()), scale)
    return {n: _harmonic(n, row, before, slack) for n in ordered}


def _finer(vector: Callable[[Floats], Complexes], samples: Complexes) -> tuple[Complexes, Complexes]:
    """Double the samples of a turn by those half way between them; give them, and their transform."""
    count = 2 * len(samples)
    finer = np.empty(count, dtype=np.complex128)
    finer[::2], finer[1::2] = samples, vector(even(count)[1::2])
    return finer, np.fft.fft(finer) / count


def _settled(before: Complexes, now: tuple[Complexes, Complexes], orders: Iterable[int], scale: float) -> bool:
    """Tell whether doubling moves the harmonics by rounding alone."""
    samples, row = now
    rounding = ROUNDING * EPS * max(float(np.abs(samples).max()), scale)
    return all(abs(row[n] - before[n]) <= rounding for order in orders for n in (order, -order))


def _harmonic(order: int, row: Complexes, before: Complexes, slack: float) -> Harmonic:
    moved = max(abs(row[n] - before[n]) for n in (order, -order))
    return Harmonic(order, complex(row[order]), complex(row[-order]), max(slack, float(moved)))


LOOKS = 72  # positions of a turn over which the size of the forces is taken


class ExactLinkage:
    """A linkage by analysis whose crank turns evenly at an angular speed rad/s, with all that has mass."""

    def __init__(
        self, road: Analysis, bodies: Sequence[Body], speed: float, phi: Floats, orders: Sequence[int]
    ) -> None:
        self.mechanism, self.bodies, self.orders = road.mechanism, bodies, orders
        self.road = Analysis(road.mechanism, road.tolerance, road.first, road.looks, lambda _: Rates(speed, 0.0))
        self.road.motion(phi, 0)  # by which the way round is marched

    @cached_property
    def scale(self) -> float:
        """The largest sum of the sizes of all inertia forces, N."""
        motion = self.road.around(2 * np.pi * np.arange(LOOKS) / LOOKS)
        rows = [
            np.abs(body.mass * acceleration(self.mechanism, motion, body.link, body.centre)) for body in self.bodies
        ]
        return float(np.max(np.sum(rows, axis=0)))

    def harmonic(self, signed: int) -> complex:
        """Give the vector of a signed order, N."""
        harmonic = self._harmonics[abs(signed)]
        return harmonic.ahead if signed > 0 else harmonic.back

    @cached_property
    def _harmonics(self) -> dict[int, Harmonic]:
        return harmonics(self._force, self.orders, self.scale)

    def shaking(self, phase: Fraction) -> Complexes:
        """Give the shaking force over the turn from a phase on, N."""
        start = float(phase) * np.pi / 180
        return self._force(start + 2 * np.pi * np.arange(STEPS + 1) / STEPS)

    def _force(self, phi: Floats) -> Complexes:
        return mass_centre(self.mechanism, self.bodies, self.road.around(np.mod(phi, 2 * np.pi))).force


def slider_harmonic(unit: Unit, order: int) -> float:
    """Give the amplitude of cos(n phi) in the slider's distance from the shaft, m; odd ones beyond the first are 0.

    >>> f"{slider_harmonic(Unit(0.1, 0.4, 0.0, 9.5), 2):.10g}"
    '0.006350626058'
    """
    if order % 2:
        return unit.crank if order == 1 else 0.0
    root = math.sqrt((unit.rod - unit.crank) * (unit.rod + unit.crank)) / unit.rod
    return unit.rod * (1 + root) * _coefficient(order // 2, (unit.ratio / (1 + root)) ** 2)


def _coefficient(m: int, p: float) -> float:
    """Give the coefficient of e^(2i m phi) in sqrt((1 + p e^(2i phi)) (1 + p e^(-2i phi)))."""
    first, term = math.prod((1.5 - k) / k for k in range(1, m + 1)) * p**m, 1.0
    terms, j = [term], 0
    while abs(term) > EPS * EPS:  # each next term is less than p^2 times the last
        term *= (j - 0.5) * (j + m - 0.5) / ((j + 1) * (j + m + 1)) * p * p
        terms.append(term)
        j += 1
    return first * math.fsum(terms)


def slider_acceleration(unit: Unit, cosine: Floats, sine: Floats) -> Floats:
    """Give the second derivative of the slider's distance by the crank angle, m."""
    ratio = unit.ratio
    rod = (cosine**2 - sine**2 + ratio**2 * sine**4) / np.sqrt((1 - ratio * sine) * (1 + ratio * sine)) ** 3
    return np.asarray(-unit.crank * (cosine + ratio * rod))


def shaking(unit: Unit, speed: float, heading: Complexes) -> Complexes:
    """Give the main vector of a slider-crank's inertia forces in directions of its crank from its guide, N."""
    slider = slider_acceleration(unit, heading.real, heading.imag)
    return np.asarray(speed**2 * (unit.rotating * unit.crank * heading - unit.reciprocating * slider))


class BankMechanism(Protocol):
    """One mechanism of the bank by analysis; `scale` N is the size of the forces that shake it.

    `shaking` is its force over the turn from a phase of its crank in degrees on, (STEPS + 1,) N.
    """

    @property
    def scale(self) -> float: ...  # noqa: D102
    def harmonic(self, signed: int) -> complex: ...  # noqa: D102
    def shaking(self, phase: Fraction) -> Complexes: ...  # noqa: D102


class ExactSliderCrank(NamedTuple):
    """A slider-crank by its closed series, at an angular speed rad/s."""

    unit: Unit
    speed: float

    @property
    def scale(self) -> float:
        """The inertia force of both masses at the crank pin, N."""
        return math.fsum((self.unit.rotating, self.unit.reciprocating)) * self.unit.crank * self.speed**2

    def harmonic(self, signed: int) -> complex:
        """Give the vector of a signed order, N."""
        unit, order = self.unit, abs(signed)
        slider = unit.reciprocating * order**2 * slider_harmonic(unit, order) / 2
        return complex(self.speed**2 * (slider + (unit.rotating * unit.crank if signed == 1 else 0.0)))

    def shaking(self, phase: Fraction) -> Complexes:
        """Give the shaking force over the turn."""
        return shaking(self.unit, self.speed, turn() * direction(phase))


@cache
def turn() -> Complexes:
    """Give the directions that divide a turn evenly, from 0 on, the last the first once more."""
    return np.array([direction(Fraction(360 * k, STEPS)) for k in range(STEPS + 1)])


def bank_balance(task: BankTask, mechanism: BankMechanism) -> BankBalance:
    """Find the harmonics of a bank and its compensators."""
    orders = tuple(dict.fromkeys((*task.orders, *(asked.order for asked in task.asked))))
    single = {order: _single(mechanism, order) for order in orders}
    forces = {order: _summed(harmonic, task.members, [1.0] * len(task.members)) for order, harmonic in single.items()}
    places = [float(member.place) for member in task.members]
    moments = {order: _summed(harmonic, task.members, places) for order, harmonic in single.items()}
    found = tuple(_compensator(asked, forces[asked.order], task.speed) for asked in task.asked)
    phi, (force, moment, largest) = np.linspace(0.0, 2 * np.pi, STEPS + 1), _whole(mechanism, task.members, places)
    return BankBalance(
        by=ANALYSIS,
        task=task,
        single=single,
        forces=forces,
        moments=moments,
        compensators=found,
        phi=phi,
        force=force,
        left=np.sum([force, *(_pushes(compensator, task.speed, phi) for compensator in found)], axis=0),
        moment=moment,
        force_slack=HARMONIC * EPS * largest * len(places),
        moment_slack=HARMONIC * EPS * largest * math.fsum(map(abs, places)),
    )


def _whole(
    mechanism: BankMechanism, members: Sequence[Member], places: Sequence[float]
) -> tuple[Complexes, Complexes, float]:
    """Sum force N and moment N*m of the bank over the turn; give the largest force of one mechanism too, N."""
    turns = {phase: mechanism.shaking(phase) for phase in {member.phase % 360 for member in members}}
    terms = np.array([direction(member.axis) * turns[member.phase % 360] for member in members])
    return terms.sum(axis=0), np.array(places) @ terms, max(mechanism.scale, float(np.max(np.abs(terms))))


def _single(mechanism: BankMechanism, order: int) -> Harmonic:
    ahead, back = (mechanism.harmonic(signed) for signed in (order, -order))
    return Harmonic(order, ahead, back, HARMONIC * EPS * mechanism.scale)


def _summed(harmonic: Harmonic, members: Sequence[Member], weights: Sequence[float]) -> Harmonic:
    order, axes = harmonic.order, [direction(member.axis) for member in members]
    rows = list(zip(weights, axes, [direction(order * member.phase) for member in members], strict=True))
    ahead = [harmonic.ahead * (weight * axis * phase) for weight, axis, phase in rows]
    back = [harmonic.back * (weight * axis * phase.conjugate()) for weight, axis, phase in rows]
    sizes = [max(abs(a), abs(b)) for a, b in zip(ahead, back, strict=True)]
    slack = harmonic.slack * math.fsum(map(abs, weights)) + ROUNDING * EPS * math.fsum(sizes)
    return Harmonic(order, _sum(ahead), _sum(back), slack)


def _sum(terms: Iterable[complex]) -> complex:
    found = list(terms)
    return complex(math.fsum(vector.real for vector in found), math.fsum(vector.imag for vector in found))


def _compensator(asked: Asked, force: Harmonic, speed: float) -> Compensator:
    """Find the masses whose forces are against those of an order, and those of the couple that their offset makes."""
    square = (asked.order * speed) ** 2
    against = [0j if abs(vector) <= force.slack else -vector for vector in (force.ahead, force.back)]
    sizes = [abs(vector) for vector in against]
    angles = [plain_angle(cmath.phase(vector)) if vector else None for vector in against]
    single = asked.order == 1 and sizes[0] > 0.0 == sizes[1]  # on the crank, whatever offset is asked for
    residual = 0.0 if single else math.fsum(sizes) * abs(asked.offset)
    couple = None if asked.shafts is None else residual / (square * asked.shafts)
    return Compensator(
        asked,
        *(sizes[0] / square, angles[0], sizes[1] / square, angles[1]),
        residual,
        couple,
        _couple_angle(against, asked.offset) if couple else None,
    )


def _couple_angle(forces: Sequence[complex], offset: float) -> float:
    """Give the angle of the couple's mass, by the moment of both forces over the turn.

    Off a line u by an offset z to its left they have Re(-z (conj(u) ahead + u conj(back)) e^(i n phi)), and the couple
    of a mass at an angle has Re(-i conj(u) e^(i angle) e^(i n phi)) of its largest. Of one force alone u is the guide.
    """
    ahead, back = forces
    twice = ahead / abs(ahead) * back / abs(back) if ahead and back else 1.0  # u^2
    return plain_angle(cmath.phase(1j * offset * (ahead + twice * back.conjugate())))


def _pushes(compensator: Compensator, speed: float, phi: Floats) -> Complexes:
    square, turn = (compensator.asked.order * speed) ** 2, compensator.asked.order * phi
    ahead = compensator.with_crank * np.exp(1j * (turn + (compensator.with_angle or 0.0)))
    return np.asarray(square * (ahead + compensator.against * np.exp(1j * ((compensator.against_angle or 0.0) - turn))))
