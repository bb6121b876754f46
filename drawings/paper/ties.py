"""Ties: values that differ by a rounding alone are equal where one of them is chosen, on every computer (равенство)."""

from __future__ import annotations

from collections.abc import Iterable

PLACES = 6
# Far over what the last bits of a processor make of millimetres, 1e-12, and far under what is seen of them, 1e-3.
MARGIN = 10.0**-PLACES


def tied(value: float) -> float:
    """Give what a value counts in a choice, mm or a share: of those that are tied the first is taken.

    >>> min((0.3, 0.1 + 0.2 - 1e-12), key=tied), tied(-1e-12)
    (0.3, 0.0)
    """
    return round(value, PLACES) + 0.0


def tied_spot(value: complex) -> complex:
    """Give what a place or a way counts in a choice: one straight to the left has no lean up or down.

    >>> tied_spot(-2 - 1e-15j)
    (-2+0j)
    """
    return complex(tied(value.real), tied(value.imag))


def apart(spots: Iterable[complex]) -> Iterable[complex]:
    """Give places in their order, of those that are tied the first.

    >>> list(apart([1j, 2j, 1j + 1e-12]))
    [1j, 2j]
    """
    found: dict[complex, complex] = {}
    for spot in spots:
        found.setdefault(tied_spot(spot), spot)
    return found.values()
