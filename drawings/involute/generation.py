"""A tooth as the rack cuts it: the rack's positions as the wheel sees them, and their envelope (огибание)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.involute.mesh import ANGLE, BESIDE, DOT, SYMBOL, UNIT, drawn
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.words import Slot, joined, telling, with_index
from drawings.page.page import Drafting
from drawings.paper.strokes import INK, Circle, Kind, Line, Statement, Stroke
from drawings.paper.walk import stating
from drawings.symbols.figure import Dimension, Subject, around, heading, heading_width, point
from drawings.symbols.symbols import ARROW_LENGTH, TurnArrow, fit_dashes
from plans.involute.study import InvoluteStudy
from plans.model.involute import GearWheel
from plans.model.motion import Complexes
from plans.model.teeth import placed, racked

NAME, TOOTH = "generation", "tooth"
MARGINS = Margins(4.5, 2.0, 2.0)
LETTERS = 20.0  # it is drawn at least so many letters wide
LARGEST = 1.5  # of the shift on paper, in arrows: less is not dimensioned
WITHIN, BEYOND = 0.36, 2.0  # of a tooth's thickness: the radius of the angle at most; else so many modules


class ShownGeneration(NamedTuple):
    """A tooth with the positions of its rack, m about P_0."""

    wheel: GearWheel
    curves: Mapping[str, Complexes]  # circles, the rack's flanks, the tooth

    @property
    def reach(self) -> float:
        """Half of a rack's pitch, and a little more: how far its lines go to either side of P_0, m."""
        return 0.75 * self.wheel.rack.pitch


def shown(study: InvoluteStudy) -> ShownGeneration:
    """Give what is drawn of the generation of wheel 1."""
    one, wheel = placed(study.pair, study.sizes)[0], study.pair.wheels[0]
    tooth = {TOOTH: one.tooth(study.profile(study.flanks[0]))}
    return ShownGeneration(wheel, circles(wheel) | racked(wheel.rack, wheel.shift, wheel.radius) | tooth)


def circles(wheel: GearWheel) -> dict[str, Complexes]:
    """Give pitch and base circle of a wheel beside one tooth, m about P_0."""
    ways = 1j * np.exp(1j * np.linspace(-1, 1, 49) * math.tau / wheel.teeth * 0.75)
    return {"d_1": ways * wheel.radius - 1j * wheel.radius, "d_b1": ways * wheel.base - 1j * wheel.radius}


def measure(made: ShownGeneration, drafting: Drafting) -> Picture:
    """Measure the room that the figure needs."""
    hand = drafting.hand
    known = [complex(spot) for name, curve in made.curves.items() for spot in curve if name != TOOTH]
    title = heading_width(drafting.word("involute generation"), hand)
    return picture(NAME, known, (SYMBOL, UNIT), around(MARGINS, hand), title, LETTERS * hand.letter)


def draw(made: ShownGeneration, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw it in its spot."""
    place, hand = room.place(*spot), drafting.hand
    head = heading(spot.box, drafting.word("involute generation"), drafting.scale(spot.scale), hand)
    lines = [head, *_lines(made, place, drafting)]
    return LetteredFigure(NAME, tuple(lines), partial(_letters, made, place, drafting))


def _lines(made: ShownGeneration, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    hand = drafting.hand
    styles = {"d_1": hand.axis, "d_b1": hand.other, "0": hand.relative, "0'": hand.relative, TOOTH: hand.result}
    for name, curve in made.curves.items():
        yield drawn(NAME, name, curve, place, styles.get(name, hand.drafted))
    for level in dict.fromkeys((0.0, made.wheel.shift * made.wheel.rack.module)):
        start, end = (place.on(complex(side * made.reach, level)) for side in (-1, 1))
        yield from fit_dashes([Line(start, end, hand.axis)])
    yield from _action(made, place, drafting)
    size = _shift(made, place, drafting)
    yield from size.draw(hand) if size else ()
    yield point(Subject(NAME, SYMBOL, None), "P_0", 0j, place, Circle(place.on(0j), DOT * hand.symbol, INK), "pole")


def _action(made: ShownGeneration, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the line of action of the rack, from where it touches the base circle."""
    rack, r = made.wheel.rack, made.wheel.radius
    along = cmath.exp(1j * rack.angle)
    start, end = -r * math.sin(rack.angle) * along, rack.module * along * 2.5
    start = max(start, -4 * rack.module * along, key=lambda spot: spot.real)
    yield Line(place.on(start), place.on(end), drafting.hand.drafted)
    yield stating(Statement(Kind.ANGLE, NAME, "α"), *_angle(made, place, drafting).angle(drafting.hand))


def _angle(made: ShownGeneration, place: Place, drafting: Drafting) -> TurnArrow:
    """Give the angle of the rack at P_0: within the tooth, or beyond it where its arrows have no room there."""
    wheel, hand = made.wheel, drafting.hand
    within = min(ANGLE * hand.symbol, place.length(WITHIN * wheel.width))
    roomy = within * wheel.rack.angle > 1.5 * ARROW_LENGTH * hand.symbol
    return TurnArrow(place.on(0j), within if roomy else place.length(BEYOND * wheel.rack.module), 0.0, wheel.rack.angle)


def _shift(made: ShownGeneration, place: Place, drafting: Drafting) -> Dimension | None:
    """Dimension the shift from the pitch line to the rack's mean line, where it is long enough."""
    shift = made.wheel.shift * made.wheel.rack.module
    if place.length(abs(shift)) < LARGEST:
        return None
    start, end = (place.on(complex(-made.reach, level)) for level in (0.0, shift))
    text = joined("", ("x_{1}m = ", drafting.slot(Slot("x_1m", 1e3 * shift))))
    states = Statement(Kind.LENGTH, NAME, "x_1m", scale=place.scale.mu)
    return Dimension(text, start, end, complex(-6 * drafting.hand.symbol), states)


def _letters(made: ShownGeneration, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    hand = drafting.hand
    spot, away = _angle(made, place, drafting).middle
    yield labels.beside(spot, "α", hand.letter, BESIDE, away)
    yield labels.beside(place.on(0j), with_index("P_0"), hand.letter, BESIDE, -math.pi / 3)
    levels = {0.0: "involute pitch line", made.wheel.shift * made.wheel.rack.module: "involute mean line"}
    for level, word in levels.items():
        spot = place.on(complex(made.reach, level))
        side = math.pi / 2 if level > 0 or (level == 0 and made.wheel.shift < 0) else -math.pi / 2
        yield labels.beside(spot, drafting.word(word), hand.number, BESIDE, side)
    for name in ("d_1", "d_b1"):
        end, before = (place.on(complex(spot)) for spot in made.curves[name][:2])
        yield labels.beside(end, with_index(name), hand.number, BESIDE, cmath.phase(end - before))
    if size := _shift(made, place, drafting):
        yield telling(NAME, labels.beside(size.middle, size.letter, hand.number, BESIDE, math.pi), size.letter)
