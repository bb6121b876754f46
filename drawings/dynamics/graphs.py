"""The graphs over a machine's turn: curves by strips, the pole's rays, what each is a graph of (графики цикла)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator
from typing import NamedTuple

import numpy as np

from drawings.kinds.axes import BEYOND, OVER, RIGHT, UNDER, Axes, Letter, Part, Pole
from drawings.lettering.extent import every
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, LineStyle, Polyline, Stroke
from drawings.paper.walk import apart, stating
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import TICK
from plans.model.dynamics import TURN, Cycle, Speeds, edge_names
from plans.model.motion import Floats

STEPS = 360  # of a turn at least: a degree, of which no curve on paper shows the corners


class Dense(NamedTuple):
    """A turn followed densely: angles rad from 0 on, moment N*m, work J, varying inertia kg*m2; jumps are upright."""

    turned: Floats
    moment: Floats
    work: Floats
    varying: Floats


def dense(cycle: Cycle) -> Dense:
    """Join the points of a cycle smoothly, each strip on its own: loads may jump or bend at its edges."""
    shares = np.linspace(0.0, 1.0, 1 + math.ceil(STEPS / len(cycle.means)))
    slopes = _slopes(cycle.turned, cycle.varying)
    ends = np.column_stack([slopes[:-1], slopes[1:]])
    turned = cycle.turned[:-1, None] + shares * np.diff(cycle.turned)[:, None]
    rows = (
        turned,
        _parabolas(cycle.moments, cycle.means, shares),
        _cubics(cycle.turned, cycle.work, cycle.moments, shares),
        _cubics(cycle.turned, cycle.varying, ends, shares),
    )
    return Dense(*(row.ravel() for row in rows))


def _parabolas(ends: Floats, means: Floats, shares: Floats) -> Floats:
    """Follow each strip through its ordinates at both ends and in the middle, (n, shares)."""
    first, last, s = ends[:, :1], ends[:, 1:], shares
    bend = 4 * (means[:, None] - (first + last) / 2)
    return np.asarray(first + (last - first) * s + bend * s * (1 - s))


def _cubics(x: Floats, y: Floats, slopes: Floats, shares: Floats) -> Floats:
    """Follow each strip through its ends with the slopes (n, 2) that it has there, (n, shares)."""
    wide, s = np.diff(x)[:, None], shares
    first, rise = y[:-1, None], np.diff(y)[:, None]
    left, right = slopes[:, :1] * wide - rise, rise - slopes[:, 1:] * wide
    return np.asarray(first + rise * s + s * (1 - s) * (left * (1 - s) + right * s))


def _slopes(x: Floats, y: Floats) -> Floats:
    """Give the slopes of a smooth periodic curve at its points, each from the two strips beside it."""
    wide, rise = np.diff(x), np.diff(y)
    chords = rise / wide
    before, after = np.roll(wide, 1), wide
    own = (np.roll(chords, 1) * after + chords * before) / (before + after)
    return np.append(own, own[0])


MARKED = 72  # strips: of more only the numbered edges have a point and a tick
NUMBERED = 36  # positions that are numbered at most where not all edges are marked
SEEN = 1e-3  # of the largest moment: a smaller jump cannot be seen


class Strips(NamedTuple):
    """The edges of the strips, rad, their names, and the places of those at which a load jumps."""

    turned: Floats
    names: tuple[str, ...]
    jumps: tuple[int, ...]

    @property
    def steps(self) -> Floats:
        """The numbers of the edges as positions, NaN between two of them."""
        return np.array([float(name) if name.isdigit() else np.nan for name in self.names])

    def told(self, every: int) -> tuple[int, ...]:
        """Choose both ends, the jumps, and every so many positions."""
        last = len(self.turned) - 1
        return tuple(sorted({0, last, *self.jumps, *np.flatnonzero(self.steps % every == 0).tolist()}))

    def every(self, least: float) -> int:
        """Choose how many positions apart numbers stand: a divisor of the turn, if there is one not much above."""
        return every(least, round(float(np.nanmax(self.steps))))

    @property
    def crowded(self) -> bool:
        """Whether there are so many edges that only the numbered ones are marked."""
        return len(self.turned) > MARKED + 1

    @property
    def candidates(self) -> tuple[int, ...]:
        """The edges that may be numbered."""
        return self.told(self.every(float(np.nanmax(self.steps)) / NUMBERED) if self.crowded else 1)

    def marked(self, numbered: Collection[int]) -> Collection[int]:
        """Give the edges that have a point, if some are numbered."""
        return numbered if self.crowded else range(len(self.turned))

    def spaced(self, length: float, apart: float) -> tuple[int, ...]:
        """Choose the edges that can be numbered along an axis of some length mm, both ends and jumps first."""
        places = self.turned * (length / TURN)
        every = self.every(apart / length * float(np.nanmax(self.steps)))
        kept: list[int] = []
        for k in (0, len(places) - 1, *self.jumps, *self.told(every)):
            if all(abs(places[k] - places[other]) >= apart for other in kept):
                kept.append(k)
        return tuple(sorted(kept))


def strips(cycle: Cycle, divisions: int) -> Strips:
    """Name the edges: positions by their numbers, an edge between two of them by the first one's with a prime."""
    return Strips(cycle.turned, edge_names(cycle.turned, divisions), _jumps(cycle))


