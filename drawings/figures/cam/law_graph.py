"""One of a law's diagrams drawn: ordinates at numbered edges, chords, curve, jumps and impulses (диаграмма закона)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator
from itertools import pairwise

import numpy as np

from drawings.figures.cam.law_frame import LawPlate, LawRow
from drawings.figures.graphs.axes import BEYOND, Axes, Curve
from drawings.figures.graphs.part import Letter, Part
from drawings.lettering.thinning import every
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, LineStyle, Polyline, Stroke
from drawings.paper.ties import apart, tied
from drawings.paper.walk import stating
from drawings.report.cam_letters import letters
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import TICK, arrowhead
from plans.cam.diagrams import Strips
from plans.cam.dimensions import RATIO

DOT = 0.6  # mm, radius of a point of a curve
GIVEN, CLEAR = 1.1, 2.5  # mm, radius of a given point; least distance of two, in radii
LEAST = 0.05  # mm: a shorter ordinate is a point
APART = 1.9  # sizes of a number from one numbered edge to the next
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
    step = every(APART * size / max(float(np.diff(places).min()), LEAST), cam.divisions)
    rest = [k for k, name in enumerate(names) if name.isdigit() and int(name) % step == 0]
    kept: list[int] = []
    for k in (0, len(places) - 1, *ends, *strips.jumps, *rest, *range(len(places))):
        if all(tied(abs(places[k] - places[other]) - APART * size) >= 0 for other in kept):
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
    if all(abs(other - one) > CLEAR * radius for one, other in pairwise(spots)):
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
