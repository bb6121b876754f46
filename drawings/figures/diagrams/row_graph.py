"""One of the kinematic diagrams drawn: ordinates at numbered positions, curves, values by chords (диаграмма)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator

from drawings.figures.diagrams.frame import VELOCITY, DiagramRow, DiagramsPlate
from drawings.figures.graphs.axes import BEYOND, Axes, Curve
from drawings.figures.graphs.curve_graph import stretches
from drawings.figures.graphs.part import Letter, Part
from drawings.figures.graphs.pole import Pole
from drawings.lettering.lettering import text_width
from drawings.lettering.thinning import every
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, LineStyle, Polyline, Stroke, Text
from drawings.paper.ties import tied
from drawings.paper.walk import stating
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import TICK

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
