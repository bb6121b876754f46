"""Springs, friction circles and the coupling on a loading scheme, as they are drawn (обозначения на схеме)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.figures.forces.scheme import Scheme
from drawings.layout.ink import Ink
from drawings.layout.place import Place
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Stroke, stated
from drawings.symbols.symbols import HINGE, fixed_hinge
from drawings.symbols.transmission import coupling, spring

SEEN = 0.4  # mm that a friction circle must be wider than the hinge's own circle
OFF, REACH = 20.0, 8.0  # mm from the shaft to its coupling, and how far the coupled shafts reach
WAYS = (1, -1, 1j, -1j)


def springs(shown: Scheme, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw each spring from its point on the links; one that the frame holds has its stand."""
    own = shown.links.points
    for one in shown.springs:
        start, end = place.on(one.start), place.on(one.end)
        data = {"kind": "spring", "name": one.name, "direction": stated((end - start) / abs(end - start))}
        strokes: tuple[Stroke, ...] = (spring(start, end, hand),)
        if one.fixed and one.letter not in own:
            strokes += fixed_hinge(end, hand, HINGE * hand.symbol)
        yield Group(strokes, "", data)


def friction_circles(shown: Scheme, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw the friction circles that are to be seen at the scheme's scale, each about its hinge."""
    for one in dict.fromkeys(shown.circles):  # a point that joins three links has a circle for each two of them
        radius = place.length(one.radius)
        if radius > HINGE * hand.symbol + SEEN and one.point in shown.named:
            circle = Circle(place.on(shown.named[one.point]), radius, hand.drafted)
            yield Group((circle,), "", {"kind": "friction", "name": one.point})


def coupled(shown: Scheme, place: Place, hand: Hand, ink: Ink) -> Iterator[Group]:
    """Draw the coupling beside the shaft, where it crosses the fewest lines."""
    if not shown.coupled:
        return
    shaft = place.on(shown.links.spot(shown.links.mechanism.drive.pivot, shown.links.shown))
    choices = [coupling(shaft + way * OFF * hand.symbol, way, hand, REACH) for way in WAYS]
    best = min(choices, key=ink.crossed_by)
    yield Group(tuple(best), "", {"kind": "coupling", "name": str(shown.links.mechanism.drive.link)})
