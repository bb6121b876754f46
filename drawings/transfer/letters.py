"""How transfer functions are lettered: u_31' as u′_{31}, S_B'' as S″_{B} (обозначения передаточных функций)."""

from __future__ import annotations

import numpy as np

from drawings.page.page import Drafting
from plans.quantity import Comparison, Quantity

PRIMES = ("", "′", "″")


def markup(name: str) -> str:
    """Letter a transfer function by its name.

    >>> markup("u_31"), markup("u_31'"), markup("S_B''")
    ('u_{31}', 'u′_{31}', 'S″_{B}')
    """
    bare = name.rstrip("'")
    symbol, _, index = bare.partition("_")
    return f"{symbol}{PRIMES[len(name) - len(bare)]}_{{{index}}}"


def named(found: Quantity, drafting: Drafting) -> str:
    """Name a row of the table of values."""
    return f"{markup(found.name)}, {drafting.word(found.unit)}" if found.unit else markup(found.name)


def told(comparison: Comparison) -> list[Quantity]:
    """List what the table tells: all that is anywhere more than rounding."""
    return [
        found
        for found in comparison.findings
        if np.nanmax(np.abs(found.analysis), initial=0.0) > np.nanmax(found.allowed, initial=0.0)
    ]
