"""Sentences with numbers that notes or a report must have, each number to its last digit (сверка предложений)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from typing import NamedTuple

from drawings.checks import reading
from drawings.checks.reading import NOTES
from drawings.checks.wrong import Wrong, within
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import texts

TURN = 360.0  # degrees
SHOWN = 5  # digits of a number where a sentence is quoted
_OPEN, _CLOSE = "\ue000", "\ue001"  # no letter of any alphabet
_MARK = re.compile(f"{_OPEN}([^{_CLOSE}]*){_CLOSE}")
_NUMBER = r"([−+\d.,]*\d)"
PLAIN, TURNS, SIGNED = "plain", "turns", "signed"  # a number; an angle, whole turns aside; a change, with its sign


def number(true: float, slack: float, digits: int, kind: str = PLAIN) -> str:
    """Put a number into a sentence: its value, what it may be out by, its digits, how it is written."""
    return f"{_OPEN}{float(true)!r} {float(slack)!r} {digits} {kind}{_CLOSE}"


class Number(NamedTuple):
    """A number that a sentence must have."""

    true: float
    slack: float
    digits: int
    kind: str

    @classmethod
    def of(cls, mark: str) -> Number:
        """Read the mark that stands for it."""
        true, slack, digits, kind = mark.split()
        return cls(float(true), float(slack), int(digits), kind)

    def holds(self, text: str) -> bool:
        """Tell whether a text is it, rounded."""
        bare = text.removeprefix("+")
        found = reading.value(bare)
        if found is None or (bare != text) != (self.kind == SIGNED and found > 0):
            return False
        turned = TURN * round((found - self.true) / TURN) if self.kind == TURNS else 0.0
        return reading.reads(bare, self.true + turned, self.slack, self.digits)


class Sentence(NamedTuple):
    """A sentence that must stand somewhere, with marks for its numbers; where rounding decides it may be missing."""

    marked: str
    sure: bool = True

    @property
    def pattern(self) -> re.Pattern[str]:
        """The sentence with any numbers."""
        return re.compile(_NUMBER.join(map(re.escape, _MARK.split(self.marked)[::2])))

    @property
    def numbers(self) -> list[Number]:
        """Its numbers, in their order."""
        return [Number.of(mark) for mark in _MARK.findall(self.marked)]

    @property
    def quoted(self) -> str:
        """The sentence as it is told of where it is missing."""
        return _MARK.sub(lambda found: f"{Number.of(found[1]).true:.{SHOWN}g}", self.marked)

    def holds(self, found: re.Match[str]) -> bool:
        """Tell whether each number is right."""
        return all(one.holds(text) for one, text in zip(self.numbers, found.groups(), strict=True))

    def told_by(self, line: str) -> bool:
        """Tell whether a line is it."""
        found = self.pattern.fullmatch(line)
        return found is not None and self.holds(found)


def is_line(line: str, sentences: Iterable[Sentence]) -> bool:
    """Tell whether a line is some sentences joined, each that may be missing there or not."""
    ways = product(*([one] if one.sure else [one, None] for one in sentences))
    return any(Sentence("; ".join(one.marked for one in way if one is not None)).told_by(line) for way in ways)


def flat(text: str) -> str:
    """Write a text in plain single spaces.

    >>> flat("a =  b")
    'a = b'
    """
    return " ".join(text.split())


def on_sheet(note: str) -> str:
    """Write a note as it is read off a sheet: indices on the line."""
    return flat(Text(0j, note).plain)


def notes(leaf: Leaf) -> str:
    """Read the notes of a sheet as one line."""
    own = (text.plain for group in leaf.groups if group.name == NOTES for text in texts((group,)))
    return flat(" ".join(own))


def wrong_notes(leaf: Leaf, due: Iterable[Sentence]) -> Iterator[Wrong]:
    """Hold the notes: each sentence once, in its turn, its numbers right, and nothing beside."""
    told, place = notes(leaf), 0
    for one in due:
        found = one.pattern.search(told, place)
        if found is None:
            yield from [within("missing_from", NOTES, name=one.quoted)] if one.sure else []
            continue
        yield from _strange(told[place : found.start()])
        yield from [] if one.holds(found) else [within("in", NOTES, text=found[0])]
        place = found.end()
    yield from _strange(told[place:])


def _strange(text: str) -> Iterator[Wrong]:
    if text.strip():
        yield within("stranger_in", NOTES, text=text.strip())


def told_otherwise(lines: Sequence[str], due: Sequence[Sentence]) -> Iterator[tuple[bool, str]]:
    """Give each line that is not the one due, and each that is due and not there: whether it is there, and its text."""
    rest = list(lines)
    for one in due:
        found = one.pattern.fullmatch(rest[0]) if rest else None
        if found is not None:
            yield from [] if one.holds(found) else [(True, rest[0])]
            rest.pop(0)
        elif one.sure:
            yield False, one.quoted
    yield from ((True, line) for line in rest)
