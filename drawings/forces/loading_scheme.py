"""The loading scheme of a cut in one position: links to scale, a larger force by a longer arrow (схема нагружения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from itertools import product

from drawings.forces.arms import aside
from drawings.forces.letters import KNOWN, PRESSING, letter_of
from drawings.forces.scheme import UNSIZED, Scheme, coupled, drawn_circles, drawn_springs, fan, lengths
from drawings.kinds.polygon import ShownVector
from drawings.kinds.scheme import Joints, link_numbers, ties
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels, free_side
from drawings.layout.parallel_offsets import Segment, merging
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import bounds, text_width
from drawings.lettering.words import with_index
from drawings.page.page import Drafting, Field, Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Kind, Line, Statement, Stroke, Text
from drawings.paper.walk import stating, tied
from drawings.symbols.couples import HALF, THREE_QUARTERS, CoupleArc, ForceArrow, Gear, letter_each, not_to_scale
from drawings.symbols.figure import LINE, SQUARE, Arm, Dimension, Subject, heading, plain_name, to_scale
from drawings.symbols.symbols import BLOCK, MASS, fit_dashes
from plans.forces.drive import DRIVING

GUIDE = 16.0  # mm of a guide's axis on either side of its slider
RADIUS, BLOCKED, APART = 6.5, 9.0, 2.5  # mm: radius of a couple's arc, about a block, and what each further is wider
DIMENSION, LAYOUT_LEAST = 9.0, 0.5  # mm: from a guide to the dimension along it; the least shown
FACINGS = 12  # directions that an arc may face
BAR, ARROW, THIN = 3.0, 6.0, 1.0  # thin lines that a link, an arrow and an arm count as
ZERO = "zero"  # of the mark from which the places of a scheme are told
NARROW = 0.4  # what an arc of half a turn costs against one of three quarters


@dataclass(frozen=True)
class SchemeLayout:
    """A scheme at its place on paper."""

    shown: Scheme
    place: Place
    drafting: Drafting
    box: Field | None  # None: as much room as is asked for

    @cached_property
    def joints(self) -> Joints:
        """Links and pairs on paper."""
        return Joints(self.shown.links, self.place, self.drafting.hand)

    @property
    def hand(self) -> Hand:
        """The hand of the pairs' symbols."""
        return self.joints.hand

    def letter(self, name: str) -> str:
        """Write a force's or a moment's letter as the sheet's language does."""
        return letter_of(name, self.drafting)

    @cached_property
    def links(self) -> list[Stroke]:
        """The links with their pairs; under them the axes of guides."""
        joints = self.joints
        under = [*self._axes(), *ties(joints)]
        return [*under, *joints.bars(), *(block for _, block in joints.blocks), *joints.corners(), *joints.stands()]

    def _axes(self) -> Iterator[Stroke]:
        ends = [self.place.on(shift.end) for shift in self.shown.acting.shifts]
        for at, along in self.shown.links.guides:
            spot = self.place.on(at)
            reach = [((end - spot) * along.conjugate()).real for end in ends]
            low, high = min([0.0, *reach]), max([0.0, *reach])
            more = GUIDE * self.hand.symbol
            yield from fit_dashes([Line(spot + (low - more) * along, spot + (high + more) * along, self.hand.axis)])

    @cached_property
    def marks(self) -> list[Stroke]:
        """Hinges, mass centres and other points, each under its letter."""
        symbols: list[Stroke] = []
        for name, value in self.shown.named.items():
            symbol = self.joints.symbol(name, self.place.on(value), name in self.shown.centres)
            symbols.append(Group(symbol, "", {}, name))
        zero = Statement(Kind.AXIS, self._plan, ZERO, self.shown.column, self.place.scale.mu)
        return [stating(zero, symbols[0]), *symbols[1:]] if symbols else []

    @cached_property
    def gear(self) -> Gear | None:
        """The wheel that drives the crank."""
        wheel = self.shown.wheel
        if wheel is None:
            return None
        return Gear(self.place.on(wheel.centre), self.place.length(wheel.radius), wheel.at, wheel.action)

    @property
    def _plan(self) -> str:
        return f"scheme {self.shown.cut.label}"

    @cached_property
    def arms(self) -> list[Arm]:
        """The arms to scale, measurable, the longest last: none lies on a force or on a link."""
        lines = [ends for a in self.arrows for ends in ((a.start, a.tip), (a.lead or a.at, a.at))]
        return aside(sorted(self._bare, key=lambda arm: tied(arm.length)), [*lines, *self.rods], self.box, self.hand)

    @cached_property
    def rods(self) -> list[Segment]:
        """The lines of the links on paper."""
        return [bar for outline in self.joints.outlines for bar in self.joints.placed(outline) if bar[0] != bar[1]]

    @cached_property
    def _bare(self) -> list[Arm]:
        subject = Subject(self._plan, "h", self.shown.column)
        on, scale = self.place.on, self.place.scale
        faint = self.shown.faint(scale.mu)
        arms = (arm for arm in self.shown.dimensioned if arm.letter not in faint)
        return [to_scale(arm.letter, on(arm.pivot), on(arm.at), arm.direction, scale, subject) for arm in arms]

    @cached_property
    def shifts(self) -> list[Dimension]:
        """How far from their sliders' points guides press, beyond the block from where the reaction comes."""
        dimensions = []
        for shift in self.shown.acting.shifts:
            start, end = self.place.on(shift.start), self.place.on(shift.end)
            ahead = shift.value / abs(shift.value)
            dimensions.append(Dimension(self.letter(shift.name), start, end, DIMENSION * self.hand.symbol * ahead))
        return [dimension for dimension in dimensions if dimension.length >= LAYOUT_LEAST]

    @cached_property
    def arrows(self) -> list[ForceArrow]:
        """The forces, placed among links and arms."""
        forces = self.shown.acting.forces
        known = iter(lengths([abs(force.value) for force in forces if force.kind == KNOWN]))
        sizes = [next(known) if force.kind == KNOWN else UNSIZED for force in forces]
        arrows = [self._arrow(force, size) for force, size in zip(forces, sizes, strict=True)]
        box = self.box
        if box is not None:
            box = box.inset(self.drafting.hand.letter)
        spots = [self.place.on(spot) for spot in self.shown.named.values()]
        reaches = [(self._reach(force), self._sides(force, arrow)) for force, arrow in zip(forces, arrows, strict=True)]
        return fan(arrows, reaches, self._around, spots, box, self.hand)

    def _sides(self, force: ShownVector, arrow: ForceArrow) -> list[int]:
        """Give the sides to which a force may stand that would run in a link's line: none across a point of moments."""
        both = ((arrow.at, arrow.at + sign * arrow.length * arrow.direction) for sign in (1, -1))
        if not all(any(merging(line, rod) for rod in self.rods) for line in both):
            return []
        pivots = [self.place.on(arm.pivot) - arrow.at for arm in self.shown.arms if arm.name == force.name]
        return [side for side in (-1, 1) if all(side * (arrow.direction.conjugate() * to).imag < 0 for to in pivots)]

    def _arrow(self, force: ShownVector, length: float) -> ForceArrow:
        """Give a force's arrow at its point; that of a guide presses on its slider."""
        at, size = self.place.on(force.at), length * self.hand.symbol
        letter = self.letter(force.name)
        return not_to_scale(letter, force.direction, at, size, force.kind == PRESSING, force.kind != KNOWN)

    def _reach(self, force: ShownVector) -> float:
        """Give how far from a force's point symbols reach: its slider's block, where a guide's reaction meets that."""
        (length, width), at = (size / 2 * self.hand.symbol for size in BLOCK), self.place.on(force.at)
        pressing = force.kind == PRESSING and any(abs(at - spot) <= length for spot in self._blocks)
        return width if pressing else self._rim(force.spot)

    @property
    def _blocks(self) -> list[complex]:
        return [sum(block.points) / len(block.points) for _, block in self.joints.blocks]

    def _rim(self, spot: str) -> float:
        if spot in self.shown.centres and spot not in self.joints.hinges:
            return MASS * self.hand.symbol
        return self.joints.radius(spot) if spot in self.shown.named else 0.0

    def clear(self, name: str) -> float:
        """Give how far from a point letters stand clear of its symbols."""
        return max(self.joints.clear(name), self._rim(name))

    @property
    def _around(self) -> list[tuple[Stroke, float]]:
        thick = [(stroke, BAR) for stroke in self.links]
        marks = [(mark, BAR) for mark in self.marks]
        thin = [(Line(arm.about, arm.foot), THIN) for arm in self._bare]
        thin += [(Line(*ends), THIN) for shift in self.shifts for ends in shift.lines]
        wheel = [] if self.gear is None else [(stroke, THIN) for stroke in self.gear.draw(self.hand)[:1]]
        return [*thick, *marks, *thin, *wheel, *((group, THIN) for group in self.attached)]

    @cached_property
    def attached(self) -> list[Group]:
        """Springs and friction circles."""
        return [*drawn_springs(self.shown, self.place, self.hand), *drawn_circles(self.shown, self.place, self.hand)]

    @cached_property
    def coupling(self) -> tuple[Group, ...]:
        """The coupling that drives the crank, among what is there."""
        return tuple(coupled(self.shown, self.place, self.hand, self._felt()))

    def _felt(self) -> Ink:
        ink = Ink()
        for stroke, weight in self._around:
            ink.draw([stroke], weight)
        apart, near = [arm for arm in self.arms if arm.aside], SQUARE * self.hand.symbol
        ink.draw((stroke for arm in apart for stroke in arm.draw(self.hand)), THIN)
        ink.draw((Circle(end, near) for arm in apart for end in arm.ends), BAR)  # heads and squares
        ink.draw((arrow.shaft for arrow in self.arrows), ARROW)
        ink.draw((Line(arrow.lead, arrow.at) for arrow in self.arrows if arrow.lead is not None), THIN)
        return ink

    @cached_property
    def couples(self) -> list[CoupleArc]:
        """The moments as arcs: each faces where it crosses the fewest lines; one about a point is inside the next."""
        ink, arcs = self._felt(), list[CoupleArc]()
        for moment in self.shown.acting.moments:
            at = self.place.on(moment.at)
            before = [other for other in arcs if abs(other.at - at) < RADIUS]
            least = BLOCKED if any(abs(spot - at) < RADIUS for spot in self._blocks) else RADIUS
            radius = (least + APART * len(before)) * self.hand.symbol
            arc = CoupleArc(self.letter(moment.name), at, moment.sense, radius)
            ways = product((THREE_QUARTERS, HALF), (2 * math.pi * k / FACINGS for k in range(FACINGS)))
            choices = (arc._replace(facing=facing, sweep=sweep) for sweep, facing in ways)
            arcs.append(min(choices, key=partial(self._crossing, before, ink)))
        return arcs

    def _crossing(self, before: Sequence[CoupleArc], ink: Ink, arc: CoupleArc) -> tuple[int, float]:
        return arc.crowded(before), ink.crossed_by([arc.draw(self.hand)]) + NARROW * (arc.sweep == HALF)

    def _hidden(self, spot: complex) -> bool:
        """Tell whether a block would hide the arrowhead of an arm that ends at a place."""
        corners = [[abs(corner - spot) for corner in block.points] for _, block in self.joints.blocks]
        sizes = (abs(block.points[0] - block.points[2]) for _, block in self.joints.blocks)
        return any(max(reach) <= size for reach, size in zip(corners, sizes, strict=True))

    def _arm(self, arm: Arm) -> tuple[Stroke, ...]:
        said = Statement(Kind.POINT, self._plan, plain_name(arm.letter), self.shown.column, self.place.scale.mu)
        strokes = list(arm.draw(self.hand))
        first = 1 if arm.aside else -1  # the line from the point to an arm aside of it, or the arm
        strokes[first] = stating(said, strokes[first])
        return tuple(strokes)

    def _stated(self, kind: Kind, mark: Dimension | ForceArrow | CoupleArc) -> Stroke:
        said = Statement(kind, self._plan, plain_name(mark.letter), self.shown.column, self.place.scale.mu)
        drawn = mark.draw(self.hand)
        return stating(said, *((drawn,) if isinstance(drawn, Group) else drawn))

    def strokes(self) -> Iterator[Stroke]:
        """Draw everything but letters, from the thinnest lines to the arrows."""
        hand = self.hand
        over = [arm for arm in self.arms if any(self._hidden(end) for end in arm.ends)]
        arms = tuple(stroke for arm in self.arms if arm not in over for stroke in self._arm(arm))
        arms += tuple(self._stated(Kind.VECTOR, shift) for shift in self.shifts)
        yield from [Group(arms)] if arms else []
        if self.gear is not None and self.shown.wheel is not None:
            yield Group(self.gear.draw(hand, self.shown.wheel.whole))
        yield Group((*self.links, *self.attached, *self.coupling, *self.marks))
        yield from [Group(tuple(stroke for arm in over for stroke in self._arm(arm)))] if over else []
        leads = tuple(Line(arrow.lead, arrow.at, hand.drafted) for arrow in self.arrows if arrow.lead is not None)
        forces: tuple[Stroke, ...] = (*leads, *(self._stated(Kind.DIRECTION, arrow) for arrow in self.arrows))
        yield from [Group(forces)] if forces else []
        couples = tuple(self._stated(Kind.DIRECTION, couple) for couple in self.couples)
        yield from [Group(couples)] if couples else []


