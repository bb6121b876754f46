"""The steps behind a mark, in order, and a span between two marks (построения за точкой)."""

from __future__ import annotations

from typing import NamedTuple

from geometry.board import Mark


class Span(NamedTuple):
    """A vector of a plan between two of its marks."""

    start: Mark
    end: Mark


class Reading(NamedTuple):
    """What an angular velocity or acceleration is read from: a vector of the link and its turning part on the plan."""

    arm: Mark
    turning: Mark


def behind(*marks: Mark) -> list[Mark]:
    """Give the marks that the given ones rest on, themselves last, in drafting order across boards.

    >>> from geometry.board import Board
    >>> board = Board("positions")
    >>> a, c, d = board.given("A", 0j), board.given("C", 5 + 0j), board.given("D", 9j)
    >>> [mark.name for mark in behind(board.join("AC", a, c))]
    ['A', 'C', 'AC']
    """
    order: dict[Mark, None] = {}
    waiting = [(mark, False) for mark in reversed(marks)]
    while waiting:
        mark, ready = waiting.pop()
        if ready:
            order.setdefault(mark)
        elif mark not in order:
            waiting.append((mark, True))
            waiting.extend((source, False) for source in reversed(mark.step.inputs))
    return list(order)
