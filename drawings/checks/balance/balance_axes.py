"""Every stroke and letter of the graphs of balancing ticked off: axes, ticks, points, curves (опись графиков)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from drawings.checks.balance import balance_graphs as graphs
from drawings.checks.balance import figure_parts as parts
from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance.balance_lines import Figure
from drawings.checks.balance.figure_parts import Axis
from drawings.checks.balance.share_level import bare, curve_letter
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line, written_scales
from drawings.checks.precise import KNOWN
from drawings.checks.wrong import Wrong, on
from drawings.figures.balance import moment_graph, share_graph
from drawings.figures.graphs.curve_graph import BEFORE as THIN
from drawings.lettering.balance_letters import MOMENT
from drawings.paper.strokes import Circle, Leaf, Line, Polyline, Text
from drawings.paper.walk import group_named
from drawings.symbols.symbols import TICK
from plans.model.balance.linkage import FORCE as LEAST_FORCE
from plans.model.balance.linkage import Choice
from plans.model.motion import Floats

TURN = 360.0  # degrees


def rocking(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold all that the graph of the main moment shows."""
    part = group_named(leaf.groups, moment_graph.NAME)
    if part is None or "φ" not in written_scales(part):
        return
    figure = Figure(moment_graph.NAME, part, expected)
    yield from _Rocking(figure).faults()


@dataclass(frozen=True)
class _Rocking:
    """The graph of the main moment on a sheet."""

    figure: Figure

    @property
    def expected(self) -> Expected:
        return self.figure.expected

    @cached_property
    def scales(self) -> tuple[float, float]:
        """The scales of both axes."""
        told = written_scales(self.figure.part)
        return told["φ"], self.figure.mu if self.figure.vectors else told.get("M", 1.0)

    @cached_property
    def zero(self) -> complex:
        """Where the axes cross."""
        seen = self.figure.vectors
        return graphs.zero_of(self.expected, seen, self.scales[0]) if seen else graphs.corner_of(self.figure.part)

    @cached_property
    def moments(self) -> Floats:
        """The moments at the positions, those that are nothing left out."""
        own = list(self.expected.states.values())[-1].centre.moment
        return np.where(np.abs(own) <= self.expected.none.moment, 0.0, own)

    @cached_property
    def dense(self) -> list[Floats]:
        """The moments over the turn of every state."""
        rows = (one.around.moment for one in self.expected.states.values())
        return [np.where(np.abs(row) <= self.expected.none.moment, 0.0, row) for row in rows]

    @property
    def known(self) -> bool:
        """Whether a whole turn without gaps is followed: else not all of its places are known."""
        return self.expected.whole and all(bool(np.isfinite(row).all()) for row in self.dense)

    def faults(self) -> Iterator[Wrong]:
        across, up = self.scales
        largest = max(one.rocking for one in self.expected.states.values())
        slack = max(self.expected.slack(name) for name in ("M_Φ", "M_Φ'")) + KNOWN * largest
        ink = parts.inventory(self.figure.plan, self.figure.part, parts.NEAR + slack / up + KNOWN * TURN / across)
        self._headed(ink)
        self._axes(ink)
        for k in sorted(self.expected.told):
            self._station(ink, k)
        self._curves(ink)
        yield from ink.faults()

    def _headed(self, ink: Inventory) -> None:
        by, (across, up) = self.expected.drafting, self.scales
        thin = [by.word("thin before")] if self.expected.whole and len(self.expected.states) > 1 else []
        under = [scale_line(across, "φ", "°", by), scale_line(up, "M", "N*m", by), *thin]
        parts.headed(ink, by.word("rocking graph", point=self.expected.mechanism.drive.pivot), under)

    def _axes(self, ink: Inventory) -> None:
        across, up = self.scales
        letter = f"{MOMENT}, {self.expected.drafting.word('N*m')}"
        if self.known:
            rows = [0.0, *(float(end) for row in (*self.dense, self.moments) for end in (row.min(), row.max()))]
            last = self.zero + TURN / across
            low, high = (self.zero + 1j * end / up for end in (min(rows), max(rows)))
            parts.axes(ink, [Axis("φ", self.zero, last), Axis(letter, low, high)])
            parts.tick(ink, last, 1j, on("tick", ink.plan, name="0"))
            ink.letter("0", [last], on("letter", ink.plan, name="0"))
            return
        for text, way in (("φ", 1 + 0j), (letter, 1j)):
            axis = ink.take(Line, partial(_goes, way=way), on("axes", ink.plan, name=read(text)))
            if axis is not None:
                ink.head(axis.end, way, on("head", ink.plan, name=read(text)))
                ink.letter(read(text), [axis.end], on("letter", ink.plan, name=read(text)))

    def _station(self, ink: Inventory, k: int) -> None:
        """Tick off what stands at a position: tick, ordinate, point, number."""
        one, (across, up) = self.figure.vectors.get(str(k)), self.scales
        sure = one is not None or (self.known and not graphs.crowded(k, self.figure.vectors, self.expected))
        value = float(self.moments[k])
        if one is None and not (self.known and math.isfinite(value)):
            return
        foot = one.start if one is not None else self.zero + graphs.stations_of(self.expected)[k] / across
        if one is not None:
            ink.line(one.start, one.end)
        parts.tick(ink, foot, 1j, on("tick", ink.plan, name=str(k)) if sure else None)
        ink.letter(str(k), [foot], on("letter", ink.plan, name=str(k)) if sure else None)
        parts.dots(ink, [(str(k), foot + 1j * value / up)], sure)

    def _curves(self, ink: Inventory) -> None:
        """Tick off the curves, one chain each; at gaps, of which less is known, all chains and what is left beside."""
        states = list(self.expected.states)
        if len(states) > 1 and self.expected.whole:
            thin = group_named((self.figure.part,), THIN)
            parts.chains(ink, thin, 1 if self.known else len(thin.strokes) if thin is not None else 0, states[0])
        if self.known:
            ink.take(Polyline, lambda one: len(one.points) > TURN / 2, on("path", ink.plan, name=states[-1]))
            return
        ink.every(Polyline, lambda one: self.expected.whole)  # between positions alone nothing is known
        ink.every(Circle, lambda one: True)
        ink.every(Line, lambda one: abs(abs(one.end - one.start) - 2 * TICK) <= ink.near)
        ink.every(Text, lambda one: one.plain.isdigit())


