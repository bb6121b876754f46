"""The self-check of load diagrams and of the flywheel's sketch: corners, strokes, sizes (проверка размеров)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.checks.dynamics_expected import KNOWN, Expected
from drawings.checks.dynamics_graphs import has, part, vertices, written
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.figures.dynamics import flywheel_sketch, load_diagram
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import texts
from plans.analytic.dynamics.rim import wheel
from plans.forces.stroke import Stroke
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, IDLE, WORKING, Force, Machine, Moment, Track
from plans.words.words import message

BENT = 2e-3  # of two slopes: a bend that is less need not be told
OVERRUNS = ("overrun_1", "overrun_2")


def loads(
    names: Sequence[str], measured: Measured, leaf: Leaf, machine: Machine, strokes: Mapping[Track, Stroke]
) -> Iterator[Wrong]:
    """Hold each load diagram on a sheet against the load of the machine."""
    every: tuple[Force | Moment, ...] = (*machine.forces, *machine.moments)
    known = {f"{load_diagram.NAME}-{one.name}": one for one in every}
    for name in names:
        own, group = [one for one in measured.vectors if one.plan == name], part(leaf, name)
        if group is not None:
            shown = _Load(name, group, {one.name: one for one in own}, measured.quantum, known[name])
            yield from shown.faults(strokes[known[name].stroke])


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
        length = abs(stroke.reach[1] - stroke.reach[0])
        length, name = (length, "H") if stroke.sliding else (math.degrees(length), "β")
        whole = self.seen.get(name)
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

    def _scales(self) -> Iterator[Wrong]:
        scales = written(self.group)
        stated = {one.quantity: one.scale for one in self.seen.values()}
        for letter, mu in stated.items():
            if not math.isclose(scales.get(letter, math.nan), mu, rel_tol=1e-9):
                yield message("wrong.scale", text=f"μ_{letter}")

    def _corners(self, whole: MeasuredVector, length: float, near: float) -> Iterator[Wrong]:
        """Hold the ordinates: each at a corner, of few corners each has one, and a line goes through all."""
        due = list(_corners(self.load))
        most = max((abs(one.size) for one in due), default=0.0)
        marks = [one for name, one in self.seen.items() if name not in (whole.name, *OVERRUNS)]
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


class _Corner(NamedTuple):
    """A corner of a load: share of the stroke, size; whether the load bends there, or begins or ends."""

    share: float
    size: float
    bent: bool


def _corners(load: Force | Moment) -> Iterator[_Corner]:
    """Give every corner of a load that is not zero, by its law alone."""
    law = load.diagram if isinstance(load, Force) else None
    begin, end = load.overrun[0], 1 - load.overrun[1]
    shares = np.array(sorted({begin, end, *(share for share in (law.travel if law else ()) if begin < share < end)}))
    turns = load.against if isinstance(load, Moment) else load.resists or (load.direction is None and load.line is None)
    for during, sense in (((WORKING, FORWARD), 1.0), ((IDLE, BACKWARD), -1.0 if turns else 1.0)):
        if load.during not in (ALWAYS, *during):
            continue
        sizes = (law.back or law.sizes if IDLE in during else law.sizes) if law else ()
        found = sense * load.size * (np.interp(shares, law.travel, sizes) if law else np.ones(len(shares)))
        slopes = np.diff(found) / np.diff(shares)
        bends = np.abs(np.diff(slopes)) > BENT * (np.abs(slopes[1:]) + np.abs(slopes[:-1]))
        bent = [True, *bends.tolist(), True]
        rows = zip(shares.tolist(), found.tolist(), bent, strict=True)
        yield from (_Corner(*row) for row in rows if row[1])


def flywheel(measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the sizes of the rim, as they are drawn and as they are lettered."""
    plan, group = flywheel_sketch.NAME, part(leaf, flywheel_sketch.NAME)
    true = None if expected.wheel is None else wheel(expected.wheel.inertia, expected.task.rim)
    if true is None or group is None:
        yield message("wrong.missing", name=plan)
        return
    seen = {one.name: one for one in measured.vectors if one.plan == plan}
    lettered = [text.plain for text in texts((group,))]
    sizes = {"D": 1j * true.diameter, "t": 1j * true.thickness, "b": complex(true.breadth)}
    for name, value in sizes.items():
        one = seen.get(name)
        if one is None:
            yield on("missing_on", plan, name=name)
        elif not abs(one.value - value) <= 3 * measured.quantum * one.scale + KNOWN * abs(value):
            yield on("differs_on", plan, name=name)
        text = flywheel_sketch.size(name, abs(value), precise(drafting))
        if not any(tells(told, text, (flywheel_sketch.DIGITS,), KNOWN) for told in lettered):
            yield on("letter", plan, name=name)
    said = flywheel_sketch.said(true, precise(drafting))
    if not any(tells(told, said, (flywheel_sketch.DIGITS,), KNOWN) for told in lettered):
        yield on("letter", plan, name="m, J")
    yield from _scale(lettered, seen)


def _scale(lettered: Sequence[str], seen: Mapping[str, MeasuredVector]) -> Iterator[Wrong]:
    """Hold the written scale of the sketch."""
    for text in lettered:
        if text.startswith(("μ", "K")):
            value = float(text.split(" = ")[1].split(" ")[0].replace(",", "."))
            mu = value if text.startswith("μ") else 1 / value
            if not all(math.isclose(mu, one.scale, rel_tol=1e-3) for one in seen.values()):
                yield message("wrong.scale", text=text)