def _jumps(cycle: Cycle) -> tuple[int, ...]:
    """Find the inner edges at which the two sides of the moment differ to the eye."""
    apart = np.abs(cycle.moments[1:, 0] - cycle.moments[:-1, 1])
    return tuple(int(k) + 1 for k in np.flatnonzero(apart > SEEN * np.abs(cycle.moments).max()))


def middles(turned: Floats) -> Floats:
    """Give the middles of the strips, rad."""
    return (turned[1:] + turned[:-1]) / 2


NAME = "pole"
POLE, DISTANCE = "P", "H_p"  # H alone is a stroke
BETWEEN_RAYS = 1.0  # sizes of a letter between the ends of two rays that are drawn
OFF = 2.2  # sizes of a letter from the axis to the dimension of the pole distance


def pole_part(cycle: Cycle, axes: Axes, distance: float, hand: Hand) -> Part:
    """Draw the pole at its distance, mm, and rays to the mean ordinates that lie apart, each carried to the axis."""
    size, off = hand.letter, _off(cycle) * OFF * hand.letter
    own = Pole((POLE, DISTANCE), distance, middles(cycle.turned), -cycle.means, BETWEEN_RAYS * size, off, UNDER)
    return own.part(NAME, axes, hand)


def _off(cycle: Cycle) -> complex:
    """Give the side of the axis on which the diagram is lower."""
    return -1j if -cycle.means.min() >= cycle.means.max() else 1j


DOT = 0.6  # mm, radius of a point of a curve
LEAST = 0.05  # mm: a shorter ordinate is a point
APART = 2.4  # sizes of a number from one numbered edge to the next


class Trace(NamedTuple):
    """A curve of a graph: its points in true units, how it is drawn, its letter and where along it that stands."""

    x: Floats
    y: Floats
    style: str = "result"  # a line of the hand
    letter: str = ""
    at: float = 0.5  # share of its points
    side: float = math.pi / 2


