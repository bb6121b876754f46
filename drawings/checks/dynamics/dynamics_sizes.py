"""The self-check of load diagrams and of the flywheel's sketch: corners, strokes, sizes (проверка размеров)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.checks.dynamics.dynamics_expected import KNOWN, Expected
from drawings.checks.dynamics.dynamics_graphs import has, vertices
from drawings.checks.dynamics.load_law import branches
from drawings.checks.dynamics.load_strokes import Laid, LoadStrokes
from drawings.checks.dynamics.sketch_strokes import SketchStrokes
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import Wrong, on
from drawings.figures.dynamics import flywheel_sketch, load_diagram
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import group_named
from plans.analytic.dynamics.rim import wheel
from plans.forces.stroke import Stroke
from plans.model.machine import Force, Machine, Moment, Track
from plans.words.words import message

BENT = 2e-3  # of two slopes: a bend that is less need not be told
OVERRUNS = ("overrun_1", "overrun_2")


def loads(
    names: Sequence[str],
    measured: Measured,
    leaf: Leaf,
    machine: Machine,
    strokes: Mapping[Track, Stroke],
    drafting: Drafting,
    spots: Mapping[str, Sequence[complex]] | None = None,
) -> Iterator[Wrong]:
    """Hold each load diagram on a sheet against the load of the machine.

    `spots` are the places on paper, by the names of diagrams, at which the load is in the positions of a sheet.
    """
    every: tuple[Force | Moment, ...] = (*machine.forces, *machine.moments)
    known = {f"{load_diagram.NAME}-{one.name}": one for one in every}
    for name in names:
        own, group = [one for one in measured.vectors if one.plan == name], group_named(leaf.groups, name)
        if group is not None:
            shown = _Load(name, group, {one.name: one for one in own}, measured.quantum, known[name])
            stroke = strokes[known[name].stroke]
            yield from shown.faults(stroke)
            yield from shown.strokes(stroke, (spots or {}).get(name, ()), drafting)


@dataclass(frozen=True)
class _Load:
    """A load diagram on a sheet, with the load of the machine."""

    plan: str
    group: Group
    seen: Mapping[str, MeasuredVector]
    quantum: float
    load: Force | Moment

    def faults(self, stroke: Stroke) -> Iterator[Wrong]:
        """Hold the stroke first: all places are counted from its beginning."""
        (length, name), whole = _whole(stroke), self.whole(stroke)
        if whole is None:
            yield on("missing_on", self.plan, name=name)
            return
        near = 3 * self.quantum * whole.scale + KNOWN * length
        if not abs(whole.value - length) <= near:
            yield on("differs_on", self.plan, name=name)
        for mark, share in zip(OVERRUNS, self.load.overrun, strict=True):
            found = self.seen[mark].value if mark in self.seen else 0j
            if not abs(found - share * length) <= near:
                yield on("differs_on", self.plan, name=f"{share:g}{name}")
        yield from self._scales()
        yield from self._corners(whole, length, near)

    def whole(self, stroke: Stroke) -> MeasuredVector | None:
        """Give the stroke as it is dimensioned."""
        return self.seen.get(_whole(stroke)[1])

    @property
    def ordinates(self) -> list[MeasuredVector]:
        """The ordinates of the corners."""
        return [one for name, one in self.seen.items() if name not in ("H", "ψ", *OVERRUNS)]

    def strokes(self, stroke: Stroke, spots: Sequence[complex], drafting: Drafting) -> Iterator[Wrong]:
        """Hold all that is drawn of it, where its stroke and an ordinate tell its place and scales."""
        (length, _), whole, marks = _whole(stroke), self.whole(stroke), self.ordinates
        if whole is not None and marks:
            zero, near = complex(whole.start.real, marks[0].start.imag), KNOWN * length / whole.scale
            laid = Laid(zero, length, whole.scale, marks[0].scale)
            near += KNOWN * max(abs(one.value) / one.scale for one in marks)
            yield from LoadStrokes(
                self.plan, self.group, laid, self.load, stroke.sliding, marks, spots, near, drafting
            ).faults()

    def _scales(self) -> Iterator[Wrong]:
        scales = written_scales(self.group)
        stated = {one.quantity: one.scale for one in self.seen.values()}
        for letter, mu in stated.items():
            if not math.isclose(scales.get(letter, math.nan), mu, rel_tol=1e-9):
                yield message("wrong.scale", text=f"μ_{letter}")

    def _corners(self, whole: MeasuredVector, length: float, near: float) -> Iterator[Wrong]:
        """Hold the ordinates: each at a corner, of few corners each has one, and a line goes through all."""
        due = list(_corners(self.load))
        most = max((abs(one.size) for one in due), default=0.0)
        marks = self.ordinates
        told = set[_Corner]()
        for one in marks:
            way = (one.start - whole.start).real * whole.scale
            fits = {c for c in due if abs(c.share * length - way) <= near and self._same(one, c.size, most)}
            yield from () if fits else (on("differs_on", self.plan, name=one.name),)
            told |= fits
        few, chain = sum(one.bent for one in due) <= load_diagram.FEW, np.array(list(vertices(self.group)))
        for corner in due:
            base = marks[0].start.imag if marks else whole.start.imag
            mu = marks[0].scale if marks else 1.0
            spot = complex(whole.start.real + corner.share * length / whole.scale, base + corner.size / mu)
            due_mark = few and corner.bent and corner not in told
            if due_mark or not has(chain, spot, 2 * near / whole.scale + KNOWN * most / mu):
                yield on("corner", self.plan, way=f"{corner.share:.4g}", size=f"{corner.size:.4g}")

    def _same(self, one: MeasuredVector, size: float, most: float) -> bool:
        return abs(one.value - 1j * size) <= 2 * self.quantum * one.scale + KNOWN * most


def _whole(stroke: Stroke) -> tuple[float, str]:
    """Give the length of a stroke, m or degrees, and its letter."""
    length = abs(stroke.reach[1] - stroke.reach[0])
    return (length, "H") if stroke.sliding else (math.degrees(length), "ψ")


class _Corner(NamedTuple):
    """A corner of a load: share of the stroke, size; whether the load bends there, or begins or ends."""

    share: float
    size: float
    bent: bool


def _corners(load: Force | Moment) -> Iterator[_Corner]:
    """Give every corner of a load that is not zero, by its law alone."""
    for _, shares, found in branches(load):
        slopes = np.diff(found) / np.diff(shares)
        bends = np.abs(np.diff(slopes)) > BENT * (np.abs(slopes[1:]) + np.abs(slopes[:-1]))
        bent = [True, *bends.tolist(), True]
        rows = zip(shares.tolist(), found.tolist(), bent, strict=True)
        yield from (_Corner(*row) for row in rows if row[1])


def flywheel(measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the sizes of the rim, as they are drawn and as they are lettered."""
    plan, group = flywheel_sketch.NAME, group_named(leaf.groups, flywheel_sketch.NAME)
    true = None if expected.wheel is None else wheel(expected.wheel.inertia, expected.task.rim)
    if true is None or group is None:
        yield message("wrong.missing", name=plan)
        return
    seen = {one.name: one for one in measured.vectors if one.plan == plan}
    sizes = {"D": 1j * true.diameter, "t": 1j * true.thickness, "b": complex(true.breadth)}
    for name, value in sizes.items():
        one = seen.get(name)
        if one is None:
            yield on("missing_on", plan, name=name)
        elif not abs(one.value - value) <= 3 * measured.quantum * one.scale + KNOWN * abs(value):
            yield on("differs_on", plan, name=name)
    if seen:
        scale = next(iter(seen.values())).scale
        yield from SketchStrokes(group, true, scale, drafting).faults()
