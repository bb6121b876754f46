"""The equations beside a cut as they stand on a sheet: statements, moments, forces (чтение уравнений)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

from drawings.paper.strokes import Group, Line, Text
from drawings.paper.walk import flat

BAR = "\N{COMBINING MACRON}"
UNDER = 2.0  # sizes of the letters below a term in which its lines stand; the next line of writing is further
ASTRAY = 0.2  # mm that a line under a term may begin off it
_STATED = re.compile(r"(?P<name>\S+) = (?P<value>[−\d.,]+?),?(?: (?P<unit>\S+?))?,?")
_MOMENTS = re.compile(r"ΣM(?P<about>[^(]+?)(?:\((?P<link>\d+)\))?:")


class Statement(NamedTuple):
    """What a quantity is: its letter, its number, its unit."""

    name: str
    value: str
    unit: str


class WrittenTerm(NamedTuple):
    """A term with its sign: of moments a force by its arm, or a couple between bars, without one."""

    sign: int
    force: str
    arm: str = ""


class WrittenVector(NamedTuple):
    """A term of the equation of forces: its sign, its letter, the lines under it, whether it has a bar."""

    sign: int
    letter: str
    lines: int
    barred: bool


class WrittenMoments(NamedTuple):
    """An equation of moments about a point, and the link that it is of, where it is told."""

    about: str
    link: int | None
    terms: tuple[WrittenTerm, ...]


class WrittenEquations:
    """The passage of equations of one cut."""

    def __init__(self, group: Group) -> None:
        strokes = tuple(flat((group,)))
        self.texts = [one for one in strokes if isinstance(one, Text)]
        self.lines = [one for one in strokes if isinstance(one, Line)]

    @cached_property
    def statements(self) -> tuple[Statement, ...]:
        """What is told of single quantities."""
        found = (_STATED.fullmatch(one.plain) for one in self.texts)
        return tuple(Statement(one["name"], one["value"], one["unit"] or "") for one in found if one is not None)

    @cached_property
    def moments(self) -> tuple[WrittenMoments, ...]:
        """The equations of moments."""
        return tuple(
            WrittenMoments(found["about"], int(found["link"]) if found["link"] else None, tuple(_terms(run)))
            for head, run in self._runs
            if head is not None and (found := _MOMENTS.fullmatch(head.plain)) is not None
        )

    @cached_property
    def forces(self) -> tuple[WrittenVector, ...]:
        """The terms of the equation of forces."""
        runs = (run for head, run in self._runs if head is None)
        return tuple(
            WrittenVector(sign, one.plain.replace(BAR, ""), self._under(one), BAR in one.plain)
            for run in runs
            for sign, one in _signed(run)
        )

    @cached_property
    def _runs(self) -> list[tuple[Text | None, list[Text]]]:
        """Give what stands before each "= 0", with the heading of moments."""
        runs: list[tuple[Text | None, list[Text]]] = [(None, [])]
        for one in self.texts:
            if _MOMENTS.fullmatch(one.plain):
                runs.append((one, []))
            elif one.plain == "=":
                runs.append((None, []))
            elif one.plain != "0" and _STATED.fullmatch(one.plain) is None and " = " not in one.plain:
                runs[-1][1].append(one)
        return runs

    def _under(self, text: Text) -> int:
        """Count the lines that begin under a term."""
        below = (text.at - line.start for line in self.lines)
        return sum(abs(off.real) <= ASTRAY and 0 < off.imag <= UNDER * text.size for off in below)


def _signed(run: Sequence[Text]) -> Iterator[tuple[int, Text]]:
    sign = 1
    for one in run:
        if one.plain in ("+", "−"):
            sign = 1 if one.plain == "+" else -1
        else:
            yield sign, one
            sign = 1


def _terms(run: Sequence[Text]) -> Iterator[WrittenTerm]:
    for sign, one in _signed(run):
        force, _, arm = one.plain.rpartition("·")
        yield WrittenTerm(sign, force, arm) if force else WrittenTerm(sign, one.plain.strip("|"))
