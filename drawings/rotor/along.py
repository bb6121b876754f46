"""The view along the shaft of a rotor: masses and counterweights at their radii and angles (вид вдоль вала)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import partial

from drawings.kinds.polygon import FEW
from drawings.kinds.view import AXIS, BESIDE, ORIGIN, QUANTITY, SYMBOL, UNIT, origin, square
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Kind, Line, LineStyle, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.rotor.polygon import RotorView, ShownBody, letters_of
from drawings.symbols.figure import Subject, around, heading, point
from drawings.symbols.symbols import HINGE, fit, hinge, rotation

NAME = "along"
MARGINS = Margins(4.0, 3.4, 3.4)  # paper around it for letters, in their sizes
LETTERS, EACH = 14.0, 1.5  # it is drawn at least so many letters large, and so many for each mass
BODY = 2.4  # mm, radius of a mass
DOT = 0.6  # mm, radius of one of many masses
TURN = (9.0, math.radians(25), math.radians(80))  # radius mm, start and sweep of the arrow that shows the turning


def measure(shown: RotorView, drafting: Drafting) -> Picture:
    """Measure the room that the view needs: a circle about the axis."""
    hand = drafting.hand
    title = text_width(Text(0j, drafting.word("view along"), hand.title))
    least = hand.letter * max(LETTERS, EACH * min(len(shown.bodies), FEW))
    return picture(NAME, square(shown.reach), (SYMBOL, UNIT), around(MARGINS, hand), title, least)


def draw(shown: RotorView, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the view in its spot: axes, shaft, the lines to the masses, the masses."""
    place, hand = room.place(*spot), drafting.hand
    under = drafting.scale(spot.scale) if shown.scaled else drafting.word("angles alone")
    title = heading(spot.box, drafting.word("view along"), under, hand)
    half = place.length(shown.reach) + AXIS * hand.symbol
    centre, style = place.on(0j), fit(hand.axis, 2 * half)
    arrow = rotation(place.on(0j), shown.turning, TURN, hand).draw(hand)
    lines: list[Stroke] = [Line(centre - along * half, centre + along * half, style) for along in (1, 1j)]
    lines += [stating(Statement(Kind.DIRECTION, NAME, "ω"), *arrow)] if shown.turning else []
    lines += [_spoke(mass, place, hand) for mass in shown.distinct]
    bodies = (body(shown, mass, mass.centre, place, NAME, drafting) for mass in shown.bodies)
    (circle,) = hinge(place.on(0j), hand)
    axis = origin(NAME, 0j, place, circle)
    return LetteredFigure(NAME, (title, *lines, axis, *bodies), partial(_letters, shown, place, drafting))


def _letters(shown: RotorView, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Letter each mass outward, the axis, the direction from which angles are counted, and the sense of turning."""
    hand, lettering = drafting.hand, letters_of(drafting)
    for mass in shown.distinct:
        text, size = lettering.of(mass.mark, len(shown.bodies), hand)
        gap = BODY * hand.symbol + BESIDE
        yield labels.beside(place.on(mass.centre), text, size, gap, cmath.phase(mass.centre))
    end = place.length(shown.reach) + AXIS * hand.symbol
    yield labels.beside(place.on(0j), ORIGIN, hand.letter, BESIDE + HINGE * hand.symbol, -math.pi / 4)
    yield labels.beside(place.on(0j) + end, "φ = 0", hand.number, BESIDE, math.pi / 2)
    if shown.turning:
        spot, away = rotation(place.on(0j), shown.turning, TURN, hand).middle
        yield labels.beside(spot, "ω", hand.letter, BESIDE, away)


def _spoke(mass: ShownBody, place: Place, hand: Hand) -> Stroke:
    """Draw the line from the axis to a mass: a result in a main line, dashed where only its angle is known."""
    style = hand.result if mass.added else hand.other
    ends = place.on(0j), place.on(mass.centre)
    return Line(*ends, style if mass.known else fit(style._replace(dash=hand.dashed), abs(ends[1] - ends[0])))


def body(shown: RotorView, mass: ShownBody, centre: complex, place: Place, plan: str, drafting: Drafting) -> Group:
    """Draw a mass as a circle, a counterweight as a black one; measurable where its radius is known."""
    hand, many = drafting.hand, mass not in shown.distinct
    style = INK if mass.added or many else LineStyle(hand.main, fill="#ffffff")
    circle = Circle(place.on(centre), (DOT if many else BODY) * hand.symbol, style)
    if many or not mass.known:  # too many masses bear no letters; the table has them
        return Group((circle,), "", {}, mass.mark)
    drawn = point(Subject(plan, QUANTITY, None), mass.mark, centre, place, circle)
    return drawn._replace(title=letters_of(drafting).of(mass.mark, len(shown.bodies), hand)[0])
