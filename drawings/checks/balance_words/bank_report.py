"""The self-check of a bank in the report: its sentences and the table of its orders (проверка отчёта о блоке)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.checks.balance_words.bank_sentences import BankSentences
from drawings.checks.balance_words.report_lines import head, table, wrong_chapter
from drawings.checks.balance_words.sentences import Sentence, is_line, number
from drawings.checks.bank.bank_expected import Expected
from drawings.checks.documents_old import chapters
from drawings.checks.note.lines import in_report
from drawings.page.drafting import drafting_of
from plans.bank.letters import FORCE, MOMENT, SINGLE, letters
from plans.model.balance.bank import Harmonic
from plans.study import Study
from plans.words.words import Message, message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS = 10  # of numbers
HEADS = ("order", "one force", "bank force", "force left", "bank moment")


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """Give what the report tells of a bank otherwise than the analysis (row of the table of reports)."""
    expected, language = Expected(study["bank"].task, study.comparison("bank")), study.scene.sheet.language
    sentences = BankSentences(expected, drafting_of(study.scene), DIGITS, in_report)
    due = {
        "bank": _listed([*sentences.members(), *sentences.given()]),
        "bank_orders": list(_orders(expected, sentences)),
        "bank_sums": _listed(sentences.sums()),
        "bank_compensators": _listed(sentences.compensators()),
    }
    for name, lines in due.items():
        title = head(word(language, f"report.{name}"))
        if lines:
            yield from wrong_chapter(text, [*title, *lines])
        elif title[0].marked in text.splitlines():
            yield message("wrong.told", text=title[0].marked)
    heads = [name for name, lines in due.items() if lines]
    yield from chapters.faults(text, language, [*heads, "left_out", "bank_left_out"])


def headline(study: Study) -> Callable[[str], bool] | None:
    """Give what tells whether a line says what compensates a bank's forces, or which orders vanish; None of neither."""
    expected = Expected(study["bank"].task, study.comparison("bank"))
    own = BankSentences(expected, drafting_of(study.scene), DIGITS, in_report)
    due = [*own.compensators()] or [*own.vanishing()]
    return (lambda line: is_line(line, due)) if due else None


def _listed(sentences: Iterator[Sentence] | Sequence[Sentence]) -> list[Sentence]:
    """Give sentences as lines of a list."""
    return [Sentence(f"- {one.marked}", one.sure) for one in sentences]


def _orders(expected: Expected, sentences: BankSentences) -> Iterator[Sentence]:
    """Give the table of the orders: of one mechanism, of the bank, what is left, the moment."""
    analysis = expected.analysis
    answered = {one.asked.order for one in analysis.compensators}
    rows = []
    for order, single in analysis.single.items():
        force = _size(expected, FORCE, analysis.forces[order])
        left = "0" if order in answered else force
        moment = _size(expected, MOMENT, analysis.moments[order])
        rows.append([str(order), _size(expected, SINGLE, single), force, left, moment])
    yield from table([in_report(sentences.drafting.word(key)) for key in HEADS], iter(rows))


def _size(expected: Expected, kind: str, one: Harmonic) -> str:
    """Put in the largest that both vectors of an order come to along one line."""
    sizes = [abs(one.ahead), abs(one.back)]
    slack = 2 * expected.allowed[letters(kind, one.order)]
    return number(0.0 if max(sizes) <= one.slack else math.fsum(sizes), slack, DIGITS)
