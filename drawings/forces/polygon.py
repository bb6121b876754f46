"""A force polygon with its letters, and the detail of what is too small in it (план сил)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import groupby
from typing import NamedTuple

from drawings.forces.arms import largest
from drawings.forces.letters import CLOSING, WHOLE, letter_of
from drawings.kinds.polygon import Chain, ShownVector, carriers, ends, lay, letters, margins
from drawings.kinds.vector_plan import LEAST, directions
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import Segment
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.page.page import Drafting, Scale
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.strokes import LEAN, Circle, Group, Stroke, Text
from drawings.paper.walk import tied
from drawings.symbols.figure import LINE, Subject, heading, heading_width
from geometry.board import Line as Direction
from geometry.board import Mark, at, between
from geometry.meet import EPS
from plans.forces.cut import CutGroup, ForcePlan
from plans.model.motion import NOTHING

SHORT = 0.6  # sizes of a letter: a side of a plan of the least size that even twice as large has no room for its own
CROWDED = 2.0  # sizes of a letter: a side that has no room beside its own letter for that of a short one next to it
STUB = 0.2  # of a detail's size: how far the sides on either side of it are followed
HEADED = 1.5 * SEEN  # mm: a side whose head, two thirds of it, is seen
DETAIL_LETTERS, WIDEST = 9.0, 18.0  # a detail is drawn at least so many of its letters large, and at most


def details(shown: ForcePolygon, room: Picture, drafting: Drafting, before: int) -> tuple[ForcePolygon, ...]:
    """Give the details of a force plan: of each run of short sides of which one is not seen at the plan's least size.

    A lone one has a detail with a side next to it that would crowd its letter; else, where it is not seen, the sheet
    lists its name. `before` details of other plans have the first letters.
    """
    least = max(room.wide, room.high) / room.least if room.least else 0.0
    letters = drafting.word("detail letters")
    sides = [force for force in shown.forces if force.kind != WHOLE]
    sizes, unit = [abs(force.value) for force in sides], drafting.hand.letter * least
    runs = (run for run in _runs(sizes, drafting.hand.letter, least) if len(run) > 1)
    ends = ((run, min(sizes[k] for k in run), max(sizes[k] for k in run)) for run in runs)
    runs = (run for run, low, high in ends if low < SEEN * least or high >= SHORT * unit)
    named = zip(letters[before:], runs, strict=False)
    return tuple(
        shown._replace(forces=tuple(sides[k] for k in run), rays=tuple(_stubs(sides, run)), detail=letter)
        for letter, run in named
    )


def _runs(sizes: Sequence[float], letter: float, least: float) -> Iterator[list[int]]:
    """Give the runs of short sides, a lone one with the shorter side next to it, if a detail shows both."""
    small = {k for k, size in enumerate(sizes) if size < SHORT * letter * least}
    for k in [k for k in sorted(small) if not {k - 1, k + 1} & small]:
        near = min({k - 1, k + 1} & {*range(len(sizes))}, key=lambda one: sizes[one], default=k)
        if sizes[near] < letter * min(CROWDED * least, sizes[k] * WIDEST / HEADED):
            small.add(near)
    runs = groupby(range(len(sizes)), small.__contains__)
    yield from ([*run] for short, run in runs if short)


def _stubs(sides: Sequence[ShownVector], run: Sequence[int]) -> Iterator[Segment]:
    first, last = sides[run[0]], sides[run[-1]]
    points = [end for k in run for end in (sides[k].at, sides[k].end)]
    reach = STUB * max(abs(point - other) for point in points for other in points)
    if run[0] > 0:
        yield first.at - sides[run[0] - 1].direction * reach, first.at
    if run[-1] + 1 < len(sides):
        yield last.end + sides[run[-1] + 1].direction * reach, last.end


SYMBOL, UNIT = "F", "N"
DETAIL = "detail-"  # before a cut's links: the name of an enlarged detail of its force plan
MARGINS = Margins(3.0, 2.4, 2.4)  # paper around a polygon for its letters, in their sizes
LETTERS, EACH = 12.0, 1.6  # a polygon is drawn at least so many letters large, and so many for each of its vectors
WIDE = 2.7  # sizes of a letter between two lanes, with what it keeps clear of them
AROUND, BESIDE = 2.5, 1.0  # mm from what a detail shows to the circle around it, and on to its letter
# Rounding left where forces cancel, as a share of the greatest: a chain of some ten sides, each rounded a few times.
ZERO = 256 * EPS


class ForcePolygon(NamedTuple):
    """What one position of a force plan shows: its vectors in the order of laying, diagonals last, and directions."""

    label: str  # the links: "4-5"
    grouped: bool  # False: the primary link
    column: int  # place of the position among the constructed ones
    forces: tuple[ShownVector, ...]
    rays: tuple[Segment, ...]  # true ends of the lines of known direction: from their start to the meeting
    detail: str = ""  # the letter of a detail, of which only some sides are shown
    details: tuple[ForcePolygon, ...] = ()  # that show what is too small in it

    @property
    def plan(self) -> str:
        """The name of the plan that the vectors belong to."""
        return f"{DETAIL}{self.label}-{self.detail}" if self.detail else f"forces-{self.label}"

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        ends = [end for force in self.forces for end in (force.at, force.end)]
        return [*ends, *(end for ray in self.rays for end in ray)] if self.detail else [0j, *ends]

    @property
    def enlarged(self) -> set[str]:
        """The names of what its details show."""
        return {side.name for detail in self.details for side in detail.forces}

    def faint(self, mu: float) -> tuple[str, ...]:
        """Name the forces that are to be seen neither at a scale, N/mm, nor in a detail: a sheet lists them beside."""
        shown = self.enlarged
        return tuple(one.name for one in self.forces if abs(one.value) < SEEN * mu and one.name not in shown)


def polygon(plan: ForcePlan, cut: CutGroup, column: int) -> ForcePolygon:
    """Read a force polygon from its record; forces that are zero are left out, all where no force acts on the cut."""
    named = {side.name: _vector(side.name, side.kind, side.start, side.end, column) for side in cut.sides}
    for support in cut.reactions:
        mark = support.force
        if mark.step.op == "join":
            start, end = mark.step.inputs
            named.setdefault(mark.name, _vector(mark.name, WHOLE, start, end, column))
    greatest = max((abs(vector.value) for vector in named.values()), default=0.0)
    least = math.inf if greatest <= NOTHING * largest(plan, column) else ZERO * greatest
    kept = tuple(vector for vector in named.values() if not abs(vector.value) <= least)  # what is unknown is kept
    closing = {corner for side in cut.sides if side.kind == CLOSING for corner in (side.start, side.end)}
    rays = tuple(ray for corner in cut.sides for ray in _rays(corner.start, column) if corner.start in closing)
    return ForcePolygon(cut.label, cut.group is not None, column, kept, rays)


def _vector(name: str, kind: str, start: Mark, end: Mark, column: int) -> ShownVector:
    return ShownVector(name, kind, at(start.point, column), at(between(start, end), column))


def _rays(corner: Mark, column: int) -> list[Segment]:
    if corner.step.op != "meet":
        return []
    met = [line.value for line in corner.step.inputs if isinstance(line.value, Direction)]
    return [(at(line.through, column), at(corner.point, column)) for line in met]


def measure(shown: ForcePolygon, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs: its points, letters around them, lanes beside a flat one, its heading.

    There is room for the names of all forces that are neither to be seen at its least size nor shown in details.
    """
    hand = drafting.hand
    title = heading_width(_title(shown, drafting), hand)
    least = hand.letter * max(LETTERS, EACH * len(shown.forces))
    room = picture(shown.plan, shown.points, (SYMBOL, UNIT), margins(shown.points, MARGINS, hand), title, least)
    mu = max(room.wide, room.high) / least
    faint = shown.faint(mu)
    if faint:
        wide = max(title, room.wide / mu + 2 * room.margins.side) if mu else title
        lines = _under(shown, faint, Scale(mu, SYMBOL, UNIT), wide, drafting)
        above = room.margins.above + (len(lines) - 1) * LINE * hand.text
        room = room._replace(heading=wide, margins=room.margins._replace(above=above))
    if shown.detail:
        shortest = max(room.wide, room.high) / min(abs(force.value) for force in shown.forces)
        most = WIDEST * hand.letter
        room = room._replace(least=min(max(DETAIL_LETTERS * hand.letter, HEADED * shortest), most), most=most)
    return room


