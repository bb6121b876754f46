"""The self-check of the graphs over the turn: ordinates, edges, curves, lines, scales, pole (проверка диаграмм)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.dynamics.dynamics_expected import INERTIA, KNOWN, MOMENTS, WORKS, Expected
from drawings.checks.dynamics.graph_strokes import GraphStrokes, Laid
from drawings.checks.dynamics.joining_strokes import pole_strokes
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import Wrong, on
from drawings.figures.dynamics.strips import MARKED
from drawings.lettering.words import number
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Group, Leaf, Line, Polyline
from drawings.paper.walk import group_named, texts, walk
from plans.model.dynamics import TURN
from plans.model.motion import Complexes, Floats
from plans.words.words import message

NONE = float("nan")
POLE = "pole"  # the part with the pole and the rays
_DISTANCE = re.compile(r"Hp = (\d+(?:[.,]\d+)?)")


def graphs(
    measured: Measured, leaf: Leaf, expected: Expected, due: Iterable[str], drafting: Drafting
) -> Iterator[Wrong]:
    """Hold every graph that a sheet must show."""
    parts = {name: one for name in due if (one := group_named(leaf.groups, name)) is not None}
    angle = next(
        (scales["φ"] for name, one in parts.items() if name != INERTIA and "φ" in (scales := written_scales(one))), NONE
    )
    found = [_Graph(name, one, measured, expected, angle) for name, one in parts.items()]
    yield from (message("wrong.missing", name=name) for name in due if group_named(leaf.groups, name) is None)
    shared = frozenset(k for one in found if one.name != INERTIA for k in one.told)
    for graph in found:
        yield from graph.faults(shared if graph.name != INERTIA else frozenset(), drafting.language)
        if graph.marks and not np.isfinite(graph.length):
            yield message("wrong.scale", text="μφ")
        elif graph.marks:
            yield from GraphStrokes(graph.name, graph.group, graph.laid, expected, graph.names, drafting).faults()
    names = {graph.name: graph for graph in found}
    if MOMENTS in names and WORKS in names:
        yield from _pole(leaf, names[MOMENTS], names[WORKS], drafting)


def edges_on(measured: Measured, leaf: Leaf, expected: Expected, name: str, like: str) -> Complexes | None:
    """Give where the values of a graph at the edges lie on paper, mm (n + 1,); None where it cannot be told.

    `like` is the graph whose heading states the scale of the angle.
    """
    own, other = group_named(leaf.groups, name), group_named(leaf.groups, like)
    if own is None or other is None:
        return None
    graph = _Graph(name, own, measured, expected, written_scales(other).get("φ", NONE))
    if not graph.marks or not np.isfinite(graph.length):
        return None
    rows = zip(expected.cycle.turned.tolist(), graph.values.tolist(), strict=True)
    return np.array([graph.on(*row) for row in rows])


@dataclass(frozen=True)
class _Graph:
    """A graph on a sheet, with what it must show."""

    name: str
    group: Group
    measured: Measured
    expected: Expected
    angle: float  # scale of the angle that the graphs under one another share, rad/mm

    @property
    def values(self) -> Floats:
        return self.expected.graphs[self.name]

    @property
    def along(self) -> complex:
        """The way of the angles on paper."""
        return -1j if self.name == INERTIA else 1 + 0j

    @property
    def rise(self) -> complex:
        return 1 + 0j if self.name == INERTIA else 1j

    @cached_property
    def marks(self) -> Mapping[int, MeasuredVector]:
        """The ordinates by their edges."""
        return {
            one.position: one for one in self.measured.vectors if one.plan == self.name and one.position is not None
        }

    @property
    def told(self) -> frozenset[int]:
        """The edges with an ordinate."""
        return frozenset(self.marks)

    @property
    def mu(self) -> float:
        """The scale of the ordinates."""
        return next((one.scale for one in self.marks.values()), 1.0)

    @property
    def slack(self) -> float:
        """How far a value may be off: the sheet's own resolution, and what both roads may differ by."""
        return 2 * self.measured.quantum * self.mu + KNOWN * float(np.abs(self.values).max(initial=0.0))

    @property
    def length(self) -> float:
        """The scale of the angle as it is written, rad/mm."""
        return written_scales(self.group).get("φ", NONE) if self.name == INERTIA else self.angle

    def faults(self, shared: frozenset[int], language: str) -> Iterator[Wrong]:
        yield from self._ordinates(shared)
        yield from self._scales(language)
        if self.marks:
            yield from self._feet()
            yield from self._curve()

    def _ordinates(self, shared: frozenset[int]) -> Iterator[Wrong]:
        """Hold the ordinates; one that others of the plate have and that is no point must be there."""
        last = len(self.values) - 1
        for k, one in self.marks.items():
            if not 0 <= k <= last or not abs(one.value - self.rise * self.values[k]) <= self.slack:
                yield on("differs_at", self.name, name=one.name, position=k)
        seen = {text.plain for text in texts((self.group,))}
        due = shared | {k for k, name in enumerate(self.names) if name in seen}
        for k in sorted(due - self.told):
            if 0 <= k <= last and abs(self.values[k]) > SHORT * self.mu:
                yield on("missing_at", self.name, name=self.names[k], position=k)

    @property
    def names(self) -> tuple[str, ...]:
        return edge_names(self.expected)

    def _scales(self, language: str) -> Iterator[Wrong]:
        """Hold the written scales against those that the ordinates state."""
        stated = {one.quantity: one.scale for one in self.marks.values()}
        found = written_scales(self.group)
        for letter, mu in stated.items():
            if number(found.get(letter, 0.0), language) != number(mu, language):
                yield message("wrong.scale", text=f"μ_{letter}")

    @property
    def laid(self) -> Laid:
        """Where it lies on paper."""
        return Laid(self.zero, self.length, self.mu, self.along, self.rise, self.told)

    @property
    def zero(self) -> complex:
        """The beginning of the axis of angles on paper, by its first ordinate."""
        k, one = next(iter(self.marks.items()))
        return complex(one.start - self.along * self.expected.cycle.turned[k] / self.length)

    def on(self, angle: float, value: float) -> complex:
        """Give the place on paper of a value, mm."""
        return self.zero + self.along * angle / self.length + self.rise * value / self.mu

    def _feet(self) -> Iterator[Wrong]:
        """Hold the places of the ordinates along the axis."""
        turned = self.expected.cycle.turned
        for k, one in self.marks.items():
            if 0 <= k < len(turned) and not abs(one.start - self.on(turned[k], 0.0)) <= self.near:
                yield on("foot", self.name, name=one.name)

    @property
    def near(self) -> float:
        """How far a place may be off on paper, mm."""
        return self.slack / self.mu + KNOWN * TURN / self.length + self.measured.quantum

    def _curve(self) -> Iterator[Wrong]:
        """See that a point stands at each marked edge, at a jump two, and that curves and lines go through theirs."""
        turned, places = self.expected.cycle.turned, np.array(list(vertices(self.group)))
        dots = np.array([one.centre for one in walk((self.group,)) if isinstance(one, Circle)])
        rows = [self.values, self.expected.before] if self.name == MOMENTS else [self.values]
        for k, angle in enumerate(turned):
            spots = [self.on(angle, float(row[k])) for row in rows]
            marked = len(turned) <= MARKED + 1 or k in self.told
            if not all((has(dots, spot, self.near) or not marked) and has(places, spot, self.near) for spot in spots):
                yield on("edge", self.name, name=self.names[k])
        chains = [one.points for one in walk((self.group,)) if isinstance(one, Polyline)]
        for start, end in self.expected.lines.get(self.name, ()):
            ends = self.on(0.0, start), self.on(TURN, end)
            if not any(straight(chain, ends, self.near) for chain in chains):
                yield on("line", self.name)


