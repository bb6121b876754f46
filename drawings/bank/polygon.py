"""The figure of a polygon of an order: harmonic forces of the members end to end, or their moments (многоугольник)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from drawings.bank.star import RESULT, SIDE, ShownOrder
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.vector_letters import lowered_bank
from drawings.page.scale import Drafting, Scale
from drawings.paper.limits import SEEN
from drawings.paper.strokes import LEAN, Group, Stroke, Text
from drawings.paper.walk import tied
from drawings.rotor.polygon import CROWD, FEW
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.polygon import LaidVector, ShownVector, carriers, ends, lay, letters, margins
from drawings.symbols.symbols import pole
from plans.bank.harmonics import FORCE, MOMENT


def letter(name: str, count: int) -> str:
    """Letter one of so many vectors: with its letters, or of many by the number of its member alone.

    >>> letter("F_II,3", 4), letter("F_II,3", 12), letter("F_II", 12)
    ('F_{II,3}', '3', 'F_{II}')
    """
    number = name.partition(",")[2]
    return number if count > FEW and number else lowered_bank(name)


def size(text: str, drafting: Drafting) -> float:
    """Give the size of a letter, mm: numbers alone are smaller."""
    return drafting.hand.number if text.isdigit() else drafting.hand.letter


NAMES = {FORCE: "order_forces", MOMENT: "order_moments"}  # of the polygons, before the order
BACK = "back"  # after the order of what turns against the crank
UNITS = {FORCE: "N", MOMENT: "N*m"}  # of the scales
MARGINS = Margins(4.0, 2.4, 2.4)  # paper around a polygon for its letters, in their sizes
LETTERS, EACH = 9.0, 1.4  # a polygon is drawn at least so many letters large, and so many for each of its vectors
RANGE = 2.6  # and at most so many times that: standard scales are up to 2.5 times apart
WIDEST = 0.00025  # a scale as long as one is written
ROOM = 5.2 + 1.9j  # width + 1j * height of a letter between two lanes, in its sizes, with what it keeps clear of them


def plan_of(kind: str, signed: int) -> str:
    """Name the figure of a polygon.

    >>> plan_of(MOMENT, -2)
    'order_moments-2-back'
    """
    name = f"{NAMES[kind]}-{abs(signed)}"
    return name if signed > 0 else f"{name}-{BACK}"


def told_apart(shown: ShownOrder) -> ShownOrder:
    """Draw one vector, the sum, for all members that are too many to be told apart."""
    if len(shown.vectors) <= CROWD + 1:
        return shown
    return shown._replace(vectors=tuple(one for one in shown.vectors if one.kind == RESULT))


@dataclass(frozen=True)
class BankPolygonFigure:
    """A polygon placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: ShownOrder
    place: Place
    lines: tuple[Stroke, ...]
    arrows: tuple[LaidVector, ...]  # those that are lettered
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure with the letter of each vector beside it, the shortest served first."""
        zero = labels.beside(self.place.on(0j), "0", self.drafting.hand.letter, 1.6, -math.pi / 4)
        beside = letters(self.arrows, self._mark, labels)
        return (Group((*self.lines, Group((zero, *beside))), plan_of(self.shown.kind, self.shown.signed)),)

    def _mark(self, name: str) -> tuple[str, float]:
        text = letter(name, len(self.shown.vectors))
        return text, size(text, self.drafting)


def measure(shown: ShownOrder, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs: its points, letters around them, lanes beside a flat one, its heading."""
    hand = drafting.hand
    title = text_width(Text(0j, title_of(shown, drafting), hand.title)) + 2 * LEAN * hand.title
    under = text_width(Text(0j, _under(shown, Scale(WIDEST, shown.kind, UNITS[shown.kind]), drafting), hand.text))
    least = hand.letter * max(LETTERS, EACH * min(len(shown.vectors), FEW))
    around = margins(shown.points, MARGINS, hand)
    subject = shown.kind, UNITS[shown.kind]
    found = picture(plan_of(shown.kind, shown.signed), shown.points, subject, around, max(title, under), least)
    return found._replace(most=RANGE * least)


def draw(shown: ShownOrder, room: Picture, spot: Spot, drafting: Drafting) -> BankPolygonFigure:
    """Draw the polygon in its spot: the sum in a main line, the others thinner, title and scale above."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, title_of(shown, drafting), _under(shown, spot.scale, drafting), hand)
    subject = Subject(plan_of(shown.kind, shown.signed), shown.kind, None)
    zero = point(subject, "0", 0j, place, pole(place.on(0j)), "pole")
    order = sorted(shown.vectors, key=lambda one: (one.kind != RESULT, -tied(place.length(abs(one.value)))))
    seen = [one for one in order if tied(place.length(abs(one.value))) >= SEEN]
    arrows = lay(seen, place, spot.box, ROOM, hand)
    short = (LaidVector(one, ends(one, place)) for one in order if one not in seen)
    thin = carriers(arrows, place, hand)
    sides = (_side(subject, shown.vectors, one, place, drafting) for one in (*reversed(arrows), *short))
    return BankPolygonFigure(shown, place, (title, *thin, *sides, zero), arrows, drafting)


def _side(subject: Subject, vectors: Sequence[ShownVector], one: LaidVector, place: Place, drafting: Drafting) -> Group:
    hand = drafting.hand
    style = hand.relative if one.vector.kind == SIDE else hand.result
    return one.draw(subject, letter(one.vector.name, len(vectors)), place, style, hand.symbol)


def title_of(shown: ShownOrder, drafting: Drafting) -> str:
    """Give the title of a polygon: what it is of, which order, which sense."""
    name = "moments of order" if shown.kind == MOMENT else "forces of order"
    return drafting.word(name if shown.signed > 0 else f"{name} back", order=abs(shown.signed))


def _under(shown: ShownOrder, scale: Scale, drafting: Drafting) -> str:
    """Write the scale; of a polygon that closes by itself that it does, and what is too short to bear a letter."""
    parts = [drafting.scale(scale)]
    parts += [drafting.word("closes by itself")] if shown.closed else []
    faint = ", ".join(lowered_bank(one.name) for one in shown.vectors if abs(one.value) < SEEN * scale.mu)
    parts += [drafting.word("unlettered", names=faint)] if faint else []
    return ";  ".join(parts)
