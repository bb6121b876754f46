"""The figure of the plan of positions: all positions thin, one in full lines with its pairs, paths and extremes."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import NamedTuple

from drawings.kinds.outlines import Poses, outlines, reach_of
from drawings.kinds.scheme import ties
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.linkage.guides import arrows, axes, grounds
from drawings.linkage.numbering import apart, crank_numbers, crank_places, same, stroke_line
from drawings.linkage.position_letters import letters, path_ticks, strokes, swings
from drawings.linkage.skeleton import Pairs, Skeletons, cylinders, reference
from drawings.linkage.special_points import false_positions, special_letters, special_lines, special_spots
from drawings.linkage.trajectories import phases, trajectories
from drawings.page.page import Drafting
from drawings.paper.hand import Field, Hand
from drawings.paper.limits import MANY
from drawings.paper.strokes import Arc, Circle, Group, Kind, Line, LineStyle, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols import symbols
from drawings.symbols.figure import Subject, around, heading, heading_width
from drawings.symbols.symbols import fit_dashes
from drawings.symbols.trimming import trim
from geometry.board import Arc as Notch
from geometry.board import at
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import CHANGE_POINT, POSITIONS

NAME = POSITIONS.plan
TICKS = "path-ticks"  # the group of the positions on trajectories
OTHERS, ROTATION = "all-positions", "rotation"  # the groups of the thin positions, and of the drive's arrows
TIES = "ties"  # the group of the lines to mass centres off their links
# Paper around the plan of positions in sizes of its letters: numbers, symbols, and above it the dimension of a stroke.
MARGINS = Margins(3.5, 3.5, 5.0)
STEPS = 360  # of a circle that is cut at a figure's box
NOTCH = 9.0  # mm of a notch arc kept on each side of its meeting
HATCH, SLANT = 2.5, 0.02  # mm of hatching on the barred part of the crank circle, and its slant, rad
MARK, RIM = 20.0, 1.0  # what a dimension is held off a point's mark by: lines that it counts as, mm around it
SHARE = 0.3  # what a line of another position counts where a dimension looks for a clear place


class PositionFigure(NamedTuple):
    """A plan of positions placed on paper: its lines, and the letters still to be placed among those of all figures."""

    pairs: Pairs
    lines: tuple[Group, ...]

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure, its points lettered and its positions numbered."""
        figure = *self.lines, letters(self.pairs, labels)
        figure += special_letters(self.pairs, labels)
        if not apart(self.pairs.bones):
            return figure
        circle = _around(self.pairs)
        return *figure, Group((labels.beside(circle.centre, DETAIL, self.pairs.sheet.letter, circle.radius + 1.0),))


def measure(bones: Skeletons, name: str, drafting: Drafting) -> Picture:
    """Measure the room that a plan of positions needs: all its positions, letters around them, its heading above."""
    size, hand = drafting.hand.letter, drafting.hand
    title = text_width(Text(0j, drafting.word(NAME), hand.heading))
    side, below, above = (share * size for share in MARGINS)
    return picture(name, bones.points, ("l", "m"), Margins(side, below, above + 2.5 * hand.heading), title)


def draw(bones: Skeletons, room: Picture, spot: Spot, drafting: Drafting) -> PositionFigure:
    """Draw the plan of positions in its spot, with its title and its written scale above it."""
    pairs = Pairs(bones, room.place(*spot), drafting.hand)
    lines = Group(tuple(layers(pairs, drafting.language)), NAME)
    return PositionFigure(pairs, (headed(NAME, spot, drafting), lines))


DETAIL, CRANK = "I", "crank"  # the letter of the crank circle's detail, and the name of its figure
AROUND, SIZES = 2.0, (8.0, 16.0)  # mm outside a crank circle to that of its detail; letters that this is large
NUMBERED = Margins(2.0, 2.0, 2.0)  # paper around it, in sizes of its letters


def _around(pairs: Pairs) -> Circle:
    """Give the thin circle around what a detail shows."""
    radius = pairs.bones.crank(pairs.place) + AROUND * pairs.hand.symbol
    return Circle(pairs.bones.pivot(pairs.place), radius, pairs.hand.drafted)


def measure_detail(bones: Skeletons, drafting: Drafting) -> Picture:
    """Measure the room of a tiny crank circle drawn apart, with the numbers of its positions."""
    hand, drive = drafting.hand, bones.mechanism.drive
    pivot = bones.mechanism.links[FRAME].points[drive.pivot]
    radius = abs(bones.drive_end(0) - pivot)
    corners = [pivot + radius * way for way in (1, 1j, -1, -1j)]
    title = heading_width(drafting.word("detail", letter=DETAIL), hand)
    least, most = (size * hand.letter for size in SIZES)
    return picture(CRANK, corners, ("l", "m"), around(NUMBERED, hand), title, least)._replace(most=most)


