"""Kinematic diagrams of the output: a row a graph, one under the other (кинематические диаграммы)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from drawings.diagrams.frame import NAME, VELOCITY, DiagramRow, DiagramsFrame, DiagramsPlate
from drawings.kinds.axes import BEYOND, Axes, Curve, Letter, Part, Parts, Pole, caption, wide
from drawings.kinds.graph import stretches
from drawings.kinds.working import SCALES, Working, told
from drawings.layout.picture import Picture, Spot
from drawings.lettering.extent import every
from drawings.lettering.lettering import text_width
from drawings.page.scale import Drafting, Scale
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, LineStyle, Polyline, Stroke, Text
from drawings.paper.walk import stating, tied
from drawings.symbols.figure import Subject, heading
from drawings.symbols.symbols import TICK
from plans.diagrams.study import DiagramsStudy

POLES = {True: ("P_1", "H_1"), False: ("P_2", "H_2")}  # of the velocity; of the acceleration
POLE_APART = 0.7  # sizes of a letter between the ends of two rays that are drawn
OFF = 1.2  # sizes of a letter from the highest ray to the dimension of the pole distance


def letters_of(row: DiagramRow) -> tuple[str, str]:
    """Give the letters of a row's pole and of its distance."""
    return POLES[row.key == VELOCITY]


def pole_part(row: DiagramRow, plate: DiagramsPlate, axes: Axes, distance: float) -> Part:
    """Draw the pole at its distance, mm, and rays along the chords, each carried to where its value belongs."""
    size = plate.hand.letter
    off = 1j * (OFF * size + row.span[1] / axes.up.mu)
    own = Pole(letters_of(row), distance, row.chords.x, row.chords.y, POLE_APART * size, off)
    return own.part(plate.named(f"{row.key}-pole"), axes, plate.hand)


DOT, RING = 0.6, 1.0  # mm, radii: of a point by chords, of one by the plans
LEAST = 0.05  # mm: a shorter ordinate is a point
APART = 0.8  # sizes of a number between two numbers
MARKED = 72  # positions: of more only the numbered ones have a point and a tick


def graph_part(row: DiagramRow, plate: DiagramsPlate, axes: Axes, numbered: Collection[int]) -> Part:
    """Draw a row on its axes, each ordinate that is numbered measurable."""
    hand = plate.hand
    lines = (
        *axes.lines((0.0, plate.length), row.span, hand, "" if row.flat else plate.named(row.key)),
        *_edges(row, plate, axes, numbered),
        *_course(row, plate, "exact", [stroke for curve in row.thin for stroke in _line(curve, axes, hand.other)]),
        *_course(row, plate, "result", [stroke for curve in row.results for stroke in _line(curve, axes, hand.result)]),
        *_points(row, plate, axes, numbered),
    )
    return Part(plate.named(row.key), lines, (*_letters(row, plate, axes), *_numbers(row, plate, axes, numbered)))


def numbered_positions(plate: DiagramsPlate, length: float) -> tuple[int, ...]:
    """Choose the places of the axis that can be numbered along its length, mm: the ends, then every so many."""
    places, number = plate.axis.turned / plate.length * length, plate.hand.number
    size = APART * number + text_width(Text(0j, str(max(plate.axis.numbers)), number))
    kept = [0, len(places) - 1]
    count = len(places) - plate.axis.closed
    step = every(size * count / length, count)
    for k in (*range(0, len(places), step), *range(len(places))):
        if all(tied(abs(places[k] - places[other]) - size) >= 0 for other in kept):
            kept.append(k)
    return tuple(sorted(set(kept)))


def marked(plate: DiagramsPlate, numbered: Collection[int]) -> Collection[int]:
    """Give the positions that have a tick and a point."""
    return range(len(plate.axis.turned)) if len(plate.axis.turned) <= MARKED + 1 else numbered


def _edges(row: DiagramRow, plate: DiagramsPlate, axes: Axes, numbered: Collection[int]) -> Iterator[Stroke]:
    """Draw the tick of each position, and the ordinate of one that is numbered; position 0 is told once."""
    for k in marked(plate, numbered):
        foot = axes.on(float(plate.axis.turned[k]))
        yield Line(foot - 1j * TICK, foot + 1j * TICK, plate.hand.drafted)
        value = 0.0 if row.flat or math.isnan(row.at[k]) else float(row.at[k])
        tip = axes.on(float(plate.axis.turned[k]), value)
        if k in numbered and abs(tip - foot) > LEAST:
            number, line = plate.axis.numbers[k], Line(foot, tip, plate.hand.drafted)
            again = plate.axis.closed and k == len(plate.axis.turned) - 1
            data = Subject(plate.named(row.key), row.letter, number).data("vector", str(number), 1j * value, axes.up)
            yield line if again else Group((line,), "", data, str(number))


