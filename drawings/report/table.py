"""What tells each technique in the report; chapters and tables in Markdown (отчёт)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from drawings.lettering.words import decimal, fixed, number, span
from drawings.report.formula import DIGITS, Chapters
from plans.model.motion import Complexes, Floats
from plans.quantity import EQUILIBRIUM, Quantity
from plans.words.words import ENGLISH, Message, term, word, written

if TYPE_CHECKING:
    from drawings.page.page import Drafting
    from drawings.paper.strokes import Leaf
    from geometry.board import Mark
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


def united(heads: Iterable[str], drafting: Drafting) -> list[str]:
    """Write the units of the heads of columns, which stand behind a comma, in the language of the report."""
    parts = (head.partition(", ") for head in heads)
    return [f"{name}{comma}{drafting.word(unit) if unit else unit}" for name, comma, unit in parts]


def tabled(heads: Sequence[str], columns: Iterable[Any], language: str, gap: str = "", first: str = "") -> list[str]:
    """Write a table of all positions, or of what else is numbered from 0 on."""
    rows = zip(*(column(values, language, gap) for values in columns), strict=True)
    named = first or word(language, "table.position")
    return [*header([named, *heads]), *(row([str(k), *cells]) for k, cells in enumerate(rows))]


def column(values: Any, language: str, gap: str = "") -> list[str]:
    """Write numbers, or vectors as x; y, to the decimals that the largest of them has.

    >>> column([12.3456, 0.00012, math.nan], "en"), column([1 - 0.5j], "ru"), column([0.0, 2e6], "en")
    (['12.3456', '0.0001', 'gap'], ['1,00000; −0,50000'], ['0', '2000000'])
    """
    numbers = np.asarray(values)
    sizes = np.abs([numbers.real, numbers.imag])
    largest = float(np.max(sizes[np.isfinite(sizes)], initial=0.0))
    places = MOST - 1 - math.floor(math.log10(largest)) if largest else 0
    gap = gap or word(language, "table.gap")
    return [gap if math.isnan(abs(value)) else _cell(value, places, language) for value in numbers.tolist()]


def _cell(value: complex, places: int, language: str) -> str:
    if isinstance(value, complex):
        return f"{_cell(value.real, places, language)}; {_cell(value.imag, places, language)}"
    if math.isinf(value):
        return "∞"
    if abs(value) < 0.5 * 10.0**-places:
        return "0"
    return fixed(value, language, places) if places >= 0 else number(value, language, DIGITS)


ANGLE = "\N{NO-BREAK SPACE}∠\N{NO-BREAK SPACE}"  # between the size of a vector and its direction
MOST = 6  # digits of the largest number of a column, so that a hundredth of it still has four
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
PLAIN = 1e-3  # a smaller number is written by its power of ten


def tiny(value: float, language: str) -> str:
    """Write a difference with two digits.

    >>> tiny(-2.46e-16, "ru"), tiny(0.165, "ru"), tiny(0.0, "ru")
    ('−2,5·10⁻¹⁶', '0,17', '0')
    """
    if abs(value) >= PLAIN or not value:
        return number(value, language, 2)
    mantissa, power = f"{value:.1e}".replace("-", "−", value < 0).split("e")
    return f"{decimal(mantissa, language)}·10{str(int(power)).translate(RAISED)}"


def heading(finding: Quantity, language: str) -> str:
    """Name a quantity with its unit, if it has one."""
    unit = term(language, "unit", finding.unit)
    return f"{quantity(finding.name, language)}, {unit}" if unit else quantity(finding.name, language)


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


class TableSubject(NamedTuple):
    """The subject of a study: its structure and what comes out of it, and both in a sentence."""

    structure: str
    output: str
    sentence: str


def titled(study: Study) -> TableSubject:
    """Tell a scene by its title, where its first technique has no more to say."""
    title = study.scene.heading(ENGLISH)
    return TableSubject(title, "", f"{title}.")


class Report(NamedTuple):
    """What one technique tells; it is the REPORT of its file report.py."""

    chapters: Callable[[Study, Mapping[str, Sequence[Leaf]]], Chapters]  # what was found, beside the leaves by sheets
    headline: Callable[[Study], str] = lambda study: ""  # a line about it on the screen, or nothing
    remarks: Callable[[Study], Iterable[Message]] = lambda study: ()  # what is not whole: gaps, dead centres, jams
    subject: Callable[[Study], TableSubject] = titled  # what is studied, for the gallery's page: by its first technique
    conclusion: Callable[[Study], Iterable[str]] | None = None  # what follows from the numbers; None: its headline
    equations: Callable[[Study, Mark, int], Iterable[str]] = lambda study, mark, position: ()  # that give a mark


def _quantities(technique: str, study: Study, _: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the quantities of a technique by both roads."""
    language = study.scene.sheet.language
    heads = [word(language, key) for key in ("table.quantity", "sheet.by plan", "sheet.by analysis")]
    found = (finding for finding in study.quantities(technique) if finding.plan != EQUILIBRIUM)
    rows = (
        row(
            [
                heading(finding, language),
                *(_size(finding, road, language) for road in (finding.construction, finding.analysis)),
            ]
        )
        for finding in found
    )
    return Chapters(values=[chapter(language, technique), *header(heads), *rows])


def _size(finding: Quantity, road: Complexes | Floats, language: str) -> str:
    """Write how large a quantity is by a road, at the least and at the most over all positions; rounding is 0."""
    sizes = zip(abs(road).tolist(), finding.allowed.tolist(), strict=True)
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
