"""How transfer functions are lettered: u_31' as u′_{31}, S_B'' as S″_{B} (обозначения передаточных функций)."""

from __future__ import annotations

from drawings.lettering.words import word
from plans.quantity import Quantity

PRIMES = ("", "′", "″")


def markup(name: str) -> str:
    """Letter a transfer function by its name.

    >>> markup("u_31"), markup("u_31'"), markup("S_B''")
    ('u_{31}', 'u′_{31}', 'S″_{B}')
    """
    bare = name.rstrip("'")
    symbol, _, index = bare.partition("_")
    return f"{symbol}{PRIMES[len(name) - len(bare)]}_{{{index}}}"


def named(found: Quantity, language: str) -> str:
    """Name a row of a table of them, with its unit."""
    return f"{markup(found.name)}, {word(language, found.unit)}" if found.unit else markup(found.name)
