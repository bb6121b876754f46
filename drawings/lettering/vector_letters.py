"""Letters of vectors with their indices, as a language writes them (обозначения с индексами)."""

from __future__ import annotations

import re
from functools import lru_cache

from drawings.lettering.words import word


@lru_cache(maxsize=4096)
def with_index(letter: str) -> str:
    """Write a mark's letter with its index lowered: b, a_3, n_BA.

    >>> with_index("a3"), with_index("n_BA"), with_index("s12'")
    ('a_{3}', 'n_{BA}', "s_{12}'")
    """
    if "_" in letter:
        head, index = letter.split("_", 1)
        return f"{head}_{{{index}}}"
    digits = "".join(sign for sign in letter if sign.isdigit())
    return letter.replace(digits, f"_{{{digits}}}", 1) if digits else letter


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


def lowered_bank(name: str) -> str:
    """Mark up the letters of a vector or a mass, its index lowered, its prime above.

    >>> lowered_bank("F_-II,12"), lowered_bank("mr_M,I"), lowered_bank("m_M,II'")
    ('F_{−II,12}', 'mr_{M,I}', "m_{M,II}'")
    """
    letter, _, index = name.rstrip("'").partition("_")
    return (f"{letter}_{{{index.replace('-', '−')}}}" if index else letter) + "'" * name.count("'")
