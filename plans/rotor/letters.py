"""The letters of a rotor's vectors on the board, as the textbook has them: m_1D_1, m_1D_1h_1, m_ID_I (обозначения)."""

from __future__ import annotations


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