def draw(shown: ForcePolygon, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the polygon in its spot: sides in main lines, the rest thinner, what a detail enlarges circled."""
    place, hand, letter = room.place(*spot), drafting.hand, partial(letter_of, drafting=drafting)
    chain = lay(shown.forces, WHOLE, place, spot.box, WIDE, hand, LEAST, shown.enlarged)
    sides = chain.sides(Subject(shown.plan, SYMBOL, shown.column), WHOLE, letter, place, hand)
    thin = [*directions(shown.rays, place, hand), *carriers(chain.seen, place, hand)]
    faint = shown.faint(place.scale.mu)
    circles = {detail.detail: _circle(detail, place, hand) for detail in shown.details}
    under, *further = _under(shown, faint, spot.scale, spot.box.width, drafting)
    title = heading(spot.box, _title(shown, drafting), under, hand, *further)
    around = (Group((circle,), "", {"kind": "detail", "name": name}) for name, circle in circles.items())
    lines = (title, *([Group(tuple(thin))] if thin else []), *sides, *around)
    return LetteredFigure(f"{shown.plan}-{shown.column}", lines, partial(_letter, chain, circles, drafting))


def _letter(chain: Chain, circles: Mapping[str, Circle], drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    size = drafting.hand.letter
    short = [side.ends for side in chain.short if tied(abs(side.ends[1] - side.ends[0])) >= SEEN]
    yield from letters(chain.seen, lambda name: (letter_of(name, drafting), size), labels, short)
    for name, circle in circles.items():
        yield labels.beside(circle.centre, name, size, circle.radius + BESIDE)


def _circle(detail: ForcePolygon, place: Place, hand: Hand) -> Circle:
    spots = [end for force in detail.forces for end in ends(force, place)]
    middle = sum(spots) / len(spots)
    return Circle(middle, max(abs(spot - middle) for spot in spots) + AROUND * hand.symbol, hand.drafted)


def _under(shown: ForcePolygon, faint: tuple[str, ...], scale: Scale, wide: float, drafting: Drafting) -> list[str]:
    """Write the scale, and beside it, or on lines below, the forces that are too short to bear a letter."""
    if not shown.forces:
        return [drafting.word("unloaded")]
    names = ", ".join(letter_of(name, drafting) for name in faint)
    text = drafting.scale(scale)
    return _broken(f"{text};  {drafting.word('unlettered', names=names)}", wide, drafting.hand) if faint else [text]


def _broken(text: str, wide: float, hand: Hand) -> list[str]:
    lines = [""]
    for part in text.split(" "):
        longer = f"{lines[-1]} {part}" if lines[-1] else part
        if lines[-1] and text_width(Text(0j, longer, hand.text)) + 2 * LEAN * hand.text > wide:
            lines.append(part)
        else:
            lines[-1] = longer
    return lines


def _title(shown: ForcePolygon, drafting: Drafting) -> str:
    if shown.detail:
        return drafting.word("detail", letter=shown.detail)
    key = "force plan" if shown.grouped else "primary force plan"
    return f"{drafting.word(key, group=shown.label)}, {drafting.word('position', position=shown.column)}"
