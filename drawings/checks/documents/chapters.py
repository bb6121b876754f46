"""The chapters of a report: their heads, with what is said before tables, stand once and in order (главы отчёта)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from drawings.checks.wrong import Wrong
from plans.words.words import message, word


def faults(text: str, language: str, due: Iterable[str]) -> Iterator[Wrong]:
    """Hold the heads, and other lines without numbers, by their words' keys."""
    place = 0
    for key in due:
        head = word(language, f"report.{key}").strip()
        found = f"\n{text}".find(f"\n{head}\n", place)
        if found < 0 or text.count(f"\n{head}\n") > 1:
            yield message("wrong.missing", name=head.splitlines()[0])
        place = max(found, place)
