"""The self-check of load diagrams and of the flywheel's sketch: corners, strokes, sizes (проверка размеров)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.dynamics_expected import KNOWN, Expected
from drawings.checks.dynamics_graphs import part, written
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.figures.dynamics import flywheel_sketch, load_diagram
from drawings.measure.measure import Measured, MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from drawings.paper.walk import texts
from plans.analytic.dynamics.rim import wheel
from plans.forces.stroke import Stroke
from plans.model.machine import ALWAYS, IDLE, WORKING, Force, Machine, Moment, Track
from plans.words.words import message

STROKES = ("H", "β")  # letters of the whole stroke
OVERRUNS = ("overrun_1", "overrun_2")


def loads(
    names: Sequence[str], measured: Measured, leaf: Leaf, machine: Machine, strokes: Mapping[Track, Stroke]
) -> Iterator[Wrong]:
    """Hold each load diagram on a sheet against the load of the machine."""
    every: tuple[Force | Moment, ...] = (*machine.forces, *machine.moments)
    known = {f"{load_diagram.NAME}-{one.name}": one for one in every}
    for name in names:
        own = [one for one in measured.vectors if one.plan == name]
        yield from _load(name, own, measured.quantum, known[name], strokes[known[name].stroke])
        group = part(leaf, name)
        scales = written(group) if group is not None else {}
        for one in own:
            if not math.isclose(scales.get(one.quantity, math.nan), one.scale, rel_tol=1e-9):
                yield message("wrong.scale", text=f"μ_{one.quantity}")
                break


def _load(
    plan: str, seen: Sequence[MeasuredVector], quantum: float, load: Force | Moment, stroke: Stroke
) -> Iterator[Wrong]:
    """Hold the ordinates by their places: at each corner of the law one, and none anywhere else."""
    whole = next((one for one in seen if one.name in STROKES), None)
    length = abs(stroke.reach[1] - stroke.reach[0])
    length = length if stroke.sliding else math.degrees(length)
    if whole is None:
        yield on("missing_on", plan, name=STROKES[not stroke.sliding])
        return
    near = 3 * quantum * whole.scale + KNOWN * length
    yield from (() if abs(whole.value - length) <= near else (on("differs_on", plan, name=whole.name),))
    for name, share in zip(OVERRUNS, load.overrun, strict=True):
        found = next((one.value for one in seen if one.name == name), 0j)
        if not abs(found - share * length) <= near:
            yield on("differs_on", plan, name=f"{share:g}{whole.name}")
    due = {(way * length, size) for way, size in _corners(load)}
    most = max((abs(size) for _, size in due), default=0.0)
    for one in seen:
        if one.name in (whole.name, *OVERRUNS):
            continue
        way = (one.start - whole.start).real * whole.scale
        fits = {pair for pair in due if abs(pair[0] - way) <= near and _same(one, pair[1], quantum, most)}
        yield from () if fits else (on("differs_on", plan, name=one.name),)
        due -= fits
    yield from (on("corner", plan, way=f"{way:.4g}", size=f"{size:.4g}") for way, size in sorted(due))


def _same(one: MeasuredVector, size: float, quantum: float, most: float) -> bool:
    return abs(one.value - 1j * size) <= 2 * quantum * one.scale + KNOWN * most


def _corners(load: Force | Moment) -> Iterator[tuple[float, float]]:
    """Give share of the stroke and size of every corner of a load that is not zero, by its law alone."""
    law = load.diagram if isinstance(load, Force) else None
    begin, end = load.overrun[0], 1 - load.overrun[1]
    shares = {begin, end, *(share for share in (law.travel if law else ()) if begin < share < end)}
    turns = load.against if isinstance(load, Moment) else load.resists or (load.direction is None and load.line is None)
    for during, sense in ((WORKING, 1.0), (IDLE, -1.0 if turns else 1.0)):
        if load.during in (ALWAYS, during):
            sizes = (law.back or law.sizes if during == IDLE else law.sizes) if law else ()
            for share in shares:
                size = sense * load.size * (float(np.interp(share, law.travel, sizes)) if law else 1.0)
                yield from ((share, size),) if size else ()


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
