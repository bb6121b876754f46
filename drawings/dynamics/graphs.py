"""The graphs over a machine's turn: curves by strips, the pole's rays, what each is a graph of (графики цикла)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import NamedTuple

import numpy as np

from drawings.kinds.axes import OVER, RIGHT, UNDER, Axes, Letter, Part, Pole
from drawings.kinds.graph import Graph
from drawings.kinds.smooth import cubics, inner_slopes
from drawings.lettering.lettering import every, spaced
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.symbols.symbols import fit_dashes
from geometry.strips import middles
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
    turned = cycle.turned[:-1, None] + shares * np.diff(cycle.turned)[:, None]
    slopes = _slopes(cycle.turned, cycle.varying)
    rows = (
        turned,
        _parabolas(cycle.moments, cycle.means, shares),
        cubics(turned, (cycle.work[:-1], cycle.work[1:]), (cycle.moments[:, 0], cycle.moments[:, 1])),
        cubics(turned, (cycle.varying[:-1], cycle.varying[1:]), (slopes[:-1], slopes[1:])),
    )
    return Dense(*(row.ravel() for row in rows))


def _parabolas(ends: Floats, means: Floats, shares: Floats) -> Floats:
    """Follow each strip through its ordinates at both ends and in the middle, (n, shares)."""
    first, last, s = ends[:, :1], ends[:, 1:], shares
    bend = 4 * (means[:, None] - (first + last) / 2)
    return np.asarray(first + (last - first) * s + bend * s * (1 - s))


def _slopes(x: Floats, y: Floats) -> Floats:
    """Give the slopes of a smooth periodic curve at its points."""
    wide, steep = np.diff(x), np.diff(y) / np.diff(x)
    inner = inner_slopes(*(np.append(row[-1], row) for row in (wide, steep)))
    return np.append(inner, inner[0])


MARKED = 72  # strips: of more only the numbered edges have a point and a tick
NUMBERED = 36  # positions that are numbered at most where not all edges are marked
SEEN = 1e-3  # of the largest moment: a smaller jump cannot be seen


class DrawnStrips(NamedTuple):
    """The edges of the strips, rad, their names, and the places of those at which a load jumps."""

    turned: Floats
    names: tuple[str, ...]
    jumps: tuple[int, ...]

    @property
    def steps(self) -> Floats:
        """The numbers of the edges as positions, NaN between two of them."""
        return np.array([float(name) if name.isdigit() else np.nan for name in self.names])

    def numbered(self, every: int) -> tuple[int, ...]:
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
        return self.numbered(self.every(float(np.nanmax(self.steps)) / NUMBERED) if self.crowded else 1)

    def marked(self, numbered: Collection[int]) -> Collection[int]:
        """Give the edges that have a point, if some are numbered."""
        return numbered if self.crowded else range(len(self.turned))

    def spaced(self, length: float, apart: float) -> tuple[int, ...]:
        """Choose the edges that can be numbered along an axis of some length mm, both ends and jumps first."""
        places = self.turned * (length / TURN)
        every = self.every(apart / length * float(np.nanmax(self.steps)))
        return tuple(sorted(spaced(places.tolist(), apart, (0, len(places) - 1, *self.jumps, *self.numbered(every)))))


def strips(cycle: Cycle, divisions: int) -> DrawnStrips:
    """Name the edges: positions by their numbers, an edge between two of them by the first one's with a prime."""
    return DrawnStrips(cycle.turned, edge_names(cycle.turned, divisions), _jumps(cycle))


def _jumps(cycle: Cycle) -> tuple[int, ...]:
    """Find the inner edges at which the two sides of the moment differ to the eye."""
    apart = np.abs(cycle.moments[1:, 0] - cycle.moments[:-1, 1])
    return tuple(int(k) + 1 for k in np.flatnonzero(apart > SEEN * np.abs(cycle.moments).max()))


NAME = "pole"
POLE, DISTANCE = "P", "H_p"  # H alone is a stroke
BETWEEN_RAYS = 1.0  # sizes of a letter between the ends of two rays that are drawn
OFF = 2.2  # sizes of a letter from the axis to the dimension of the pole distance


def pole_part(cycle: Cycle, axes: Axes, distance: float, hand: Hand) -> Part:
    """Draw the pole at its distance, mm, and rays to the mean ordinates that lie apart, each carried to the axis."""
    means = cycle.way * cycle.means
    size, lower = hand.letter, means.max() >= -means.min()
    off = (-1j if lower else 1j) * OFF * size  # on the side of the axis on which the diagram is lower
    pole = Pole((POLE, DISTANCE), distance, middles(cycle.turned), means, BETWEEN_RAYS * size, off, UNDER)
    return pole.part(NAME, axes, hand)


DOT = 0.6  # mm, radius of a point of a curve
APART = 2.4  # sizes of a number from one numbered edge to the next


class GraphTrace(NamedTuple):
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
    traces: tuple[GraphTrace, ...]
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