class StripGraph(NamedTuple):
    """A quantity over the turn: its letter, unit, values at the edges after and before a jump, and all its curves.

    Values are drawn from the level `base`, which the axis of angles stands for.
    """

    name: str
    letter: str
    unit: str
    values: Floats  # (n + 1,)
    before: Floats  # (n + 1,)
    traces: tuple[Trace, ...]
    base: float = 0.0
    axis: str = ""  # the letter of the axis, if it is not that of the quantity

    @property
    def symbol(self) -> str:
        """The letter of the scale."""
        return self.letter.split("_")[0].lstrip("Δ")

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest value above the base, zero among them."""
        ys = np.concatenate([self.values - self.base, *(trace.y - self.base for trace in self.traces)])
        return min(float(ys.min()), 0.0), max(float(ys.max()), 0.0)


def graph_part(graph: StripGraph, strips: Strips, axes: Axes, drafting: Drafting) -> Part:
    """Draw a graph on its axes, each ordinate that is numbered measurable."""
    hand = drafting.hand
    length = abs(axes.on(TURN) - axes.on(0.0))
    numbered = strips.spaced(length, APART * hand.number)
    lines = (
        *axes.lines((0.0, TURN), graph.span, hand, graph.name),
        *_edges(graph, strips, numbered, axes, hand),
        *(stroke for trace in graph.traces for stroke in _curve(graph, trace, axes, hand)),
    )
    return Part(graph.name, lines, (*_letters(graph, axes, drafting), *_numbers(graph, strips, numbered, axes, hand)))


def _edges(graph: StripGraph, strips: Strips, numbered: tuple[int, ...], axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw tick, ordinate and points of each edge."""
    tick = TICK * axes.rise
    for k in strips.marked(numbered):
        angle = float(strips.turned[k])
        foot, value, other = axes.on(angle), graph.values[k] - graph.base, graph.before[k] - graph.base
        yield Line(foot - tick, foot + tick, hand.drafted)
        if k in numbered:
            yield from _ordinate(graph, strips.names[k], k, (foot, axes.on(angle, value)), value, axes, hand)
        for tip in apart((axes.on(angle, value), axes.on(angle, other))):
            yield Circle(tip, DOT * hand.symbol, INK)


def _ordinate(
    graph: StripGraph, name: str, k: int, ends: tuple[complex, complex], value: float, axes: Axes, hand: Hand
) -> Iterator[Stroke]:
    if abs(ends[1] - ends[0]) > LEAST:
        data = Subject(graph.name, graph.symbol, k).data("vector", name, axes.rise * float(value), axes.up)
        yield Group((Line(*ends, hand.drafted),), "", data, name)