NEAR = 4.0  # mm beyond its letter: lines that end so near to a point are lines at it
LEAST = 14.0  # a scheme is drawn at least so many of its letters large: below, its forces hide it
LETTERS, BESIDE = 1.6, 2.4  # letters' sizes below and above the lines of a scheme, and beside them


def measure(shown: Scheme, drafting: Drafting) -> Picture:
    """Measure the room that a scheme needs: its links to scale, and what of its arrows is outside them, in mm."""
    hand, name = drafting.hand, f"scheme-{shown.cut.label}"
    least = LEAST * hand.letter
    bare = picture(name, shown.points, ("l", "m"), Margins(0, 0, 0), 0.0)
    solid = picture(name, shown.solid, ("l", "m"), Margins(0, 0, 0), 0.0)
    extent, links = max(bare.wide, bare.high), max(solid.wide, solid.high)
    least *= extent / links if links else 1.0  # the links are as large beside a long spring as without one
    bare = bare._replace(least=least if extent else 0.0)  # a lone point is not drawn smaller at any scale
    place = Place(0j, bare.middle, Scale((extent or 1.0) / least, "l", "m"))
    left, bottom, right, top = bounds(Group(tuple(SchemeLayout(shown, place, drafting, None).strokes())))
    wide, high = bare.wide / place.scale.mu / 2, bare.high / place.scale.mu / 2
    around, further = LETTERS * hand.letter, _further(shown, place.scale.mu, drafting)
    side = max(-left - wide, right - wide, 0.0) + BESIDE * hand.letter
    margins = Margins(side, max(-bottom - high, 0.0) + around, max(top - high, 0.0) + around + _head(hand, further))
    heads = [Text(0j, _title(shown, drafting), hand.title), *(Text(0j, line, hand.text) for line in further)]
    return bare._replace(margins=margins, heading=max(map(text_width, heads)))


