"""The dimension of the output's stroke H, placed where it crosses the fewest lines (размер хода)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import product

from drawings.figures.linkage.skeleton import Skeletons
from drawings.figures.linkage.tracks import sliders
from drawings.layout.ink import Ink
from drawings.layout.place import Place
from drawings.lettering.extent import bounds
from drawings.lettering.lettering import text_reach, text_width
from drawings.lettering.phrase import Phrase, slotted, telling
from drawings.lettering.words import fixed
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Box, Group, Line, Stroke, Text
from drawings.paper.ties import tied
from drawings.paper.walk import stating
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead
from plans.linkage.travel import frame_slide
from plans.model.order import POSITIONS

# mm from the stroke's line to its dimension: at least what leaves room for numbers and ground, then by steps.
DISTANCES = (15.0, 18.0, 21.0, 24.0, 28.0, 32.0, 37.0, 42.0, 48.0, 55.0, 63.0)
AWAY = 4.0  # mm that an extension line begins from its point
PAST = 2.0  # mm that an extension line goes past its arrow
ABOVE = 1.0  # mm from the dimension line to its number
TAIL = 8.0  # mm of a dimension line outside its extension lines, where its arrows stand outside
SHARES = (0.5, 0.4, 0.6, 0.3, 0.7)  # where along the dimension line its number may stand
# What crossing one line costs, in mm of distance: a number struck through is no number.
STRUCK, CROSSED = 200.0, 4.0
BORDER = 14.0  # mm that a sheet leaves free round the points of a plan
OUTSIDE = 30.0  # what each mm beyond the border costs


def strokes(bones: Skeletons, place: Place, hand: Hand, language: str, ink: Ink) -> list[Stroke]:
    """Dimension the strokes of all sliders on the frame, in millimetres of the machine, each by its point's letter."""
    found = stroke(bones, place, hand, language, ink, named=bool(bones.strokes))
    for track in sliders(bones):
        ink.draw(found)
        ends = [place.on(one.spot) for one in track.places if one.extreme]
        if len(ends) == 2 and abs(ends[1] - ends[0]) > SEEN and track.travel is not None:
            text = _text(track.point, track.travel.extremes.stroke, language)
            found += _told(f"H_{track.point}", clearest(_ordered(ends), text, bones, place, hand, ink), place)
    return found


def stroke(bones: Skeletons, place: Place, hand: Hand, language: str, ink: Ink, named: bool = False) -> list[Stroke]:
    """Dimension the stroke H of a sliding output, in millimetres of the machine, on the clearer side of its guide."""
    travel, out = bones.study.travel, bones.study.output
    slide = frame_slide(bones.mechanism, out.link)
    if travel is None or slide is None or bones.extremes is None:
        return []
    point = out.point or slide.point
    ends = _ordered([place.on(complex(value)) for value in bones.extremes.points[point]])
    text = _text(point if named else "", travel.extremes.stroke, language)
    return _told(f"H_{point}" if named else "H", clearest(ends, text, bones, place, hand, ink), place)


def _told(name: str, dimension: list[Stroke], place: Place) -> list[Stroke]:
    """Give a dimension as the stroke that it states, by its arrows and by its number."""
    own = (telling(POSITIONS.plan, one) if isinstance(one, Text) else one for one in dimension)
    return [stating(Statement(Kind.LENGTH, POSITIONS.plan, name, scale=place.scale.mu), *own)]


def _ordered(ends: list[complex]) -> tuple[complex, complex]:
    first, last = sorted(ends, key=lambda pin: (tied(pin.real), pin.imag))
    return first, last


def _text(point: str, size: float, language: str) -> Phrase:
    """Write a stroke with its size; among several by its point's letter: H_B."""
    letter = f"H_{{{point}}}" if point else "H"
    return slotted(f"{letter} = ", f"H_{point}" if point else "H", length(size, language))


def length(size: float, language: str) -> str:
    """Write a length m in millimetres, of two decimals those that are not zero."""
    return fixed(1000 * size, language).rstrip("0").rstrip(".,")


def clearest(
    ends: tuple[complex, complex], text: str, bones: Skeletons, place: Place, hand: Hand, ink: Ink
) -> list[Stroke]:
    """Dimension the way between two places on paper, on the side and as far off as is clearest."""
    first, last = ends
    room = _room([place.on(value) for value in bones.points])
    best: list[Stroke] = []
    cheapest = math.inf
    for distance in DISTANCES:
        if distance >= cheapest:
            break  # no place further off can be better
        for strokes in _candidates(first, last, distance, text, hand):
            cost = tied(distance + _cost(strokes, ink, room))
            if cost < cheapest:
                best, cheapest = strokes, cost
    return best


def _candidates(first: complex, last: complex, distance: float, text: str, hand: Hand) -> Iterator[list[Stroke]]:
    up = 1j * (last - first) / abs(last - first)
    for side, share in product((1, -1), SHARES):
        yield _dimension(first, last, side * distance * up, share, text, hand)


def _dimension(first: complex, last: complex, off: complex, share: float, text: str, hand: Hand) -> list[Stroke]:
    """Draw a dimension at some distance: arrows between the extension lines, or outside where room is short."""
    start, end = first + off, last + off
    along, out = (end - start) / abs(end - start), off / abs(off)
    width = text_width(Text(0j, text, hand.letter, "middle", True))
    roomy = tied(abs(end - start) - 2 * ARROW_LENGTH * hand.symbol) >= 2
    fits = tied(abs(end - start) - width) >= 2
    tail = along * TAIL * hand.symbol
    tips = [(end, start), (start, end)] if roomy else [(start - 2 * tail, start), (end + 2 * tail, end)]
    shelf = end + tail + along * (width + 2 if not fits else 0)
    line = (start, end) if roomy and fits else (start if roomy else start - tail, shelf)
    inside = min(max(share * abs(end - start), width / 2), abs(end - start) - width / 2)  # the number stays between
    middle = start + along * inside if fits else shelf - along * width / 2
    above = ABOVE - text_reach(Text(0j, text, hand.letter, "middle", True))[0]  # a comma hangs below its line
    letters = Text(middle + 1j * along * above, text, hand.letter, "middle", True, math.degrees(cmath.phase(along)))
    heads = [head for tip in tips if (head := arrowhead(*tip, hand.symbol)) is not None]
    return [
        letters,
        Line(*line, hand.drafted),
        *(Line(pin + AWAY * out, foot + PAST * out, hand.drafted) for pin, foot in ((first, start), (last, end))),
        *heads,
    ]


def _cost(strokes: list[Stroke], ink: Ink, room: Box) -> float:
    """Weigh a dimension: lines through its number, lines that its own lines cross, what is beyond the border."""
    letters, dimension, *extensions = strokes[:4]
    struck, crossed = ink.crossed_by([letters]), ink.crossed_by([dimension]) + ink.crossed_by(extensions) / 2
    return STRUCK * struck + CROSSED * crossed + OUTSIDE * _beyond(strokes, room)


def _room(points: list[complex]) -> Box:
    """Give the box of a plan's points with the border round it."""
    xs, ys = [point.real for point in points], [point.imag for point in points]
    return min(xs) - BORDER, min(ys) - BORDER, max(xs) + BORDER, max(ys) + BORDER


def _beyond(strokes: list[Stroke], room: Box) -> float:
    """Give by how much strokes lie outside the room, mm."""
    left, bottom, right, top = bounds(Group(tuple(strokes)))
    return sum(max(by, 0.0) for by in (room[0] - left, room[1] - bottom, right - room[2], top - room[3]))
