"""A line of math as it must stand in a note: letters, signs and units as they are, each number of its own (строки)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong
from drawings.report.formula import DIGITS
from plans.words.words import message

NUMBER = "\0"  # in the place of a number
_NUMBER = r"(-?\d+(?:\.\d+)?)"


class Quantity(NamedTuple):
    """A number that is put in, and what it may be off by beside its last digit."""

    value: float
    off: float

    def over(self, divisor: float) -> Quantity:
        """Give it divided, as a length on paper is by a scale."""
        return Quantity(self.value / divisor, self.off / divisor)


class DueMath(NamedTuple):
    """A line: its text, NUMBER where each number stands; `needed` ones must stand, others may."""

    text: str
    numbers: tuple[Quantity, ...] = ()
    needed: bool = True

    def holds(self, line: str) -> bool:
        """Tell whether a line is this one."""
        found = re.fullmatch(_NUMBER.join(map(re.escape, self.text.split(NUMBER))), line.replace("{,}", "."))
        return found is not None and all(
            reads(text, one.value, one.off, DIGITS) for text, one in zip(found.groups(), self.numbers, strict=True)
        )


Due = tuple[DueMath, ...]  # a line, by any of the ways in which it may stand


def faults(lines: Sequence[str], due: Sequence[Due]) -> Iterator[Wrong]:
    """Hold lines to those that are due, one for one and in their order: what is found before it is used."""
    at = 0
    for line in lines:
        found = next((k for k in range(at, len(due)) if any(one.holds(line) for one in due[k])), None)
        if found is None:
            yield message("wrong.told", text=line)
        else:
            yield from _missing(due[at:found])
            at = found + 1
    yield from _missing(due[at:])


def _missing(due: Sequence[Due]) -> Iterator[Wrong]:
    for one in due:
        if all(way.needed for way in one):
            yield message("wrong.missing", name=one[0].text.partition(" = ")[0].removeprefix("- "))
