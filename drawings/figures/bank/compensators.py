"""The layout of compensators: two shafts that turn against each other, and those of the couple, to scale (компенсатор).

Each mass at phi = 0; the circles of the gears are drawn as large as the masses ask, the shafts so far below the crank.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass

from drawings.figures.bank.compensator_layout import SHARE, UNDER, Layout, Weight, speed
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.place import Place
from drawings.lettering.bank_letters import lowered
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, LineStyle, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.dashes import fit
from drawings.symbols.dimension import Dimension
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.symbols import HINGE, POINT, hinge, turning_arrow

SYMBOL, UNIT, QUANTITY = "l", "m", "r"
MARGINS = Margins(4.6, 5.0, 3.0)  # paper around it for letters, in their sizes
LETTERS, MOST = 14.0, 36.4  # it is drawn at least so many letters large, and at most
BODY = 2.4  # mm, radius of a mass
BESIDE = 1.0  # mm from a mass to its letter
OFF = 7.0  # mm from what is dimensioned to its line
TURN = (math.radians(200), math.radians(70))  # start and sweep of the arrow on a shaft


@dataclass(frozen=True)
class LayoutFigure:
    """The layout placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: Layout
    place: Place
    lines: tuple[Stroke, ...]
    sizes: tuple[Dimension, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole layout, each mass lettered outward, each shaft with the speed at which it turns."""
        placed = (*self._masses(labels), *self._speeds(labels), *self._sizes(labels))
        return (Group((*self.lines, Group(placed)), self.shown.name),)

    def _masses(self, labels: Labels) -> Iterator[Stroke]:
        hand = self.drafting.hand
        gap = BODY * hand.symbol + BESIDE
        yield labels.beside(self.place.on(0j), "O", hand.letter, BESIDE + HINGE * hand.symbol, -math.pi / 4)
        for one in self.shown.weights():
            spot = self.place.on(one.shaft + one.arm)
            yield labels.beside(spot, lowered(one.name), hand.letter, gap, cmath.phase(one.arm))

    def _speeds(self, labels: Labels) -> Iterator[Stroke]:
        """Write on each shaft how fast it turns, against the crank with a minus."""
        middle = TURN[0] + TURN[1] / 2
        for one in self.shown.weights():
            spot = self.place.on(one.shaft) + cmath.rect(arrow_radius(self.shown, self.place), middle)
            yield labels.beside(spot, speed(one.turns), self.drafting.hand.number, BESIDE, middle)

    def _sizes(self, labels: Labels) -> Iterator[Stroke]:
        for one in self.sizes:
            side = cmath.phase(one.off)
            yield labels.along(*one.lines[0], one.letter, self.drafting.hand.number, BESIDE, side)


def arrow_radius(shown: Layout, place: Place) -> float:
    """Give the radius of the arrow on a shaft, mm."""
    return 0.55 * place.length(shown.gear)


def measure(shown: Layout, drafting: Drafting) -> Picture:
    """Measure the room that the layout needs."""
    hand = drafting.hand
    title = text_width(Text(0j, title_of(shown, drafting), hand.title))
    side, below, above = (share * hand.letter + OFF * hand.symbol for share in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    found = picture(shown.name, list(shown.points()), (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)
    return found._replace(most=MOST * hand.letter)


def title_of(shown: Layout, drafting: Drafting) -> str:
    """Give the title of a layout."""
    if shown.found.on_crank:
        return drafting.word("counterweight on crank")
    return drafting.word("compensator of order", order=shown.found.asked.order)


def draw(shown: Layout, sense: float, room: Picture, spot: Spot, drafting: Drafting) -> LayoutFigure:
    """Draw the layout in its spot: guide and line of the compensators, gears, shafts, masses, sizes."""
    place, hand = room.place(*spot), drafting.hand
    under = drafting.scale(spot.scale) + ("" if shown.known else f";  {drafting.word('arms nominal')}")
    title = heading(spot.box, title_of(shown, drafting), under, hand)
    sizes = tuple(_sizes(shown, place, drafting))
    lines: list[Stroke] = [title, *_axes(shown, place, hand)]
    lines += [stroke for one in shown.weights() for stroke in _gear(shown, one, place, hand, sense)]
    lines += [_mass(shown, one, place, hand) for one in shown.weights()]
    lines += [stroke for one in sizes for stroke in one.draw(hand)]
    (circle,) = hinge(place.on(0j), hand)
    lines.append(point(Subject(shown.name, QUANTITY, None), "O", 0j, place, circle, "pole"))
    return LayoutFigure(shown, place, tuple(lines), sizes, drafting)


def _axes(shown: Layout, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the line of the force through the shaft of the crank, and that of the compensators beside it."""
    far = place.length((1 if shown.found.on_crank else 2 + UNDER) * shown.gear) * shown.line
    up = (HINGE + 4) * hand.symbol * shown.line
    offset = place.on(shown.offset * shown.across)
    for start in [place.on(0j)] + ([offset] if abs(offset - place.on(0j)) > POINT else []):
        yield Line(start - far, start + up, fit(hand.axis, abs(far) + abs(up)))


def _gear(shown: Layout, one: Weight, place: Place, hand: Hand, sense: float) -> Iterator[Stroke]:
    """Draw a shaft with its gear and the sense in which it turns; the couple's shafts have no gears of their own."""
    centre, (start, sweep), own = place.on(one.shaft), TURN, math.copysign(1.0, one.turns * sense)
    if one.geared and not shown.found.on_crank:
        radius = place.length(shown.gear)
        yield Circle(centre, radius, fit(hand.axis, math.tau * radius, True))
    begin = start if own > 0 else start + sweep
    yield from turning_arrow(centre, arrow_radius(shown, place), begin, own * sweep, hand)
    yield Circle(centre, POINT * hand.symbol, LineStyle(hand.main, fill="#ffffff"))


def _mass(shown: Layout, one: Weight, place: Place, hand: Hand) -> Group:
    """Draw a mass on its arm; it can be measured where its radius is known."""
    known = shown.known and one.geared
    ends = place.on(one.shaft), place.on(one.shaft + one.arm)
    dashed = fit(hand.result._replace(dash=hand.dashed), abs(ends[1] - ends[0]))
    way = Kind.VECTOR, shown.name, one.name, None, place.scale.mu
    line = Line(*ends, hand.result if known else dashed)
    arm: Stroke = stating(Statement(*way), line) if known else line
    circle, subject = Circle(ends[1], BODY * hand.symbol, INK), Subject(shown.name, QUANTITY, None)
    if not known:
        return Group((arm, Group((circle,), "", {}, one.name)))
    body = point(subject, one.name, one.shaft + one.arm, place, circle)
    return Group((arm, body._replace(title=lowered(one.name))))


def _sizes(shown: Layout, place: Place, drafting: Drafting) -> Iterator[Dimension]:
    """Dimension the offset of the compensators' line, and the distance of the couple's shafts."""
    asked, off = shown.found.asked, OFF * drafting.hand.symbol
    if shown.offset:
        up = (off + HINGE * drafting.hand.symbol) * shown.line
        text = f"z = {drafting.number(1000 * shown.offset)}"
        yield Dimension(text, place.on(0j), place.on(shown.offset * shown.across), up)
    shafts = [place.on(one.shaft) for one in shown.weights() if not one.geared]
    if shafts and asked.shafts:
        aside = -(place.length(SHARE * shown.gear) + off) * shown.across
        first, last = shafts
        yield Dimension(f"L = {drafting.number(1000 * asked.shafts)}", first, last, aside)