def _curve(graph: StripGraph, trace: Trace, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    points = tuple(axes.on(x, y) for x, y in zip(trace.x.tolist(), (trace.y - graph.base).tolist(), strict=True))
    style: LineStyle = getattr(hand, trace.style)
    lines = fit_dashes([Polyline(points, False, style)])
    yield stating(Statement(Kind.CURVE, graph.name, trace.letter or graph.letter), *lines)


def _letters(graph: StripGraph, axes: Axes, drafting: Drafting) -> Iterator[Letter]:
    """Letter both axes at their ends, and the curves that have letters."""
    size, letter = drafting.hand.letter, drafting.letter(graph.axis or graph.letter)
    high, last = axes.on(0.0, graph.span[1]) + BEYOND * axes.rise, axes.on(TURN) + BEYOND * axes.along
    yield Letter(high, f"{letter}, {drafting.word(graph.unit)}", size, cmath.phase(axes.along))
    yield Letter(last, "φ", size, cmath.phase(axes.rise))
    for trace in graph.traces:
        if trace.letter:
            k = round(trace.at * (len(trace.x) - 1))
            spot = axes.on(float(trace.x[k]), float(trace.y[k]) - graph.base)
            yield Letter(spot, drafting.letter(trace.letter), size, trace.side)


def _numbers(graph: StripGraph, strips: Strips, numbered: tuple[int, ...], axes: Axes, hand: Hand) -> Iterator[Letter]:
    """Number the edges at the axis, each on the side away from its ordinate."""
    for k in numbered:
        away = axes.rise if axes.below(float(graph.values[k]) - graph.base) else -axes.rise
        yield Letter(axes.on(strips.turned[k]), strips.names[k], hand.number, cmath.phase(away), TICK + 0.6)


MOST = 4.0  # times as far as with the flywheel: what swings more has a graph of its own
MOMENTS, WORKS, SURPLUS, INERTIA, SPEEDS, BEFORE = "moments", "works", "surplus", "inertia", "speeds", "before"


def moments(cycle: Cycle, dense: Dense) -> StripGraph:
    """The reduced moment of resistance, with both sides of its jumps, and the constant one of the drive."""
    after = np.append(-cycle.moments[:, 0], -cycle.moments[-1, 1])
    before = np.append(-cycle.moments[0, 0], -cycle.moments[:, 1])
    most = int(np.argmax(np.abs(dense.moment)))
    traces = (
        Trace(
            dense.turned, -dense.moment, "result", "M_{us}", most / (len(dense.moment) - 1), _away(-dense.moment[most])
        ),
        _level(cycle.driving, "relative", "M_{dr}", RIGHT, 1.0),
    )
    return StripGraph(MOMENTS, "M_{red}", "N*m", after, before, traces)


def works(cycle: Cycle) -> StripGraph:
    """The work of resistance by the chords of its construction, and that of the drive, a straight line."""
    own = -cycle.work
    traces = (
        Trace(cycle.turned, own, "result", "A_{us}", 0.6, _away(-cycle.driving)),
        Trace(np.array([0.0, TURN]), np.array([0.0, own[-1]]), "relative", "A_{dr}", 0.0, OVER),
    )
    return StripGraph(WORKS, "A", "J", own, own, (traces[0], _halved(traces[1])))


def _halved(trace: Trace) -> Trace:
    """Give a straight line a point at which its letter stands."""
    x, y = (np.array([row[0], row[0] + 0.25 * (row[1] - row[0]), row[1]]) for row in (trace.x, trace.y))
    return trace._replace(x=x, y=y, at=0.5)


def surplus(cycle: Cycle, dense: Dense) -> StripGraph:
    """The change of the kinetic energy."""
    energy = cycle.driving * dense.turned + dense.work
    return StripGraph(SURPLUS, "ΔT", "J", cycle.surplus, cycle.surplus, (Trace(dense.turned, energy),))


def inertia(cycle: Cycle, dense: Dense) -> StripGraph:
    """The part of the reduced inertia that changes."""
    own = cycle.varying
    return StripGraph(INERTIA, "ΔJ", "kg*m2", own, own, (Trace(dense.turned, dense.varying),))


def speeds(cycle: Cycle, dense: Dense, speeds: Speeds, before: Speeds | None = None) -> StripGraph:
    """The speed with the flywheel from its mean on, the extremes; that without it dashed, if it swings little more."""
    low, high = speeds.extremes
    traces = [Trace(dense.turned, omega(cycle, dense, speeds))]
    traces += [_level(high, "drafted", "ω_{max}"), _level(low, "drafted", "ω_{min}", UNDER)]
    if before is not None and beside(speeds, before):
        traces.append(Trace(dense.turned, omega(cycle, dense, before), "path", "ω_0", 0.15))
    return StripGraph(SPEEDS, "ω", "rad/s", speeds.omega, speeds.omega, tuple(traces), speeds.mean)


def beside(speeds: Speeds, before: Speeds) -> bool:
    """Tell whether the speeds without the flywheel are drawn among those with it: they are others, and not too far."""
    apart = before.extremes[1] - before.extremes[0]
    return before.inertia != speeds.inertia and apart <= MOST * (speeds.extremes[1] - speeds.extremes[0])


def omega(cycle: Cycle, dense: Dense, speeds: Speeds) -> Floats:
    """Give the speed densely, rad/s: by the energy and the inertia of the whole machine."""
    energy = speeds.energy + cycle.driving * dense.turned + dense.work
    whole = speeds.inertia + dense.varying
    return np.asarray(np.sqrt(2 * np.maximum(energy, 0.0) / whole))


def _level(value: float, style: str, letter: str, side: float = OVER, at: float = 0.5) -> Trace:
    """Draw a constant over the whole turn."""
    return Trace(np.array([0.0, 0.9 * TURN, TURN]), np.full(3, value), style, letter, at, side)


def _away(value: float) -> float:
    return OVER if value >= 0 else UNDER
