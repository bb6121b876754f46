"""The view across the shaft of a bank to scale: places, cranks at phi = 0 as they are seen from there (вид сбоку)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from itertools import pairwise

from drawings.bank.star import NEAR, BankView
from drawings.kinds import view
from drawings.kinds.view import BESIDE, FIRST, SHAFT, Sized
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.words import Phrase, Slot, joined
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Kind, Line, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.figure import Subject, around, heading, point
from drawings.symbols.symbols import ARROW_LENGTH, fit, pole
from plans.model.balance.bank import Member

NAME = "shaft"
QUANTITY = "h"
MARGINS = Margins(4.6, 1.6, 2.6)  # paper around it for letters, in their sizes
LETTERS, LONGEST = 20.0, 80.0  # it is drawn at least so many letters long, and at most
RANGE = 2.6  # standard scales are up to 2.5 times apart: one of them fits between the least length and the most
WEB = 2.2  # mm, half the breadth of a crank
PIN = 1.0  # mm, radius of a pin that points to the eye
GUIDE = 6.0  # mm that the axis of a guide goes past the cranks
VIEWS = "views"  # the star and this view have one scale


def _letters(shown: BankView, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Number each mechanism at its place, letter the plane of place 0."""
    hand, gap = drafting.hand, BESIDE + SHAFT * drafting.hand.symbol
    for where, names in named(shown).items():
        yield labels.beside(place.on(complex(where)), names, hand.letter, gap, math.pi / 4)
    yield labels.beside(place.on(0j), view.ORIGIN, hand.letter, gap, -3 * math.pi / 4)


def named(shown: BankView) -> dict[float, str]:
    """Name the mechanisms at one place together, in their order."""
    found: dict[float, str] = {}
    for member in shown.members:
        place = float(member.place)
        found[place] = f"{found[place]}, {member.name}" if place in found else member.name
    return found


def measure(shown: BankView, drafting: Drafting) -> Picture:
    """Measure the room that the view needs: the shaft, its ends, the cranks, the dimensions under it."""
    hand, levels = drafting.hand, len(_dimensioned(shown))
    title = text_width(Text(0j, drafting.word("view across"), hand.title))
    high, (up, down) = GUIDE * hand.symbol, tall(shown)
    under = high + FIRST * hand.symbol + levels * view.step(hand)
    margins = around(MARGINS, hand, view.END * hand.symbol, under, high)
    spots = [complex(place, side) for place in (0.0, *named(shown)) for side in (up, -down)]
    least = max(LETTERS * hand.letter, min(_roomy(shown, drafting), LONGEST * hand.letter / RANGE))
    return picture(NAME, spots, (view.SYMBOL, view.UNIT), margins, title, least)._replace(most=LONGEST * hand.letter)


