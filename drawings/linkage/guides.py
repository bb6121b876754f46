"""Guides of the frame: the axis over the block's travel, ground beside the block, ticks (направляющие)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from drawings.layout.ink import Ink
from drawings.layout.picture import Place
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Line, Stroke
from drawings.symbols.symbols import BLOCK, TurnArrow, arrowhead, ground, tick
from drawings.symbols.trimming import trim
from plans.linkage.primary import pushed
from plans.model.mechanism import FRAME, Slide

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


class TurningArrow(NamedTuple):
    """An arrow about the crank's pivot, with the letter of what it shows."""

    letter: str
    arc: TurnArrow

    @property
    def middle(self) -> tuple[complex, float]:
        """The middle of the arrow, and the direction away from the pivot there."""
        return self.arc.middle

    @property
    def field(self) -> list[Stroke]:
        """Rays across the arrow and the place of its letter: no other arrow stands there."""
        centre, radius, start, sweep = self.arc
        turns = [start + sweep * k / RAYS for k in range(RAYS + 1)]
        return [Line(centre, centre + cmath.rect(radius + OUTER, turn)) for turn in turns]

    @property
    def room(self) -> list[Stroke]:
        """Arcs within, along and outside the arrow, a little longer than it is: what they cross comes too near."""
        centre, radius, start, sweep = self.arc
        low, high = sorted((start, start + sweep))
        return [Arc(centre, radius + off, low - LETTER, high + LETTER) for off in (-BESIDE, 0.0, BESIDE)]

    def strokes(self, pairs: Pairs) -> tuple[Stroke, ...]:
        """Draw it."""
        return self.arc.draw(pairs.hand)


@lru_cache(maxsize=1)  # the figure draws the arrows, and later its letters stand beside them
def turnings(pairs: Pairs) -> tuple[TurningArrow, ...]:
    """Place the arrow of ω where it crosses the fewest lines, and beside it that of ε, of each that is not zero."""
    ink, arrows = felt(pairs), list[TurningArrow]()
    for symbol, sense in senses("ωε", pairs.bones):
        arrows.append(_best(f"{symbol}_{pairs.bones.mechanism.drive.link}", sense, pairs, ink))
        ink.draw(arrows[-1].field, THICK)
    return tuple(arrows)


def felt(pairs: Pairs) -> Ink:
    """Ink the shown position: what an arrow keeps clear of."""
    ink = Ink()
    ink.draw([*pairs.bars(), *pairs.stands(), *(block for _, block in pairs.blocks)], THICK)
    ink.draw(circle for circles in pairs.hinges.values() for circle in circles)
    return ink


def senses(symbols: str, bones: Skeletons) -> Iterator[tuple[str, int]]:
    """Give the rates of the primary link by their symbols with their signs; at rest at the end of a stroke has none."""
    for symbol, rate in zip(symbols, bones.study.rates.at(bones.shown), strict=True):
        if rate:
            yield symbol, int(math.copysign(1, rate))


def _best(letter: str, sense: int, pairs: Pairs, ink: Ink) -> TurningArrow:
    bones, place = pairs.bones, pairs.place
    crank = cmath.phase(place.on(bones.drive_end(bones.shown)) - bones.pivot(place))

    def cost(turning: TurningArrow) -> float:
        away = abs(cmath.phase(cmath.rect(1.0, turning.middle[1] - crank - 0.8 * sense)))
        return ink.crossed_by(turning.room) + APART * math.degrees(away)

    return min(_turning_places(letter, sense, pairs), key=cost)


def _turning_places(letter: str, sense: int, pairs: Pairs) -> Iterator[TurningArrow]:
    centre, factor = pairs.bones.pivot(pairs.place), pairs.hand.symbol
    # Inside the crank circle where it has room, else outside its numbers
    crank = pairs.bones.crank(pairs.place)
    inside = [radius * factor for radius in (INNER, OUTER) if radius * factor <= crank - RIM]
    for radius in inside or [crank + NUMBERS]:
        for k in range(STARTS):
            yield TurningArrow(letter, TurnArrow(centre, radius, 2 * math.pi * k / STARTS, sense * SWEEP))


BEYOND = 16.0  # mm of a guide's axis past the block's outermost places
BASE = 28.0  # mm of ground beside a block
DOWNWARD = 0.5  # crossed lines that a ground under its block is better than one over it


def frame_slides(bones: Skeletons) -> list[Slide]:
    """Give the slides on the frame."""
    return [slide for slide in bones.mechanism.slides if slide.owner == FRAME]


