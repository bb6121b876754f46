"""The plan of characteristic positions of a machine on its sheet (характерные положения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

import numpy as np

from drawings.layout.ink import Ink
from drawings.layout.picture import Picture, Spot
from drawings.lettering.lettering import text_width
from drawings.linkage import position_plan
from drawings.linkage.position_letters import clearest, length, settled, stroke
from drawings.linkage.position_plan import PositionFigure
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.page.page import Drafting
from drawings.paper.strokes import INK, Arc, Circle, Group, Stroke, Text
from drawings.paper.walk import tied
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import fit_dashes
from drawings.symbols.trimming import trim
from geometry.board import Arc as Notch
from plans.cyclogram.study import CyclogramStudy
from plans.linkage.travel import frame_slide
from plans.model.cyclogram import BEGIN, END, ENTRY, EXIT, Cyclogram
from plans.model.mechanism import FRAME

NAME = "characteristic"
TITLE = "characteristic positions"
OVERRUNS, STROKE, NOTCHES, PINS = "overruns", "stroke", "notches", "pins"  # the names of its groups
LONG = 6.0  # mm of a notch arc kept on each side of its meeting
DOT = 0.8  # mm, radius of a crank pin
LETTERS = 30.0  # it is drawn at least so many of its letters large: its angles are read from it


def shown_of(found: Cyclogram) -> int:
    """Give the number of the position in full lines: where the tool comes to the work, or leaves it."""
    return found.number(ENTRY if found.of(ENTRY) else EXIT)


def measure(bones: Skeletons, drafting: Drafting) -> Picture:
    """Measure the room that it needs."""
    room = position_plan.measure(bones, NAME, drafting)
    heading = text_width(Text(0j, drafting.word(TITLE), drafting.hand.heading))
    return room._replace(heading=heading, least=LETTERS * drafting.hand.letter)


def draw(study: CyclogramStudy, bones: Skeletons, room: Picture, spot: Spot, drafting: Drafting) -> PositionFigure:
    """Draw it in its spot, its title and its scale over it."""
    pairs = Pairs(bones, room.place(*spot), drafting.hand)
    layers = [layer for layer in position_plan.layers(pairs, drafting.language) if layer.name not in (NOTCHES, STROKE)]
    notches = Group(tuple(fit_dashes(trim(_notches(study, pairs), pairs.masks))), NOTCHES)
    ink, head = Ink(), position_plan.headed(TITLE, spot, drafting)
    ink.draw([line for layer in (head, *layers) for line in layer.strokes])
    overruns = Group(tuple(_overruns(study.cyclogram, pairs, drafting, ink)), OVERRUNS)
    whole = Group(tuple(stroke(bones, pairs.place, pairs.hand, drafting.language, ink)), STROKE)
    pins = Group(tuple(_pins(bones, pairs)), PINS)  # under the hinges
    lines = Group((notches, pins, *layers, overruns, whole), NAME)
    return PositionFigure(pairs, (head, lines))


def _notches(study: CyclogramStudy, pairs: Pairs) -> Iterator[Stroke]:
    """Keep the notch arcs struck from points that move with the tool; an arc about a fixed hinge is a path already."""
    for board in study.boards:
        for mark in board:
            if mark.step.op == "meet":
                for (source, ray), locus in zip(mark.rays, mark.step.inputs, strict=False):
                    centres, rays = np.broadcast_arrays(np.atleast_1d(source.point), np.atleast_1d(ray))
                    if not isinstance(locus.value, Notch) or np.ptp(centres.real) + np.ptp(centres.imag) == 0:
                        continue
                    for centre, arm in zip(centres.tolist(), rays.tolist(), strict=True):
                        radius, turn = pairs.place.length(abs(arm)), cmath.phase(arm)
                        half = min(LONG * pairs.hand.symbol / radius, math.pi)
                        yield Arc(pairs.place.on(centre), radius, turn - half, turn + half, pairs.hand.drafted)


def _pins(bones: Skeletons, pairs: Pairs) -> Iterator[Group]:
    """Mark the crank's end in every position but the one in full lines, to be measured by its number from the pivot."""
    drive, place = bones.mechanism.drive, pairs.place
    pivot = bones.mechanism.links[FRAME].points[drive.pivot]
    data = Subject(NAME, "r", None).data("pole", drive.pivot, pivot, place.scale)
    yield Group((Circle(place.on(pivot), DOT * pairs.hand.symbol, INK),), "", data, drive.pivot)
    for k in range(len(bones.numbered)):
        if k != bones.shown:
            value, subject = bones.drive_end(k), Subject(NAME, "r", k)
            data = subject.data("point", f"{drive.end}_{k}", value, place.scale)
            yield Group((Circle(place.on(value), DOT * pairs.hand.symbol, INK),), "", data, str(k))


def _overruns(found: Cyclogram, pairs: Pairs, drafting: Drafting, ink: Ink) -> Iterator[Stroke]:
    """Dimension how far the tool goes past the work, of one that slides."""
    slide = frame_slide(pairs.bones.mechanism, found.output.link)
    if slide is None:
        return
    places = pairs.bones.numbered.points[found.output.point or slide.point]
    for role, extreme in ((ENTRY, BEGIN), (EXIT, END)):
        if found.of(role):
            ends = [pairs.place.on(complex(places[found.number(named)])) for named in (extreme, role)]
            first, last = sorted(ends, key=lambda pin: (tied(pin.real), pin.imag))
            station, other = found.of(role)[0], found.of(extreme)[0]
            size = length(abs(station.place - other.place), drafting.language)
            text = drafting.word("cyclogram overrun size", size=size)
            strokes = clearest((first, last), text, pairs.bones, pairs.place, pairs.hand, ink)
            settled(strokes, ink)
            yield from strokes
