"""A mechanism's balance in the report: masses, main points, counterweights, what they cost, shares (отчёт)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.page.drafting import Drafting, drafting_of
from drawings.report.balance import balance_tables as tables
from drawings.report.balance.balance_notes import BalanceNotes
from drawings.report.formula import Chapters
from drawings.report.markdown import chapter
from drawings.report.run_tables import plain
from plans.balance.study import BalanceStudy
from plans.study import Study
from plans.words.words import Message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS = 10


def headline(study: Study) -> str:
    """Say what is to be put on, and what it costs."""
    notes = notes_of(study)
    return "; ".join(map(plain, (*notes.counterweights(), *notes.price())))


def remarks(study: Study) -> list[Message]:
    """Find nothing that is not whole but the gaps, which are told with the positions."""
    return []


def notes_of(study: Study, digits: int = 5) -> BalanceNotes:
    """Give the notes on what the construction finds."""
    own: BalanceStudy = study["balance"]
    return notes_by(own, digits)


def drafting_for(own: BalanceStudy) -> Drafting:
    """Give what a scene asks of its sheets, with the letter that it gives reactions."""
    return drafting_of(own.linkage.scene)._replace(reactions=own.statics.form.sheet.reactions)


def notes_by(own: BalanceStudy, digits: int = 5) -> BalanceNotes:
    """Give the notes on a balance by construction."""
    after = None if own.balance.after is None else own.points(after=True).vectors
    vectors = own.points().vectors, after
    drafting = drafting_for(own)
    return BalanceNotes(own.linkage.mechanism, own.tree, own.machine, own.balance, vectors, drafting, digits)


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell what is balanced, by what, and what it costs."""
    language, notes = study.scene.sheet.language, notes_of(study, DIGITS)
    aim = word(language, f"report.aim_{notes.balance.task.aim}")
    masses = () if "forces" in study.techniques else tables.masses(notes)
    return Chapters(
        subject=[chapter(language, "balancing").lstrip(), aim, *masses, *_lines(notes.main_points())],
        values=[*_counterweights(notes), *_costs(notes), *_shares(notes), *_centres(notes)],
        left_out=[word(language, "report.balance_left_out")],
    )


def _counterweights(notes: BalanceNotes) -> Iterator[str]:
    told = [*notes.counterweights(), *notes.balanced(), *notes.left()]
    if told:
        yield chapter(notes.drafting.language, "counterweights")
        yield from _lines(told)
    if notes.balance.counterweights:
        yield ""
        yield from tables.counterweights(notes)


def _costs(notes: BalanceNotes) -> Iterator[str]:
    yield chapter(notes.drafting.language, "balance_costs")
    yield from tables.costs(notes)


def _shares(notes: BalanceNotes) -> Iterator[str]:
    shares = notes.balance.shares
    if shares is not None:
        yield chapter(notes.drafting.language, "shares")
        yield from _lines(notes.choice())
        yield ""
        yield from tables.shares(shares, plain(notes.shaft), notes.drafting)


def _centres(notes: BalanceNotes) -> Iterator[str]:
    yield chapter(notes.drafting.language, "mass_centre")
    yield from tables.centres(notes)


def _lines(notes: Iterable[str]) -> Iterator[str]:
    return (f"- {plain(note)}" for note in notes)
