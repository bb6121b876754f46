"""Mistakes in an equation of moments: a term with the wrong sign, or left out, and what it gives (знаки моментов)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping

import numpy as np

from drawings.grading import verdict
from drawings.grading.records import Slip
from geometry.board import Board, Mark
from geometry.errors import DraftError
from geometry.replay import redraw

SIMILARITIES = ("turn", "similar")  # verbs that carry a figure over


def continued(target: Mark, own: Mapping[Mark, complex]) -> complex | None:
    """Give where a mark lies if it is drawn as the record draws it, from another's places of what is before it.

    >>> board = Board("velocities")
    >>> pole, a, ab = board.given("p", 0j), board.given("a", 3 + 0j), board.given("ab", 1j)
    >>> continued(board.lay_off("b", a, ab), {a: 2j})
    3j
    """
    givens = {mark: value for mark, value in own.items() if mark is not target}
    return _point(redraw([target], givens)[target])


def mirrored(target: Mark, own: Mapping[Mark, complex]) -> complex | None:
    """Give where a mark lies whose figure is carried over mirrored; None of one that no figure gives."""
    if target.step.op != "lay_off" or target.step.inputs[1].step.op not in SIMILARITIES:
        return None
    origin, vector = target.step.inputs
    base = vector.step.inputs[0]
    again = redraw([origin, base, vector], {mark: value for mark, value in own.items() if mark is not target})
    start, along, there = (_point(again[mark]) for mark in (origin, base, vector))
    if start is None or along is None or there is None or along == 0:
        return None
    return start + along * (there / along).conjugate()


def turned_over(meeting: Mark) -> complex | None:
    """Give the other of the two places where the loci of a mark meet; None of one that meets but once."""
    if meeting.step.op != "meet" or not np.any(meeting.step.side):
        return None
    first, second = meeting.step.inputs
    other = Board(meeting.subject).meet(meeting.name, first, second, -meeting.step.side)
    return _point(other)


def _point(mark: Mark) -> complex | None:
    try:
        value = complex(np.asarray(mark.point).reshape(-1)[0])
    except (DraftError, TypeError):
        return None
    return value if cmath.isfinite(value) else None


def mistaken(force: Mark, own: Mapping[Mark, complex]) -> Iterator[Slip]:
    """Give what a force found by moments is by one mistake in them, from what the student has drawn before.

    >>> from geometry.board import Board
    >>> board = Board("forces")
    >>> at, up = board.given("D", 2 + 0j), board.given("up", 1j)
    >>> load = board.moment("C(G)", board.given("C", 0j), board.given("S", 1 + 0j), board.given("G_4", -10j))
    >>> twist, line = board.given("M^Φ_4", 4.0), board.parallel("line", at, up)
    >>> force = board.balance("R", board["C"], line, load, twist)
    >>> [(one.kind, one.of, abs(one.value)) for one in mistaken(force, {})]
    [('moment', 'G_4', 7.0), ('forgotten', 'G_4', 2.0), ('couple', 'M^Φ_4', 7.0), ('forgotten', 'M^Φ_4', 5.0)]
    """
    if force.step.op != "balance":
        return
    terms = force.step.inputs[2:]
    again = redraw(list(terms), own)
    for term in terms:
        moment, name = np.ravel(again[term].point)[0], _named(term)
        for kind, value in ((_turned(term), -moment), (verdict.FORGOTTEN, 0 * moment)):
            there = continued(force, {**own, term: complex(value)})
            if there is not None:
                yield Slip(kind, there, name)


def _named(term: Mark) -> str:
    """Name what has a moment: a force by its letters, a couple by its own."""
    return term.step.inputs[2].name if term.step.op == "moment" else term.name


def _turned(term: Mark) -> str:
    return verdict.MOMENT if term.step.op == "moment" else verdict.COUPLE
