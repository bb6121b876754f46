"""Every stroke and letter of the polygons and the curves of a bank ticked off, and none beside them (опись фигур)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance import figure_parts as parts
from drawings.checks.balance.figure_parts import Axis
from drawings.checks.bank import bank_curves
from drawings.checks.bank.bank_expected import Expected, Polygon
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line, written_scales
from drawings.checks.wrong import Wrong, on
from drawings.figures.bank.bank_polygon import plan_of
from drawings.figures.bank.turn_graph import STATIONS
from drawings.figures.rotor.letters import FEW
from drawings.lettering.bank_letters import lowered
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Group, Leaf, Line, Polyline
from drawings.paper.walk import group_named
from plans.bank.letters import MOMENT

ZERO, POLE = "0", "o"  # the letters of poles
TURN = 360.0  # degrees
UNITS = {"F": "N", "M": "N*m"}
TITLES = {"force_graph": "bank force title", "moment_graph": "bank moment title"}


def polygons(
    measured: Measured, leaf: Leaf, expected: Expected, by: Drafting, figures: Collection[str]
) -> Iterator[Wrong]:
    """Hold all that the polygons of a sheet show."""
    for one in expected.polygons():
        plan = plan_of(one.kind, one.signed)
        part = group_named(leaf.groups, plan)
        if part is not None and plan in figures:
            yield from _polygon(measured, one, part, by)


def _polygon(measured: Measured, one: Polygon, part: Group, by: Drafting) -> Iterator[Wrong]:
    plan = plan_of(one.kind, one.signed)
    seen, mu = marks.vectors(measured, plan), marks.scale(measured, plan)
    ink, pole = parts.inventory(plan, part, parts.NEAR + one.slack / mu), marks.pole(part)
    key = ("moments of order" if one.kind == MOMENT else "forces of order") + ("" if one.signed > 0 else " back")
    closed = [] if one.name in seen else [by.word("closes by itself")]
    faint = ", ".join(_lettered(name) for name in seen if _length(one, name) < SEEN * mu)
    short = [by.word("unlettered", names=faint)] if faint else []
    scale = scale_line(mu, one.kind, UNITS[one.kind], by)
    parts.headed(ink, by.word(key, order=abs(one.signed)), [scale, *closed, *short])
    if one.slack >= SEEN * mu:  # forces of rounding, drawn as large as they are: no road tells where their lines are
        yield from ink.wrong
        return
    parts.spot(ink, pole, ZERO, ZERO)
    parts.weighed(ink, part, one.name, by.hand.main)
    starts = _starts(one, seen, part, mu, ink.near)
    for name, vector in seen.items():
        number = name.partition(",")[2]
        parts.arrow(ink, vector, number if len(seen) > FEW and number else lowered(name))
        if name in starts:
            parts.carried(ink, vector, starts[name], vector.end - vector.start)
        else:
            ink.wrong.append(on("start", plan, name=name))
    yield from ink.faults()


def _lettered(name: str) -> str:
    return read(lowered(name))


def _length(one: Polygon, name: str) -> float:
    return abs(one.sides.get(name, one.whole))


class _Chain(NamedTuple):
    """The sides of a polygon on paper, to be laid end to end again: where each is drawn, and its value, mm."""

    drawn: Mapping[str, MeasuredVector]
    values: Mapping[str, complex]
    thin: Sequence[Line]  # the lines by which sides are carried over to lanes
    near: float

    def starts(self, left: frozenset[str], at: complex) -> dict[str, complex] | None:
        """Find where each of some sides belongs from a place on, whatever their order; None where they cannot be."""
        for name in sorted(left):
            if self._goes_from(name, at):
                rest = self.starts(left - {name}, at + self.values[name])
                if rest is not None:
                    return {name: at, **rest}
        return None if left else {}

    def _goes_from(self, name: str, at: complex) -> bool:
        """Tell whether a side goes from a place, or is carried over from there to its lane."""
        shift = self.drawn[name].start - at
        if abs(shift) <= self.near:
            return True
        off, value = shift / self.values[name], self.values[name]
        square = abs(off.real) * abs(value) <= self.near
        return square and all(any(self._carries(one, end, shift) for one in self.thin) for end in (at, at + value))

    def _carries(self, one: Line, end: complex, shift: complex) -> bool:
        return abs(one.start - end) <= self.near and ((one.end - one.start) / shift).real > 1


def _starts(
    one: Polygon, seen: Mapping[str, MeasuredVector], part: Group, mu: float, near: float
) -> dict[str, complex]:
    """Find where the vectors of a polygon belong: sides end to end from the pole, the sum from there too."""
    thin, pole = [line for line in part.strokes if isinstance(line, Line)], marks.pole(part)
    drawn = {name: seen[name] for name in one.sides if name in seen}
    chain = _Chain(drawn, {name: value / mu for name, value in one.sides.items()}, thin, near)
    return {**(chain.starts(frozenset(drawn), pole) or {}), **({one.name: pole} if one.name in seen else {})}


def curves(
    measured: Measured, leaf: Leaf, expected: Expected, by: Drafting, figures: Collection[str]
) -> Iterator[Wrong]:
    """Hold all that the graphs and hodographs of a sheet show."""
    told: dict[str, list[str]] = {}
    for plan in bank_curves.due(expected, figures):
        told.setdefault(bank_curves.figure_of(expected, plan), []).append(plan)
    for name, plans in told.items():
        part = group_named(leaf.groups, name)
        if part is not None and name in figures:
            yield from (_graph if name in TITLES else _hodograph)(measured, part, expected, by, plans)


def _hodograph(measured: Measured, part: Group, expected: Expected, by: Drafting, plans: list[str]) -> Iterator[Wrong]:
    (plan,) = plans
    finding, letter, _ = bank_curves.CURVES[plan]
    values, mu, pole = expected.force_of(finding), marks.scale(measured, plan), marks.pole(part)
    ink = parts.inventory(plan, part, parts.NEAR + expected.allowed[finding] / mu)
    symbol = letter.rstrip("'")
    parts.headed(ink, by.word(f"hodograph of {plan}"), [scale_line(mu, symbol, UNITS[symbol], by)])
    parts.spot(ink, pole, POLE, POLE)
    for one in marks.vectors(measured, plan).values():
        ink.line(one.start, one.end)
        ink.head(one.end, one.end - one.start, on("head", plan, name=letter))
    ink.letter_along(letter, pole, pole + complex(values[0]) / mu, on("letter", plan, name=letter))
    known = marks.points(measured, plan)
    for number in range(STATIONS):
        spot = pole + complex(values[number * (len(values) - 1) // STATIONS]) / mu
        sure = str(number) in known
        ink.circle(spot, on("edge", plan, name=str(number)))
        ink.letter(str(number), [spot], on("letter", plan, name=str(number)) if sure else None)
    ink.take(Polyline, lambda one: one.closed, on("curve", plan))
    yield from ink.faults()


def _graph(measured: Measured, part: Group, expected: Expected, by: Drafting, plans: list[str]) -> Iterator[Wrong]:
    scales, drawn = written_scales(part), [one for one in measured.vectors if one.plan in plans]
    letter = bank_curves.CURVES[plans[0]][1]
    if "φ" not in scales or not drawn:
        return
    rows = {plan: expected.force_of(bank_curves.CURVES[plan][0]).real for plan in plans}
    mu, across = drawn[0].scale, scales["φ"]
    slack = max(expected.allowed[bank_curves.CURVES[plan][0]] for plan in plans)
    ink = parts.inventory(part.name, part, parts.NEAR + slack / mu)
    angle, own = scale_line(across, "φ", "°", by), scale_line(mu, letter, UNITS[letter], by)
    parts.headed(ink, by.word(TITLES[part.name]), [angle, own])
    zero = drawn[0].start - int(drawn[0].position or 0) * TURN / (len(rows[plans[0]]) - 1) / across
    _axes(ink, zero, across, mu, list(rows.values()), f"{letter}, {by.word(UNITS[letter])}")
    for one in drawn:
        ink.line(one.start, one.end)
    for plan, values in rows.items():
        _course(ink, values, zero, (across, mu), plan == plans[0])
        if len(plans) > 1:
            name, even = bank_curves.CURVES[plan][1], 2 * expected.allowed[bank_curves.CURVES[plan][0]]
            tops = np.flatnonzero(np.abs(values) >= np.abs(values).max() - even)  # of a pure harmonic, several
            spots = [zero + int(k) * TURN / (len(values) - 1) / across + 1j * float(values[k]) / mu for k in tops]
            ink.letter(name, spots, on("letter", part.name, name=name))
    yield from ink.faults()


def _axes(
    ink: Inventory, zero: complex, across: float, mu: float, rows: list[np.ndarray[tuple[int], np.dtype[np.float64]]],
    letter: str,
) -> None:  # fmt: skip
    low = min(0.0, *(float(row.min()) for row in rows))
    high = max(0.0, *(float(row.max()) for row in rows))
    axes = [Axis("φ", zero, zero + TURN / across), Axis(letter, zero + 1j * low / mu, zero + 1j * high / mu)]
    parts.axes(ink, axes)


def _course(
    ink: Inventory,
    values: np.ndarray[tuple[int], np.dtype[np.float64]],
    zero: complex,
    scales: tuple[float, float],
    numbered: bool,
) -> None:
    """Tick off a curve, its points, the ticks under them; the numbers of the stations stand once."""
    across, mu = scales
    last = len(values) - 1
    for k in range(0, last + 1, last // STATIONS):
        foot, name = zero + k * TURN / last / across, str(k * STATIONS // last % STATIONS)
        parts.tick(ink, foot, 1j, on("tick", ink.plan, name=name))
        parts.dots(ink, [(name, foot + 1j * float(values[k]) / mu)])
        if numbered:
            ink.letter(name, [foot], on("letter", ink.plan, name=name))
    ink.take(Polyline, lambda one: len(one.points) == len(values), on("curve", ink.plan))
