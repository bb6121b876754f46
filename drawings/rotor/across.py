"""The view across the shaft of a rotor: bearings, planes of masses and of correction, arms (вид сбоку)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from drawings.kinds import view
from drawings.kinds.view import BESIDE, FIRST, SHAFT, Sized
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.rotor_letters import index
from drawings.lettering.words import Slot, joined
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Kind, Line, Statement, Stroke, Text
from drawings.rotor.along import BODY, body
from drawings.rotor.polygon import RotorView, ShownBody, letters_of
from drawings.symbols.figure import around, heading
from drawings.symbols.symbols import fit, ground, pole
from plans.rotor.study import BEARINGS
from plans.words.words import ALONE

NAME = "across"
MARGINS = Margins(4.6, 1.6, 2.6)  # paper around it for letters, in their sizes
LETTERS = 24.0  # it is drawn at least so many letters large
SHELL = (9.0, 0.9)  # mm, length of a bearing's shell, and from the shaft to it
ABOVE = 5.0  # mm that a plane of correction goes past the outermost mass


def measure(shown: RotorView, drafting: Drafting) -> Picture:
    """Measure the room that the view needs: the rotor, its ends, and the dimensions under it."""
    hand, levels = drafting.hand, len(_arms(shown))
    title = text_width(Text(0j, drafting.word("view across"), hand.title))
    under = FIRST * hand.symbol + levels * view.step(hand)
    over = ABOVE * hand.symbol + len(_bearings(shown)) * view.step(hand)
    margins = around(MARGINS, hand, view.END * hand.symbol, under, over)
    corners = [complex(x, y) for x in (min(shown.places), max(shown.places)) for y in (-shown.reach, shown.reach)]
    return picture(NAME, corners, (view.SYMBOL, view.UNIT), margins, title, LETTERS * hand.letter)


def draw(shown: RotorView, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the view in its spot: shaft, bearings, planes of correction, masses, and the arms dimensioned."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, drafting.word("view across"), drafting.scale(spot.scale), hand)
    lines = [*_shaft(shown, place, hand), *_shells(shown, place, hand), *_planes(shown, place, hand)]
    lines += [_stem(mass, place, hand) for mass in shown.distinct]
    bodies = [body(shown, mass, _side(mass), place, NAME, drafting) for mass in shown.bodies]
    arms = _dimensions(shown, place, drafting)
    base = complex(shown.planes[-1][1])
    zero = view.origin(NAME, base, place, pole(place.on(base)))
    return LetteredFigure(NAME, (title, *lines, *arms, zero, *bodies), partial(_letters, shown, place, drafting))


def _letters(shown: RotorView, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Letter masses, planes of correction and bearings."""
    hand, lettering = drafting.hand, letters_of(drafting)
    for mass in shown.distinct:
        text, size = lettering.of(mass.mark, len(shown.bodies), hand)
        up = 1.2 if mass.centre.imag >= 0 else -1.2
        yield labels.beside(place.on(_side(mass)), text, size, BODY * hand.symbol + BESIDE, up)
    base = place.on(complex(shown.planes[-1][1]))
    yield labels.beside(base, view.ORIGIN, hand.letter, BESIDE + SHAFT * hand.symbol, 2.4)
    for name, where in shown.planes:
        if name != ALONE:
            top = place.on(complex(where)) + 1j * _half(shown, place, hand)
            yield labels.beside(top, name, hand.letter, BESIDE, 1.5)
    for name, where in zip(BEARINGS, shown.bearings, strict=False):
        low = place.on(complex(where)) - 1j * (SHAFT + SHELL[1] + 3.0) * hand.symbol
        yield labels.beside(low, name, hand.letter, BESIDE, -1.5)


def _side(mass: ShownBody) -> complex:
    """Give where a body is seen: its place along the shaft, and its height over the axis, m."""
    return complex(mass.place, mass.centre.imag)


def _half(shown: RotorView, place: Place, hand: Hand) -> float:
    """Give half the height of a plane of correction on paper, mm."""
    return place.length(shown.reach) + ABOVE * hand.symbol


def _shaft(shown: RotorView, place: Place, hand: Hand) -> Iterator[Stroke]:
    start, stop, axis = view.shaft(shown.places, place, hand)
    rim = 1j * SHAFT * hand.symbol
    yield axis
    for side in (rim, -rim):
        yield Line(start + side, stop + side, hand.result)
    for end in (start, stop):
        yield Line(end + rim, end - rim, hand.result)


def _shells(shown: RotorView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw a bearing: a fixed line over the shaft and one under it (подшипник)."""
    length, gap = (share * hand.symbol for share in SHELL)
    for where in shown.bearings:
        for side in (1j, -1j):
            middle = place.on(complex(where)) + side * (SHAFT * hand.symbol + gap)
            yield from ground(middle - length / 2, middle + length / 2, side, hand)


def _planes(shown: RotorView, place: Place, hand: Hand) -> Iterator[Stroke]:
    half = 1j * _half(shown, place, hand)
    for _, where in shown.planes:
        spot = place.on(complex(where))
        yield Line(spot - half, spot + half, fit(hand.extreme, 2 * abs(half)))


def _stem(mass: ShownBody, place: Place, hand: Hand) -> Stroke:
    style = hand.result if mass.added else hand.other
    return Line(place.on(complex(mass.place)), place.on(_side(mass)), style)


def _arms(shown: RotorView) -> dict[float, list[ShownBody]]:
    """Give the different arms from the last plane with the bodies that have them, the shortest first."""
    found: dict[float, list[ShownBody]] = {}
    for mass in shown.bodies:
        if mass.arm and not (mass.added and mass.name == shown.planes[-1][0]):
            found.setdefault(mass.arm, []).append(mass)
    return dict(sorted(found.items(), key=lambda pair: abs(pair[0]))) if len(found) <= view.MOST else {}


def _bearings(shown: RotorView) -> dict[str, float]:
    """Give the places of the bearings that do not stand in the last plane, the nearest first, m."""
    base = shown.planes[-1][1]
    found = [pair for pair in zip(BEARINGS, shown.bearings, strict=False) if pair[1] != base]
    return dict(sorted(found, key=lambda pair: abs(pair[1] - base)))


def _dimensions(shown: RotorView, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Dimension arms under the view and bearings over it, from the last plane; millimetres of the machine."""
    hand, arms, bearings = drafting.hand, list[Sized](), list[Sized]()
    zero, half = shown.planes[-1][1], 1j * _half(shown, place, hand)
    base = place.on(complex(zero))
    for arm, row in _arms(shown).items():
        names = " = ".join(f"h_{{{index(mass.name, drafting.language)}}}" for mass in row)
        arms.append(_sized(place.on(_side(row[0])), names, Slot(f"h_{row[0].name}", 1000 * abs(arm)), place, drafting))
    for name, where in _bearings(shown).items():
        foot = place.on(complex(where)) + 1j * (SHAFT + SHELL[1]) * hand.symbol
        size = Slot(f"bearing {name}", 1000 * abs(where - zero))
        bearings.append(_sized(foot, f"h_{name}", size, place, drafting))
    past = place.length(shown.reach) + FIRST * hand.symbol
    yield from view.dimensions(base - half, base.imag - past, arms, hand)
    yield from view.dimensions(base + half, base.imag + past, bearings, hand, side=1)


def _sized(spot: complex, names: str, size: Slot, place: Place, drafting: Drafting) -> Sized:
    """Give a place with what its dimension says and states."""
    states = Statement(Kind.LENGTH, NAME, size.quantity, scale=place.scale.mu)
    return spot, joined(" = ", (names, drafting.slot(size))), states
