"""Chapters and tables of the report in Markdown, in its language (главы и таблицы)."""

from __future__ import annotations

from collections.abc import Sequence

from plans.checks.comparison import Finding
from plans.rotor.letters import written
from plans.words.words import term, word


def chapter(language: str, name: str) -> str:
    """Give the head of a chapter, with what is said before its tables."""
    return f"\n{word(language, f'report.{name}')}\n"


def row(cells: Sequence[str]) -> str:
    """Write a row of a table."""
    return f"| {' | '.join(cells)} |"


def header(heads: Sequence[str]) -> list[str]:
    """Write the heads of a table's columns."""
    return [row(heads).replace("|  |", "| |"), "|" + "---|" * len(heads)]


def heading(finding: Finding, language: str) -> str:
    """Name a quantity with its unit."""
    return f"{quantity(finding.name, language)}, {term(language, 'text_unit', finding.unit)}"


def quantity(name: str, language: str) -> str:
    """Name a quantity: its letter, and in words what tells it from others of that letter.

    >>> quantity("M_bal lever", "en"), quantity("M_bal lever", "ru")
    ('M_bal lever', 'M_ур по рычагу')
    >>> quantity("m_cw4", "ru")
    'm_пр4'
    """
    parts = name.split(" ")
    if len(parts) == 1:
        return written(term(language, "quantity", name), language)
    return " ".join(term(language, "quantity", term(language, "quantity_part", part)) for part in parts)
