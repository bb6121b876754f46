"""The letters of a bank's vectors: of order two F_II turns with the crank, F_-II against it (обозначения).

A harmonic is named by its order with a sign, +n of the vector that turns with the crank and -n of the other; f is of
one mechanism, F and M are of the bank, and F_II,3 is the share of its mechanism 3.
"""

from __future__ import annotations

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