def draw_detail(bones: Skeletons, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the crank in all positions on its circle, the shown one in full lines, enlarged (выносной элемент)."""
    pairs, drive = Pairs(bones, room.place(*spot), drafting.hand), bones.mechanism.drive
    place, hand, pivot = pairs.place, pairs.hand, bones.pivot(pairs.place)
    rays = [(place.on(station.crank), station) for station in crank_places(bones) if station.column != bones.shown]
    thin = (Line(pivot, end, hand.extreme if station.extreme else hand.drafted) for end, station in rays)
    marks = [circle for name in (drive.pivot, drive.end) for circle in pairs.hinges.get(name, ())]
    lines = [*_path(bones, place, hand), *thin, Line(pivot, place.on(bones.drive_end(bones.shown)), hand.result)]
    title = heading(spot.box, drafting.word("detail", letter=DETAIL), drafting.scale(spot.scale), drafting.hand)
    named = {name: pairs.named[name] for name in (drive.pivot, drive.end) if name in pairs.named}

    def lettered(labels: Labels) -> Iterator[Stroke]:
        yield from pairs.letters(named, labels)
        yield from crank_numbers(pairs, labels)

    return LetteredFigure(CRANK, (title, Group(tuple(fit_dashes(lines))), *marks), lettered)


def headed(title: str, spot: Spot, drafting: Drafting) -> Group:
    """Write the title of the largest figure, by its word, and its scale above it."""
    hand = drafting.hand
    at = complex(spot.box.centre.real, spot.box.top - hand.heading)
    under = at - 1j * (0.6 * hand.heading + hand.title)
    above = Text(at, drafting.word(title), hand.heading, "middle", True)
    return Group((above, Text(under, drafting.scale(spot.scale), hand.title, "middle", True)))


def layers(pairs: Pairs, language: str) -> list[Group]:
    """Draw the plan of positions at its place, from the thinnest lines to the pairs; its letters come last of all."""
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    subject = Subject(NAME, "r", bones.shown)
    body, stands = list(pairs.bars()), list(pairs.stands())
    blocks = [block for _, block in pairs.blocks]
    paths, positions = trajectories(bones, place, hand), [*_path(bones, place, hand), *_positions(pairs)]
    senses = arrows(pairs)
    extremes, lines, notches = list(_extremes(pairs)), axes(bones, place, hand), list(_notches(bones, place, hand))
    special = special_lines(bones, place, hand)
    notches += false_positions(bones, place, hand)
    ink = Ink()
    ink.draw([*body, *blocks, *stands])
    grounded = grounds(pairs, ink)
    ink.draw((Circle(place.on(at), pairs.radius(name) + RIM) for name, at in pairs.named.items()), MARK)
    ink.draw(grounded)
    ink.draw([*paths, *positions, *extremes, *lines, *notches, *special], SHARE)
    under: list[tuple[str, Iterable[Stroke]]] = [("paths", paths), (OTHERS, positions), ("extremes", extremes)]
    under += [("guides", lines), ("notches", notches), (TIES, ties(pairs)), (TICKS, path_ticks(pairs))]
    under += [("special-lines", special)]
    groups = [Group(tuple(fit_dashes(trim(lines, pairs.masks))), name) for name, lines in under]
    groups += [
        Group(tuple(grounded), "grounds"),
        Group((*blocks, *body, *pairs.corners()), "shown-position"),
        Group((*stands, *pairs.marks(subject, reference(bones.mechanism))), "pairs"),
        Group(tuple(special_spots(bones, subject, place, hand)), "special-points"),
        Group(tuple(strokes(bones, place, hand, language, ink)), "stroke"),
        Group((_around(pairs),) if apart(bones) else (), "detail"),
        Group(tuple(stating(Statement(Kind.DIRECTION, NAME, a.letter), *a.strokes(pairs)) for a in senses), ROTATION),
        Group(tuple(part for phase in phases(pairs, language) for part in phase.strokes(pairs)), "phases"),
        Group(tuple(part for swing in swings(pairs, language) for part in swing.strokes(pairs)), "swing"),
    ]
    return [group for group in groups if group.strokes]


def _path(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the way of the primary link's end: the crank's circle, or the stroke of a slider."""
    return (stroke_line if bones.mechanism.drive.pushed else _circle)(bones, place, hand)


def _circle(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the crank circle; hatch it where the crank cannot go, cross its gaps and change points."""
    pivot, radius, (low, high) = bones.pivot(place), bones.crank(place), bones.swept
    strokes: list[Stroke] = [Arc(pivot, radius, low, high, hand.drafted)] if low < high else []
    for barrier in bones.study.met:
        count = max(int((barrier.end - barrier.start) * radius / HATCH), 1)
        angles = (barrier.start + (barrier.end - barrier.start) * k / count for k in range(count + 1))
        for ray in (cmath.rect(1.0, angle) for angle in angles if bones.sweeps(angle)):
            tip = pivot + (radius + HATCH * hand.symbol) * ray * cmath.rect(1.0, SLANT)
            strokes.append(Line(pivot + radius * ray, tip, hand.drafted))
    crossed = [complex(d) for d in bones.study.turn.directions[bones.study.lost]]
    changes = (barrier.start for barrier in bones.study.met if barrier.kind == CHANGE_POINT)
    crossed += [cmath.rect(1.0, start) for start in changes if bones.sweeps(start)]
    return strokes + [arm for ray in crossed for arm in symbols.cross(pivot + radius * ray, hand)]


def _positions(pairs: Pairs) -> Iterable[Stroke]:
    """Draw the other positions thin; of very many, those between every so many only by a tick of the crank."""
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    extremes = {same(bones, k) for k in range(2)} if bones.extremes else set()
    every = drawn_every(bones.study)
    for k in range(len(bones.numbered)):
        if k == bones.shown or k in extremes:
            continue
        if k % every == 0:
            yield from _links(bones, bones.numbered, k, place, hand.drafted)
        elif not bones.study.lost[k] and bones.mechanism.drive.turns:  # of a stroke every position has its tick
            spot = place.on(bones.drive_end(k))
            ray = (spot - bones.pivot(place)) / bones.crank(place)
            yield symbols.tick(spot, 1j * ray, hand)


def drawn_every(study: LinkageStudy) -> int:
    """Tell which of the positions are drawn with all links: every so many from the first."""
    return max(math.ceil((len(study.turn) - (not study.mechanism.drive.turns)) / MANY), 1)


def _links(bones: Skeletons, poses: Poses, k: int, place: Place, style: LineStyle) -> Iterable[Stroke]:
    """Draw the bars of all links in a position that can be assembled, slots as far as their stones."""
    for outline in outlines(bones, reach_of(bones, poses, k)):
        for bar in outline.bars:
            start, end = (complex(poses.of(outline.link, spot)[k]) for spot in bar)
            if not math.isnan(start.real) and start != end:
                yield Line(place.on(start), place.on(end), style)
    cylinder = (ends for j, ends in enumerate(cylinders(bones, poses)) if j == k and not cmath.isnan(sum(ends)))
    yield from (Line(place.on(start), place.on(end), style) for start, end in cylinder)


def _extremes(pairs: Pairs) -> Iterable[Stroke]:
    bones = pairs.bones
    if bones.extremes is not None:
        for k in range(2):
            if same(bones, k) != bones.shown:
                yield from _links(bones, bones.extremes, k, pairs.place, pairs.hand.extreme)


def _notches(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Keep the notch arcs of the shown position, trimmed to their use; arcs that miss are drawn through the figure."""
    plan = bones.study.drafts().positions
    # The box around some places on paper, and a margin
    spots = [place.on(value) for value in bones.points]
    margin = NOTCH * hand.symbol
    across, up = [spot.real for spot in spots], [spot.imag for spot in spots]
    box = Field(min(across) - margin, min(up) - margin, max(across) + margin, max(up) + margin)
    arcs: list[Stroke] = []
    for mark in plan.board:
        for (source, ray), locus in zip(mark.rays, mark.step.inputs, strict=False):
            if mark.step.op == "meet" and isinstance(locus.value, Notch):
                centre, arm = place.on(at(source.point, bones.shown)), at(ray, bones.shown)
                if math.isnan(arm.real) and not math.isnan(centre.real):
                    whole = place.length(abs(at(locus.value.radius, 0)))
                    arcs += _within(Arc(centre, whole, 0, 2 * math.pi), box, hand)
                elif not math.isnan(arm.real):
                    radius, angle = place.length(abs(arm)), cmath.phase(arm)
                    half = min(NOTCH * hand.symbol / radius, math.pi)
                    arcs.append(Arc(centre, radius, angle - half, angle + half, hand.drafted))
    return arcs


def _within(circle: Arc, box: Field, hand: Hand) -> Iterator[Arc]:
    """Give the parts of a circle that lie in a figure's box: an arc that is never met may be larger than the paper."""
    step = 2 * math.pi / STEPS
    inside = [box.holds(circle.at(k / STEPS)) for k in range(STEPS + 1)]
    start = 0
    for is_inside, part in groupby(inside):
        count = len(list(part))
        if is_inside and count > 1:
            yield Arc(circle.centre, circle.radius, start * step, (start + count - 1) * step, hand.drafted)
        start += count
