"""A primary link that slides: its stroke divided on its guide, the arrows of how it is pushed along (ход)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.rotation import Turning, turnings
from drawings.figures.linkage.skeleton import Skeletons
from drawings.layout.ink import Ink
from drawings.layout.place import Place
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.symbols import symbols
from drawings.symbols.symbols import arrowhead
from plans.model.mechanism import FRAME, Mechanism, Slide

LENGTH = 14.0  # mm of an arrow
OFFS = (9.0, 12.0, 16.0, 21.0, 27.0)  # mm from the guide to an arrow
BESIDE = 1.6  # mm that an arrow keeps from a line beside it
THICK = 12.0  # thin lines that a bar or a symbol of the shown position counts as


class Push(NamedTuple):
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


def pushed(mechanism: Mechanism) -> Slide:
    """Give the slide that is pushed along."""
    slide = mechanism.drive.guide
    assert slide is not None  # asked only where one is
    return slide


def stroke_line(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the slider's stroke with a tick at every position; cross those that the mechanism does not reach."""
    ends = [place.on(bones.drive_end(k)) for k in range(len(bones.numbered))]
    along = pushed(bones.mechanism).way(FRAME).direction
    ticks: list[Stroke] = [symbols.tick(end, along, hand) for end in ends]
    lost = [arm for end, gone in zip(ends, bones.study.lost, strict=True) if gone for arm in symbols.cross(end, hand)]
    return [Line(ends[0], ends[-1], hand.drafted), *ticks, *lost]


def aside(bones: Skeletons) -> complex:
    """Give the unit direction off the slider's guide to the side where the mechanism is not."""
    line = pushed(bones.mechanism).way(FRAME)
    offs = [((spot - line.through) * line.direction.conjugate()).imag for spot in bones.points]
    return line.direction * (-1j if max(offs) + min(offs) >= 0 else 1j)


def arrows(pairs: Pairs) -> tuple[Turning | Push, ...]:
    """Give the arrows of how the primary link moves: it turns, or it is pushed along."""
    return pushes(pairs) if pairs.bones.mechanism.drive.pushed else turnings(pairs)


@lru_cache(maxsize=1)  # the figure draws the arrows, and later their letters stand beside them
def pushes(pairs: Pairs) -> tuple[Push, ...]:
    """Place the arrow of the slider's velocity where it crosses the fewest lines, and that of its acceleration."""
    return tuple(_pushes(pairs))


def _pushes(pairs: Pairs) -> Iterator[Push]:
    bones = pairs.bones
    ink = Ink()
    ink.draw([*pairs.bars(), *pairs.stands(), *(block for _, block in pairs.blocks)], THICK)
    ink.draw(circle for circles in pairs.hinges.values() for circle in circles)
    point = pushed(bones.mechanism).point
    for symbol, rate in zip("va", bones.study.rates.at(bones.shown), strict=True):
        if rate:
            push = _clearest(f"{symbol}_{point}", math.copysign(1.0, rate), pairs, ink)
            ink.draw(push.room, THICK)
            yield push


def _clearest(letter: str, sense: float, pairs: Pairs, ink: Ink) -> Push:
    return min(_candidates(letter, sense, pairs), key=lambda push: ink.crossed_by(push.room))


def _candidates(letter: str, sense: float, pairs: Pairs) -> Iterator[Push]:
    """Give the places of an arrow beside the shown block, the nearest to it first."""
    bones, factor = pairs.bones, pairs.hand.symbol
    along, away = pushed(bones.mechanism).way(FRAME).direction, aside(bones)
    spot = pairs.place.on(bones.drive_end(bones.shown))
    for off in OFFS:
        for side in (away, -away):
            for shift in (0.5, -0.5, 1.5, -1.5):
                middle = spot + (off * side + shift * LENGTH * along) * factor
                half = along * sense * LENGTH / 2 * factor
                yield Push(letter, middle - half, middle + half, side)
