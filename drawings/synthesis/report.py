"""A task of synthesis in the report: what is asked, how it is drawn, what is found by both roads (синтез в отчёте)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice

from drawings.lettering.words import Phrase, joined
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.formula import Chapters, entry, plain
from drawings.report.report import Report, TableSubject, chapter, ruled
from drawings.synthesis.due import DIGITS, told
from drawings.synthesis.due_shown import NAME
from drawings.synthesis.sheet import family, notes, values
from plans.study import Study
from plans.synthesis.quantities import letter_of
from plans.synthesis.study import SynthesisStudy
from plans.words.words import ENGLISH, Message

LINKS = 4  # sizes that a headline tells: the lengths of the links come first


def headline(study: Study) -> str:
    """Say which mechanism is taken."""
    return plain(_told(study.of(SynthesisStudy).synthesis.chosen.sizes, drafting_of(study.scene), LINKS))


def _told(sizes: Mapping[str, float], drafting: Drafting, most: int | None = None) -> Phrase:
    return joined(", ", [told(name, size, drafting, DIGITS) for name, size in islice(sizes.items(), most)])


def subject(study: Study) -> TableSubject:
    """Tell a task in a few words, for the gallery's page."""
    found = study.of(SynthesisStudy)
    kind, asked = family(found, ENGLISH), plain(_told(found.task.asked, drafting_of(study.scene)))
    return TableSubject(f"{kind} to be found", asked, f"A task of synthesis: a {kind} with {asked}.")


def _steps(found: SynthesisStudy, drafting: Drafting) -> Iterator[str]:
    """Tell each construction step by step: why its marks are drawn; those that only carry others have no names."""
    for number, one in enumerate(found.drawn):
        if one.found:
            letter = letter_of(number) if len(found.drawn) > 1 else ""
            yield f"\n{drafting.word('synthesis construction')} {letter}\n".replace(" \n", "\n")
            whys = ((mark.name, mark.step.why) for mark in one.board if isinstance(mark.step.why, Message))
            said = (("" if ":" in name else f"{name}: ") + why.worded(drafting.language) for name, why in whys)
            yield from map(entry, dict.fromkeys(said))  # what several of them are drawn for is told once


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell a task: what is asked, the construction, all sizes by both roads."""
    drafting, found = drafting_of(study.scene), study.of(SynthesisStudy)
    said = map(entry, notes(found, drafting))
    return Chapters(
        values=[
            chapter(drafting.language, NAME),
            *said,
            *_steps(found, drafting),
            "",
            *ruled(values(study, drafting).plain),
        ]
    )


REPORT = Report(chapters, headline, subject=subject)
