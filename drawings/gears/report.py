"""A gear train in the report: what is given, how it fits, ratios, speeds of all links (зубчатый механизм в отчёте)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.gears.notes import GearsNotes
from drawings.gears.sheet import results, speeds
from drawings.gears.synthesis import solutions
from drawings.page.page import drafting_of
from drawings.report.formula import Chapters, entry, plain
from drawings.report.report import Report, TableSubject, chapter, ruled
from plans.gears.quantities import GearsComparison
from plans.gears.study import GEARS, GearsStudy
from plans.study import Study

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def _notes(study: Study) -> GearsNotes:
    return GearsNotes(study.of(GearsStudy), study.of(GearsComparison).analysis, drafting_of(study.scene))


def headline(study: Study) -> str:
    """Say the ratio of each gear."""
    return "; ".join(map(plain, _notes(study).ratios()))


def subject(study: Study) -> TableSubject:
    """Tell the train by its wheels and its ratios."""
    found = study.of(GearsStudy)
    ratios = ((gear.name, study.of(GearsComparison).analysis.ratio(gear)) for gear in found.train.gears)
    given = (f"{name} {ratio}".strip().replace("-", "\N{MINUS SIGN}") for name, ratio in ratios if ratio is not None)
    told = ", ".join(given) or "a differential"
    structure = f"gear train, {len(found.train.wheels)} wheels"
    output = f"{found.ratio_name} = {told}" if found.train.single else told
    return TableSubject(structure, output, f"A {structure}: {output}.")


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the train: what is given, how it fits, its ratios, the speeds of its links."""
    notes, drafting = _notes(study), drafting_of(study.scene)
    comparison = study.of(GearsComparison)
    searched = study.of(GearsStudy).searched
    sought = ["", *ruled(solutions(searched, drafting, None).plain)] if searched else []
    told = (results(comparison, drafting), speeds(comparison.analysis, drafting))
    tables = [line for each in told for line in ("", *ruled(each.plain))]
    found = *notes.willis(), *notes.ratios(whole=True), *notes.inertia(), *notes.moments()
    head = chapter(drafting.language, GEARS)
    return Chapters(
        subject=[
            head if study.techniques[0] != GEARS else head.lstrip(),
            *map(entry, (*notes.given(), *notes.synthesis(None), *notes.fit())),
            *sought,
        ],
        values=["", *map(entry, found), *tables],
    )


def _concluded(study: Study) -> Iterator[str]:
    yield from map(entry, _notes(study).ratios())


REPORT = Report(chapters, headline, subject=subject, conclusion=_concluded)
