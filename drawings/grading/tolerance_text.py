"""A tolerance as a teacher writes it: "0.2 mm" of a hand, "2 %" of a plan's largest vector, or "exact" (допуск)."""

from __future__ import annotations

import re

from drawings.grading.allowance import EXACT, Allowance

_WRITTEN = re.compile(r"(\d+(?:[.,]\d+)?)\s*(mm|%)?")
MOST = 5.0  # mm: a hand that slips by more draws nothing


def allowance(text: str) -> Allowance | None:
    """Read a tolerance; None of what is none.

    >>> allowance("0.5 mm"), allowance("2 %").share, allowance("much")
    (Allowance(slip=0.5, share=None), 0.02, None)
    """
    if text.strip() == "exact":
        return EXACT
    match = _WRITTEN.fullmatch(text.strip())
    if match is None:
        return None
    size = float(match[1].replace(",", "."))
    if match[2] == "%":
        return Allowance(share=size / 100) if 0 < size <= 100 else None
    return Allowance(size) if 0 < size <= MOST else None


def written(by: Allowance) -> str:
    """Write a tolerance as it is read.

    >>> written(Allowance(0.2)), written(Allowance(share=0.02)), written(EXACT)
    ('0.2 mm', '2 %', 'exact')
    """
    if by == EXACT:
        return "exact"
    return f"{by.slip:g} mm" if by.share is None else f"{100 * by.share:g} %"
