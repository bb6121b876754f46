"""The names of the rows of a bar chart, broken into two lines where one has no room (наименования механизмов)."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from drawings.figures.cyclogram import course
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Text
from plans.model.cyclogram import Row


def width(rows: Sequence[Row], drafting: Drafting, clear: float) -> float:
    """Give the width, mm, of a column that bears the names, clear of its sides: in two lines what has two words."""
    names = [course.name(row, drafting) for row in rows]
    lines = (one for name in names for one in min(_ways(name), key=lambda way: max(map(len, way))))
    return max(_wide(one, drafting) for one in lines) + 2 * clear


def lines(row: Row, room: complex, step: float, drafting: Drafting) -> tuple[str, ...]:
    """Give the lines of a name in a room, mm wide and high, at a step in sizes of letters; none, if there is none."""
    found = broken(course.name(row, drafting), room.real, lambda text: _wide(text, drafting))
    high = (step * (len(found) - 1) + 1) * drafting.hand.number
    return found if high <= room.imag else ()


def broken(text: str, room: float, wide: Callable[[str], float]) -> tuple[str, ...]:
    """Break a name into two lines at most that have room, as even as may be; nothing if they have none.

    >>> broken("auxiliary mechanism", 12, len), broken("tool", 12, len), broken("mechanism", 8, len)
    (('auxiliary', 'mechanism'), ('tool',), ())
    """
    one, *others = _ways(text)
    best = one if wide(text) <= room else min(others, key=lambda way: max(map(wide, way)), default=one)
    return best if max(map(wide, best)) <= room else ()


def _ways(text: str) -> list[tuple[str, ...]]:
    """Give the ways to break a text, in one line first."""
    parts = text.split(" ")
    return [(text,), *((" ".join(parts[:k]), " ".join(parts[k:])) for k in range(1, len(parts)))]


def _wide(text: str, drafting: Drafting) -> float:
    return text_width(Text(0j, text, drafting.hand.number, "middle", True))
