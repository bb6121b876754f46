"""Mistakes in an equation of moments: a term with the wrong sign, or left out, and what it gives (знаки моментов)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from drawings.grading import verdict
from drawings.grading.continuation import continued
from drawings.grading.records import Slip
from geometry.board import Mark
from geometry.replay import redraw


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
