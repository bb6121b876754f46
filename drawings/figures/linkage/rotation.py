"""The sense of the crank's rotation and its angular acceleration: arrows about its pivot (направление вращения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from drawings.figures.linkage.pairs import Pairs
from drawings.layout.ink import Ink
from drawings.paper.strokes import Arc, Line, Stroke
from drawings.symbols.symbols import turning_arrow

SWEEP = math.radians(65)
RAYS = 12  # across an arrow's own field
STARTS = 18  # directions in which an arrow may begin
INNER, OUTER = 10.0, 14.0  # mm: radii of an arrow inside a crank circle that has room for one
NUMBERS = 9.0  # mm outside the crank circle that its numbers take
RIM = 4.0  # mm that an arrow keeps from the crank circle
BESIDE = 1.6  # mm that an arrow keeps from a line beside it
LETTER = 0.25  # rad of free arc that an arrow keeps from the bars of the shown position on either side
THICK = 12.0  # thin lines that a bar or a symbol of the shown position counts as
APART = 0.02  # what each degree away from the crank costs: the arrow is looked for ahead of it


class Turning(NamedTuple):
    """An arrow about the crank's pivot, with the letter of what it shows."""

    letter: str
    centre: complex
    radius: float
    start: float
    sweep: float

    @property
    def middle(self) -> tuple[complex, float]:
        """The middle of the arrow, and the direction away from the pivot there."""
        turn = self.start + self.sweep / 2
        return self.centre + cmath.rect(self.radius, turn), turn

    @property
    def field(self) -> list[Stroke]:
        """Rays across the arrow and the place of its letter: no other arrow stands there."""
        turns = [self.start + self.sweep * k / RAYS for k in range(RAYS + 1)]
        return [Line(self.centre, self.centre + cmath.rect(self.radius + OUTER, turn)) for turn in turns]

    @property
    def room(self) -> list[Stroke]:
        """Arcs within, along and outside the arrow, a little longer than it is: what they cross comes too near."""
        low, high = sorted((self.start, self.start + self.sweep))
        radii = (self.radius - BESIDE, self.radius, self.radius + BESIDE)
        return [Arc(self.centre, radius, low - LETTER, high + LETTER) for radius in radii]

    def strokes(self, pairs: Pairs) -> tuple[Stroke, ...]:
        """Draw it."""
        return turning_arrow(self.centre, self.radius, self.start, self.sweep, pairs.hand)


@lru_cache(maxsize=1)  # the figure draws the arrows, and later its letters stand beside them
def turnings(pairs: Pairs) -> tuple[Turning, ...]:
    """Place the arrow of ω where it crosses the fewest lines, and beside it that of ε, of each that is not zero."""
    bones, drive = pairs.bones, pairs.bones.mechanism.drive
    ink = Ink()
    ink.draw([*pairs.bars(), *pairs.stands(), *(block for _, block in pairs.blocks)], THICK)
    ink.draw(circle for circles in pairs.hinges.values() for circle in circles)
    arrows = list[Turning]()
    for symbol, rate in zip("ωε", bones.study.rates.at(bones.shown), strict=True):
        if rate:  # at rest at the end of a stroke there is no ω
            arrows.append(_best(f"{symbol}_{drive.link}", int(math.copysign(1, rate)), pairs, ink))
            ink.draw(arrows[-1].field, THICK)
    return tuple(arrows)


def _best(letter: str, sense: int, pairs: Pairs, ink: Ink) -> Turning:
    bones, place = pairs.bones, pairs.place
    crank = cmath.phase(place.on(bones.drive_end(bones.shown)) - bones.pivot(place))

    def cost(turning: Turning) -> float:
        away = abs(cmath.phase(cmath.rect(1.0, turning.start + turning.sweep / 2 - crank - 0.8 * sense)))
        return ink.crossed_by(turning.room) + APART * math.degrees(away)

    return min(_candidates(letter, sense, pairs), key=cost)


def _candidates(letter: str, sense: int, pairs: Pairs) -> Iterator[Turning]:
    centre, factor = pairs.bones.pivot(pairs.place), pairs.hand.symbol
    for radius in _radii(pairs.bones.crank(pairs.place), factor):
        for k in range(STARTS):
            yield Turning(letter, centre, radius, 2 * math.pi * k / STARTS, sense * SWEEP)


def _radii(crank: float, factor: float) -> list[float]:
    """Give the radii of an arrow: inside the crank circle where it has room, else outside its numbers."""
    inside = [radius * factor for radius in (INNER, OUTER) if radius * factor <= crank - RIM]
    return inside or [crank + NUMBERS]