def graph_part(shown: StripGraph, strips: DrawnStrips, axes: Axes, drafting: Drafting) -> Part:
    """Draw a graph on its axes, each ordinate that is numbered measurable."""
    hand, values = drafting.hand, (shown.values - shown.base).tolist()
    graph = Graph(shown.name, axes, hand)
    numbered = strips.spaced(abs(axes.on(TURN) - axes.on(0.0)), APART * hand.number)
    sides = [*zip(values, (shown.before - shown.base).tolist(), strict=True)]
    turned, names = strips.turned.tolist(), strips.names
    ordinates = {k for k in numbered if k not in strips.jumps or sides[k][0] == sides[k][1]}  # a jump has its own
    lines = (
        *axes.lines((0.0, TURN), shown.span, hand, shown.name),
        *(
            stroke
            for k in strips.marked(numbered)
            for stroke in graph.station(turned[k], sides[k], names[k], k, k in ordinates, DOT)
        ),
        *(stroke for trace in shown.traces for stroke in _curve(trace, shown, graph)),
    )
    up = f"{drafting.letter(shown.axis or shown.letter)}, {drafting.word(shown.unit)}"
    ends = graph.ends((TURN, "Δφ"), (shown.span[1], up))
    numbers = (graph.number(turned[k], names[k], values[k]) for k in numbered)
    return Part(shown.name, lines, (*ends, *_letters(shown, axes, drafting), *numbers))


def _curve(trace: GraphTrace, shown: StripGraph, graph: Graph) -> Iterator[Stroke]:
    """Draw a curve, dashed where it jumps so far that it is seen."""
    x, y = trace.x, trace.y - shown.base
    jumps = np.flatnonzero((np.diff(x) == 0) & (np.abs(np.diff(y)) > SEEN * np.abs(y).max()))
    apart, broken = (np.insert(row, jumps + 1, np.nan) for row in (x, y))
    yield graph.stated(trace.letter or shown.letter, graph.curve(apart, broken, getattr(graph.hand, trace.style)))
    axes = graph.axes
    yield from fit_dashes(Line(axes.on(x[k], y[k]), axes.on(x[k], y[k + 1]), graph.hand.path) for k in jumps.tolist())


def _letters(shown: StripGraph, axes: Axes, drafting: Drafting) -> Iterator[Letter]:
    """Letter the curves that have letters."""
    for trace in shown.traces:
        if trace.letter:
            k = round(trace.at * (len(trace.x) - 1))
            spot, end = (axes.on(float(trace.x[n]), float(trace.y[n]) - shown.base) for n in (k, -1))
            yield Letter(spot, drafting.letter(trace.letter), drafting.hand.letter, trace.side, further=(end,))


MOST = 4.0  # times as far as with the flywheel: what swings more has a graph of its own
MOMENTS, WORKS, SURPLUS, INERTIA, SPEEDS, BEFORE = "moments", "works", "surplus", "inertia", "speeds", "before"


def moments(cycle: Cycle, dense: Dense) -> StripGraph:
    """The reduced moment of the loads, with both sides of its jumps, and the constant one of the other side."""
    drawn, moment, (loads, other) = cycle.way * cycle.moments, cycle.way * dense.moment, cycle.indices
    after, before = np.append(drawn[:, 0], drawn[-1, 1]), np.append(drawn[0, 0], drawn[:, 1])
    most = int(np.argmax(np.abs(dense.moment)))
    at, side = most / (len(dense.moment) - 1), _away(moment[most])
    loaded = GraphTrace(dense.turned, moment, "result", f"M_{{{loads}}}", at, side)
    traces = (loaded, _level(abs(cycle.driving), "relative", f"M_{{{other}}}", RIGHT, 1.0))
    return StripGraph(MOMENTS, "M_{red}", "N*m", after, before, traces)


def works(cycle: Cycle) -> StripGraph:
    """The work of the loads by the chords of its construction, and that of the other side, a straight line."""
    work, (loads, other) = cycle.way * cycle.work, cycle.indices
    loaded = GraphTrace(cycle.turned, work, "result", f"A_{{{loads}}}", 0.6, _away(-abs(cycle.driving)))
    line = np.array([0.0, 0.25, 1.0])  # its letter stands at a point of its own
    steady = GraphTrace(TURN * line, work[-1] * line, "relative", f"A_{{{other}}}", 0.5, OVER)
    return StripGraph(WORKS, "A", "J", work, work, (loaded, steady))


def surplus(cycle: Cycle, dense: Dense) -> StripGraph:
    """The change of the kinetic energy."""
    energy = cycle.driving * dense.turned + dense.work
    return StripGraph(SURPLUS, "ΔT", "J", cycle.surplus, cycle.surplus, (GraphTrace(dense.turned, energy),))


def inertia(cycle: Cycle, dense: Dense) -> StripGraph:
    """The part of the reduced inertia that changes."""
    varying = cycle.varying
    return StripGraph(INERTIA, "ΔJ", "kg*m2", varying, varying, (GraphTrace(dense.turned, dense.varying),))


def speeds(cycle: Cycle, dense: Dense, speeds: Speeds, before: Speeds | None = None) -> StripGraph:
    """The speed with the flywheel from its mean on, the extremes; that without it dashed, if it swings little more."""
    low, high = speeds.extremes
    traces = [GraphTrace(dense.turned, omega(cycle, dense, speeds))]
    traces += [_level(high, "drafted", "ω_{max}"), _level(low, "drafted", "ω_{min}", UNDER)]
    if before is not None and beside(speeds, before):
        traces.append(GraphTrace(dense.turned, omega(cycle, dense, before), "path", "ω_0", 0.15))
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


def _level(value: float, style: str, letter: str, side: float = OVER, at: float = 0.5) -> GraphTrace:
    """Draw a constant over the whole turn."""
    return GraphTrace(np.array([0.0, 0.9 * TURN, TURN]), np.full(3, value), style, letter, at, side)


def _away(value: float) -> float:
    return OVER if value >= 0 else UNDER
