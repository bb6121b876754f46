"""The letters of a rotor's vectors on the board, as the textbook has them: m_1D_1, m_1D_1h_1, m_ID_I (обозначения)."""

from __future__ import annotations

from plans.words.words import word

ALONE = "cw"  # the index of the only counterweight, which each language writes in its own letters


def unbalance_letters(name: str) -> str:
    """Letter a static moment.

    >>> unbalance_letters("II")
    'm_IID_II'
    """
    return f"m_{name}D_{name}"


def moment_letters(name: str) -> str:
    """Letter the moment of a static moment about the last plane of correction.

    >>> moment_letters("2")
    'm_2D_2h_2'
    """
    return f"{unbalance_letters(name)}h_{name}"


def written(name: str, language: str) -> str:
    """Write the letters of a vector as a language does.

    >>> written("m_cwD_cwh_cw", "ru"), written("m_IID_II", "ru")
    ('m_прD_прh_пр', 'm_IID_II')
    """
    return name.replace(f"_{ALONE}", f"_{word(language, 'sheet.counterweight index')}")
