"""The diagrams of a cam's law one under another over its turn: S'', S' by a pole, S by another (диаграммы движения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from drawings.cam.law_frame import LEVEL, LawFrame, LawPlate, LawRow
from drawings.cam.notes import ACCELERATION, VELOCITY, letters, phase_letter
from drawings.kinds.axes import BEYOND, Axes, Curve, Letter, Part, Pole, caption, wide
from drawings.layout.labels import Labels
from drawings.layout.picture import Picture, Spot
from drawings.lettering.extent import every
from drawings.lettering.lettering import text_width
from drawings.lettering.phrase import Slot, joined, telling
from drawings.page.scale import Drafting, Scale
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, LineStyle, Polyline, Stroke, Text
from drawings.paper.walk import apart, stating, tied
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.dimension import Dimension
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import TICK, arrowhead
from drawings.symbols.trimming import around, trim
from geometry.strips import middles
from plans.cam.diagrams import LawDiagrams, Strips
from plans.cam.sizing import RATIO

POLES = {True: ("P_1", "H_1"), False: ("P_2", "H_2")}  # of the acceleration; of the velocity
POLE_APART = 0.7  # sizes of a letter between the ends of two rays that are drawn
OFF = 1.2  # sizes of a letter from the highest ray to the dimension of the pole distance


def letters_of(row: LawRow) -> tuple[str, str]:
    """Give the letters of a row's pole and of its distance."""
    return POLES[row.key == ACCELERATION]


def pole_part(row: LawRow, plate: LawPlate, axes: Axes, distance: float) -> Part:
    """Draw the pole at its distance, mm, and rays to the mean ordinates that lie apart, each carried to its strip."""
    size, shown = plate.hand.letter, plate.shown
    means = shown.means if row.key == ACCELERATION else shown.travel.means
    off = 1j * (OFF * size + row.span[1] / axes.up.mu)  # above the highest ray, where the axis goes on
    own = Pole(letters_of(row), distance, middles(shown.strips.edges), means, POLE_APART * size, off)
    return own.part(plate.named(f"{row.key}-pole"), axes, plate.hand)


DOT = 0.6  # mm, radius of a point of a curve
GIVEN, GRAPH_CLEAR = 1.1, 2.5  # mm, radius of a given point; least distance of two, in radii
LEAST = 0.05  # mm: a shorter ordinate is a point
GRAPH_APART = 1.9  # sizes of a number from one numbered edge to the next
MARKED = 72  # strips: of more only the numbered edges have a point and a tick
INFINITE = "∞"


def graph_part(row: LawRow, plate: LawPlate, axes: Axes, numbered: Collection[int]) -> Part:
    """Draw a row on its axes, each ordinate that is numbered measurable."""
    lines = (
        *axes.lines((0.0, plate.cam.turn), row.span, plate.hand, plate.named(row.key)),
        *_edges(row, plate, axes, numbered),
        *_chords(row, plate, axes),
        *_exact(row, plate, axes),
        stating(
            Statement(Kind.CURVE, plate.named(row.key), row.letter), _polyline(row.result, axes, plate.hand.result)
        ),
        *_given(row, plate, axes),
        *_impulses(row, plate, axes),
    )
    return Part(plate.named(row.key), lines, (*_letters(row, plate, axes), *_numbers(row, plate, axes, numbered)))


def numbered_edges(strips: Strips, length: float, size: float) -> tuple[int, ...]:
    """Choose the edges that can be numbered along an axis, mm: the ends, those of phases, jumps, then every so many."""
    cam, names = strips.course.cam, strips.names
    places = strips.edges / cam.turn * length
    ends = np.flatnonzero(np.isin(strips.edges, [one.start for one in cam.phases])).tolist()
    step = every(GRAPH_APART * size / max(float(np.diff(places).min()), LEAST), cam.divisions)
    rest = [k for k, name in enumerate(names) if name.isdigit() and int(name) % step == 0]
    kept: list[int] = []
    for k in (0, len(places) - 1, *ends, *strips.jumps, *rest, *range(len(places))):
        if all(tied(abs(places[k] - places[other]) - GRAPH_APART * size) >= 0 for other in kept):
            kept.append(k)
    return tuple(sorted(kept))


