"""The letters of the plan of positions: points, mass centres, arcs, numbers of links and of positions (обозначения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.figures.linkage.guides import Turning
from drawings.figures.linkage.numbering import frame_number, link_numbers, numbers
from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.tracks import Push, arrows, output_point
from drawings.figures.linkage.trajectories import Phase, Traced, phases, sized, traced
from drawings.layout.labels import Labels, free_side
from drawings.layout.place import Place
from drawings.lettering.indices import with_index
from drawings.lettering.phrase import Phrase, telling
from drawings.paper.hand import Hand
from drawings.paper.limits import MANY
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Group, Line, Stroke
from drawings.paper.ties import PLACES, tied
from drawings.paper.walk import stating
from drawings.symbols.symbols import ARROW_LENGTH, HEAD, TICK, tick, turning_arrow
from drawings.symbols.trimming import trim
from plans.model.mechanism import FRAME
from plans.model.order import POSITIONS

NUMBERED = 4  # about so many positions bear a number along a path
GAP = 1.0  # mm from a tick's end to its number
LONG = 40.0  # mm: a shorter path has no room for numbers


def path_ticks(pairs: Pairs) -> Iterator[Line]:
    """Tick each trajectory at the positions, across it; a tick that a symbol would cut is left out."""
    for one in traced(pairs.bones):
        for k in _shown(one):
            direction = _direction(one, k, pairs.place)
            if direction is not None:
                line = tick(pairs.place.on(complex(one.numbered[k])), direction, pairs.hand)
                yield from (line,) if list(trim([line], pairs.masks)) == [line] else ()


def path_numbers(pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Number a few ticks of each trajectory where there is room; output and crank have their numbers already."""
    drive, masses = pairs.bones.mechanism.drive, pairs.bones.masses
    known = {output_point(pairs.bones), *(name for name, (link, _) in masses.items() if link == drive.link)}
    for one in traced(pairs.bones):
        if one.name not in known and _length(one, pairs.place) >= LONG:
            yield from _numbers(pairs, one, labels)


def _numbers(pairs: Pairs, one: Traced, labels: Labels) -> Iterator[Stroke]:
    every = max(math.ceil(len(one.numbered) / NUMBERED), 1)
    for k in _shown(one):
        direction = _direction(one, k, pairs.place)
        if k % every == 0 and k != pairs.bones.shown and direction is not None:
            spot, gap = pairs.place.on(complex(one.numbered[k])), TICK * pairs.hand.symbol + GAP
            number = labels.close(spot, str(k), pairs.sheet.number, gap, cmath.phase(1j * direction))
            yield from () if number is None else (number,)


def _shown(one: Traced) -> list[int]:
    """List the positions that are ticked: of very many about as many as are drawn with all links."""
    every = max(math.ceil(len(one.numbered) / MANY), 1)
    return [k for k in range(0, len(one.numbered), every) if not math.isnan(one.numbered[k].real)]


def _direction(one: Traced, k: int, place: Place) -> complex | None:
    """Give the unit direction of a path at a position: of the longer step beside it; none of a point that stands."""
    apart = np.abs(one.way - one.numbered[k])
    if np.isnan(apart).all():
        return None
    nearest = int(np.nanargmin((apart / place.scale.mu).round(PLACES)))
    beside = one.way[max(nearest - 1, 0) : nearest + 2]
    steps = np.diff(beside[~np.isnan(beside)])
    longest = max(steps.tolist(), key=lambda step: tied(place.length(abs(step))), default=0j)
    return longest / abs(longest) if longest else None


def _length(one: Traced, place: Place) -> float:
    known = one.way[~np.isnan(one.way)]
    return place.length(float(np.abs(np.diff(known)).sum()))


LETTER = "ψ"
SHARES = (0.45, 0.35, 0.55, 0.25, 0.65, 0.75)  # of the rocker's arm, where its arc may cross it, the best first
LEAST = 4.0  # lengths of an arrow's head that an arc is long at least: below, its two heads hide it


