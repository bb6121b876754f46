"""Graphs without marks: curves that a student drew on the axes of our form, read over its places (на осях бланка)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.eye.sheet import SeenSheet
from drawings.grading.curves.asked_figure import ORDINATES, FigureAsked, Sizes, Values
from drawings.grading.curves.drawn_curve import PLACED, THROUGH, Frame, away, chains, heights
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.curves.form.form_line import (
    AXES,
    FRAME,
    Blank,
    axes,
    course_on_form,
    every_axes,
    lines_within,
    written_at,
)
from drawings.grading.drawn_plan import Arrow

ABSCISSAS = ("φ", "x", "t")  # letters of what a graph goes over: of an angle and its time, the angle
SHIFTED = 0.3  # of what a graph is out by where it stands, and it is less out a position beside: it is shifted


class ReadCurve(NamedTuple):
    """A curve read over the places of a graph: these along its axes, its heights, and those beside, by how far, mm."""

    frame: Frame
    places: Sizes
    high: Sizes
    shifts: dict[float, Sizes]
    drawn: Values

    @property
    def is_graph(self) -> bool:
        """Whether it may be the graph that is asked for: over most places, no straight line and no steps."""
        steps = np.diff(self.drawn)
        stepped = (np.minimum(np.abs(steps.real), np.abs(steps.imag)) <= PLACED).all()
        straight = (away(self.drawn[[0, -1]], self.drawn) <= THROUGH).all()
        return 2 * int(np.isfinite(self.high).sum()) > len(self.high) and not (stepped or straight)

    def differs(self, other: ReadCurve) -> bool:
        """Tell whether another one on the same axes goes elsewhere."""
        apart = np.abs(self.high - other.high)
        return self.frame == other.frame and bool((apart[np.isfinite(apart)] > THROUGH).any())


def from_form(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    """Give a graph by the curve that is drawn on its axes; None where there are no axes, or no curve on them."""
    own = axes(seen, asked.plan)
    if asked.kind != ORDINATES or asked.paper is None or own is None:
        return None
    if asked.returns:
        return course_on_form(asked, seen)
    written = written_at(seen, own, dict.fromkeys(ABSCISSAS, "") | asked.stated)
    step = _step(own, written, asked.paper.turn)
    if step is None:
        return None
    found = [one for frame in _frames(asked, own) for one in _read(seen, asked, frame, step)]
    best = max(found, key=lambda one: int((~np.isnan(one.high)).sum()), default=None)
    if best is None or np.isnan(best.high).all():
        return None
    mu = written.get(tuple(asked.scales)[-1])
    shift, high = _shifted(asked, mu or _fitted(asked, best.high), best)
    values = np.asarray(asked.way * high * (mu or _fitted(asked, high)))
    doubled = any(one.is_graph and one.differs(best) for one in found) and best.is_graph
    return DrawnFigure(asked, values, _arrows(best, shift, high), mu is not None, shift, free=True, doubled=doubled)


def empty_axes(seen: SeenSheet) -> frozenset[str]:
    """Give the plans on whose axes nothing is drawn that might be a curve."""
    return frozenset(
        plan for plan, own in every_axes(seen).items()
        if next(_curves(seen, plan), None) is None and next(lines_within(seen, own), None) is None
    )  # fmt: skip


def _arrows(best: ReadCurve, shift: float, high: Sizes) -> dict[int, Arrow]:
    """Give where the values of a curve stand on paper."""
    feet = best.frame.origin + best.frame.along * (best.places + shift)
    ends = feet + best.frame.rise * high
    return {k: Arrow(complex(feet[k]), complex(ends[k])) for k in np.flatnonzero(np.isfinite(high)).tolist()}


def _frames(asked: FigureAsked, own: Blank) -> Iterator[Frame]:
    """Give the axes as a graph may lie on them: one of inertia stands on its side, its angles up or down."""
    for along in (1 + 0j,) if asked.way == 1j else (1j, -1j):
        yield Frame(own.origin, along, asked.way)


def _read(seen: SeenSheet, asked: FigureAsked, frame: Frame, step: float) -> Iterator[ReadCurve]:
    """Give the heights of each curve over the places, mm, and those a position to either side."""
    assert asked.paper is not None  # asked before
    places = (asked.paper.along - asked.paper.along[0]) / step
    beside = float(np.median(np.diff(np.unique(places))))
    for one in _curves(seen, asked.plan):
        own = frame.seen(one)
        if own.real.min() >= -beside - PLACED and own.real.max() <= places[-1] + 2 * beside + PLACED:
            shifts = {by: heights(own, places + by) for by in (-beside, beside)}
            yield ReadCurve(frame, places, heights(own, places), shifts, own)


def _curves(seen: SeenSheet, plan: str) -> Iterator[Values]:
    """Give the curves that are nearer to the axes of a graph than to any others."""
    every = every_axes(seen)
    strokes = [one for one in seen.leaf.groups if one.data.get("kind") != AXES and one.name != FRAME]
    for one in chains(strokes):
        if min(every, key=lambda name: every[name].away(one)) == plan:
            yield one


def _step(own: Blank, written: dict[str, float], turn: float | None) -> float | None:
    """Give the scale along the abscissa: that which is written, else a turn has as many positions as ticks."""
    stated = next((written[letter] for letter in ABSCISSAS if letter in written), None)
    if stated or turn is None or len(own.ticks) < 2:
        return stated
    return turn / len(own.ticks) / float(np.median(np.diff(own.ticks)))


def _fitted(asked: FigureAsked, high: Sizes) -> float:
    """Give the scale by which a graph is nearest to what is asked for."""
    there, true = ~np.isnan(high), (asked.true / asked.way).real
    size = float((high[there] ** 2).sum())
    return abs(float((true[there] * high[there]).sum())) / size if size else 1.0


def _shifted(asked: FigureAsked, mu: float, read: ReadCurve) -> tuple[float, Sizes]:
    """Tell whether a graph is right but for a position along its axis."""

    def out(row: Sizes) -> float:
        return float(np.nanmean(asked.off(np.asarray(asked.way * row * mu), asked.true)))

    there = {by: row for by, row in read.shifts.items() if np.isfinite(row).any()}
    by, row = min(there.items(), key=lambda one: out(one[1]), default=(0.0, read.high))
    right = out(row) < SHIFTED * out(read.high) and not _near(asked, mu, read.high)
    return (by, row) if right else (0.0, read.high)


def _near(asked: FigureAsked, mu: float, high: Sizes) -> bool:
    """Tell whether most of a graph is right where it stands."""
    fits = asked.off(np.asarray(asked.way * high * mu), asked.true) <= PLACED * mu + asked.slack
    return 2 * int(fits.sum()) > len(high)
