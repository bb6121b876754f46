"""Every stroke and letter of the polygon and the graphs of balancing ticked off, and none beside them (опись фигур)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance import figure_parts as parts
from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance.balance_schemes import runs
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.wrong import Wrong, on
from drawings.figures.balance import shaking_hodograph, static_polygon
from drawings.lettering.balance_letters import RESULT, lowered
from drawings.measure.measured import MeasuredVector
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import group_named

POLE, ZERO = "o", "0"  # the letters of poles


class Figure(NamedTuple):
    """A figure of a sheet, with its marks and what is expected of it."""

    plan: str
    part: Group
    expected: Expected

    @property
    def vectors(self) -> dict[str, MeasuredVector]:
        """The vectors of it that were measured."""
        return marks.vectors(self.expected.measured, self.plan)

    @property
    def mu(self) -> float:
        """Its scale."""
        return marks.scale(self.expected.measured, self.plan)

    @property
    def pole(self) -> complex:
        """Where its pole is, mm."""
        return marks.pole(self.part)


def polygon(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold all that the polygon of static moments shows."""
    part = group_named(leaf.groups, static_polygon.NAME)
    if part is None:
        return
    figure, word = Figure(static_polygon.NAME, part, expected), expected.drafting.word
    ink, seen = parts.inventory(figure.plan, part), figure.vectors
    own = [word("no vectors")]
    if seen:
        closed = [] if RESULT in seen else [word("closes by itself")]
        own = [scale_line(figure.mu, "{mr}", "kg*m", expected.drafting), *closed]
    parts.headed(ink, f"{word('polygon of static moments')}, {word('position', position=expected.shown)}", own)
    parts.spot(ink, figure.pole, ZERO, ZERO)
    parts.weighed(ink, part, RESULT, expected.drafting.hand.main)
    starts = {one.name: one.start for one in expected.moments()} | {RESULT: 0j}
    for name, one in seen.items():
        parts.arrow(ink, one, lowered(name))
        parts.carried(ink, one, figure.pole + starts.get(name, 0j) / figure.mu, one.end - one.start)
    yield from ink.faults()


def shaking(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold all that the hodographs of the main vector show."""
    part = group_named(leaf.groups, shaking_hodograph.NAME)
    if part is None:
        return
    figure, word = Figure(shaking_hodograph.NAME, part, expected), expected.drafting.word
    states = [name for name, one in expected.states.items() if one.shaking > expected.none.force]
    slack = max(expected.slack(name) for name in ("Φ", "Φ'")) / figure.mu
    ink = parts.inventory(figure.plan, part, parts.NEAR + slack)
    thin = [word("thin before")] if len(states) > 1 else []
    parts.headed(ink, word("shaking hodograph"), [scale_line(figure.mu, "F", "N", expected.drafting), *thin])
    parts.spot(ink, figure.pole, POLE, POLE)
    for name, one in figure.vectors.items():
        _shown(ink, one, name)
    for state in states:
        _state(ink, figure, state)
    yield from ink.faults()


def _shown(ink: Inventory, one: MeasuredVector, name: str) -> None:
    """Tick off the vector of the shown position: its letter stands by its middle."""
    ink.line(one.start, one.end)
    length = abs(one.end - one.start)
    ink.head(
        one.end, one.end - one.start, on("head", ink.plan, name=name) if length > parts.HEADED + ink.near else None
    )
    ink.letter_along(read(name), one.start, one.end, on("letter", ink.plan, name=name))


def _state(ink: Inventory, figure: Figure, state: str) -> None:
    """Tick off the curve of a state, the points on it, and their numbers where these have room."""
    expected, one = figure.expected, figure.expected.states[state]
    curve = group_named((figure.part,), f"{figure.plan}-{state}")
    count = sum(1 for run in runs(np.asarray(one.around.force)) if len(run) > 1) if expected.whole else 0
    parts.chains(ink, curve, count, state)
    ends = {k: complex(one.centre.force[k]) for k in sorted(expected.told)}
    known = {k: figure.pole + value / figure.mu for k, value in ends.items() if np.isfinite(value)}
    parts.dots(ink, ((f"{state} {k}", at) for k, at in known.items()))
    marked = marks.points(expected.measured, figure.plan)
    for k, at in known.items():
        numbered = f"{state} {k}" in marked
        ink.letter(str(k), [at], on("letter", ink.plan, name=f"{state} {k}") if numbered else None)