SHORT = 0.1  # mm: an ordinate that is shorter may be a point


def vertices(group: Group) -> Iterator[complex]:
    """Give the corners of all chains of lines of a part; a chain of one line that goes across is one too."""
    for one in walk((group,)):
        if isinstance(one, Polyline):
            yield from one.points
        elif isinstance(one, Line) and one.start.real != one.end.real:
            yield from (one.start, one.end)


def has(places: np.ndarray[tuple[int, ...], np.dtype[np.complex128]], spot: complex, near: float) -> bool:
    """Tell whether one of some places is near a spot."""
    return bool(places.size) and bool(np.abs(places - spot).min() <= near)


def straight(chain: Sequence[complex], ends: tuple[complex, complex], near: float) -> bool:
    """Tell whether a chain of lines goes straight from one end to another."""
    start, end = ends
    along = (end - start) / abs(end - start)
    apart = [abs(chain[0] - start), abs(chain[-1] - end), *(abs(((p - start) / along).imag) for p in chain)]
    return max(apart) <= near


def edge_names(expected: Expected) -> tuple[str, ...]:
    """Name the edges: positions by their numbers, those between two of them by the first one's with primes."""
    places = expected.cycle.turned * expected.task.divisions / TURN
    names: list[str] = []
    for place in places:
        whole = int(np.floor(place + KNOWN))
        primes = 0 if abs(place - whole) <= KNOWN else 1 + sum(one.startswith(f"{whole}'") for one in names)
        names.append(f"{whole}" + "'" * primes)
    return tuple(names)


def _pole(leaf: Leaf, moments: _Graph, works: _Graph, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the pole distance against the scales, the pole and each ray against it."""
    group = group_named(leaf.groups, POLE)
    told = _DISTANCE.search(" ".join(text.plain for text in texts((works.group,))))
    if group is None or told is None:
        yield message("wrong.missing", name="H_p")
        return
    if not moments.marks or not works.marks:  # nothing acts; an ordinate that is missing is told of by itself
        return
    distance = works.mu / (moments.mu * moments.length)
    if not abs(float(told[1].replace(",", ".")) - distance) <= WRITTEN * distance:
        yield message("wrong.scale", text=told[0])
    pole = moments.zero - distance
    if not has(np.array([one.centre for one in walk((group,)) if isinstance(one, Circle)]), pole, moments.near):
        yield on("differs_on", MOMENTS, name="P")
    means = np.array([moments.on(0.0, -float(mean)) for mean in moments.expected.cycle.means])
    rays = [one.end for one in walk((group,)) if isinstance(one, Line) and abs(one.start - pole) <= moments.near]
    rays = [end for end in rays if abs(end.real - pole.real) > moments.near]  # the rest dimensions the distance
    true = np.append(means, moments.zero)
    yield from (on("ray", MOMENTS) for end in rays if not has(true, end, moments.near))
    if not any(has(np.array(rays), spot, moments.near) for spot in means if abs(spot - moments.zero) > SHORT):
        yield message("wrong.missing", name="P")
    turned, tips = moments.expected.cycle.turned, means
    feet = np.array([moments.on(float(x), 0.0) - moments.zero for x in (turned[1:] + turned[:-1]) / 2]) + tips
    yield from pole_strokes(group, moments.zero, distance, tips, feet, moments.near, drafting)


WRITTEN = 1e-3  # of a number: it is written with four digits