class Swing(NamedTuple):
    """An arc about a rocker's pivot from one of its extreme positions to the other."""

    text: Phrase
    centre: complex
    radius: float
    start: float
    sweep: float

    @property
    def middle(self) -> tuple[complex, float]:
        """The middle of the arc, and the direction away from the pivot there."""
        turn = self.start + self.sweep / 2
        return self.centre + cmath.rect(self.radius, turn), turn

    def strokes(self, pairs: Pairs) -> Iterator[Stroke]:
        """Draw it from its middle to both sides, each half with its arrow."""
        turn, half = self.start + self.sweep / 2, self.sweep / 2
        halves = [
            turning_arrow(self.centre, self.radius, turn, k * half, pairs.hand, pairs.hand.drafted) for k in (-1, 1)
        ]
        yield stating(Statement(Kind.ANGLE, POSITIONS.plan, LETTER), *halves[0], *halves[1])


def swings(pairs: Pairs, language: str) -> tuple[Swing, ...]:
    """Give the arc of an output that rocks about a hinge of the frame; none of any other, or where it has no room."""
    bones, study, tip = pairs.bones, pairs.bones.study, output_point(pairs.bones)
    own = bones.mechanism.links[study.output.link].points
    pivot = next((name for name in own if name in bones.mechanism.links[FRAME].points), None)
    if study.travel is None or study.travel.extremes.sliding or pivot is None or tip is None or tip == pivot:
        return ()
    low, high = study.travel.extremes.reach
    arm, centre = own[tip] - own[pivot], pairs.place.on(bones.mechanism.links[FRAME].points[pivot])
    start, length = low + cmath.phase(arm), pairs.place.length(abs(arm))
    text = sized(LETTER, abs(high - low), language)
    arcs = (Swing(text, centre, share * length, start, high - low) for share in SHARES)
    least = LEAST * HEAD[0] * pairs.hand.symbol
    roomy = [one for one in arcs if one.radius * abs(one.sweep) >= least]
    return tuple(roomy[:1])


LINKS, NUMBERS = "links", "path-numbers"  # the groups of numbers of links, and of positions on trajectories


def letters(pairs: Pairs, labels: Labels) -> Group:
    """Letter the points and number the positions, where the lines of all figures leave room."""
    bones, place, hand = pairs.bones, pairs.place, pairs.sheet
    strokes: list[Stroke] = []
    for name in sorted(bones.numbered.points):
        value = bones.spot(name, bones.shown)
        if not math.isnan(value.real):
            gap = pairs.clear(name) + 1.0
            strokes.append(labels.beside(place.on(value), with_index(name), hand.letter, gap, _free(pairs, name)))
    for name in bones.masses:
        if name in pairs.centres:
            strokes.append(labels.beside(pairs.centres[name], with_index(name), hand.letter, 2.5, math.pi / 4))
    strokes += [_on_arc(arrow, arrow.letter, labels, hand) for arrow in arrows(pairs)]
    strokes += [_on_arc(phase, phase.text, labels, hand) for phase in phases(pairs, bones.study.language)]
    strokes += [_on_arc(swing, swing.text, labels, hand) for swing in swings(pairs, bones.study.language)]
    strokes += numbers(pairs, labels)
    links = *link_numbers(pairs, bones.links, labels, hand), *frame_number(pairs, labels, hand)
    return Group((*strokes, Group(links, LINKS), Group(tuple(path_numbers(pairs, labels)), NUMBERS)))


def _on_arc(arc: Turning | Push | Phase | Swing, text: str, labels: Labels, hand: Hand) -> Stroke:
    """Letter an arc about a pivot, or an arrow beside a guide, in its middle, outside."""
    middle, away = arc.middle
    return telling(POSITIONS.plan, labels.beside(middle, text, hand.letter, 1.5, away), text)


def _free(pairs: Pairs, name: str) -> float:
    """Give the side of a point that the bars leave free."""
    spot = pairs.place.on(pairs.bones.spot(name, pairs.bones.shown))
    return free_side(spot, pairs.bars(), pairs.clear(name) + ARROW_LENGTH)
