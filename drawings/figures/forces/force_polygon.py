"""The figure of a force plan: the polygon of one group, or of the primary link, at one position (план сил)."""

from __future__ import annotations

import cmath
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.figures.forces.force_letters import letter_of
from drawings.figures.forces.shown_force import CLOSING, WHOLE, ShownForce
from drawings.figures.linkage.vector_plan import BEYOND, LEAST
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import APART, Box, Segment, lanes, moved
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.place import Place
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.strokes import LEAN, Group, Line, LineStyle, Stroke, Text
from drawings.symbols.figure import Subject, heading
from drawings.symbols.symbols import arrowhead
from geometry.board import Line as Direction
from geometry.board import Mark, at, between
from geometry.meet import EPS
from plans.forces.cut import Cut
from plans.forces.force import ForcePlan

SYMBOL, UNIT = "F", "N"
MARGINS = Margins(3.0, 2.4, 2.4)  # paper around a polygon for its letters, in their sizes
FLAT = 0.1  # of its length: a polygon that is narrower is drawn in lanes
LETTERS, EACH = 12.0, 1.6  # a polygon is drawn at least so many letters large, and so many for each of its vectors
BESIDE = 0.9  # mm from a vector to its letter
ROOM = 2.7 + 1.9j  # width + 1j * height of a letter between two lanes, in its sizes, with what it keeps clear of them
PAST = 1.0  # mm that the thin lines to a lane run past it
# Rounding left where forces cancel, as a share of the greatest: a chain of some ten sides, each rounded a few times.
ZERO = 256 * EPS


class Polygon(NamedTuple):
    """What one position of a force plan shows: its vectors in the order of laying, diagonals last, and directions."""

    label: str  # the links: "4-5"
    grouped: bool  # False: the primary link
    column: int  # place of the position among the constructed ones
    forces: tuple[ShownForce, ...]
    rays: tuple[Segment, ...]  # true ends of the lines of known direction: from their start to the meeting

    @property
    def plan(self) -> str:
        """The name of the plan that the vectors belong to."""
        return f"forces-{self.label}"

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(end for one in self.forces for end in (one.at, one.end))]

    def faint(self, mu: float) -> tuple[str, ...]:
        """Name the forces that are not to be seen at a scale, N/mm: a sheet lists them beside."""
        return tuple(one.name for one in self.forces if abs(one.value) < SEEN * mu)


def polygon(plan: ForcePlan, cut: Cut, column: int) -> Polygon:
    """Read a force polygon from its record; forces that are zero are left out."""
    named = {side.name: _vector(side.name, side.kind, side.start, side.end, column) for side in cut.sides}
    for support in cut.reactions:
        mark = support.force
        if mark.step.op == "join":
            named.setdefault(mark.name, _vector(mark.name, WHOLE, *_ends(mark), column))
    greatest = max((abs(one.value) for one in named.values()), default=0.0)
    kept = tuple(one for one in named.values() if not abs(one.value) <= ZERO * greatest)  # what is unknown is kept
    closing = {corner for side in cut.sides if side.kind == CLOSING for corner in (side.start, side.end)}
    rays = tuple(ray for corner in cut.sides for ray in _rays(corner.start, column) if corner.start in closing)
    return Polygon(cut.label, cut.group is not None, column, kept, rays)


def _ends(mark: Mark) -> tuple[Mark, Mark]:
    start, end = mark.step.inputs
    return start, end


def _vector(name: str, kind: str, start: Mark, end: Mark, column: int) -> ShownForce:
    return ShownForce(name, kind, at(start.point, column), at(between(start, end), column))


def _rays(corner: Mark, column: int) -> list[Segment]:
    """Give the lines that meet in a corner, each from where it was drawn."""
    if corner.step.op != "meet":
        return []
    met = [line.value for line in corner.step.inputs if isinstance(line.value, Direction)]
    return [(at(line.through, column), at(corner.point, column)) for line in met]


class LaidForce(NamedTuple):
    """A force on paper: its ends, mm, and how far it was shifted from its own place."""

    force: ShownForce
    ends: Segment
    shift: complex


@dataclass(frozen=True)
class PolygonFigure:
    """A polygon placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: Polygon
    place: Place
    lines: tuple[Stroke, ...]
    arrows: tuple[LaidForce, ...]  # the vectors that are seen
    faint: tuple[str, ...]  # names of forces that are not to be seen at this scale
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure with the letter of each vector beside it, the shortest served first."""
        spots = [end for arrow in self.arrows for end in arrow.ends]
        middle = sum(spots, 0j) / max(len(spots), 1)
        letters = []
        for one, (start, end), shift in sorted(self.arrows, key=lambda arrow: abs(arrow.force.value)):
            outward = shift or (start + end) / 2 - middle or 1j
            letter = letter_of(one.name, self.drafting)
            letters.append(labels.along(start, end, letter, self.drafting.hand.letter, BESIDE, cmath.phase(outward)))
        return (Group((*self.lines, Group(tuple(letters))), f"{self.shown.plan}-{self.shown.column}"),)


