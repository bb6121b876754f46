"""Worked values printed with ten significant digits: a result must give every one of them."""

from __future__ import annotations

DIGITS = 10
NOTHING = 1e-14  # a true zero leaves a few roundings of values of order 1 to 10


def printed(*values: complex) -> tuple[complex, ...]:
    """Write values as a worked example prints them: ten significant digits of each coordinate."""
    return tuple(complex(_printed(complex(value).real), _printed(complex(value).imag)) for value in values)


def _printed(number: float) -> float:
    return 0.0 if abs(number) < NOTHING else float(f"{number:.{DIGITS}g}")
