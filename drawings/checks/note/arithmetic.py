"""The arithmetic of a note: what stands on both sides of a sign of equality is reckoned anew (проверка вычислений)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from drawings.report.formula import DIGITS
from plans.words.words import Message, message

_TOKEN = re.compile(r"\\cdot|\d+(?:\.\d+)?|\^\{2\}|[()+/-]")
_SIDE = re.compile(rf"(?:{_TOKEN.pattern}|\s)+")
_MATH = re.compile(r"\$+(.+?)\$+")
_UNIT = re.compile(r"\\text\{.*")


class Rounded(NamedTuple):
    """A number, and by how much the rounding of what it comes from may have moved it."""

    value: float
    off: float

    @classmethod
    def read(cls, text: str) -> Rounded:
        """Read a written number: it may be off by the half of its last digit."""
        value = float(text)
        return cls(value, 0.5 * 10.0 ** (math.floor(math.log10(value)) + 1 - DIGITS) if value else 0.0)

    def times(self, other: Rounded) -> Rounded:
        """Multiply."""
        return Rounded(self.value * other.value, abs(self.value) * other.off + abs(other.value) * self.off)

    def over(self, other: Rounded) -> Rounded:
        """Divide."""
        ratio = self.value / other.value
        return Rounded(ratio, (self.off + abs(ratio) * other.off) / abs(other.value))

    def plus(self, other: Rounded, sign: int) -> Rounded:
        """Add, or take away."""
        return Rounded(self.value + sign * other.value, self.off + other.off)


def miscounted(lines: list[str]) -> Iterator[Message]:
    """Give the lines in which two numeric sides of an equation are not equal but for the rounding of their numbers."""
    for line in lines:
        for formula in _MATH.findall(line.replace("{,}", ".")):
            sides = [_UNIT.sub("", side) for side in formula.split(" = ")]
            told = [side for side in sides if _SIDE.fullmatch(side) and re.search(r"\d", side)]
            if not all(_equal(one, other) for one, other in pairwise(told)):
                yield message("wrong.told", text=line)


def _equal(one: str, other: str) -> bool:
    left, right = reckon(one), reckon(other)
    return abs(left.value - right.value) <= left.off + right.off


def reckon(side: str) -> Rounded:
    r"""Reckon a side of an equation.

    >>> reckon(r"(2 \\cdot 3^{2} - 4) / 7").value, reckon(r"-0.5 \\cdot (-3)").value
    (2.0, 1.5)
    """
    return _Reckoner(_TOKEN.findall(side)).sum()


class _Reckoner:
    """Reads the marks of a side from left to right."""

    def __init__(self, marks: list[str]) -> None:
        self.marks = marks

    def sum(self) -> Rounded:
        found = self._product()
        while self.marks and self.marks[0] in "+-":
            sign = 1 if self.marks.pop(0) == "+" else -1
            found = found.plus(self._product(), sign)
        return found

    def _product(self) -> Rounded:
        found = self._factor()
        while self.marks and self.marks[0] in (r"\cdot", "/"):
            divides = self.marks.pop(0) == "/"
            other = self._factor()
            found = found.over(other) if divides else found.times(other)
        return found

    def _factor(self) -> Rounded:
        mark = self.marks.pop(0)
        if mark == "-":
            return Rounded(0.0, 0.0).plus(self._factor(), -1)
        if mark == "(":
            found = self.sum()
            self.marks.pop(0)  # the bracket's end
        else:
            found = Rounded.read(mark)
        if self.marks and self.marks[0] == "^{2}":
            self.marks.pop(0)
            return found.times(found)
        return found