def _goes(one: Line, way: complex) -> bool:
    """Tell whether a line is long and goes in a direction."""
    run = (one.end - one.start) / way
    return abs(run.imag) <= parts.NEAR and run.real > parts.BEYOND


def shares(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold all that the choice of the share shows."""
    part = group_named(leaf.groups, share_graph.NAME)
    if part is None or expected.balance.shares is None or "k" not in written_scales(part):
        return
    figure = Figure(share_graph.NAME, part, expected)
    if figure.vectors:
        yield from _Shares(figure).faults()


@dataclass(frozen=True)
class _Shares:
    """The choice of the share on a sheet."""

    figure: Figure

    @property
    def expected(self) -> Expected:
        return self.figure.expected

    @cached_property
    def scales(self) -> tuple[float, float]:
        return written_scales(self.figure.part)["k"], self.figure.mu

    @cached_property
    def best(self) -> dict[str, tuple[float, float]]:
        """The least places of both curves: share and value."""
        found = self.expected.balance.shares
        assert found is not None  # asked before
        rows = {share_graph.FORCES: found.least_force, share_graph.REACTIONS: found.least_reaction}
        return {kind: (one.share, graphs.value_of(one, kind)) for kind, one in rows.items()}

    @cached_property
    def zero(self) -> complex:
        kind, one = next(iter(self.figure.vectors.items()))
        return one.start - self.best[kind][0] / self.scales[0]

    @cached_property
    def high(self) -> float:
        """The largest value that is shown, N."""
        found = self.expected.balance.shares
        assert found is not None  # asked before
        curves = (graphs.value_of(one, kind) for one in found.curve for kind in self.best)
        return max(bare(self.expected), *curves)

    def on(self, share: float, value: float = 0.0) -> complex:
        """Give where a value of a share is on paper, mm."""
        return self.zero + share / self.scales[0] + 1j * value / self.scales[1]

    def faults(self) -> Iterator[Wrong]:
        ink = parts.inventory(self.figure.plan, self.figure.part, parts.NEAR + KNOWN * self.high / self.scales[1])
        by, (across, up) = self.expected.drafting, self.scales
        parts.headed(ink, by.word("share graph"), [scale_line(across, "k", "1", by), scale_line(up, "F", "N", by)])
        rows = [Axis("k", self.on(0.0), self.on(1.0)), Axis(by.word("N"), self.on(0.0), self.on(0.0, self.high))]
        parts.axes(ink, rows)
        self._ticks(ink)
        self._levels(ink)
        for kind in self.best:
            self._curve(ink, kind)
        yield from ink.faults()

    def _ticks(self, ink: Inventory) -> None:
        """Tick off the numbers of both axes with their ticks."""
        number, step = self.expected.drafting.number, share_graph.LEVEL * self.scales[1]
        for k in range(share_graph.DIVISIONS + 1):
            share = k / share_graph.DIVISIONS
            if k:
                parts.tick(ink, self.on(share), 1j, on("tick", ink.plan, name=number(share)))
            ink.letter(number(share), [self.on(share)], on("letter", ink.plan, name=number(share)))
        for k in range(1, int(self.high / step * (1 + KNOWN)) + 1):
            sure, text = k * step <= self.high * (1 - KNOWN), number(k * step)
            parts.tick(ink, self.on(0.0, k * step), 1 + 0j, on("tick", ink.plan, name=text) if sure else None)
            ink.letter(text, [self.on(0.0, k * step)], on("letter", ink.plan, name=text) if sure else None)

    def _levels(self, ink: Inventory) -> None:
        """Tick off the level of the shaft without counterweights, and the upright line of the share taken."""
        found, task, size = self.expected.balance.shares, self.expected.balance.task, bare(self.expected)
        assert found is not None  # asked before
        best = found.least_force if task.least == LEAST_FORCE else found.least_reaction
        share = best.share if task.share is None else task.share
        ink.line(self.on(share), self.on(share, self.high), on("line", ink.plan))
        ink.line(self.on(0.0, size), self.on(1.0, size), on("line", ink.plan))
        letter = curve_letter(self.expected, share_graph.REACTIONS)
        text = read(self.expected.drafting.word("bare level", letter=letter))
        ink.letter(text, [self.on(0.5, size)], on("letter", ink.plan, name=text))

    def _curve(self, ink: Inventory, kind: str) -> None:
        """Tick off a curve with its letter, and its least place with what is told of it."""
        found, letter = self.expected.balance.shares, curve_letter(self.expected, kind)
        assert found is not None  # asked before
        wrong = on("letter", ink.plan, name=kind)
        curve, main = group_named((self.figure.part,), f"{ink.plan}-{kind}"), self.expected.drafting.hand.main
        parts.lined(ink, curve, kind, kind == share_graph.FORCES, main)
        parts.chains(ink, curve, 1, kind)
        one, least = self.figure.vectors.get(kind), self.on(*self.best[kind])
        if one is not None:
            ink.line(one.start, one.end)
        ink.circle(least, on("edge", ink.plan, name=kind))
        own = found.least_force if kind == share_graph.FORCES else found.least_reaction
        ink.take(Text, lambda text: self._tells(ink, text, letter, kind, own, least), wrong)
        ends = [self.on(one.share, graphs.value_of(one, kind)) for one in (*found.curve, own)]
        ink.letter(read(letter), [max(ends, key=lambda end: end.real)], wrong)

    def _tells(self, ink: Inventory, text: Text, letter: str, kind: str, own: Choice, least: complex) -> bool:
        return graphs.tells(text.plain, letter, own, kind, self.expected) and ink.beside(text, [least])
