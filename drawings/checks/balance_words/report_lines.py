"""The lines of a report's chapter, held to those that must stand there (строки главы отчёта)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.checks.balance_words.sentences import Sentence, told_otherwise
from drawings.checks.note.lines import in_report, parts
from plans.words.words import Message, message


def listed(note: str, sure: bool = True) -> Sentence:
    """Give a note as it is listed in a report."""
    return Sentence(f"- {in_report(note)}", sure)


def row(cells: Sequence[str]) -> Sentence:
    """Give a row of a table."""
    return Sentence(f"| {' | '.join(cells)} |")


def table(heads: Sequence[str], rows: Iterator[Sequence[str]]) -> Iterator[Sentence]:
    """Give a table: its heads, the line under them, its rows."""
    yield row(heads)
    yield Sentence("|" + "---|" * len(heads))
    yield from map(row, rows)


def head(text: str) -> list[Sentence]:
    """Give the lines of a chapter's head, with what is said before its tables."""
    return [Sentence(line) for line in text.splitlines() if line.strip()]


def wrong_chapter(text: str, due: Sequence[Sentence], alike: int = 1) -> Iterator[Message]:
    """Hold the chapter that begins with the first line due; of several techniques that have one alike the nearest."""
    found = [list(told_otherwise(one, due)) for one in _chapters(text, due[0].marked)]
    if not found:
        yield message("wrong.missing", name=due[0].marked)
    if len(found) > alike:
        yield message("wrong.told", text=due[0].marked)
    for there, line in min(found, key=len, default=[]):
        yield message("wrong.told", text=line) if there else message("wrong.missing", name=line)


def _chapters(text: str, first: str) -> Iterator[list[str]]:
    """Give the lines of each chapter that begins with a line."""
    return ([first, *own] for own in parts(text, first))
