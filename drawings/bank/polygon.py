"""The polygons of the orders: harmonic forces of the members end to end, or their moments (многоугольник)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.bank.star import BankView, ShownOrder
from drawings.kinds import polygon
from drawings.kinds.polygon import RESULT, Letters, Polygon, Sizes, draw
from drawings.layout.picture import Picture
from drawings.lettering.lettering import text_width
from drawings.lettering.vector_letters import lowered_bank
from drawings.page.scale import Drafting, Scale
from drawings.paper.strokes import Text
from drawings.rotor.polygon import CROWD
from plans.bank.harmonics import FORCE, MOMENT

__all__ = ["draw", "measure", "plan_of", "polygons"]

NAMES = {FORCE: "order_forces", MOMENT: "order_moments"}  # of the polygons, before the order
BACK = "back"  # after the order of what turns against the crank
UNITS = {FORCE: "N", MOMENT: "N*m"}  # of the scales
SIZES = Sizes(9.0, 1.4, 5.2)
LETTERS = Letters(lowered_bank, lambda name: name.partition(",")[2])
RANGE = 2.6  # a polygon is drawn at most so many times its least: standard scales are up to 2.5 times apart
WIDEST = 0.00025  # a scale as long as one is written


def plan_of(kind: str, signed: int) -> str:
    """Name the figure of a polygon.

    >>> plan_of(MOMENT, -2)
    'order_moments-2-back'
    """
    name = f"{NAMES[kind]}-{abs(signed)}"
    return name if signed > 0 else f"{name}-{BACK}"


def polygons(shown: BankView, drafting: Drafting) -> Iterator[Polygon]:
    """Give the polygons of every order whose vectors do not vanish; of too many members the sum alone."""
    for order in shown.shown():
        vectors = order.vectors
        if len(vectors) > CROWD + 1:
            vectors = tuple(vector for vector in vectors if vector.kind == RESULT)
        if vectors:
            name, scale = plan_of(order.kind, order.signed), (order.kind, UNITS[order.kind])
            yield Polygon(name, title_of(order, drafting), scale, vectors, order.closed, LETTERS, SIZES)


def title_of(shown: ShownOrder, drafting: Drafting) -> str:
    """Give the title of a polygon: what it is of, which order, which sense."""
    name = "moments of order" if shown.kind == MOMENT else "forces of order"
    return drafting.word(name if shown.signed > 0 else f"{name} back", order=abs(shown.signed))


def measure(shown: Polygon, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs, what stands under its title included."""
    room = polygon.measure(shown, drafting)
    under = text_width(Text(0j, shown.under(Scale(WIDEST, *shown.scale), drafting), drafting.hand.text))
    return room._replace(heading=max(room.heading, under), most=RANGE * room.least)
