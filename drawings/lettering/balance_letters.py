"""The letters of balancing as a sheet writes them: counterweights, main points, static moments (обозначения)."""

from __future__ import annotations

import re

from drawings.lettering.words import word

CENTRE, FORCE, MOMENT, RESULT = "S", "Φ", "M^Φ", "mr_S"
INDEX = re.compile(r"_([^_]+?)(?=r_|$)")


def counterweight(link: int, language: str) -> str:
    """Letter the mass of a link's counterweight.

    >>> counterweight(1, "en"), counterweight(12, "ru")
    ('m_{cw1}', 'm_{пр12}')
    """
    return f"m_{{{word(language, 'counterweight index')}{link}}}"


def lowered(name: str) -> str:
    """Mark up the letters of a main-point vector or a static moment, each index lowered.

    >>> lowered("h_2"), lowered("m_3r_S3"), lowered("mr_S")
    ('h_{2}', 'm_{3}r_{S3}', 'mr_{S}')
    """
    return INDEX.sub(lambda found: f"_{{{found[1]}}}", name)