def _head(hand: Hand, further: Sequence[str]) -> float:
    return 1.6 * hand.title + (2 + LINE * len(further)) * hand.text


def _further(shown: Scheme, mu: float, drafting: Drafting) -> list[str]:
    """Say under the title which flank of the driving teeth bears, and what arms a scale, m/mm, leaves too short."""
    pressed = any(force.name == DRIVING for force in shown.acting.forces)
    lines = [drafting.word(shown.wheel.flank)] if shown.wheel is not None and pressed else []
    faint = ", ".join(shown.faint(mu))
    return [*lines, drafting.word("unlettered", names=faint)] if faint else lines


def _title(shown: Scheme, drafting: Drafting) -> str:
    key = "primary scheme" if shown.cut.group is None else "loading scheme"
    return f"{drafting.word(key, group=shown.cut.label)}, {drafting.word('position', position=shown.column)}"


@lru_cache(maxsize=16)
def _layout(shown: Scheme, room: Picture, spot: Spot, drafting: Drafting) -> SchemeLayout:
    place, box = room.place(*spot), spot.box
    head = _head(drafting.hand, _further(shown, place.scale.mu, drafting))
    return SchemeLayout(shown, place, drafting, box._replace(top=box.top - head))


def drawn_aside(shown: Scheme, room: Picture, spot: Spot, drafting: Drafting) -> bool:
    """Tell whether in the scheme's spot a force is drawn beside its line of action."""
    return any(arrow.beside for arrow in _layout(shown, room, spot, drafting).arrows)


