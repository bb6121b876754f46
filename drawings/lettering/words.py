"""The words of a sheet in its language, its letters as that language writes them, and its numbers (надписи листа)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from drawings.paper.strokes import SheetError
from plans.words import words

ROUNDING = 2.0**-40  # of the largest of a row: some thousand roundings, far below the digits that are printed
GROUPS = ("sheet", "unit", "reason")  # of words that stand on sheets
# Indices that each language has letters of its own for: of useful resistance, of balance, of a tangential part,
# of what is reduced, of the drive, of the flywheel, of the steady motion; of a cam's phases, which may be numbered.
_INDEX = re.compile(
    r"(?<=\^)t(?![a-z])|(?<=[_{])(?:us|bal|red|dr|fly|st)(?=}|$)"
    r"|(?<=_{)(?:rise|dwell|return|rest|rol|hol)(?=[ \u00a0}])"
)


def word(language: str, key: str, **values: object) -> str:
    """Give a phrase, a unit or a reason in the sheet's language; words of other groups by their full keys.

    >>> word("ru", "velocities", position=2), word("ru", "rad/s")
    ('План скоростей, положение 2', 'рад/с')
    """
    catalogue = words.words(language)
    found = next(name for name in (*(f"{group}.{key}" for group in GROUPS), key) if name in catalogue)
    return words.word(language, found, **values)


def letter(language: str, markup: str) -> str:
    """Write a letter of a force sheet as courses of a language do.

    >>> letter("ru", "R^t_{34}"), letter("ru", "M_{bal}"), letter("ru", "F_{us}"), letter("en", "M_{bal}")
    ('R^τ_{34}', 'M_{ур}', 'F_{п.с}', 'M_{bal}')
    """
    return _INDEX.sub(lambda found: words.word(language, f"index.{found[0]}"), markup)


def number(value: float, language: str = "en", digits: int = 4) -> str:
    """Write a number of a sheet with some significant digits, no exponent, no -0, and the language's decimal mark.

    >>> number(-0.00012344), number(1234567.0), number(0.5, "ru")
    ('−0.0001234', '1235000', '0,5')
    """
    if not math.isfinite(value):
        raise SheetError(f"{value} cannot be written on a sheet: a gap must be said in words")
    mantissa, exponent = f"{abs(value):.{digits - 1}e}".split("e")
    places = max(digits - 1 - int(exponent), 0)
    text = f"{float(f'{mantissa}e{exponent}'):.{places}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    sign = "−" if value < 0 and float(text) != 0 else ""
    return decimal(sign + text, language)


def span(values: Iterable[float], language: str = "en") -> str:
    """Write the least and the greatest of some numbers, once where they are written alike.

    >>> span([11.0, -9.0, 10.0]), span([5.0, 5.00001])
    ('−9 … 11', '5')
    """
    row = sorted(values)
    return " … ".join(dict.fromkeys(number(end, language) for end in (row[0], row[-1])))


def decimal(text: str, language: str) -> str:
    """Give a number's text the decimal mark of a language.

    >>> decimal("1.50e-09", "ru")
    '1,50e-09'
    """
    return text.replace(".", words.word(language, "number.decimal"))


def fixed(value: float, language: str = "en", places: int = 2) -> str:
    """Write a number with a fixed number of decimals, no -0, and the language's decimal mark."""
    text = f"{abs(value):.{places}f}"
    sign = "−" if value < 0 and float(text) != 0 else ""
    return decimal(sign + text, language)


def runs(positions: Iterable[int], dash: str = "–") -> str:
    """Write numbers of positions with runs joined.

    >>> runs([1, 2, 3, 7, 9, 10])
    '1–3, 7, 9–10'
    """
    joined: list[list[int]] = []
    for k in positions:
        if joined and k == joined[-1][-1] + 1:
            joined[-1].append(k)
        else:
            joined.append([k])
    return ", ".join(str(run[0]) if len(run) == 1 else f"{run[0]}{dash}{run[-1]}" for run in joined)
