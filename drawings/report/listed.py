"""Notes as a report tells them: without the braces of their indices, in a line or as a chapter's list (перечень)."""

from __future__ import annotations

from collections.abc import Iterable

from drawings.lettering.phrase import Phrase, template_of


def plain(note: str) -> str:
    """Write a note without the braces of its indices.

    >>> plain("r_{C1} = 12  mm^2")
    'r_C1 = 12 mm²'
    """
    return " ".join(note.replace("{", "").replace("}", "").replace("^2", "²").split())


def listed(title: str, notes: Iterable[str]) -> list[str]:
    """Write a chapter as a list; one without notes is left out."""
    told = [*map(entry, notes)]
    return [title, *told] if told else []


def entry(note: str) -> Phrase:
    """Give a note as a line of a list, its numbers still those of their quantities."""
    return Phrase(f"- {plain(note)}", f"- {plain(template_of(note))}")
