"""The closed series of a slider-crank's harmonics (ряд Фурье ускорения ползуна; M7.8).

With lambda the crank over the rod, sqrt(1 - lambda^2 sin^2) = sqrt(A (1 + p e^(2i phi)) (1 + p e^(-2i phi))), where
lambda' = sqrt(1 - lambda^2), p = lambda^2/(1 + lambda')^2 and sqrt(A) = (1 + lambda')/2. Both roots are binomial series
in p < 1, and their product gives every coefficient as a series in p^2 whose terms but the first are of one sign.
"""

from __future__ import annotations

import math

import numpy as np

from plans.model.balance.bank import EPS, Unit
from plans.model.motion import Complexes, Floats


def slider_harmonic(unit: Unit, order: int) -> float:
    """Give the amplitude of cos(n phi) in the slider's distance from the shaft, m; odd ones beyond the first are 0.

    >>> f"{slider_harmonic(Unit(0.1, 0.4, 0.0, 9.5), 2):.10g}"
    '0.006350626058'
    """
    if order % 2:
        return unit.crank if order == 1 else 0.0
    root = math.sqrt((unit.rod - unit.crank) * (unit.rod + unit.crank)) / unit.rod
    p = (unit.ratio / (1 + root)) ** 2
    return unit.rod * (1 + root) * _coefficient(order // 2, p)


def _coefficient(m: int, p: float) -> float:
    """Give the coefficient of e^(2i m phi) in sqrt((1 + p e^(2i phi)) (1 + p e^(-2i phi)))."""
    first, term = _binomials(m) * p**m, 1.0
    terms, j = [term], 0
    while abs(term) > EPS * EPS:  # each next term is less than p^2 times the last
        term *= (j - 0.5) * (j + m - 0.5) / ((j + 1) * (j + m + 1)) * p * p
        terms.append(term)
        j += 1
    return first * math.fsum(terms)


def _binomials(m: int) -> float:
    """Give the binomial coefficient of 1/2 over m."""
    return math.prod((1.5 - k) / k for k in range(1, m + 1))


def slider_acceleration(unit: Unit, cosine: Floats, sine: Floats) -> Floats:
    """Give the second derivative of the slider's distance by the crank angle, m."""
    ratio = unit.ratio
    root = np.sqrt((1 - ratio * sine) * (1 + ratio * sine))
    rod = (cosine**2 - sine**2 + ratio**2 * sine**4) / root**3
    return np.asarray(-unit.crank * (cosine + ratio * rod))


def shaking(unit: Unit, speed: float, heading: Complexes) -> Complexes:
    """Give the main vector of a slider-crank's inertia forces in directions of its crank from its guide, N."""
    slider = slider_acceleration(unit, heading.real, heading.imag)
    return np.asarray(speed**2 * (unit.rotating * unit.crank * heading - unit.reciprocating * slider))