def _edges(row: LawRow, plate: LawPlate, axes: Axes, numbered: Collection[int]) -> Iterator[Stroke]:
    """Draw tick, ordinate and points of each edge."""
    strips, hand, tick = plate.shown.strips, plate.hand, TICK * axes.rise
    for k in range(len(strips.edges)) if len(strips.edges) <= MARKED + 1 else numbered:
        foot = axes.on(float(strips.edges[k]))
        tips = [axes.on(float(strips.edges[k]), float(side[k])) for side in (row.after, row.before)]
        yield Line(foot - tick, foot + tick, hand.drafted)
        if k in numbered and abs(tips[0] - foot) > LEAST:
            yield _ordinate(row, plate, axes, k)
        yield from (Circle(tip, DOT * hand.symbol, INK) for tip in apart(tips))


def _ordinate(row: LawRow, plate: LawPlate, axes: Axes, k: int) -> Group:
    """Draw the ordinate of an edge, which can be measured."""
    at, value, name = float(plate.shown.strips.edges[k]), float(row.after[k]), plate.shown.strips.names[k]
    data = Subject(plate.named(row.key), row.letter, k).data("vector", name, axes.rise * value, axes.up)
    return Group((Line(axes.on(at), axes.on(at, value), plate.hand.drafted),), "", data, name)


def _chords(row: LawRow, plate: LawPlate, axes: Axes) -> Iterator[Stroke]:
    return (_polyline(one, axes, plate.hand.drafted) for one in row.chords)


def _exact(row: LawRow, plate: LawPlate, axes: Axes) -> Iterator[Stroke]:
    """Draw the exact curve where it comes out from under the one that is drawn."""
    if row.exact is not None:
        drawn = row.result.y[1:-1] if len(row.result.y) > len(row.exact.y) else row.result.y
        if np.abs(drawn - row.exact.y).max() / axes.up.mu > plate.hand.main / 2:
            yield _polyline(row.exact, axes, plate.hand.other)


def _given(row: LawRow, plate: LawPlate, axes: Axes) -> Iterator[Circle]:
    """Draw the points of tables, where they can be told apart."""
    radius, spots = GIVEN * plate.hand.symbol, [axes.on(x, y) for x, y in row.given]
    if all(abs(other - one) > GRAPH_CLEAR * radius for one, other in pairwise(spots)):
        yield from (Circle(spot, radius, plate.hand.other) for spot in spots)


def _polyline(curve: Curve, axes: Axes, style: LineStyle) -> Polyline:
    points = zip(curve.x.tolist(), curve.y.tolist(), strict=True)
    return Polyline(tuple(apart(axes.on(x, y) for x, y in points)), False, style)


def _impulses(row: LawRow, plate: LawPlate, axes: Axes) -> Iterator[Stroke]:
    """Draw an arrow up or down to infinity for each impulse."""
    for k, sense in row.impulses:
        start, tip = _impulse(row, plate, axes, k, sense)
        head, line = arrowhead(start, tip, plate.hand.symbol), Line(start, tip, plate.hand.result)
        said = Statement(Kind.DIRECTION, plate.named(row.key), plate.shown.strips.names[k], k)
        yield line if head is None else stating(said, line, head)


def _impulse(row: LawRow, plate: LawPlate, axes: Axes, k: int, sense: int) -> tuple[complex, complex]:
    at, (low, high) = float(plate.shown.strips.edges[k]), row.span
    return axes.on(at), axes.on(at, high if sense > 0 else low)


