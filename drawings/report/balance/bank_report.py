"""A bank in the report: its mechanisms, the sums of every order, what vanishes, compensators (блок в отчёте)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.page.drafting import Drafting, drafting_of
from drawings.report.balance.bank_notes import BankNotes
from drawings.report.formula import Chapters
from drawings.report.markdown import chapter, header, row
from drawings.report.run_tables import listed, plain
from drawings.report.table import Subject
from plans.model.balance.bank import BankBalance
from plans.study import Study
from plans.words.words import word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS = 10
HEADS = ("order", "one force", "bank force", "force left", "bank moment")


def subject(study: Study) -> Subject:
    """Tell a bank in a few words, for the gallery's page."""
    task = study["bank"].task
    kind = "linkages" if task.unit is None else "slider-cranks"
    count, orders = len(task.members), ", ".join(str(one.order) for one in task.asked)
    structure = f"bank of {count} {kind}"
    output = f"compensators of order {orders}" if orders else "no compensators"
    return Subject(structure, output, f"A {structure} on one shaft; {output}.")


def headline(study: Study) -> str:
    """Say what compensates the forces of the bank, or else which orders vanish by themselves."""
    notes = _notes(study)
    return "; ".join(map(plain, [*notes.compensators()] or [*notes.vanishing()]))


def remarks(study: Study) -> list[str]:
    """Find nothing that is not whole: the crank of every bank turns fully."""
    return []


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell a bank, its orders and its compensators."""
    drafting, notes = drafting_of(study.scene), _notes(study)
    language = drafting.language
    return Chapters(
        subject=listed(chapter(language, "bank").lstrip(), [*notes.members(), *notes.given()]),
        values=[chapter(language, "bank_orders"), *_orders(study["bank"].balance, drafting)],
        conditions=[
            *listed(chapter(language, "bank_sums"), [*notes.sums(), *notes.vanishing(), *notes.slight()]),
            *listed(chapter(language, "bank_compensators"), [*notes.compensators()]),
        ],
        left_out=[word(language, "report.bank_left_out")],
    )


def _orders(balance: BankBalance, drafting: Drafting) -> list[str]:
    """Write the table of the orders."""
    answered = {one.asked.order for one in balance.compensators}
    lines = header([plain(drafting.word(head)) for head in HEADS])
    for order, single in balance.single.items():
        force = balance.forces[order].size
        sizes = single.size, force, 0.0 if order in answered else force, balance.moments[order].size
        lines.append(row([str(order), *(drafting.number(one, DIGITS) for one in sizes)]))
    return lines


def _notes(study: Study) -> BankNotes:
    return BankNotes(study["bank"].balance, drafting_of(study.scene), DIGITS)
