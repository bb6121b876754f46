"""The kinematic diagrams in the report: the output's course (диаграммы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.lettering.words import decimal, number
from drawings.report.formula import Chapters
from drawings.report.markdown import chapter, header, heading, row
from plans.checks.comparison import Finding
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import Diagrams, chord_error
from plans.model.motion import Floats
from plans.study import Study
from plans.words.words import Message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

TOLD = (0, 1, 2, 3, 5)  # of the findings: S, v, a by the plans, v and a by chords
DIGITS = 10


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the output's course at all positions with the chords; why there are no diagrams, if they are wanted."""
    own: DiagramsStudy = study["diagrams"]
    language = study.scene.sheet.language
    if own.diagrams is not None:
        return Chapters(values=_values(own.diagrams, study.comparison("diagrams").findings, language))
    if own.left_out is None or not own.wanted:
        return Chapters()
    return Chapters(left_out=(word(language, "report.no_diagrams", why=own.left_out),))


def headline(study: Study) -> str:
    """Say nothing: the output is told with the motion."""
    return ""


def remarks(study: Study) -> list[Message]:
    """Warn of nothing: diagrams that are left out are told on the sheet and in the report."""
    return []


def _values(found: Diagrams, findings: Sequence[Finding], language: str) -> Iterator[str]:
    """Tabulate the course; v by a chord stands with the position from which it goes on."""
    yield chapter(language, "diagrams")
    told = [findings[k] for k in TOLD]
    heads = (word(language, "table.position"), "φ, °", *(heading(one, language) for one in told))
    yield from header(heads)
    for k, position in enumerate(found.axis.numbers):
        cells = (_cell(one, k, language) for one in told)
        yield row([str(position), decimal(f"{math.degrees(found.axis.turned[k]):.4f}", language), *cells])
    yield ""
    yield from _errors(found, told, language)


def _cell(finding: Finding, k: int, language: str) -> str:
    """Write a value by construction; what is but a rounding of the largest is 0."""
    if k == len(finding.construction):  # no step goes on from the last position
        return ""
    value = float(finding.construction[k])
    if math.isnan(value):
        return word(language, "table.gap")
    return number(0.0 if abs(value) <= float(finding.allowed[k]) else value, language, DIGITS)


def _errors(found: Diagrams, told: Sequence[Finding], language: str) -> Iterator[str]:
    """Tell how far the chords are out at the most, and where."""
    numbers = found.axis.numbers
    pairs: tuple[tuple[Floats, Floats], ...] = (
        (found.speeds, found.true_speeds),
        (found.growths, found.true_growths),
    )
    for one, (values, true), fast in zip(told[3:], pairs, (True, False), strict=True):
        error = chord_error(values, true)
        if error is not None:
            place = f"{numbers[error.at]}–{numbers[error.at + 1]}" if fast else str(numbers[error.at])
            off = number(100 * error.share, language, 3)
            yield word(language, "report.chords", name=one.name.split(" ")[0], off=off, place=place)
