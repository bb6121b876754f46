"""Special points of triads on the plan of positions: the lines of two leads prolonged to their meeting (M3.10)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise

from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.lettering.words import with_index
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Circle, Group, Line, Stroke
from drawings.symbols.figure import Subject, point
from geometry.board import at
from geometry.three_leads import ROD, SLOT, BodyPose
from plans.model.triad import Triad

NOTCH, STEPS = 9.0, 6  # mm on either side of the meeting, and in how many steps a way is drawn there
RADIUS = 0.6  # mm: of the mark, in sizes of symbols


def special_lines(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Prolong the lines of the leads to the special point."""
    marks = bones.specials
    return [Line(place.on(start), place.on(mark.value), hand.drafted) for mark in marks for start in mark.contacts]


def false_positions(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the notch that settles a triad: the way of the third lead's hinge on the two others, and its arc."""
    plan, k, strokes = bones.study.drafts().positions, bones.shown, list[Stroke]()
    for triad in (group for group in bones.study.groups if isinstance(group, Triad)):
        settled = plan.images[triad.basis].origin
        settling, met = settled.step.settling, settled.meeting
        if settling is None or met is None or math.isnan(at(settled.point, k).real):
            continue
        known = settling.known([at(mark.point, k) for mark in settled.step.inputs[:-1]])
        body, pose, out = settling.body, BodyPose(at(met.first, k), at(met.second, k)), settling.out
        lead, held = body.leads[out], body.held(known, pose)
        reach = place.length(abs(held.arm(out) / held.crosses[out]))  # mm from the special point
        if lead.kind == SLOT or not reach > NOTCH:
            continue
        turns = [NOTCH / reach * step / STEPS for step in range(-STEPS, STEPS + 1)]
        way = [place.on(spot) for spot in body.locus(known, pose, out, turns)]
        strokes += [Line(start, end, hand.drafted) for start, end in pairwise(way)]
        if lead.kind == ROD:
            centre, radius = place.on(known.places[out]), place.length(lead.size)
            angle = cmath.phase(way[STEPS] - centre)
            strokes.append(Arc(centre, radius, angle - NOTCH / radius, angle + NOTCH / radius, hand.drafted))
    return strokes


def special_spots(bones: Skeletons, subject: Subject, place: Place, hand: Hand) -> Iterator[Group]:
    """Mark the special points."""
    for mark in bones.specials:
        dot = Circle(place.on(mark.value), RADIUS * hand.symbol, hand.drafted)
        yield point(subject, mark.name, mark.value, place, dot)


def special_letters(pairs: Pairs, labels: Labels) -> tuple[Group, ...]:
    """Letter the special points."""
    size, gap = pairs.sheet.letter, 2 * RADIUS * pairs.hand.symbol
    marks = pairs.bones.specials
    strokes = [labels.beside(pairs.place.on(mark.value), with_index(mark.name), size, gap) for mark in marks]
    return (Group(tuple(strokes)),) if strokes else ()
