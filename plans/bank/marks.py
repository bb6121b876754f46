"""Marks of a bank by the names that `explain` takes: f_II, F_II, F_-II of those that turn back, M_II, F_II,3, mr_II."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from geometry.board import Mark, behind
from plans.bank.harmonics import COMPENSATORS, FORCE, HARMONICS, MOMENT, SINGLE, STATIC, couple_letters, letters, roman
from plans.bank.polygons import MOMENTS
from plans.bank.reading import ORDER_LIMIT, BankSurvey
from plans.bank.study import BankStudy, orders_of
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.model.balance.bank import BankTask
from plans.study import Study
from plans.words.words import message

LETTERS = re.compile(rf"-?({SINGLE}|{FORCE}|{MOMENT}|{STATIC})_|Φ\(")
NUMERAL = re.compile(rf"-?(?:{SINGLE}|{FORCE}|{MOMENT}|{STATIC})_(?:{MOMENT},)?-?([IVXLC]+|100)(?:,|$)")
UNITS = {HARMONICS: "N", MOMENTS: "N*m", COMPENSATORS: "kg*m"}


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark; of a vector of the bank those behind its harmonic only if all are asked for."""
    task: BankTask = study.scene.meaning.of(BankSurvey).task
    name = re.sub(r"^m_(?=M,|-?[IVXLC])", f"{STATIC}_", name)  # a mass is told by its static moment
    if not LETTERS.match(name):  # for a mark of another technique no bank is drawn
        return _no_mark(task)
    bank = study.of(BankStudy)
    mark = next((mark for board in bank.boards for mark in board if mark.name == name), None)
    if mark is None:
        return _other_order(task, name) or _no_mark(task)
    if position:
        raise UnknownMark(message("mark.no_position", mark=name, position=position))
    steps = behind(mark)
    kept = steps if study.whole else list(_marks(bank, mark, steps))
    left = len(steps) - len(kept)
    notes = (message("explain.ordinates", count=left),) if left else ()
    return Explanation(message("explain.name", mark=name), tuple(kept), UNITS, notes, zeros=frozenset(_zeros(bank)))


def _marks(bank: BankStudy, mark: Mark, steps: Sequence[Mark]) -> Iterator[Mark]:
    """Leave out what is behind the harmonics of one mechanism, unless one of them is asked for."""
    single = bank.single
    if mark.subject == HARMONICS and mark.number <= max(vector.number for vector in single.vectors.values()):
        yield from steps
        return
    ordinates = set(behind(*single.vectors.values())) - {single.pole, *single.vectors.values()}
    yield from (step for step in steps if step not in ordinates)


def _zeros(bank: BankStudy) -> Iterator[Mark]:
    """Give the vectors of the bank that vanish, and the corners where their polygons close."""
    for total in (*bank.drawing.forces.values(), *bank.drawing.moments.values()):
        if total.vanishes:
            yield from (total.vector, total.polygon.closing, *total.polygon.closing.step.inputs[:1])


def _other_order(task: BankTask, name: str) -> NoMark | None:
    """Say of a vector of an order that is not told how to have it told."""
    found, known = NUMERAL.match(name), orders_of(task)
    strange = (order for order in range(1, ORDER_LIMIT + 1) if found and roman(order) == found[1])
    order = next(strange, known[0])
    if order in known:
        return None
    orders = ", ".join(map(str, sorted((*known, order))))
    return NoMark((), message("mark.other_order", order=order, orders=orders), ())


def _no_mark(task: BankTask) -> NoMark:
    """Name the marks that there are."""
    first = task.orders[0]
    shown = [*(letters(kind, first) for kind in (SINGLE, FORCE, MOMENT)), letters(FORCE, first, task.members[0].name)]
    shown += [letters(STATIC, asked.order) for asked in task.asked[:1]]
    return NoMark(tuple(_names(task)), message("mark.marks", marks=", ".join(shown)), ())


def _names(task: BankTask) -> Iterator[str]:
    for order in orders_of(task):
        for signed in (order, -order):
            yield from (letters(kind, signed) for kind in (SINGLE, FORCE, MOMENT))
            yield from (letters(kind, signed, member.name) for kind in (FORCE, MOMENT) for member in task.members)
    for asked in task.asked:
        yield from (letters(STATIC, asked.order), letters(STATIC, -asked.order), couple_letters(asked.order))
