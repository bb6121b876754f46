"""Balance quality grades of ISO 21940-11: a grade bounds e*omega, the speed of the mass centre (класс точности)."""

from __future__ import annotations

import math
from typing import Final

GRADES: Final = (0.4, 1.0, 2.5, 6.3, 16.0, 40.0, 100.0, 250.0, 630.0, 1600.0, 4000.0)  # mm/s
MILLIMETRES = 1000.0


def permissible(grade: float, mass: float, speed: float) -> float:
    """Give the residual unbalance kg*m that a grade mm/s permits a rotor of a mass kg at a speed rad/s.

    >>> round(1e6 * permissible(6.3, 20.0, 314.159265), 1)
    401.1
    """
    return grade / MILLIMETRES * mass / abs(speed)


def quality(unbalance: float, mass: float, speed: float) -> float:
    """Give e*omega in mm/s of an unbalance kg*m, of a rotor of a mass kg at a speed rad/s."""
    return MILLIMETRES * unbalance / mass * abs(speed)


def grade_of(value: float) -> float | None:
    """Give the finest grade that holds e*omega mm/s; None where it is beyond the coarsest.

    >>> grade_of(0.0), grade_of(6.3), grade_of(7.0), grade_of(5000.0)
    (0.4, 6.3, 16.0, None)
    """
    return next((grade for grade in GRADES if value <= grade), None)


def nearest_grade(value: float) -> float:
    """Give the grade that a value mm/s differs from by the smallest factor; of zero the finest.

    >>> nearest_grade(7.0), nearest_grade(0.0)
    (6.3, 0.4)
    """
    return min(GRADES, key=lambda grade: abs(math.log(grade / value))) if value > 0 else GRADES[0]


def letters(grade: float) -> str:
    """Write a grade as the standard does.

    >>> letters(6.3), letters(16.0)
    ('G6.3', 'G16')
    """
    return f"G{grade:g}"
