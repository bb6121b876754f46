"""Graphs without marks: curves that a student drew on the axes of our form, read over its places (на осях бланка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from drawings.grading.curves.drawn_figure import PLACED, THROUGH, DrawnFigure, Frame, away, chains, foot, heights
from drawings.grading.curves.figure_records import ORDINATES, FigureAsked, Sizes, Values
from drawings.grading.drawn_plan import Arrow
from drawings.grading.plans_on_form import form_places
from drawings.grading.written_number import stated_scales
from drawings.paper.strokes import Group, Line
from drawings.paper.walk import flat, groups, texts
from drawings.reading.sheet import SeenSheet

FRAME, AXES = "frame", "axes"  # the group of the page itself, and the kind of those of a form that are axes
NEAR = 90.0  # mm: a scale that is written farther from the axes is not theirs


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


def axes(seen: SeenSheet, plan: str) -> Blank | None:
    """Give the axes of a graph on a form; None where there are none."""
    return every_axes(seen).get(plan)


def every_axes(seen: SeenSheet) -> dict[str, Blank]:
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


def written_at(seen: SeenSheet, own: Blank, due: Mapping[str, str]) -> dict[str, float]:
    """Give the scales that are written nearest to the axes, by the letters that are due with their units."""
    head = complex((own.origin.real + own.right) / 2, own.top)
    near = sorted(texts(seen.leaf.groups), key=lambda one: abs(one.at - head))
    return stated_scales((one for one in near if abs(one.at - head) <= NEAR), due)


def course_on_form(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    """Give a course by the lines that are drawn on its axes; None where no scales are written, or none are drawn.

    At each place it is read on the branch that is nearer to what is asked for, or to a mistake that has a name if the
    whole course is nearer to that.
    """
    own = axes(seen, asked.plan)
    if asked.paper is None or own is None:
        return None
    written = written_at(seen, own, asked.stated)
    across, up = (written.get(letter) for letter in asked.scales)
    lines = [one - own.origin for one in lines_within(seen, own)]
    if across is None or up is None or not lines:
        return None
    places = asked.paper.along / across
    dues = ((values / asked.way).real / up for values in (asked.true, -asked.true, *(m.values for m in asked.mistakes)))
    high = min((_line_read(lines, places, due) for due in dues), key=lambda one: one.off).high
    there = np.isfinite(high)
    if not there.any():
        return None
    feet = own.origin + places
    arrows = {k: Arrow(complex(feet[k]), complex(feet[k] + 1j * high[k])) for k in np.flatnonzero(there).tolist()}
    return DrawnFigure(asked, np.asarray(asked.way * high * up), arrows, free=True)


class Heights(NamedTuple):
    """How high a course is over its places, mm, and by how much it is out of what is due."""

    high: Sizes
    off: float


def _line_read(lines: Sequence[Values], places: Sizes, due: Sizes) -> Heights:
    high = np.array([_nearest(lines, spot) for spot in (places + 1j * due).tolist()])
    return Heights(high, float(np.nansum(np.abs(high - due))))


def lines_within(seen: SeenSheet, own: Blank) -> Iterator[Values]:
    """Give the lines and chains that lie within the axes."""
    strokes = [one for one in seen.leaf.groups if one.data.get("kind") != AXES and one.name != FRAME]
    straight = (np.array([one.start, one.end]) for one in flat(strokes) if isinstance(one, Line))
    for one in (*chains(strokes), *straight):
        apart = one - own.origin
        low, high = -PLACED, max(own.top - own.origin.imag, own.right - own.origin.real)
        if apart.real.min() >= low and apart.real.max() <= high and np.abs(apart.imag).max() <= high:
            yield one


def _nearest(lines: Iterable[Values], due: complex) -> float:
    """Give how high lines are over the place of a spot, mm: where they are nearest to it; NaN where none is over it."""
    found = [high for one in lines for high in _heights(one[:-1], one[1:], due)]
    return min(found, key=lambda one: abs(one - due.imag), default=float("nan"))


def _heights(start: Values, end: Values, due: complex) -> list[float]:
    """Give the heights of segments over a place; of an upright one that which is nearest to the spot.

    >>> _heights(np.array([0j, 2 + 1j]), np.array([2 + 1j, 2 + 3j]), 2 + 2j)
    [1.0, 2.0]
    """
    turned = end.real < start.real
    low, high = np.where(turned, end, start), np.where(turned, start, end)
    wide = high.real - low.real
    over = (low.real <= due.real + PLACED) & (high.real >= due.real - PLACED)
    share = np.clip((due.real - low.real) / np.where(wide > PLACED, wide, 1.0), 0.0, 1.0)
    sloped = low.imag + share * (high.imag - low.imag)
    upright = np.clip(due.imag, np.minimum(low.imag, high.imag), np.maximum(low.imag, high.imag))
    return list(map(float, np.where(wide > PLACED, sloped, upright)[over]))


class Place(NamedTuple):
    """The place of a figure on a form: its pole, mm, the scales that it states, and the lines that are drawn in it."""

    pole: complex
    scales: dict[str, float]
    lines: tuple[Values, ...]

    def states(self, asked: FigureAsked) -> bool:
        """Tell whether all scales of a figure are written there."""
        return asked.scales.keys() <= self.scales.keys()


def line_on_form(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    """Give a figure by the line in its place, at the points of it that are nearest to what is asked for."""
    place = (_on_axes(asked, seen) or _in_place(asked, seen)) if asked.curved else None
    if place is None or not place.lines:
        return None
    across, up = _measures(asked, place)
    apart = [one - place.pole for one in place.lines]
    lines = tuple(np.asarray(one.real * across + 1j * one.imag * up) for one in apart)
    values = np.full(len(asked.true), complex(np.nan, np.nan))
    for k in asked.curved:
        values[k] = foot(lines, complex(asked.true[k]))
    spots = {k: place.pole + complex(values[k].real / across, values[k].imag / up) for k in asked.curved}
    arrows = {k: Arrow(spot, spot) for k, spot in spots.items()}
    return DrawnFigure(asked, values, arrows, place.states(asked), free=True, lines=lines)


def _measures(asked: FigureAsked, place: Place) -> tuple[float, float]:
    """Give how much of a figure's values a mm shows across and up: where no scale is written, as large as it is due."""
    if place.states(asked):
        mu = [place.scales[letter] / (own if asked.on_paper else 1.0) for letter, own in asked.scales.items()]
        return mu[0], mu[-1]
    drawn, due = np.concatenate(place.lines), asked.true[list(asked.curved)]
    return float(np.ptp(due.real) / np.ptp(drawn.real)), float(np.ptp(due.imag) / np.ptp(drawn.imag))


def _on_axes(asked: FigureAsked, seen: SeenSheet) -> Place | None:
    """Give the place of a figure that has axes: the curves that are nearer to these than to any others."""
    own = axes(seen, asked.plan)
    if own is None:
        return None
    every = every_axes(seen)
    near = (one for one in _drawn(seen) if min(every, key=lambda name: every[name].away(one)) == asked.plan)
    return Place(own.origin, written_at(seen, own, asked.stated), tuple(near))


def _in_place(asked: FigureAsked, seen: SeenSheet) -> Place | None:
    """Give the place of a figure that has a pole: the curves within the corners of it, by the scale of the form."""
    own = next((one for one in form_places(seen.leaf) if one.plan[0] == asked.plan), None)
    if own is None or own.pole is None:
        return None
    inside = tuple(one for one in _drawn(seen) if own.off(complex(one.real.mean(), one.imag.mean())) == 0)
    return Place(own.pole, dict.fromkeys(asked.scales, own.scale), inside)


def _drawn(seen: SeenSheet) -> Iterator[Values]:
    """Give the curves that are no part of the form's own figures."""
    return chains([one for one in seen.leaf.groups if one.data.get("kind") != AXES and one.name != FRAME])


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
