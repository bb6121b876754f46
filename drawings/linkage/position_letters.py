"""The letters of the plan of positions: points, mass centres, arcs, numbers of links and of positions (обозначения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from drawings.kinds.scheme import frame_number, link_numbers
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import Segment
from drawings.layout.picture import Place
from drawings.lettering.lettering import bounds, spaced, text_reach, text_width
from drawings.lettering.words import Phrase, fixed, slotted, telling, with_index
from drawings.linkage.guides import PushArrow, TurningArrow, arrows
from drawings.linkage.numbering import lone, numbers, output_point, sliders
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.linkage.trajectories import Traced, phases, sized, traced
from drawings.paper.hand import Hand
from drawings.paper.limits import MANY, SEEN
from drawings.paper.strokes import Box, Group, Kind, Line, Statement, Stroke, Text
from drawings.paper.walk import PLACES, stating, texts, tied
from drawings.symbols.symbols import ARROW_LENGTH, HEAD, TICK, TurnArrow, arrowhead, tick
from drawings.symbols.trimming import trim
from plans.model.mechanism import FRAME, output_way
from plans.model.motion import POSITIONS

# mm from the stroke's line to its dimension: at least what leaves room for numbers and ground, then by steps.
DISTANCES = (15.0, 18.0, 21.0, 24.0, 28.0, 32.0, 37.0, 42.0, 48.0, 55.0, 63.0)
NEARER = (9.0, 12.0)  # where a point's path has no ground
AWAY = 4.0  # mm that an extension line begins from its point
PAST = 2.0  # mm that an extension line goes past its arrow
ABOVE = 1.0  # mm from the dimension line to its number
TAIL = 8.0  # mm of a dimension line outside its extension lines, where its arrows stand outside
DIMENSION_SHARES = (0.5, 0.4, 0.6, 0.3, 0.7)  # where along the dimension line its number may stand
# What crossing one line costs, in mm of distance: a number struck through is no number.
STRUCK, CROSSED = 200.0, 4.0
BORDER = 14.0  # mm that a sheet leaves free round the points of a plan
OUTSIDE = 30.0  # what each mm beyond the border costs


def strokes(bones: Skeletons, place: Place, hand: Hand, language: str, ink: Ink) -> list[Stroke]:
    """Dimension the strokes of all sliders on the frame, in millimetres of the machine, each by its point's letter."""
    found = stroke(bones, place, hand, language, ink, named=bool(bones.strokes))
    for track in sliders(bones):
        settled(found, ink)
        ends = [place.on(numbered.spot) for numbered in track.places if numbered.extreme]
        if len(ends) == 2 and abs(ends[1] - ends[0]) > SEEN and track.travel is not None:
            text = _text(track.point, track.travel.extremes.stroke, language)
            found += _letters(f"H_{track.point}", clearest(_ordered(ends), text, bones, place, hand, ink), place)
    return found


def settled(dimensions: list[Stroke], ink: Ink) -> None:
    """Ink dimensions in: a line of another that runs through one of their numbers costs as much as one struck."""
    ink.draw(dimensions)
    ink.draw(texts(dimensions), STRUCK / CROSSED)


def stroke(bones: Skeletons, place: Place, hand: Hand, language: str, ink: Ink, named: bool = False) -> list[Stroke]:
    """Dimension the stroke H of an output, in millimetres of the machine, along its guide or the direction told."""
    travel, out = bones.study.travel, bones.study.output
    counted = output_way(bones.mechanism, out)
    if travel is None or counted is None or bones.extremes is None:
        return []
    point, along = counted[0], out.along and _ordered([-out.along, out.along])[1]
    ends = _ordered([place.on(complex(value)) for value in bones.extremes.points[point]])
    if along and ((ends[1] - ends[0]) * along.conjugate()).real < 0:
        ends = ends[::-1]
    text = _text(point if named else "", travel.extremes.stroke, language)
    return _letters(f"H_{point}" if named else "H", clearest(ends, text, bones, place, hand, ink, along), place)


