"""The steps behind a mark: what it rests on, in drafting order (шаги построения)."""

from __future__ import annotations

from geometry.board import Mark


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
