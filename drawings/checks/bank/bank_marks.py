"""The self-check of what can be measured on the sheets of a bank: vectors, crank pins, places, masses (метки)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from drawings.checks.bank.bank_expected import Expected, Polygon
from drawings.checks.wrong import Wrong, on
from drawings.figures.bank import shaft, star
from drawings.figures.bank.bank_polygon import plan_of
from drawings.figures.rotor.letters import MOST
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector

FAR = 1e-9  # of a place: both roads take it from one length and one angle


def polygons(measured: Measured, expected: Expected, figures: frozenset[str]) -> Iterator[Wrong]:
    """Hold the polygons that a sheet bears: every vector that must be there, none that is not."""
    for one in expected.polygons():
        if plan_of(one.kind, one.signed) in figures:
            yield from _Seen(measured, one).faults()


class _Seen(NamedTuple):
    """A polygon as it is measured, with what it must show."""

    measured: Measured
    true: Polygon

    @property
    def plan(self) -> str:
        return plan_of(self.true.kind, self.true.signed)

    @property
    def seen(self) -> Mapping[str, MeasuredVector]:
        """The vectors that are there by their names."""
        return {one.name: one for one in self.measured.vectors if one.plan == self.plan}

    @property
    def due(self) -> Mapping[str, complex]:
        """The vectors that must be there; of too many the sum alone."""
        true, sides = self.true, {} if len(self.true.sides) > MOST else self.true.sides
        summed = true.open or (true.name in self.seen and not true.closed)
        return {**sides, **({true.name: true.whole} if summed else {})}

    def faults(self) -> Iterator[Wrong]:
        seen = self.seen
        paper = 2 * self.measured.quantum * max((one.scale for one in seen.values()), default=0.0)
        yield from (on("stranger_on", self.plan, name=name) for name in seen.keys() - self.due.keys())
        for name, value in self.due.items():
            slack = self.true.side_slack.get(name, self.true.slack)
            if name not in seen:
                yield on("missing_on", self.plan, name=name)
            elif not abs(seen[name].value - value) <= slack + paper:
                yield on("differs_on", self.plan, name=name)
        left = abs(sum(one.value for one in seen.values()))
        if self.true.name not in self.due and left > self.true.slack + len(seen) * paper:
            yield on("open", self.plan)


def places(measured: Measured, expected: Expected, figures: frozenset[str]) -> Iterator[Wrong]:
    """Hold the crank pins of the star, and the places along the shaft."""
    if star.NAME in figures and expected.crank is not None:
        pins = {one.name: expected.crank * expected.crank_at(one) for one in expected.members}
        yield from points(measured, star.NAME, pins)
    if shaft.NAME in figures:
        yield from points(measured, shaft.NAME, {one.name: complex(float(one.place)) for one in expected.members})


def points(
    measured: Measured, plan: str, true: Mapping[str, complex], slack: Mapping[str, float] | None = None
) -> Iterator[Wrong]:
    """Hold the points of a figure: each that must be there, none that is not."""
    seen = {one.name: one for one in measured.points if one.plan == plan}
    yield from (on("stranger_on", plan, name=name) for name in seen.keys() - true.keys())
    yield from (on("missing_on", plan, name=name) for name in true.keys() - seen.keys())
    for name in seen.keys() & true.keys():
        one, own = seen[name], (slack or {}).get(name, FAR * abs(true[name]))
        if not abs(one.value - true[name]) <= own + 2 * measured.quantum * one.scale:
            yield on("differs_on", plan, name=name)
