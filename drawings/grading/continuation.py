"""Going on from what is there: a mark of the record drawn from the places that a student gave those before it."""

from __future__ import annotations

import cmath
from collections.abc import Mapping

import numpy as np

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