def _letters(row: LawRow, plate: LawPlate, axes: Axes) -> Iterator[Letter]:
    """Letter both axes at their ends, and the impulses."""
    size, drafting = plate.hand.letter, plate.drafting
    high, last = axes.on(0.0, row.span[1]) + BEYOND * axes.rise, axes.on(plate.cam.turn) + BEYOND * axes.along
    unit = "" if row.unit == RATIO else f", {drafting.word(row.unit)}"
    yield Letter(high, f"{row.letter}{unit}", size, cmath.phase(axes.along))
    yield Letter(last, letters(plate.cam)[1], size, cmath.phase(axes.rise))
    for k, sense in row.impulses:
        tip = _impulse(row, plate, axes, k, sense)[1]
        yield Letter(tip, INFINITE, plate.hand.number, 0.0 if sense > 0 else math.pi)


def _numbers(row: LawRow, plate: LawPlate, axes: Axes, numbered: Collection[int]) -> Iterator[Letter]:
    """Number the edges at the axis, each on the side away from its ordinate."""
    strips, impulses = plate.shown.strips, dict(row.impulses)
    for k in numbered:
        low = axes.below(float(row.after[k] + row.before[k])) or impulses.get(k, 1) < 0
        side = cmath.phase(axes.rise if low else -axes.rise)
        yield Letter(axes.on(float(strips.edges[k])), strips.names[k], plate.hand.number, side, TICK + 0.6)


CLEAR = 1.5  # mm around a caption
ABOVE = 1.0  # mm from a dimension line to its letters
APART = 1.6  # sizes of a text from the title's line to the one under it
PER_CENT = 2  # digits of an error
ROUNDED = 1e-9  # of the largest value: chords that are exact but for the roundings of their steps


