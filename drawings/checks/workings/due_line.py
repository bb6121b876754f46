"""A line of a working as it must stand: letters, numbers, what comes of them; and the lines read back (выкладки)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group
from drawings.paper.walk import texts
from plans.words.words import message

DIGITS = 4  # of a number of a working
PARTS = 3  # of a line: letters, numbers, what comes of them
_FACTOR = re.compile(r"[^·/()]+")


class Quantity(NamedTuple):
    """A number as it must be written: its true value, what the two roads may differ by, its unit, "s per mm"."""

    true: float
    slack: float = 0.0
    unit: str = ""

    def told(self, text: str, drafting: Drafting) -> bool:
        """Tell whether a text is the number with its unit, to the half of its last digit."""
        digits, _, unit = text.partition(" ")
        due = "/".join(map(drafting.word, self.unit.split(" per "))) if self.unit else ""
        return unit == due and reads(digits, self.true, self.slack, DIGITS)


class DueLine(NamedTuple):
    """A line that must stand beside a figure: what is found, of what product of letters, of which numbers for them.

    Below `none` it may be left out.
    """

    letter: str
    product: str  # of letters by "·", "/" and brackets
    numbers: tuple[Quantity, ...]
    result: Quantity
    none: float = 0.0

    def holds(self, line: Sequence[str], drafting: Drafting) -> bool:
        """Tell whether a line is this one."""
        if len(line) != PARTS or line[0] != f"{self.letter} = {self.product}":
            return False
        numbers = line[1].removeprefix("= ")
        parts = _FACTOR.findall(numbers)
        own = _FACTOR.sub("", numbers) == _FACTOR.sub("", self.product) and len(parts) == len(self.numbers)
        told = own and all(one.told(part, drafting) for one, part in zip(self.numbers, parts, strict=True))
        return told and self.result.told(line[2].removeprefix("= "), drafting)


def scaled(letter: str, segment: str, of: str, quantity: Quantity, mu: float, drafting: Drafting) -> DueLine:
    """Give the line by which a true size is read off a segment, at a scale of some letter."""
    length = Quantity(quantity.true / mu, quantity.slack / mu)
    if drafting.notation == "K":
        return DueLine(letter, f"{segment}/K{of}", (length, Quantity(1 / mu)), quantity)
    return DueLine(letter, f"{segment}·μ{of}", (length, Quantity(mu)), quantity)


def laid_off(letter: str, segment: str, of: str, quantity: Quantity, mu: float, drafting: Drafting) -> DueLine:
    """Give the line by which a true size is laid off as a segment, mm."""
    k = drafting.notation == "K"
    product, factor = (f"{letter}·K{of}", 1 / mu) if k else (f"{letter}/μ{of}", mu)
    drawn = Quantity(quantity.true / mu, quantity.slack / mu, "mm")
    return DueLine(segment, product, (quantity, Quantity(factor)), drawn)


def lines(group: Group) -> list[list[str]]:
    """Read the lines of a working: each begins with what it finds."""
    found: list[list[str]] = []
    for text in (one.plain for one in texts((group,))):
        if text.startswith("= ") and found:
            found[-1].append(text)
        else:
            found.append([text])
    return found


def faults(group: Group, due: Sequence[DueLine], figure: str, drafting: Drafting) -> Iterator[Wrong]:
    """Hold a working: every line is one that is due, each once, and none is missing."""
    left = list(due)
    for line in lines(group):
        own = next((one for one in left if one.holds(line, drafting)), None)
        if own is None:
            yield message("wrong.told", text=" ".join(line))
        else:
            left.remove(own)
    for one in left:
        if abs(one.result.true) > one.none:
            yield on("missing_on", figure, name=one.letter)