def _letters(name: str, dimension: list[Stroke], place: Place) -> list[Stroke]:
    """Give a dimension as the stroke that it states, by its arrows and by its number."""
    parts = (telling(POSITIONS.plan, stroke) if isinstance(stroke, Text) else stroke for stroke in dimension)
    return [stating(Statement(Kind.LENGTH, POSITIONS.plan, name, scale=place.scale.mu), *parts)]


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
    ends: tuple[complex, complex], text: str, bones: Skeletons, place: Place, hand: Hand, ink: Ink,
    along: complex | None = None,
) -> list[Stroke]:  # fmt: skip
    """Dimension two places on paper, or their way along a direction, on the side and as far off as is clearest."""
    first, last = ends
    points = [place.on(value) for value in bones.points]
    xs, ys = [point.real for point in points], [point.imag for point in points]
    room = min(xs) - BORDER, min(ys) - BORDER, max(xs) + BORDER, max(ys) + BORDER
    best, cheapest, up = list[Stroke](), math.inf, 1j * (along or (last - first) / abs(last - first))
    higher = ((last - first) * up.conjugate()).real  # the dimension is as far off the further one of both
    for distance in (*NEARER, *DISTANCES) if along else DISTANCES:
        if distance >= cheapest:
            break  # no place further off can be better
        for side, share in product((1, -1), DIMENSION_SHARES):
            offs = (distance + max(side * higher, 0.0), distance + max(-side * higher, 0.0))
            feet = tuple((end, end + side * off * up) for end, off in zip(ends, offs, strict=True))
            strokes = _dimension(feet, side * up, share, text, hand)
            letters, dimension, *extensions = strokes[:4]
            struck, crossed = ink.crossed_by([letters]), ink.crossed_by([dimension]) + ink.crossed_by(extensions) / 2
            cost = tied(distance + (STRUCK * struck + CROSSED * crossed + OUTSIDE * _beyond(strokes, room)))
            if cost < cheapest:
                best, cheapest = strokes, cost
    return best


def _dimension(feet: Sequence[Segment], out: complex, share: float, text: str, hand: Hand) -> list[Stroke]:
    """Draw a dimension at the feet of its extension lines: arrows between these, or outside where room is short."""
    start, end = (foot for _, foot in feet)
    along = (end - start) / abs(end - start)
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
    extensions = (Line(pin + AWAY * out, foot + PAST * out, hand.drafted) for pin, foot in feet)
    return [letters, Line(*line, hand.drafted), *extensions, *heads]


def _beyond(strokes: list[Stroke], room: Box) -> float:
    """Give by how much strokes lie outside the room, mm."""
    left, bottom, right, top = bounds(Group(tuple(strokes)))
    return sum(max(by, 0.0) for by in (room[0] - left, room[1] - bottom, right - room[2], top - room[3]))


NUMBERED = 4  # about so many positions bear a number along a path
GAP = 1.0  # mm from a tick's end to its number
TICKED = 2.0  # mm from tick to tick: nearer ones are no scale
LONG = 40.0  # mm: a shorter path has no room for numbers


def path_ticks(pairs: Pairs) -> Iterator[Line]:
    """Tick each trajectory at the positions, across it; a tick that a symbol would cut is left out."""
    for path in traced(pairs.bones):
        for k in _shown(path, pairs.place):
            direction = _direction(path, k, pairs.place)
            if direction is not None:
                line = tick(pairs.place.on(complex(path.numbered[k])), direction, pairs.hand)
                yield from (line,) if list(trim([line], pairs.masks)) == [line] else ()


