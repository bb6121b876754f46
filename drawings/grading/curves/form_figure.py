"""Graphs without marks: curves that a student drew on the axes of our form, read over its places (на осях бланка)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks.graphs.scale_line import written_scales
from drawings.eye.sheet import SeenSheet
from drawings.grading.curves.asked_figure import ORDINATES, FigureAsked, Sizes, Values
from drawings.grading.curves.drawn_curve import PLACED, Frame, chains, heights
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.drawn_plan import Arrow
from drawings.paper.strokes import Group, Line
from drawings.paper.walk import groups, texts

ABSCISSAS = ("φ", "x", "t")  # letters of what a graph goes over: of an angle and its time, the angle
FRAME, AXES = "frame", "axes"  # the group of the page itself, and the kind of those of a form that are axes
NEAR = 90.0  # mm: a scale that is written farther from the axes is not theirs
SHIFTED = 0.3  # of what a graph is out by where it stands, and it is less out a position beside: it is shifted


class Blank(NamedTuple):
    """The axes of a graph on a form: their origin, the ends of both, the ticks along the abscissa, mm."""

    origin: complex
    right: float
    top: float
    ticks: Sequence[float]

    def away(self, curve: Values) -> float:
        """Give how far a curve is from the axes, mm: about their origin's level, and to either side of their length."""
        middle = complex(curve.real.mean(), np.abs(curve.imag - self.origin.imag).mean())
        aside = max(self.origin.real - middle.real, middle.real - 2 * self.right + self.origin.real, 0.0)
        return float(np.hypot(aside, middle.imag))


class ReadCurve(NamedTuple):
    """A curve read over the places of a graph: these along its axes, its heights, and those beside, by how far, mm."""

    frame: Frame
    places: Sizes
    high: Sizes
    shifts: dict[float, Sizes]


def axes(seen: SeenSheet, plan: str) -> Blank | None:
    """Give the axes of a graph on a form; None where there are none."""
    return _every(seen).get(plan)


def _every(seen: SeenSheet) -> dict[str, Blank]:
    """Give all axes of a form by the plans that they are for."""
    own = ((one.data.get("plan", ""), _blank(one)) for one in groups(seen.leaf.groups) if one.data.get("kind") == AXES)
    return {plan: blank for plan, blank in own if blank is not None}


def _blank(group: Group) -> Blank | None:
    lines = [one for one in group.strokes if isinstance(one, Line)]
    if not lines:
        return None
    across = max(lines, key=lambda one: abs((one.end - one.start).real))
    upright = max(lines, key=lambda one: abs((one.end - one.start).imag))
    origin = complex(upright.start.real, across.start.imag)
    ticks = sorted(one.start.real for one in lines if one not in (across, upright) and _crosses(one, origin))
    return Blank(origin, max(across.start.real, across.end.real), max(upright.start.imag, upright.end.imag), ticks)


def _crosses(line: Line, origin: complex) -> bool:
    """Tell whether a line is a tick of the abscissa."""
    upright = abs((line.end - line.start).real) <= PLACED
    return upright and abs((line.start + line.end).imag / 2 - origin.imag) <= PLACED and line.start.real > origin.real


def from_form(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    """Give a graph by the curve that is drawn on its axes; None where there are no axes, or no curve on them."""
    own = axes(seen, asked.plan)
    if asked.kind != ORDINATES or asked.paper is None or own is None:
        return None
    written = _written(seen, own)
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
    return DrawnFigure(asked, values, _arrows(best, shift, high), mu is not None, shift, free=True)


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
            yield ReadCurve(frame, places, heights(own, places), shifts)


def _curves(seen: SeenSheet, plan: str) -> Iterator[Values]:
    """Give the curves that are nearer to the axes of a graph than to any others."""
    every = _every(seen)
    strokes = [one for one in seen.leaf.groups if one.data.get("kind") != AXES and one.name != FRAME]
    for one in chains(strokes):
        if min(every, key=lambda name: every[name].away(one)) == plan:
            yield one


def _written(seen: SeenSheet, own: Blank) -> dict[str, float]:
    """Give the scales that are written nearest to the axes, by their letters."""
    head = complex((own.origin.real + own.right) / 2, own.top)
    found: dict[str, float] = {}
    for text in sorted(texts(seen.leaf.groups), key=lambda one: abs(one.at - head)):
        if abs(text.at - head) <= NEAR:
            found = written_scales(Group((text,))) | found
    return found


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
