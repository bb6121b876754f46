"""The letters of a bank as a sheet writes them: indices lowered, a minus before an order against the crank."""

from __future__ import annotations


def lowered(name: str) -> str:
    """Mark up the letters of a vector or a mass, its index lowered, its prime above.

    >>> lowered("F_-II,12"), lowered("mr_M,I"), lowered("m_M,II'")
    ('F_{−II,12}', 'mr_{M,I}', "m_{M,II}'")
    """
    letter, _, index = name.rstrip("'").partition("_")
    return (f"{letter}_{{{index.replace('-', '−')}}}" if index else letter) + "'" * name.count("'")
