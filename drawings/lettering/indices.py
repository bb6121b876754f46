"""Letters of marks as they are lettered: their indices lowered (индексы)."""

from __future__ import annotations


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