def _line(curve: Curve, axes: Axes, style: LineStyle) -> Iterator[Stroke]:
    """Draw a curve, broken where it has no value."""
    for run in stretches(curve.y):
        points = tuple(axes.on(float(curve.x[k]), float(curve.y[k])) for k in run)
        yield Polyline(points, False, style)


def _course(row: DiagramRow, plate: DiagramsPlate, name: str, lines: list[Stroke]) -> Iterator[Stroke]:
    """Give the lines of a curve as what they state."""
    if row.flat:  # without a scale nothing is stated
        yield from lines
    elif lines:
        yield stating(Statement(Kind.CURVE, plate.named(row.key), name), *lines)


def _points(row: DiagramRow, plate: DiagramsPlate, axes: Axes, numbered: Collection[int]) -> Iterator[Stroke]:
    """Draw a ring at each value by the plans, a dot at each by chords; of S, that both rest on, a dot."""
    if row.flat:
        return
    symbol, first = plate.hand.symbol, not len(row.chords.x)
    for k in marked(plate, numbered):
        if not math.isnan(row.at[k]):
            spot = axes.on(float(plate.axis.turned[k]), float(row.at[k]))
            yield Circle(spot, DOT * symbol, INK) if first else Circle(spot, RING * symbol, plate.hand.other)
    if len(plate.axis.turned) <= MARKED + 1:
        spots = (axes.on(x, y) for x, y in zip(row.chords.x.tolist(), row.chords.y.tolist(), strict=True))
        yield from (Circle(spot, DOT * symbol, INK) for spot in spots)


def _letters(row: DiagramRow, plate: DiagramsPlate, axes: Axes) -> Iterator[Letter]:
    """Letter both axes at their ends."""
    size, drafting = plate.hand.letter, plate.drafting
    high = axes.on(0.0, row.span[1]) + BEYOND * axes.rise
    last = axes.on(plate.length) + BEYOND * axes.along
    yield Letter(high, f"{row.letter}, {drafting.word(row.unit)}", size, 0.0)
    yield Letter(last, "φ", size, cmath.phase(axes.rise))


def _numbers(row: DiagramRow, plate: DiagramsPlate, axes: Axes, numbered: Collection[int]) -> Iterator[Letter]:
    """Number the positions at the axis, each on the side away from its ordinate."""
    for k in numbered:
        side = cmath.phase(axes.rise if not row.flat and axes.below(float(row.at[k])) else -axes.rise)
        foot = axes.on(float(plate.axis.turned[k]))
        yield Letter(foot, str(plate.axis.numbers[k]), plate.hand.number, side, TICK + 0.6)


BETWEEN = 1.6  # sizes of a text from a row's caption to the line under it
PER_CENT = 2  # digits of an error


def measure(own: DiagramsStudy, drafting: Drafting) -> Picture:
    """Measure the room of the diagrams."""
    plate = DiagramsPlate(own, drafting)
    head = text_width(Text(0j, title(own, drafting), drafting.hand.title))
    return plate.room(max(head, *(_wide(row, plate) for row in plate.rows)))


def draw(own: DiagramsStudy, spot: Spot, drafting: Drafting) -> Parts:
    """Draw the diagrams in their spot."""
    return _Drawing(DiagramsFrame(DiagramsPlate(own, drafting), spot)).figure


def title(own: DiagramsStudy, drafting: Drafting) -> str:
    """Head the figure with the output: a point of what slides, a link that turns."""
    travel, out = own.course.travel, own.linkage.output
    point = (out.point or (travel.slide.point if travel.slide else "")) if travel.sliding else ""
    return drafting.word("diagrams of point" if point else "diagrams of link", link=out.link, point=point)


@dataclass(frozen=True)
class _Drawing:
    """Diagrams at their scale, to be drawn."""

    frame: DiagramsFrame

    @property
    def plate(self) -> DiagramsPlate:
        return self.frame.plate

    @property
    def figure(self) -> Parts:
        graphs = tuple(self._graph(row) for row in self.plate.rows)
        return Parts((self._head(),), (*graphs, *self._poles()))

    def _head(self) -> Group:
        """Write the heading of the figure, and the scales along its axis."""
        drafting, spot = self.plate.drafting, self.frame.spot
        scales = drafting.scale(spot.scale, self.frame.argument)
        return Group((heading(spot.box, title(self.plate.own, drafting), scales, self.plate.hand),), NAME)

    @cached_property
    def _numbered(self) -> tuple[int, ...]:
        return numbered_positions(self.plate, self.frame.length)

    def _graph(self, row: DiagramRow) -> Part:
        """Draw a row with its title over it, and by how much the chords are off."""
        plate = self.plate
        part = graph_part(row, plate, self.frame.axes(row), self._numbered)
        field = self.frame.fields[row.key]
        over = field._replace(top=field.top + plate.over)
        head = caption(caption_of(row, plate), ";  ".join(self._scales(row)), over, plate.hand)
        low = complex(over.centre.real, over.top - plate.hand.title - BETWEEN * plate.hand.text)
        told = (Text(low, text, plate.hand.text, "middle", True) for text in said(row, plate))
        return part._replace(lines=(Group((head, *told)), *part.lines))

    def _scales(self, row: DiagramRow) -> Iterator[str]:
        """Write the scale of a row, with the pole distance that it comes from."""
        drafting, distance = self.plate.drafting, self.frame.distance(row)
        if not row.flat:
            yield drafting.scale(self.frame.scales[row.key])
        if distance is not None:
            yield f"{letters_of(row)[1]} = {drafting.number(distance)} {drafting.word('mm')}"

    def _poles(self) -> Iterator[Part]:
        for row in self.plate.rows:
            distance = self.frame.distance(row)
            if distance is not None:
                yield pole_part(row, self.plate, self.frame.axes(row), distance)


