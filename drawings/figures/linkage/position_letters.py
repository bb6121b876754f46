"""The letters of the plan of positions: points, mass centres, arcs, numbers of links and of positions (обозначения)."""

from __future__ import annotations

import math

from drawings.figures.linkage.link_numbers import frame_number, link_numbers
from drawings.figures.linkage.numbering import numbers
from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.path_ticks import path_numbers
from drawings.figures.linkage.phases import Phase, phases
from drawings.figures.linkage.pushing import Push, arrows
from drawings.figures.linkage.rotation import Turning
from drawings.figures.linkage.swing import Swing, swings
from drawings.layout.labels import Labels, free_side
from drawings.lettering.indices import with_index
from drawings.lettering.phrase import telling
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Stroke
from drawings.symbols.symbols import ARROW_LENGTH
from plans.model.order import POSITIONS

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
