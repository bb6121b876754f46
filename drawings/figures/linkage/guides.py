"""Guides of the frame: the axis over the block's travel, ground beside the block, ticks (направляющие)."""

from __future__ import annotations

import math

from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.skeleton import Skeletons
from drawings.layout.ink import Ink
from drawings.layout.place import Place
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.symbols.symbols import BLOCK, ground, tick
from drawings.symbols.trimming import trim
from plans.model.mechanism import FRAME, Slide

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


def travel(bones: Skeletons, slide: Slide, place: Place, hand: Hand) -> tuple[complex, complex]:
    """Give the ends of a guide's axis on paper; a guide that no block comes to is where the scene puts it."""
    way = slide.on_owner
    low, high = bones.travels.get(slide, (0.0, 0.0))
    first, last = (place.on(way.through + along * way.direction) for along in (low, high))
    more = BEYOND * hand.symbol * way.direction
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