def caption_of(row: DiagramRow, plate: DiagramsPlate) -> str:
    """Give the caption of a row: its letter over the crank angle."""
    return f"{row.letter}(φ)"


def said(row: DiagramRow, plate: DiagramsPlate) -> Iterator[str]:
    """Tell under the caption by how much the chords are off, or that the row shows nothing."""
    if row.flat:
        yield plate.drafting.word("diagram flat")
    elif row.off is not None:
        yield plate.drafting.word("chords off", off=plate.drafting.number(100 * row.off.share, PER_CENT))


def _wide(row: DiagramRow, plate: DiagramsPlate) -> float:
    """Give the width that a row needs for its caption, mm, with scales as long as they may be."""
    drafting = plate.drafting
    scale = drafting.scale(Scale(0.0025, f"{{{row.letter}}}", row.unit))
    long = wide(caption_of(row, plate), f"{scale};  H_1 = 55.55 {drafting.word('mm')}", plate.hand)
    told = (text_width(Text(0j, text, plate.hand.text)) for text in said(row, plate))
    return plate.proportions.left * plate.hand.letter + max(long, *told, 0.0)


def working(own: DiagramsStudy, drafting: Drafting) -> Working:
    """Write beside the diagrams how the scale of time and the pole distances are found."""
    return Working(SCALES, NAME, lambda spot: list(_lines(DiagramsPlate(own, drafting), spot)), drafting)


def _lines(plate: DiagramsPlate, spot: Spot | None) -> Iterator[tuple[str, ...]]:
    frame = None if spot is None else DiagramsFrame(plate, spot)
    yield _time(plate, math.nan if spot is None else spot.scale.mu)
    for above, row in pairwise(plate.rows):
        if not row.flat:
            yield _pole(above, row, plate, frame)


def _time(plate: DiagramsPlate, mu: float) -> tuple[str, ...]:
    """Write the scale of time by that of the crank angle, rad/mm."""
    drafting, letter = plate.drafting, f"ω_{{{plate.own.linkage.mechanism.drive.link}}}"
    omega, (s, mm) = told(plate.omega, drafting), map(drafting.word, ("s", "mm"))
    if drafting.notation == "K":
        return (
            f"K_t = K_φ·{letter}",
            f"{told(1 / mu, drafting)}·{omega}",
            f"{told(plate.omega / mu, drafting)} {mm}/{s}",
        )
    return f"μ_t = μ_φ/{letter}", f"{told(mu, drafting)}/{omega}", f"{told(mu / plate.omega, drafting)} {s}/{mm}"


def _pole(above: DiagramRow, row: DiagramRow, plate: DiagramsPlate, frame: DiagramsFrame | None) -> tuple[str, ...]:
    """Write a pole distance by the scales of its row, of the row above it, and of time."""
    drafting, (high, low) = plate.drafting, (f"{{{one.letter}}}" for one in (above, row))
    first, second, time, distance = _working_numbers(above, row, frame)
    result = f"{letters_of(row)[1]} = ", f"{told(distance, drafting)} {drafting.word('mm')}"
    if drafting.notation == "K":
        own, over, other = (told(1 / one, drafting) for one in (second, time, first))
        return f"{result[0]}K_{low}·K_t/K_{high}", f"{own}·{over}/{other}", result[1]
    over, own, other = (told(one, drafting) for one in (first, second, time))
    return f"{result[0]}μ_{high}/(μ_{low}·μ_t)", f"{over}/({own}·{other})", result[1]


def _working_numbers(
    above: DiagramRow, row: DiagramRow, frame: DiagramsFrame | None
) -> tuple[float, float, float, float]:
    """Give the scales of both rows and of time, and the distance, mm; NaN before it is known where they stand."""
    distance = None if frame is None else frame.distance(row)
    if frame is None or distance is None:
        return math.nan, math.nan, math.nan, math.nan
    return frame.scales[above.key].mu, frame.scales[row.key].mu, frame.argument.mu, distance
