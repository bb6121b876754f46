"""Letters of links, teeth and ratios of a train, their indices lowered (обозначения)."""

from __future__ import annotations

from drawings.lettering.words import with_index


def link_letters(name: str) -> str:
    """Letter a link: a wheel's by its number, a carrier, a brake or a clutch with its number lowered.

    >>> link_letters("12"), link_letters("H1")
    ('12', 'H_{1}')
    """
    return name if name[0].isdigit() else with_index(name)


def teeth_letters(wheel: str) -> str:
    """Letter a number of teeth, its primes on the index.

    >>> teeth_letters("2'")
    "z_{2'}"
    """
    return f"z_{{{wheel}}}"
