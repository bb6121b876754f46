"""The letters of a rotor as a sheet writes them: indices lowered, that of a single counterweight in its language."""

from __future__ import annotations

import re

from drawings.lettering.words import word
from plans.words.words import ALONE

INDEX = re.compile(r"_([^_]+?)(?=[Dh]_|$)")


def lowered(name: str, language: str) -> str:
    """Mark up the letters of a vector, each index lowered.

    >>> lowered("m_IID_IIh_II", "en"), lowered("m_cwD_cw", "ru")
    ('m_{II}D_{II}h_{II}', 'm_{пр}D_{пр}')
    """
    return INDEX.sub(lambda found: f"_{{{index(found[1], language)}}}", name)


def index(name: str, language: str) -> str:
    """Give the index of a mass or a plane."""
    return word(language, "counterweight index") if name == ALONE else name
