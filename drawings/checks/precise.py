"""Texts held to true numbers: what is written is what would be written with all digits, each rounded (сверка чисел)."""

from __future__ import annotations

import re
from collections.abc import Collection
from functools import lru_cache

from drawings.checks.reading import reads
from drawings.lettering.words import number
from drawings.page.drafting import Drafting

ALL_DIGITS = 15
KNOWN = 1e-9  # share of a number that both roads may differ by: they agree far better
LONG = 6  # digits that a written number has at the most
_NUMBER = re.compile(r"[−-]?\d+(?:[.,]\d+)?")
_QUANTITY = re.compile(rf"({_NUMBER.pattern})(°?)")
TURN = 360.0  # degrees


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

    A number has one of the given numbers of digits; to the half of its last one comes a share of itself. Of degrees
    it is a share of the full turn, from which they come by differences, and a full turn is the same angle as none.

    >>> tells("J = 36.7 at 24", "J = 36.70337 at 24", (4,)), tells("J = 36.8 at 24", "J = 36.70337 at 24", (4,))
    (True, False)
    >>> tells("φ = 0°", "φ = 359.999999999°", (4,), 1e-9), tells("φ = 0°", "φ = 359.99°", (4,), 1e-9)
    (True, False)
    >>> tells("ψ = 373°", "ψ = 13°", (4,), 1e-9)
    False
    """
    if _words(text) != _words(true):
        return False
    pairs = zip(_QUANTITY.findall(text), _QUANTITY.findall(true), strict=True)
    return all(_holds(one, other, digits, share, TURN if degrees else 0.0) for (one, _), (other, degrees) in pairs)


@lru_cache(maxsize=4096)  # each line of a sheet is held to each that it might be
def _words(text: str) -> str:
    """Give what a text says but for its numbers."""
    return _NUMBER.sub("#", text)


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


def _holds(written: str, true: str, digits: Collection[int], share: float, turn: float) -> bool:
    """Tell whether a number is another one rounded, a full turn for none; what has no digits left of it is 0."""
    if written == true:
        return True
    value = float(true.replace("−", "-").replace(",", "."))
    slack = share * max(abs(value), turn)
    whole = bool(turn and share) and min(abs(value), abs(turn - value)) <= slack
    alike = {0.0, value, turn} if whole else {value}
    return any(reads(written, one, slack, count) for count in digits for one in alike)