def draw(shown: Scheme, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the scheme in its spot, with its title and its written scale above it."""
    place, hand = room.place(*spot), drafting.hand
    further = _further(shown, place.scale.mu, drafting)
    layout = _layout(shown, room, spot, drafting)
    under = f"{drafting.scale(spot.scale)};  {drafting.word('not to scale')}"
    title = heading(spot.box, _title(shown, drafting), under, hand, *further)
    name = f"scheme-{shown.cut.label}-{shown.column}"
    return LetteredFigure(name, (title, *layout.strokes()), partial(_letters, layout, hand))


def _letters(layout: SchemeLayout, hand: Hand, labels: Labels) -> Iterator[Stroke]:
    rods = (Line(*rod) for rod in layout.rods)
    yield from letter_each(layout.arms, labels, hand, (*layout.arrows, *layout.couples, *rods))
    for shift in layout.shifts:
        yield labels.beside(shift.middle, shift.letter, hand.letter, 0.8, cmath.phase(shift.off))
    lines = [line for line in layout.links if isinstance(line, Line)] + [arrow.shaft for arrow in layout.arrows]
    for name, value in layout.shown.named.items():
        spot, gap = layout.place.on(value), layout.clear(name) + 1.0
        yield labels.beside(spot, with_index(name), hand.letter, gap, free_side(spot, lines, gap + NEAR))
    yield from letter_each([*layout.arrows, *layout.couples], labels, hand)
    if layout.gear is not None and layout.gear.slants(layout.hand):
        middle, turn = layout.gear.angle(layout.hand)
        yield labels.beside(middle, "α", hand.letter, 1.0, turn)
    yield from link_numbers(layout.joints, layout.shown.links.links, labels, hand)