def draw(shown: BankView, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the view in its spot: the shaft, the axes of the guides, the cranks, the places dimensioned."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, drafting.word("view across"), drafting.scale(spot.scale), hand)
    lines = [title, *_shaft(shown, place, hand), *_datum(shown, place, hand)]
    for member in shown.members:
        far = (place.length(shown.crank) + GUIDE * hand.symbol) * (-1 if _under(shown, member) else 1)
        middle = place.on(complex(float(member.place)))
        lines += [Line(middle, middle + 1j * far, fit(hand.axis, abs(far))), *_throw(shown, member, place, hand)]
    lines += _dimensions(shown, place, drafting)
    subject = Subject(NAME, QUANTITY, None)
    lines.append(view.origin(NAME, 0j, place, pole(place.on(0j)), QUANTITY))
    lines += [_mark(subject, member, place, hand) for member in shown.members]
    return LetteredFigure(NAME, tuple(lines), partial(_letters, shown, place, drafting))


def _mark(subject: Subject, member: Member, place: Place, hand: Hand) -> Group:
    """Mark the place of a mechanism on the axis of the shaft; it can be measured."""
    spot = complex(float(member.place))
    return point(subject, member.name, spot, place, Circle(place.on(spot), 0.6 * hand.symbol, INK))


def _shaft(shown: BankView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the axis, and the shaft between the cranks."""
    start, stop, axis = view.shaft([0.0, *named(shown)], place, hand)
    yield axis
    webs = sorted(place.on(complex(where)).real for where in named(shown))
    edges = [start.real, *(x + side * WEB * hand.symbol for x in webs for side in (-1, 1)), stop.real]
    for left, right in zip(edges[::2], edges[1::2], strict=True):
        if right > left:
            yield Line(complex(left, start.imag), complex(right, start.imag), hand.result)


def tall(shown: BankView) -> tuple[float, float]:
    """Give how far cranks, and guides that go past them, reach over the shaft and under it, m."""
    down = any(outlook(shown, shown.crank_at(member)) < 0 or _under(shown, member) for member in shown.members)
    return shown.crank, shown.crank if down else 0.0


def _under(shown: BankView, member: Member) -> bool:
    """Tell whether the axis of a guide goes down from the shaft."""
    return outlook(shown, shown.guide_at(member)) < -NEAR


def _datum(shown: BankView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the plane of place 0."""
    up, down = (place.on(1j * end) for end in (tall(shown)[0], -tall(shown)[1]))
    past = 1j * GUIDE * hand.symbol
    yield Line(down - past, up + past, fit(hand.extreme, abs(up - down) + 2 * abs(past)))


def outlook(shown: BankView, way: complex) -> float:
    """Give how much of a direction is seen across: its share along the reference guide."""
    return (way * shown.turn.conjugate()).real


def _throw(shown: BankView, member: Member, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw a crank between its webs, to scale, or its pin alone where it points to the eye."""
    middle, half = place.on(complex(float(member.place))), WEB * hand.symbol
    high = 1j * place.length(shown.crank) * outlook(shown, shown.crank_at(member))
    if abs(high) <= NEAR:
        yield Circle(middle, PIN * hand.symbol, hand.body)
        return
    corners = (middle - half, middle - half + high, middle + half + high, middle + half)
    states = Statement(Kind.LENGTH, NAME, f"r {member.name}", scale=place.scale.mu)
    yield stating(states, *(Line(corner, other, hand.result) for corner, other in pairwise(corners)))


def _dimensioned(shown: BankView) -> dict[float, str]:
    """Give the places that are dimensioned, the nearest to the plane of place 0 first."""
    found = {place: names for place, names in named(shown).items() if place}
    return dict(sorted(found.items(), key=lambda pair: abs(pair[0]))) if len(found) <= view.MOST else {}


def _texts(shown: BankView, drafting: Drafting) -> dict[float, Phrase]:
    """Write the dimensions of the places, the nearest to the plane of place 0 first."""
    sizes = {where: drafting.slot(Slot(_quantity(where), abs(1000 * where))) for where in _dimensioned(shown)}
    return {where: joined("", (f"h_{{{names}}} = ", sizes[where])) for where, names in _dimensioned(shown).items()}


def _quantity(where: float) -> str:
    """Name the place of a mechanism by its millimetres."""
    return f"h at {1000 * where:g}"


def _roomy(shown: BankView, drafting: Drafting) -> float:
    """Give how long the view must be drawn for all dimensions to have room, mm."""
    places, hand = [0.0, *named(shown)], drafting.hand
    span = max(places) - min(places)
    return max((span / abs(where) * needs(text, hand) for where, text in _texts(shown, drafting).items()), default=0.0)


def needs(text: str, hand: Hand) -> float:
    """Give the length of a dimension line that a text has room over, half of each arrowhead beside it, mm."""
    return view.room_for(text, hand) + ARROW_LENGTH * hand.symbol


def _dimensions(shown: BankView, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Dimension the places from the plane of place 0, the farthest lowest; one too short the notes tell."""
    hand, base = drafting.hand, place.on(0j)
    sizes = list[Sized]()
    for where, text in _texts(shown, drafting).items():
        if place.length(abs(where)) < needs(text, hand):
            continue
        states = Statement(Kind.LENGTH, NAME, _quantity(where), scale=place.scale.mu)
        sizes.append((complex(place.on(complex(where)).real, base.imag), text, states))
    first = base.imag - place.length(tall(shown)[1]) - (GUIDE + FIRST) * hand.symbol
    yield from view.dimensions(base, first, sizes, hand)
