r"""The equations of a cut as a note has them in math: statements, moments, forces (чтение уравнений записки)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from drawings.checks.forces.written_equations import Statement, WrittenMoments, WrittenTerm, WrittenVector

_MOMENTS = re.compile(r"\\sum M_\{(?P<about>[^()]+?)(?:\((?P<link>\d+)\))?\} = (?P<terms>.+) = 0")
_VALUE = re.compile(r"(?P<value>-?\d+(?:\.\d+)?)(?:\\text\{ (?P<unit>.+)\})?")
_VECTOR = re.compile(r"(?P<lines>(?:\\underline\{)*)(?P<bar>\\bar |\\overline\{)?(?P<rest>.+)")


class Told(NamedTuple):
    """A line of a list: the letter of what it tells, in math, and all that equals it."""

    text: str
    letter: str
    equals: tuple[str, ...]

    @property
    def value(self) -> str:
        """The number at its end; none is what is no number."""
        found = _VALUE.fullmatch(self.equals[-1])
        return "" if found is None else found["value"]

    @property
    def unit(self) -> str:
        """The unit of that number."""
        found = _VALUE.fullmatch(self.equals[-1])
        return "" if found is None else found["unit"] or ""


class WrittenNote:
    """The lines on one cut; `letters` are what a sheet reads of each name, by the name's letter in math."""

    def __init__(self, lines: list[str], letters: dict[str, str]) -> None:
        self.letters = letters
        self.lines = [line.replace("{,}", ".") for line in lines]

    @cached_property
    def told(self) -> tuple[Told, ...]:
        """What is told of single quantities."""
        sides = ((one, one[3:-1].split(" = ")) for one in self.lines if one.startswith("- $") and one.endswith("$"))
        return tuple(Told(line, first, tuple(rest)) for line, (first, *rest) in sides if rest)

    @cached_property
    def statements(self) -> tuple[Statement, ...]:
        """The same by the letters of a sheet."""
        return tuple(Statement(self._letter(one.letter), one.value, one.unit) for one in self.told)

    @cached_property
    def moments(self) -> tuple[WrittenMoments, ...]:
        """The equations of moments."""
        return tuple(self._equation(found) for found in map(_MOMENTS.fullmatch, self._displayed) if found is not None)

    @cached_property
    def forces(self) -> tuple[WrittenVector, ...]:
        """The terms of the equation of forces."""
        own = (one.removesuffix(" = 0") for one in self._displayed if _MOMENTS.fullmatch(one) is None)
        return tuple(self._vector(sign, term) for one in own for sign, term in signed(one))

    @cached_property
    def strange(self) -> tuple[str, ...]:
        """The lines that are neither."""
        shown = (one for one in self.lines if one.startswith("$$") and not one.endswith(" = 0$$"))
        known = {one.text for one in self.told}
        return (*shown, *(one for one in self.lines if not one.startswith("$$") and one not in known))

    @property
    def _displayed(self) -> list[str]:
        return [one.strip("$") for one in self.lines if one.startswith("$$")]

    def _equation(self, found: re.Match[str]) -> WrittenMoments:
        terms = tuple(self._term(sign, term) for sign, term in signed(found["terms"]))
        return WrittenMoments(found["about"].replace("_", ""), int(found["link"]) if found["link"] else None, terms)

    def _term(self, sign: int, term: str) -> WrittenTerm:
        """Read a term: a force with the letter of its arm after it, or a couple alone."""
        heads = (letter for letter in self.letters if term == letter or term.startswith(f"{letter} "))
        letter = max(heads, key=len, default=term)
        return WrittenTerm(sign, self._letter(letter), term.removeprefix(letter).strip())

    def _vector(self, sign: int, term: str) -> WrittenVector:
        found = _VECTOR.fullmatch(term)
        assert found is not None  # the rest is anything
        lines = found["lines"].count("underline")
        closing = lines + (found["bar"] == r"\overline{")
        bare = found["rest"][: len(found["rest"]) - closing]
        return WrittenVector(sign, self._letter(bare), lines, found["bar"] is not None)

    def _letter(self, letter: str) -> str:
        return self.letters.get(letter, letter)


def signed(whole: str) -> Iterator[tuple[int, str]]:
    """Take a sum apart, each term with its sign.

    >>> list(signed("-a + b c - d"))
    [(-1, 'a'), (1, 'b c'), (-1, 'd')]
    """
    first, *rest = re.split(r" ([+-]) ", whole)
    yield (-1, first[1:]) if first.startswith("-") else (1, first)
    for sign, term in zip(rest[::2], rest[1::2], strict=True):
        yield (1 if sign == "+" else -1), term
