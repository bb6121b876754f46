"""The chapters of a report: their heads, with what is said before tables, stand once and in order (главы отчёта)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from plans.words.words import Message, message, word


def faults(text: str, language: str, due: Iterable[str]) -> Iterator[Message]:
    """Hold the heads, and other lines without numbers, by their words' keys."""
    return ordered(text, (word(language, f"report.{key}") for key in due))


def ordered(text: str, heads: Iterable[str]) -> Iterator[Message]:
    """Hold heads as they must be written."""
    place = 0
    for head in (one.strip() for one in heads):
        found = f"\n{text}".find(f"\n{head}\n", place)
        if found < 0 or text.count(f"\n{head}\n") > 1:
            yield message("wrong.missing", name=head.splitlines()[0])
        place = max(found, place)
