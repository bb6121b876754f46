"""By what the strokes of a scheme are told: symbols, fillings, turning arrows, numbers, leaders (штрихи схемы)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from drawings.checks.balance import figure_parts as parts
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.linkage.laid_poses import Segments
from drawings.figures.balance.balance_scheme import PATH, RIM
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Arc, Circle, Fill, Group, Line, Stroke, Text


def is_led(group: Group) -> bool:
    """Tell whether a group is a letter with its leader."""
    match group:
        case Group((Line(), Text())):
            return True
    return False


def rings(ring: Stroke, text: Text) -> bool:
    """Tell whether a circle stands around a text."""
    left, bottom, right, top = bounds(text)
    middle = complex(left + right, bottom + top) / 2
    return isinstance(ring, Circle) and abs(ring.centre - middle) < ring.radius / 2


def is_one(one: Stroke, own: set[int]) -> bool:
    """Tell whether a stroke is one of some."""
    return id(one) in own


def is_symbol(one: Circle, at: complex, sizes: list[float], near: float) -> bool:
    """Tell whether a circle is a symbol about a place."""
    return abs(one.centre - at) <= near and any(abs(one.radius - size) <= near for size in sizes)


def starts(one: Fill, at: complex, near: float) -> bool:
    """Tell whether a filling begins at a place."""
    return abs(one.points[0] - at) <= near


def is_filling(one: Fill, at: complex, far: float) -> bool:
    """Tell whether a filling lies about a place."""
    return max(abs(spot - at) for spot in one.points) <= far


def is_turning(one: Arc, at: complex, beside: Callable[[complex], bool]) -> bool:
    """Tell whether an arc is about a place, its letter beside its middle."""
    return abs(one.centre - at) <= parts.NEAR and beside(one.at(0.5))


def beside(spot: complex, ink: Inventory, texts: list[Text]) -> bool:
    """Tell whether one of some texts stands beside a spot."""
    return any(ink.beside(text, [spot]) for text in texts)


def goes_on(head: Fill, arc: Arc, sense: int) -> bool:
    """Tell whether a head goes on from the end of an arc that its sense leads to."""
    end, back = arc.at(1.0 if sense > 0 else 0.0), sum(head.points[1:]) / (len(head.points) - 1)
    return abs(back - end) <= parts.NEAR and ((head.points[0] - back) / (sense * 1j * (end - arc.centre))).real > 0


def stands_on(one: Group, names: set[str], plan: str) -> bool:
    """Tell whether a group is a vector, a counterweight, the mass centre, or a path or an outline by its name."""
    marked = one.data.get("kind") == "vector" or one.data.get("name") in names
    return marked or one.name.startswith((f"{plan}-{PATH}", f"{plan}-{RIM}"))


def without(strokes: tuple[Stroke, ...], gone: set[int]) -> Iterator[Stroke]:
    """Give strokes without some groups among them."""
    for one in strokes:
        if isinstance(one, Group):
            if id(one) not in gone:
                yield Group(tuple(without(one.strokes, gone)), one.name, one.data, one.title)
        else:
            yield one


def is_number(group: Group) -> bool:
    """Tell whether a group is the number of a link in its circle."""
    match group:
        case Group((Circle(), Text(), *_)):
            return True
    return False


def segment(line: Line) -> Segments:
    """Give a line as a piece."""
    return Segments(np.array([line.start]), np.array([line.end]))


def within(line: Line, at: complex, far: float) -> bool:
    """Tell whether a line lies about a place."""
    return max(abs(line.start - at), abs(line.end - at)) <= far
