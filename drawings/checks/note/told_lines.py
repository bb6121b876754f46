"""The lines of a chapter held to those that are due, one for one and in their order (строки главы по порядку)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from drawings.checks.precise import KNOWN, rounded, tells
from drawings.checks.wrong import Wrong
from plans.words.words import message

DIGITS = (0, 4, 5, 10)  # of the numbers of a report: fixed decimals, or so many digits


def is_line(line: str, due: str) -> bool:
    """Tell whether a line says what is due, whose numbers have all digits."""
    return tells(_plain(line), _plain(due), DIGITS, KNOWN)


def lines(texts: Iterable[str]) -> list[str]:
    """Part texts into their lines, none of them empty."""
    return [_plain(line) for text in texts for line in text.splitlines() if line.strip()]


def faults(seen: Sequence[str], due: Sequence[str]) -> Iterator[Wrong]:
    """Give each line that none of those due is, and each that is due and not there."""
    at = 0
    for line in seen:
        found = next((k for k in range(at, len(due)) if is_line(line, due[k])), None)
        if found is None:
            yield message("wrong.told", text=line.strip())
            continue
        yield from _missing(due[at:found])
        at = found + 1
    yield from _missing(due[at:])


def _missing(due: Sequence[str]) -> Iterator[Wrong]:
    return (message("wrong.missing", name=rounded(line)) for line in due)


def _plain(line: str) -> str:
    return line.strip().replace("{,}", ",")
