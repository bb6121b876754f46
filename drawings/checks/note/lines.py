"""The lines of a chapter of a note, held one by one to what the analysis writes with all digits (строки записки)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from drawings.checks.note.arithmetic import miscounted
from drawings.checks.precise import tells
from drawings.report.formula import DIGITS
from plans.words.words import Message, message


def part(text: str, head: str) -> list[str]:
    """Give the lines of a chapter by its head, up to the next chapter; none where there is no such chapter."""
    _, found, rest = text.partition(f"\n{head.strip().partition(chr(10))[0]}\n")
    own = rest.partition("\n## ")[0] if found else ""
    return [line for line in own.splitlines() if line.strip()]


def held(seen: list[str], due: Iterable[str], share: float) -> Iterator[Message]:
    """Hold lines to those that are due, and each equation to its own numbers.

    Words are alike, each number is rounded, to a share of itself that the roads differ by.
    """
    true = [line for text in due for line in text.splitlines() if line.strip()]
    yield from miscounted(seen)
    if len(seen) != len(true):
        yield message("wrong.note_lines", seen=len(seen), due=len(true))
    for line, other in zip(seen, true, strict=False):
        if not tells(_plain(line), _plain(other), (DIGITS,), share):
            yield message("wrong.told", text=line)


def _plain(line: str) -> str:
    """Write decimal marks of math as they are read."""
    return line.replace("{,}", ",")
