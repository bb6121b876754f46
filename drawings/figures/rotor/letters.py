"""Letters of many masses: each with its letters, or numbered alone (обозначения многих масс)."""

from __future__ import annotations

from drawings.lettering.rotor_letters import INDEX, lowered
from drawings.page.drafting import Drafting

FEW, MOST = 9, 40  # masses: of more each is numbered alone; of more still the table alone tells them apart


def letter(name: str, count: int, drafting: Drafting) -> str:
    """Letter one of so many vectors: with its letters, or of many masses by the number of its mass alone."""
    number = INDEX.search(name)
    if count > FEW and number is not None and number[1].isdigit():
        return number[1]
    return lowered(name, drafting.language)


def size(text: str, drafting: Drafting) -> float:
    """Give the size of a letter, mm: numbers alone are smaller."""
    return drafting.hand.number if text.isdigit() else drafting.hand.letter