def path_numbers(pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Number a few ticks of each trajectory where there is room; output and crank have their numbers already."""
    drive, masses = pairs.bones.mechanism.drive, pairs.bones.masses
    known = {output_point(pairs.bones), *(name for name, (link, _) in masses.items() if link == drive.link)}
    for path in traced(pairs.bones):
        if path.name not in known and _length(path, pairs.place) >= LONG:
            yield from _numbers(pairs, path, labels)


def _numbers(pairs: Pairs, path: Traced, labels: Labels) -> Iterator[Stroke]:
    """Number every so many ticks off all rows of numbers, two at least: one does not tell which way they count."""
    every, place = max(math.ceil(len(path.numbered) / NUMBERED), 1), pairs.place
    spots = [(k, place.on(complex(path.numbered[k]))) for k in _shown(path, place) if k % every == 0]
    ticks = [(k, spot, way) for k, spot in spots if (way := _direction(path, k, place)) and lone(spot, pairs)]
    for k, spot, way in ticks if len(ticks) > 1 else ():
        if k != pairs.bones.shown:
            gap = TICK * pairs.hand.symbol + GAP
            number = labels.close(spot, str(k), pairs.sheet.number, gap, cmath.phase(1j * way))
            yield from () if number is None else (number,)


def _shown(path: Traced, place: Place) -> list[int]:
    """List the positions that are ticked: of very many about as many as are drawn with all links, others with room."""
    known = np.flatnonzero(~np.isnan(path.numbered)).tolist()
    every = max(math.ceil(len(path.numbered) / MANY), 1)
    drawn = [k for k, position in enumerate(known) if position % every == 0]
    spots = [place.on(complex(path.numbered[k])) for k in known]
    return [known[k] for k in sorted(spaced(spots, TICKED, first=drawn))]


def _direction(path: Traced, k: int, place: Place) -> complex | None:
    """Give the unit direction of a path at a position: of the longer step beside it; none of a point that stands."""
    apart = np.abs(path.way - path.numbered[k])
    if np.isnan(apart).all():
        return None
    nearest = int(np.nanargmin((apart / place.scale.mu).round(PLACES)))
    beside = path.way[max(nearest - 1, 0) : nearest + 2]
    steps = np.diff(beside[~np.isnan(beside)])
    longest = max(steps.tolist(), key=lambda step: tied(place.length(abs(step))), default=0j)
    return longest / abs(longest) if longest else None


def _length(path: Traced, place: Place) -> float:
    known = path.way[~np.isnan(path.way)]
    return place.length(float(np.abs(np.diff(known)).sum()))


LETTER = "ψ"
SHARES = (0.45, 0.35, 0.55, 0.25, 0.65, 0.75)  # of the rocker's arm or slot, where its arc may cross it, the best first
LEAST = 4.0  # lengths of an arrow's head that an arc is long at least: below, its two heads hide it


class SwingArc(NamedTuple):
    """An arc about a rocker's pivot from one of its extreme positions to the other."""

    text: Phrase
    arc: TurnArrow

    def strokes(self, pairs: Pairs) -> Iterator[Stroke]:
        """Draw it from its middle to both sides, each half with its arrow."""
        yield stating(Statement(Kind.ANGLE, POSITIONS.plan, LETTER), *self.arc.angle(pairs.hand, (-1, 1)))


def swings(pairs: Pairs, language: str) -> tuple[SwingArc, ...]:
    """Give the arc of an output that rocks about a hinge of the frame; none of any other, or where it has no room."""
    bones, study = pairs.bones, pairs.bones.study
    points = bones.mechanism.links[study.output.link].points
    pivot = next((name for name in points if name in bones.mechanism.links[FRAME].points), None)
    if study.travel is None or study.travel.extremes.sliding or pivot is None:
        return ()
    low, high = study.travel.extremes.reach
    centre = pairs.place.on(bones.mechanism.links[FRAME].points[pivot])
    text = sized(LETTER, abs(high - low), language)
    arms = ((pairs.place.length(abs(arm)), low + cmath.phase(arm)) for arm in _arms(bones, points[pivot]))
    arcs = (SwingArc(text, TurnArrow(centre, radius, start, high - low)) for radius, start in arms if radius)
    least = LEAST * HEAD[0] * pairs.hand.symbol
    roomy = [swing for swing in arcs if swing.arc.radius * abs(swing.arc.sweep) >= least]
    return tuple(roomy[:1])


def _arms(bones: Skeletons, pivot: complex) -> Iterator[complex]:
    """Give the ways m from an output's pivot to where an arc may cross it: its arm, or its slot if it has no pin."""
    link, tip = bones.study.output.link, output_point(bones)
    if tip is not None:
        yield from (share * (bones.mechanism.links[link].points[tip] - pivot) for share in SHARES)
    slots = [slide for slide in bones.travels if slide.owner == link] if tip is None else []
    for slide, share in product(slots[:1], SHARES):
        through, way = slide.on_owner
        off = 1j * way * ((through - pivot) * way.conjugate()).imag
        end = max(bones.travels[slide], key=lambda along: abs(through + along * way - pivot))
        far = through + end * way - pivot
        reach = (share * abs(far)) ** 2 - abs(off) ** 2
        if reach > 0:
            yield off + math.copysign(math.sqrt(reach), (far * way.conjugate()).real) * way


LINKS, NUMBERS = "links", "path-numbers"  # the groups of numbers of links, and of positions on trajectories


def letters(pairs: Pairs, labels: Labels) -> Group:
    """Letter the points and number the positions, where the lines of all figures leave room."""
    bones, hand = pairs.bones, pairs.sheet
    points = {name: spot for name, spot in pairs.named.items() if name not in bones.masses}
    strokes: list[Stroke] = [*pairs.letters(points, labels)]
    centres = {name: pairs.centres[name] for name in bones.masses if name in pairs.centres}
    strokes += [labels.beside(spot, with_index(name), hand.letter, 2.5) for name, spot in centres.items()]
    strokes += [_on_arc(arrow, arrow.letter, labels, hand) for arrow in arrows(pairs)]
    strokes += [_on_arc(phase.arc, phase.text, labels, hand) for phase in phases(pairs, bones.study.language)]
    strokes += [_on_arc(swing.arc, swing.text, labels, hand) for swing in swings(pairs, bones.study.language)]
    strokes += numbers(pairs, labels)
    links = *link_numbers(pairs, bones.links, labels, hand), *frame_number(pairs, labels, hand)
    return Group((*strokes, Group(links, LINKS), Group(tuple(path_numbers(pairs, labels)), NUMBERS)))


def _on_arc(arc: TurningArrow | PushArrow | TurnArrow, text: str, labels: Labels, hand: Hand) -> Stroke:
    """Letter an arc about a pivot, or an arrow beside a guide, in its middle, outside."""
    middle, away = arc.middle
    return telling(POSITIONS.plan, labels.beside(middle, text, hand.letter, 1.5, away), text)
