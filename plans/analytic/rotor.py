"""Balancing of a rotor by sums of components, each correction by moments about the other's plane (M7.2, M7.3).

Sums are exact but for one rounding each, and no polygon is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction

from plans.model.rotor import ANALYSIS, EPS, ROUNDING, Correction, Resultant, Rotor, RotorBalance, Unbalance


def balance(rotor: Rotor, borne: bool = True) -> RotorBalance:
    """Find what balances a rotor and, if `borne` is asked for, what its bearings bear before and after."""
    loads = [(moment(mass), mass.place) for mass in rotor.masses]
    corrections = tuple(_correction(rotor, loads, k) for k in range(len(rotor.planes)))
    added = [(correction.moment.value, correction.plane.place) for correction in corrections]
    carried = [correction.moment.slack for correction in corrections]
    return RotorBalance(
        by=ANALYSIS,
        couple=_resultant([(load, rotor.arm(place)) for load, place in loads]),
        unbalance=_resultant([(load, 1.0) for load, _ in loads]),
        corrections=corrections,
        before=_reactions(rotor, loads, []) if borne else (),
        after=_reactions(rotor, [*loads, *added], [*[0.0] * len(loads), *carried]) if borne else (),
    )


def moment(mass: Unbalance) -> complex:
    """Give a static moment kg*m by its components along and across the direction of angle 0."""
    along = direction(mass.angle)
    return complex(mass.moment * along.real, mass.moment * along.imag)


def direction(angle: Fraction) -> complex:
    """Give the unit vector at an angle in degrees, by its sine and cosine.

    >>> direction(Fraction(450))
    1j
    """
    angle %= 360
    return complex(_sine((angle + 90) % 360), _sine(angle))


def _sine(angle: Fraction) -> float:
    """Give the sine of an angle from 0 to 360 degrees, by the series' own range of at most 45."""
    if angle > 180:
        return -_sine(angle - 180)
    if angle > 90:
        angle = 180 - angle
    return math.cos(math.radians(90 - angle)) if angle > 45 else math.sin(math.radians(angle))


def _correction(rotor: Rotor, loads: Sequence[tuple[complex, Fraction]], k: int) -> Correction:
    """Give the correction in a plane: against each static moment by its share of the span, all of it in one plane."""
    plane = rotor.planes[k]
    if not rotor.dynamic:
        return Correction(plane, _resultant([(load, -1.0) for load, _ in loads]))
    other = rotor.planes[1 - k].place
    span = plane.place - other
    return Correction(plane, _resultant([(load, float((other - place) / span)) for load, place in loads]))


def _reactions(
    rotor: Rotor, loads: Sequence[tuple[complex, Fraction]], carried: Sequence[float]
) -> tuple[Resultant, ...]:
    """Give the reactions of the bearings on the rotor, by moments about the other one."""
    if not rotor.bearings or rotor.speed is None:
        return ()
    resultants = []
    for here, other in (rotor.bearings, rotor.bearings[::-1]):
        shares = [float((other - place) / (here - other)) * rotor.speed**2 for _, place in loads]
        slack = sum(abs(share) * off for share, off in zip(shares, carried, strict=False))
        resultants.append(_resultant(zip((load for load, _ in loads), shares, strict=True), slack))
    return tuple(resultants)


def _resultant(weighted: Iterable[tuple[complex, float]], carried: float = 0.0) -> Resultant:
    """Sum vectors times numbers; `carried` is how far rounding can have moved the vectors themselves."""
    terms = [load * times for load, times in weighted]
    value = complex(math.fsum(term.real for term in terms), math.fsum(term.imag for term in terms))
    return Resultant(value, ROUNDING * EPS * math.fsum(map(abs, terms)) + carried)
