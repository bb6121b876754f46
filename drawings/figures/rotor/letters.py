"""The letters of a rotor on its sheet: indices lowered, that of a single counterweight as its language has it."""

from __future__ import annotations

import re

from drawings.page.drafting import Drafting

ALONE = "cw"  # the name of the only plane of correction
_INDEX = re.compile(r"_([^_]+?)(?=[Dh]_|$)")


def lowered(name: str, drafting: Drafting) -> str:
    """Mark up the letters of a vector, as m_1D_1 or m_IID_IIh_II, each index lowered."""
    return _INDEX.sub(lambda found: f"_{{{index(found[1], drafting)}}}", name)


def index(name: str, drafting: Drafting) -> str:
    """Give the index of a mass or a plane."""
    return drafting.word("counterweight index") if name == ALONE else name