def axes(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw each frame's guide: its axis over the travel, and a tick at each position."""
    lines: list[Stroke] = []
    for slide in frame_slides(bones):
        start, end = travel(bones, slide, place, hand)
        lines.append(Line(start, end, hand.axis))
        blocks = [complex(spot) for spot in bones.numbered.blocks(slide) if not math.isnan(spot.real)]
        lines += [tick(place.on(spot), slide.on_owner.direction, hand) for spot in blocks]
    return lines


def travel(bones: Skeletons, slide: Slide, place: Place, hand: Hand, beyond: float = BEYOND) -> tuple[complex, complex]:
    """Give the ends of a guide's axis on paper; a guide that no block comes to is where the scene puts it."""
    way = slide.on_owner
    low, high = bones.travels.get(slide, (0.0, 0.0))
    first, last = (place.on(way.through + along * way.direction) for along in (low, high))
    more = beyond * hand.symbol * way.direction
    return first - more, last + more


def grounds(pairs: Pairs, ink: Ink) -> list[Stroke]:
    """Draw the ground beside the shown block of each guide, on the side where fewer links are."""
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    strokes: list[Stroke] = []
    for slide in frame_slides(bones):
        start, end = travel(bones, slide, place, hand)
        block = complex(bones.numbered.blocks(slide)[bones.shown])
        middle = (start + end) / 2 if math.isnan(block.real) else place.on(block)
        sides = {side: ground(*_base(middle, slide, side, hand), hand) for side in (-1j, 1j)}
        base, *hatch = min(sides.items(), key=lambda item: ink.crossed_by(item[1]) + DOWNWARD * _up(slide, item[0]))[1]
        over = [symbol for other, symbol in pairs.blocks if other != slide]
        strokes += trim([base], over)
        strokes += [line for line in hatch if list(trim([line], over)) == [line]]  # hatching is whole or left out
    return strokes


def _up(slide: Slide, side: complex) -> float:
    return (slide.on_owner.direction * side).imag


def _base(middle: complex, slide: Slide, side: complex, hand: Hand) -> tuple[complex, complex, complex]:
    """Give the ends of the ground's line beside a block, and the way into the ground."""
    along = slide.on_owner.direction
    foot = middle + side * along * BLOCK[1] / 2 * hand.symbol
    half = along * BASE / 2 * hand.symbol
    return foot - half, foot + half, side * along


LENGTH = 14.0  # mm of an arrow


OFFS = (9.0, 12.0, 16.0, 21.0, 27.0)  # mm from the guide to an arrow


class PushArrow(NamedTuple):
    """An arrow beside the slider's guide, with the letter of what it shows."""

    letter: str
    start: complex
    end: complex
    side: complex  # unit vector away from the guide

    @property
    def middle(self) -> tuple[complex, float]:
        """The middle of the arrow, and the direction away from the guide there."""
        return (self.start + self.end) / 2, cmath.phase(self.side)

    @property
    def room(self) -> list[Stroke]:
        """Lines along it and on either side: what they cross comes too near."""
        offs = (k * BESIDE * self.side for k in (-1, 0, 1, 2, 3))
        return [Line(self.start + off, self.end + off) for off in offs]

    def strokes(self, pairs: Pairs) -> tuple[Stroke, ...]:
        """Draw it."""
        head = arrowhead(self.start, self.end, pairs.hand.symbol)
        return Line(self.start, self.end, pairs.hand.other), *(() if head is None else (head,))


def aside(bones: Skeletons) -> complex:
    """Give the unit direction off the slider's guide to the side where the mechanism is not."""
    line = pushed(bones.mechanism).way(FRAME)
    offs = [((spot - line.through) * line.direction.conjugate()).imag for spot in bones.points]
    return line.direction * (-1j if max(offs) + min(offs) >= 0 else 1j)


def arrows(pairs: Pairs) -> tuple[TurningArrow | PushArrow, ...]:
    """Give the arrows of how the primary link moves: it turns, or it is pushed along."""
    return pushes(pairs) if pairs.bones.mechanism.drive.pushed else turnings(pairs)


@lru_cache(maxsize=1)  # the figure draws the arrows, and later their letters stand beside them
def pushes(pairs: Pairs) -> tuple[PushArrow, ...]:
    """Place the arrow of the slider's velocity where it crosses the fewest lines, and that of its acceleration."""
    ink, arrows = felt(pairs), list[PushArrow]()
    for symbol, sense in senses("va", pairs.bones):
        places = _push_places(f"{symbol}_{pushed(pairs.bones.mechanism).point}", sense, pairs)
        arrows.append(min(places, key=lambda push: ink.crossed_by(push.room)))
        ink.draw(arrows[-1].room, THICK)
    return tuple(arrows)


def _push_places(letter: str, sense: int, pairs: Pairs) -> Iterator[PushArrow]:
    """Give the places of an arrow beside the shown block, the nearest to it first."""
    bones, factor = pairs.bones, pairs.hand.symbol
    along, away = pushed(bones.mechanism).way(FRAME).direction, aside(bones)
    spot = pairs.place.on(bones.drive_end(bones.shown))
    for off in OFFS:
        for side in (away, -away):
            for shift in (0.5, -0.5, 1.5, -1.5):
                middle = spot + (off * side + shift * LENGTH * along) * factor
                half = along * sense * LENGTH / 2 * factor
                yield PushArrow(letter, middle - half, middle + half, side)
