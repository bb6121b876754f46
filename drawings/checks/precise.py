"""Texts held to true numbers: what is written is what would be written with all digits, each rounded (сверка чисел)."""

from __future__ import annotations

import re
from collections.abc import Collection
from itertools import zip_longest

from drawings.checks.reading import reads
from drawings.lettering.words import number
from drawings.page.drafting import Drafting

ALL_DIGITS = 15
KNOWN = 1e-9  # share of a number that both roads may differ by: they agree far better
LONG = 6  # digits that a written number has at the most
_NUMBER = re.compile(r"[−-]?\d+(?:[.,]\d+)?")


class Precise(Drafting):
    """The drafting of a sheet, but with all digits of every number."""

    __slots__ = ()

    def number(self, value: float, digits: int = 4) -> str:
        """Write a number with all its digits."""
        return super().number(value, ALL_DIGITS)


def precise(drafting: Drafting) -> Precise:
    """Give the drafting with all digits."""
    return Precise(*drafting)


def tells(text: str, true: str, digits: Collection[int], share: float = 0.0) -> bool:
    """Tell whether a text says what another one does with all digits, in words alike, each number rounded.

    A number has one of the given numbers of digits; to the half of its last one comes a share of itself.

    >>> tells("J = 36.7 at 24", "J = 36.70337 at 24", (4,)), tells("J = 36.8 at 24", "J = 36.70337 at 24", (4,))
    (True, False)
    """
    if _NUMBER.sub("#", text) != _NUMBER.sub("#", true):
        return False
    pairs = zip_longest(_NUMBER.findall(text), _NUMBER.findall(true), fillvalue="")
    return all(_holds(one, other, digits, share) for one, other in pairs)


def rounded(text: str) -> str:
    """Write a text that has all digits of its numbers as a sheet would: what has more than four has four.

    >>> rounded("J = 36.7033712 at 24"), rounded("0,333333333333 m")
    ('J = 36.7 at 24', '0,3333 m')
    """
    return _NUMBER.sub(lambda found: _short(found[0]), text)


def _short(numeral: str) -> str:
    if len(re.sub(r"\D", "", numeral).lstrip("0")) <= LONG:
        return numeral
    value = float(numeral.replace("−", "-").replace(",", "."))
    return number(value).replace(".", "," if "," in numeral else ".")


def _holds(written: str, true: str, digits: Collection[int], share: float) -> bool:
    """Tell whether a number is another one rounded; what has no digits left of it is 0."""
    value = float(true.replace("−", "-").replace(",", "."))
    if written == true:
        return True
    return any(reads(written, value, share * abs(value), count) for count in digits)
