"""What tells each technique in the report; chapters and tables in Markdown (отчёт)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, NamedTuple

from drawings.lettering.words import span
from drawings.report.formula import Chapters
from plans.model.motion import Complexes, Floats
from plans.quantity import EQUILIBRIUM, Quantity
from plans.words.words import ENGLISH, Message, term, word, written

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf
    from plans.study import Study


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


def titled(study: Study) -> Subject:
    """Tell a scene by its title, where its first technique has no more to say."""
    title = study.scene.heading(ENGLISH)
    return Subject(title, "", f"{title}.")


class Report(NamedTuple):
    """What one technique tells; it is the REPORT of its file report.py."""

    chapters: Callable[[Study, Mapping[str, Sequence[Leaf]]], Chapters]  # what was found, beside the leaves by sheets
    headline: Callable[[Study], str] = lambda study: ""  # a line about it on the screen, or nothing
    remarks: Callable[[Study], Iterable[Message]] = lambda study: ()  # what is not whole: gaps, dead centres, jams
    subject: Callable[[Study], Subject] = titled  # what is studied, for the gallery's page: by its first technique


def _quantities(technique: str, study: Study, _: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the quantities of a technique by both roads."""
    language = study.scene.sheet.language
    heads = [word(language, key) for key in ("table.quantity", "sheet.by plan", "sheet.by analysis")]
    found = (one for one in study.quantities(technique) if one.plan != EQUILIBRIUM)
    rows = (
        row([heading(one, language), *(_size(one, road, language) for road in (one.construction, one.analysis))])
        for one in found
    )
    return Chapters(values=[chapter(language, technique), *header(heads), *rows])


def _size(one: Quantity, road: Complexes | Floats, language: str) -> str:
    """Write how large a quantity is by a road, at the least and at the most over all positions; rounding is 0."""
    sizes = zip(abs(road).tolist(), one.allowed.tolist(), strict=True)
    return span([size * (size > allowed) for size, allowed in sizes if math.isfinite(size)] or [0.0], language)


def report_of(technique: str) -> Report:
    """Give what tells a technique: where its folder has no report.py, its quantities in a table.

    >>> report_of("rotor").subject.__module__
    'drawings.rotor.report'
    """
    if find_spec(f"drawings.{technique}.report") is None:
        return Report(partial(_quantities, technique))
    report: Report = import_module(f"drawings.{technique}.report").REPORT
    return report