def measure(shown: Polygon, name: str, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs: its points, letters around them, lanes beside a flat one, its heading."""
    hand = drafting.hand
    title = text_width(Text(0j, _title(shown, drafting), hand.title)) + 2 * LEAN * hand.title
    points = np.array(shown.points)
    wide, high = float(np.ptp(points.real)), float(np.ptp(points.imag))
    beside = 2 * APART * hand.symbol if min(wide, high) < FLAT * max(wide, high) else 0.0
    side, below, above = (size * hand.letter + beside for size in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    least = hand.letter * max(LETTERS, EACH * len(shown.forces))
    return picture(name, shown.points, (SYMBOL, UNIT), margins, title, least)


def draw(shown: Polygon, room: Picture, spot: Spot, drafting: Drafting) -> PolygonFigure:
    """Draw the polygon in its spot: its sides in main lines, diagonals thinner, directions thin, title above."""
    place, hand = room.placed(*spot), drafting.hand
    told = [one for one in shown.forces if place.length(abs(one.value)) >= LEAST]
    order = sorted((one for one in told if place.length(abs(one.value)) >= SEEN), key=_rank)
    segments = [(place.on(one.at), place.on(one.end)) for one in order]
    shifts = lanes(segments, APART * hand.symbol, ROOM * hand.letter, _inside(spot.box, hand))
    placed = zip(order, segments, shifts, strict=True)
    arrows = tuple(LaidForce(one, moved(line, shift), shift) for one, line, shift in placed)
    subject = Subject(shown.plan, SYMBOL, shown.column)
    short = [(one, (place.on(one.at), place.on(one.end))) for one in told if one not in order]
    drawn = [
        _side(subject, letter_of(one.name, drafting), one, line, place, hand)
        for one, line in (*((one, line) for one, line, _ in reversed(arrows)), *short)
    ]
    thin = [*_directions(shown, place, hand), *_carried(segments, shifts, hand)]
    faint = shown.faint(place.scale.mu)
    title = heading(spot.box, _title(shown, drafting), _under(shown, faint, spot, drafting), hand)
    lines = (title, *([Group(tuple(thin))] if thin else []), *drawn)
    return PolygonFigure(shown, place, lines, arrows, faint, drafting)


def _under(shown: Polygon, faint: tuple[str, ...], spot: Spot, drafting: Drafting) -> str:
    """Write the scale, and beside it the forces that are too short to bear a letter."""
    if not shown.forces:
        return drafting.word("unloaded")
    names = ", ".join(letter_of(name, drafting) for name in faint)
    scale = drafting.scale(spot.scale)
    return f"{scale};  {drafting.word('unlettered', names=names)}" if faint else scale


def _inside(box: Field, hand: Hand) -> Box:
    """Give the part of a figure's box that a lane may run in: its letter has room beside it, the heading above."""
    wide, high = ROOM.real * hand.letter, ROOM.imag * hand.letter
    return box.left + wide, box.bottom + high, box.right - wide, box.top - 2 * hand.title - hand.text - high


def _rank(one: ShownForce) -> tuple[bool, float]:
    """Rank a vector by who keeps its place where several run along one another: sides, the longest first."""
    return one.kind == WHOLE, -abs(one.value)


def _side(subject: Subject, letter: str, one: ShownForce, ends: Segment, place: Place, hand: Hand) -> Group:
    style = hand.relative if one.kind == WHOLE else hand.result
    head = arrowhead(*ends, hand.symbol)
    strokes = (Line(*ends, style),) if head is None else (Line(*ends, style), head)
    return Group(strokes, "", subject.data("vector", one.name, one.value, place.scale), letter)


def _directions(shown: Polygon, place: Place, hand: Hand) -> list[Stroke]:
    """Draw each line of known direction from a little before its start to a little past the meeting."""
    drawn: list[Stroke] = []
    for start, end in shown.rays:
        first, last = place.on(start), place.on(end)
        if abs(last - first) >= LEAST:
            along = (last - first) / abs(last - first) * BEYOND * hand.symbol
            drawn.append(Line(first - along / 2, last + along, hand.drafted))
    return drawn


def _carried(segments: list[Segment], shifts: list[complex], hand: Hand) -> list[Stroke]:
    """Draw the thin lines that carry the ends of a vector over to its lane."""
    style = LineStyle(hand.construction)
    return [
        Line(end, end + shift + shift / abs(shift) * PAST * hand.symbol, style)
        for ends, shift in zip(segments, shifts, strict=True) if shift for end in ends
    ]  # fmt: skip


def _title(shown: Polygon, drafting: Drafting) -> str:
    key = "force plan" if shown.grouped else "primary force plan"
    return f"{drafting.word(key, group=shown.label)}, {drafting.word('position', position=shown.column)}"
