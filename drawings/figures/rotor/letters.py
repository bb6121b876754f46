"""The letters of a rotor on its sheet: indices lowered, that of a single counterweight as its language has it."""

from __future__ import annotations

import re

from drawings.page.drafting import Drafting

ALONE = "cw"  # the name of the only plane of correction
FEW, MOST = 9, 40  # masses: of more each is numbered alone; of more still the table alone tells them apart
_INDEX = re.compile(r"_([^_]+?)(?=[Dh]_|$)")


def lowered(name: str, drafting: Drafting) -> str:
    """Mark up the letters of a vector, as m_1D_1 or m_IID_IIh_II, each index lowered."""
    return _INDEX.sub(lambda found: f"_{{{index(found[1], drafting)}}}", name)


def index(name: str, drafting: Drafting) -> str:
    """Give the index of a mass or a plane."""
    return drafting.word("counterweight index") if name == ALONE else name


def letter(name: str, count: int, drafting: Drafting) -> str:
    """Letter one of so many vectors: with its letters, or of many masses by the number of its mass alone."""
    number = _INDEX.search(name)
    if count > FEW and number is not None and number[1].isdigit():
        return number[1]
    return lowered(name, drafting)


def size(text: str, drafting: Drafting) -> float:
    """Give the size of a letter, mm: numbers alone are smaller."""
    return drafting.hand.number if text.isdigit() else drafting.hand.letter
