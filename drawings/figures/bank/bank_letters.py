"""Letters of the vectors of many members: each with its letters, or numbered alone (обозначения многих механизмов)."""

from __future__ import annotations

from drawings.figures.rotor.letters import FEW
from drawings.lettering.bank_letters import lowered
from drawings.page.drafting import Drafting


def letter(name: str, count: int) -> str:
    """Letter one of so many vectors: with its letters, or of many by the number of its member alone.

    >>> letter("F_II,3", 4), letter("F_II,3", 12), letter("F_II", 12)
    ('F_{II,3}', '3', 'F_{II}')
    """
    number = name.partition(",")[2]
    return number if count > FEW and number else lowered(name)


def size(text: str, drafting: Drafting) -> float:
    """Give the size of a letter, mm: numbers alone are smaller."""
    return drafting.hand.number if text.isdigit() else drafting.hand.letter