@dataclass(frozen=True)
class LawFigure:
    """The diagrams placed on paper: their parts, the bounds of the phases and the dimensions of these."""

    parts: tuple[Part, ...]
    joining: Group
    phases: tuple[Dimension, ...]
    plate: LawPlate

    @cached_property
    def _sizes(self) -> tuple[Stroke, ...]:
        return tuple(line for one in self.phases for line in one.draw(self.plate.hand))

    @property
    def lines(self) -> tuple[Stroke, ...]:
        """All that is drawn before any letter is placed."""
        return self.joining, *self._sizes, *(line for part in self.parts for line in part.lines)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give all the parts, lettered."""
        size = self.plate.hand.number
        name, letters = (
            self.plate.named("phases"),
            (labels.along(*one.lines[0], one.letter, size, ABOVE, 1.5) for one in self.phases),
        )
        phases = Group((*self._sizes, *(telling(name, one) for one in letters)), name)
        return self.joining, phases, *(group for part in self.parts for group in part.letter(labels))


def measure(shown: LawDiagrams, drafting: Drafting) -> Picture:
    """Measure the room of the diagrams."""
    plate = LawPlate(shown, drafting)
    return plate.room(max(_wide(row, plate) for row in plate.rows))


def draw(shown: LawDiagrams, room: Picture, spot: Spot, drafting: Drafting) -> LawFigure:
    """Draw the diagrams in their spot."""
    return _Drawing(LawFrame(LawPlate(shown, drafting), spot)).figure


@dataclass(frozen=True)
class _Drawing:
    """Diagrams at their scale, to be drawn."""

    frame: LawFrame

    @property
    def plate(self) -> LawPlate:
        return self.frame.plate

    @property
    def figure(self) -> LawFigure:
        graphs = [self._graph(row) for row in self.plate.rows]
        masks = [around(part.lines[0], CLEAR) for part in graphs]
        joining = Group(tuple(fit_dashes(trim(self._bounds(), masks))), self.plate.named("bounds"))
        return LawFigure((*graphs, *self._poles()), joining, tuple(self._phases()), self.plate)

    @cached_property
    def _numbered(self) -> tuple[int, ...]:
        return numbered_edges(self.plate.shown.strips, self.frame.length, self.plate.hand.number)

    def _graph(self, row: LawRow) -> Part:
        """Draw a row with its title over it, and its shocks told."""
        plate = self.plate
        part = graph_part(row, plate, self.frame.axes(row), self._numbered)
        field = self.frame.fields[row.key]
        over = field._replace(top=field.top + plate.over)
        head = caption(_title(row, plate), joined(";  ", self._scales(row)), over, plate.hand)
        low = complex(over.centre.real, over.top - plate.hand.title - APART * plate.hand.text)
        said = (Text(low, text, plate.hand.text, "middle", True) for text in _said(row, plate))
        above, under = (tuple(telling(part.name, one) for one in own) for own in (head.strokes, said))
        return part._replace(lines=(Group((Group(above), *under)), *part.lines))

    def _scales(self, row: LawRow) -> Iterator[str]:
        """Write the scale of a row, with that of the turn or with the pole distance that it comes from."""
        drafting, distance = self.plate.drafting, self.frame.distance(row)
        if not row.flat:
            yield drafting.scale(self.frame.scales[row.key])
        if row.key == ACCELERATION:
            yield drafting.scale(self.frame.spot.scale)
        elif distance is not None:
            letter = POLES[row.key == VELOCITY][1]
            yield joined("", (f"{letter} = ", drafting.slot(Slot("H", distance)), f" {drafting.word('mm')}"))

    def _poles(self) -> Iterator[Part]:
        for row in self.plate.rows:
            distance = self.frame.pole(row)
            if distance is not None:
                yield pole_part(row, self.plate, self.frame.axes(row), distance)

    def _bounds(self) -> Iterator[Line]:
        """Draw the bounds of the phases through all the rows."""
        first, last = self.plate.rows[0], self.plate.rows[-1]
        for phase in self.plate.cam.phases[1:]:
            top, low = (self.frame.axes(row).on(phase.start).real for row in (first, last))
            fields = self.frame.fields
            yield Line(complex(top, fields[first.key].top), complex(low, fields[last.key].bottom), self.plate.hand.axis)

    def _phases(self) -> Iterator[Dimension]:
        """Dimension the phases under the last row."""
        plate, axes = self.plate, self.frame.axes(self.plate.rows[-1])
        level = -1j * LEVEL * plate.hand.number
        for number, phase in enumerate(plate.cam.phases):
            if phase.angle > 0:
                text = phase_letter(plate.cam, number, plate.drafting)
                said = Statement(Kind.LENGTH, plate.named("phases"), f"φ_{number}", scale=axes.across.mu)
                yield Dimension(text, axes.on(phase.start), axes.on(phase.end), level, said)


def _wide(row: LawRow, plate: LawPlate) -> float:
    """Give the width that a row needs for its caption, mm, with scales as long as they may be."""
    drafting, (_, turn) = plate.drafting, letters(plate.cam)
    own = (Scale(0.0025, f"{{{row.letter}}}", row.unit), Scale(0.025, turn, "m" if plate.cam.translates else "rad"))
    long = wide(_title(row, plate), drafting.scale(*own), plate.hand)
    told = (text_width(Text(0j, text, plate.hand.text)) for text in _said(row, plate))
    return plate.proportions.left * plate.hand.letter + max(long, *told, 0.0)


def _title(row: LawRow, plate: LawPlate) -> str:
    return f"{plate.drafting.word(f'law {row.key}')} {row.letter}"


def _said(row: LawRow, plate: LawPlate) -> Iterator[str]:
    """Tell under the title where there are shocks, or by how much the chords are off."""
    if row.key != ACCELERATION:
        yield plate.drafting.phrase("chords off", off=Slot("off", 100 * _noted(row.error), PER_CENT))
        return
    strips = plate.shown.strips
    soft = [k for k in strips.jumps if k not in strips.hard]
    kinds = (("hard shocks", strips.hard), ("soft shocks", soft))
    told = [plate.drafting.word(key, places=_places(strips, edges)) for key, edges in kinds if edges]
    if told:
        yield ";  ".join(told)


def _places(strips: Strips, edges: Iterable[int]) -> str:
    """Name edges; the end of a turn is its beginning."""
    return ", ".join(dict.fromkeys(strips.names[k] for k in edges))


def _noted(error: float) -> float:
    """Give an error without the roundings of the construction's steps."""
    return error if error > ROUNDED else 0.0
