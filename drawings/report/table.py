"""The table of reports: what tells each technique; chapters and tables in Markdown (отчёт)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final, NamedTuple

from plans.quantity import Quantity
from plans.words.words import term, word, written


def chapter(language: str, name: str) -> str:
    """Give the head of a chapter, with what is said before its tables."""
    return f"\n{word(language, f'report.{name}')}\n"


def row(cells: Sequence[str]) -> str:
    """Write a row of a table."""
    return f"| {' | '.join(cells)} |"


def header(heads: Sequence[str]) -> list[str]:
    """Write the heads of a table's columns."""
    return [row(heads).replace("|  |", "| |"), "|" + "---|" * len(heads)]


def heading(finding: Quantity, language: str) -> str:
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


class Subject(NamedTuple):
    """The subject of a study: its structure and what comes out of it, and both in a sentence."""

    structure: str
    output: str
    sentence: str


class Report(NamedTuple):
    """What one technique tells; each text is "module:name", imported when a scene asks for it."""

    subject: str  # of a study to what it is in a few words, for the gallery's page
    chapters: str  # of a study and the leaves by their sheets to the chapters of the report
    headline: str  # of a study to a line about it on the screen, or nothing
    remarks: str  # of a study to lines of warning: gaps, dead centres, jams
    idle: str  # of a scene whose sheets do not ask for it to lines that say what is left out of it


REPORTS: Final[Mapping[str, Report]] = {
    "linkage": Report(
        subject="drawings.linkage.notes:subject",
        chapters="drawings.linkage.report:chapters",
        headline="drawings.linkage.report:headline",
        remarks="drawings.linkage.report:remarks",
        idle="drawings.report.report:nothing",
    ),
    "diagrams": Report(
        subject="drawings.linkage.notes:subject",
        chapters="drawings.diagrams.report:chapters",
        headline="drawings.diagrams.report:headline",
        remarks="drawings.diagrams.report:remarks",
        idle="drawings.report.report:nothing",
    ),
    "forces": Report(
        subject="drawings.linkage.notes:subject",
        chapters="drawings.forces.note:chapters",
        headline="drawings.forces.report:headline",
        remarks="drawings.forces.report:remarks",
        idle="drawings.report.report:of_forces",
    ),
    "dynamics": Report(
        subject="drawings.linkage.notes:subject",
        chapters="drawings.dynamics.report:chapters",
        headline="drawings.dynamics.report:headline",
        remarks="drawings.dynamics.report:remarks",
        idle="drawings.report.report:of_dynamics",
    ),
    "balance": Report(
        subject="drawings.linkage.notes:subject",
        chapters="drawings.balance.report:chapters",
        headline="drawings.balance.report:headline",
        remarks="drawings.balance.report:remarks",
        idle="drawings.report.report:nothing",
    ),
    "bank": Report(
        subject="drawings.bank.report:subject",
        chapters="drawings.bank.report:chapters",
        headline="drawings.bank.report:headline",
        remarks="drawings.bank.report:remarks",
        idle="drawings.report.report:nothing",
    ),
    "rotor": Report(
        subject="drawings.rotor.report:subject",
        chapters="drawings.rotor.report:chapters",
        headline="drawings.rotor.report:headline",
        remarks="drawings.rotor.report:remarks",
        idle="drawings.report.report:nothing",
    ),
    "cyclogram": Report(
        subject="drawings.cyclogram.report:subject",
        chapters="drawings.cyclogram.report:chapters",
        headline="drawings.cyclogram.report:headline",
        remarks="drawings.cyclogram.report:remarks",
        idle="drawings.report.report:nothing",
    ),
    "cam": Report(
        subject="drawings.cam.report:subject",
        chapters="drawings.cam.report:chapters",
        headline="drawings.cam.report:headline",
        remarks="drawings.cam.report:remarks",
        idle="drawings.report.report:nothing",
    ),
}
