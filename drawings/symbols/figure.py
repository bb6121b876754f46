"""A figure: a plan placed on paper, its strokes measurable (фигура листа)."""

from __future__ import annotations

from typing import NamedTuple

from drawings.layout.picture import Margins, Place
from drawings.lettering.lettering import text_width
from drawings.page.page import Scale
from drawings.paper.hand import Field, Hand
from drawings.paper.strokes import LEAN, Circle, Group, Line, LineStyle, Text, numeral, stated
from drawings.symbols.symbols import arrowhead

PLAN_LETTERS = 12.0  # a plan is drawn at least so many of its letters large, and as many as it has: below, they hide it
LINE = 1.6  # from one line below a title to the next, in sizes of their letters


class Subject(NamedTuple):
    """What a figure's marks belong to: the plan's name, its quantity, its position; None is every position."""

    plan: str
    quantity: str
    position: int | None

    def data(self, kind: str, name: str, value: complex, scale: Scale) -> dict[str, str]:
        """Give the data of a mark that can be measured."""
        return {
            "kind": kind,
            "plan": self.plan,
            "quantity": self.quantity,
            "name": name,
            **({"position": str(self.position)} if self.position is not None else {}),
            "value": stated(value),
            "unit": scale.unit,
            "scale": numeral(scale.mu),
        }


def vector(
    subject: Subject, name: str, ends: tuple[complex, complex], place: Place, style: LineStyle, symbol: float = 1.0
) -> Group:
    """Draw a vector between two true ends, full length to the arrow's tip, and say what it is."""
    start, end = place.on(ends[0]), place.on(ends[1])
    head = arrowhead(start, end, symbol)
    strokes = (Line(start, end, style),) if head is None else (Line(start, end, style), head)
    return Group(strokes, "", subject.data("vector", name, ends[1] - ends[0], place.scale), name)


def point(
    subject: Subject, name: str, value: complex, place: Place, circle: Circle, kind: str = "point", title: str = ""
) -> Group:
    """Draw a point or a pole by its circle, and say what it is; its title is its name, or another one."""
    return Group((circle,), "", subject.data(kind, name, value, place.scale), title or name)


def around(sizes: Margins, hand: Hand, side: float = 0.0, below: float = 0.0, above: float = 0.0) -> Margins:
    """Give the paper around a figure, mm: for its letters, in their sizes, for what reaches beyond it, its heading."""
    beside, under, over = (size * hand.letter for size in sizes)
    return Margins(beside + side, under + below, over + above + 2 * hand.title + hand.text)


def heading_width(title: str, hand: Hand) -> float:
    """Give the width of a figure's title, mm, with what slanted letters lean beyond it."""
    return text_width(Text(0j, title, hand.title)) + 2 * LEAN * hand.title


def heading(box: Field, title: str, under: str, hand: Hand, *further: str) -> Group:
    """Write a figure's title and its scale, or what is said instead, at the top of its box; further lines below."""
    at = complex(box.centre.real, box.top - hand.title)
    low = at - 1j * (0.6 * hand.title + hand.text)
    lines = ((low - 1j * k * LINE * hand.text, line) for k, line in enumerate((under, *further)))
    texts = (Text(place, line, hand.text, "middle", True) for place, line in lines)
    return Group((Text(at, title, hand.title, "middle", True), *texts))
