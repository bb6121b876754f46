"""Graphs without marks: curves that a student drew on the axes of our form, read over its places (на осях бланка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from drawings.checks.hold import off
from drawings.checks.readers import Frame
from drawings.grading.curves.drawn_figure import PLACED, THROUGH, DrawnFigure, away, chains, foot, heights, nearness
from drawings.grading.curves.figure_records import FigureAsked
from drawings.grading.drawn_plan import Arrow
from drawings.grading.form_place import FormPlace, form_places, straight_lines
from drawings.grading.written_number import stated_scales
from drawings.lettering.lettering import bounds
from drawings.paper.strokes import GIVEN, Curve, Fill, Group, Line, Polyline
from drawings.paper.walk import flat, groups, texts
from drawings.reading.sheet import SeenSheet
from plans.model.motion import Complexes, Floats

FRAME, AXES = "frame", "axes"  # the group of the page itself, and the kind of those of a form that are axes
NEAR = 90.0  # mm: a scale that is written farther from the axes is not theirs
OVER = 1.3  # of the axes: so far a line may reach that is drawn on them
ABSCISSAS = ("φ", "x", "t")  # letters of what a graph goes over: of an angle and its time, the angle
HEADED, LETTERS = 5, 3  # corners that an arrowhead has at the most; outlines of letters that a scale has at the least
FLUSH, SHORT = 0.1, 8.0  # mm: how far lines of axes may be off, and no tick is longer
SHIFTED = 0.3  # of what a graph is out by where it stands, and it is less out a position beside: it is shifted


class Blank(NamedTuple):
    """The axes of a graph on a form: their origin, the ends of both, the ticks along the abscissa, mm."""

    origin: complex
    right: float
    top: float
    ticks: Sequence[float]

    def away(self, curve: Complexes) -> float:
        """Give how far a curve is from the axes, mm: about their origin's level, and to either side of their length."""
        middle = complex(curve.real.mean(), np.abs(curve.imag - self.origin.imag).mean())
        aside = max(self.origin.real - middle.real, middle.real - self.right, 0.0)
        return float(np.hypot(aside, middle.imag))

    def written(self, sheet: SeenSheet, letters: Mapping[str, str]) -> dict[str, float]:
        """Give the scales that are written nearest to the axes, by letters with their units."""
        head = complex((self.origin.real + self.right) / 2, self.top)
        near = sorted(texts(sheet.leaf.groups), key=lambda text: abs(text.at - head))
        return stated_scales((text for text in near if abs(text.at - head) <= NEAR), letters)

    def is_outlined(self, sheet: SeenSheet) -> bool:
        """Tell whether letters turned to outlines, small filled figures of many corners, stand where scales do."""
        head = complex((self.origin.real + self.right) / 2, self.top)
        filled = (stroke for stroke in flat(_ink(sheet)) if isinstance(stroke, Fill | Polyline | Curve))
        inked = (stroke for stroke in filled if stroke.style.fill != "none")
        boxes = [bounds(stroke) for stroke in inked if isinstance(stroke, Curve) or len(stroke.points) > HEADED]
        near = (box for box in boxes if off(head, box) <= NEAR and max(box[2] - box[0], box[3] - box[1]) < SHORT)
        return len(list(near)) >= LETTERS

    def lines(self, sheet: SeenSheet) -> Iterator[Complexes]:
        """Give the lines and chains that lie within the axes."""
        every = (np.array([line.start, line.end]) for line in flat(_ink(sheet)) if isinstance(line, Line))
        straight = (line for line in every if not _is_own(line - self.origin))
        for line in (*chains(_ink(sheet)), *straight):
            apart = line - self.origin
            high, wide = OVER * (self.top - self.origin.imag), OVER * (self.right - self.origin.real)
            if apart.real.min() >= -PLACED and apart.real.max() <= wide and np.abs(apart.imag).max() <= high:
                yield line


def _is_own(line: Complexes) -> bool:
    """Tell whether a line from the origin of axes is one of them, or a tick: an editor may have regrouped them."""
    along, up = np.abs(line.imag).max() <= FLUSH, np.abs(line.real).max() <= FLUSH
    return bool(along or up or (np.ptp(line.real) <= FLUSH and abs(line.imag.sum()) <= FLUSH))


def every_axes(sheet: SeenSheet) -> dict[str, Blank]:
    """Give all axes of a form by the plans that they are for; those that an editor has regrouped by their order."""
    found = [group for group in groups(sheet.leaf.groups) if group.data.get("kind") == AXES]
    blanks = {group.data.get("plan", ""): _blank(straight_lines(group.strokes)) for group in found}
    empty = [plan for plan, blank in blanks.items() if blank is None]
    loose = list(_loose(straight_lines(flat(sheet.leaf.groups)))) if empty else []
    if len(loose) == len(empty):
        blanks |= dict(zip(empty, loose, strict=True))
    return {plan: blank for plan, blank in blanks.items() if blank is not None}


def _loose(lines: Sequence[Line]) -> Iterator[Blank]:
    """Give the axes that lines are: one along, with ticks, and one upright through its left end."""
    for across in (line for line in lines if abs((line.end - line.start).imag) <= FLUSH):
        left = min(across.start, across.end, key=lambda spot: spot.real)
        upright = (line for line in lines if abs(line.start.real - left.real) + abs(line.end.real - left.real) <= FLUSH)
        middle = (line for line in upright if abs((line.start + line.end).imag / 2 - left.imag) <= PLACED)
        up = next((line for line in middle if abs(line.end - line.start) > PLACED), None)
        blank = None if up is None else _blank([across, up, *lines])
        if blank is not None and len(blank.ticks) > 1 and abs(across.end - across.start) > NEAR / 2:
            yield blank


def _blank(lines: Sequence[Line]) -> Blank | None:
    if not lines:
        return None
    across, upright = lines[:2]
    origin, right = complex(upright.start.real, across.start.imag), max(across.start.real, across.end.real)
    short = (
        line for line in lines[2:] if abs((line.end - line.start).real) <= PLACED and abs(line.end - line.start) < SHORT
    )
    ticks = (line.start.real for line in short if abs((line.start + line.end).imag / 2 - origin.imag) <= PLACED)
    among = sorted(along for along in ticks if origin.real < along < right)
    return Blank(origin, right, max(upright.start.imag, upright.end.imag), among)


def _ink(sheet: SeenSheet) -> list[Group]:
    """Give what is no part of the form's own axes and page."""
    return [group for group in sheet.leaf.groups if group.data.get("kind") not in (AXES, GIVEN) and group.name != FRAME]


def _curves(sheet: SeenSheet, plan: str) -> Iterator[Complexes]:
    """Give the curves that are nearer to the axes of a graph than to any others, and in no place of another figure."""
    blanks, places = every_axes(sheet), form_places(sheet.leaf)
    for curve in chains(_ink(sheet)):
        near = min(blanks, key=lambda name: blanks[name].away(curve)) == plan
        if near and not any(place.holds(curve.tolist()) for place in places):
            yield curve


def places_filled(sheet: SeenSheet) -> dict[str, bool]:
    """Tell by the plans that a form has axes or a place for whether anything is drawn there that might be a curve."""
    filled = {place.plan[0]: bool(_within(sheet, place)) for place in form_places(sheet.leaf)}
    for plan, blank in every_axes(sheet).items():
        filled[plan] = any(True for lines in (_curves(sheet, plan), blank.lines(sheet)) for _ in lines)
    return filled


def _within(sheet: SeenSheet, place: FormPlace) -> list[Complexes]:
    return [line for line in chains(_ink(sheet)) if place.off(complex(line.mean())) == 0]


def from_form(asked: FigureAsked, sheet: SeenSheet) -> DrawnFigure | None:
    """Give a figure by what is drawn on its axes or in its place on a form; None where nothing of it is there."""
    blank = every_axes(sheet).get(asked.plan)
    if asked.is_graph and blank is not None:
        return (_course if asked.returns else _graph)(asked, sheet, blank)
    return _line(asked, sheet, blank) if asked.curved else None


def _course(asked: FigureAsked, sheet: SeenSheet, blank: Blank) -> DrawnFigure | None:
    """Give a course by the lines that are drawn on its axes; None where no scales are written, or none are drawn.

    At each place it is read on the branch that is nearer to what is asked for, or to a mistake that has a name if the
    whole course is nearer to that.
    """
    assert asked.paper is not None  # asked before
    written = blank.written(sheet, asked.stated)
    across, up = (written.get(letter) for letter in asked.scales)
    lines = [line - blank.origin for line in blank.lines(sheet)]
    if across is None or up is None or not lines:
        return None
    places = asked.paper.along / across
    dues = _dues(asked, up)
    read = (np.array([_nearest(lines, spot) for spot in (places + 1j * expected).tolist()]) for expected in dues)
    high, _ = min(zip(read, dues, strict=True), key=nearness)
    if not np.isfinite(high).any():
        return None
    arrows = _arrows(Frame(blank.origin, 1 + 0j, 1j, 1.0, 1.0), places, high)
    return DrawnFigure(asked, np.asarray(asked.way * high * up), arrows, free=True, mu=up)


def _dues(asked: FigureAsked, mu: float) -> list[Floats]:
    """Give the heights that a graph may have: by analysis, all the other way, by the mistakes that have names; mm."""
    known = (asked.true, -asked.true, *(mistake.values for mistake in asked.mistakes))
    return [(np.where(np.isnan(values), asked.true, values) / asked.way).real / mu for values in known]


def _nearest(lines: Iterable[Complexes], expected: complex) -> float:
    """Give how high lines are over the place of a spot, mm: where they are nearest to it; NaN where none is over it."""
    found = [high for line in lines for high in _heights(line[:-1], line[1:], expected)]
    return min(found, key=lambda high: abs(high - expected.imag), default=float("nan"))


def _heights(start: Complexes, end: Complexes, expected: complex) -> list[float]:
    """Give the heights of segments over a place; of an upright one that which is nearest to the spot.

    >>> _heights(np.array([0j, 2 + 1j]), np.array([2 + 1j, 2 + 3j]), 2 + 2j)
    [1.0, 2.0]
    """
    turned = end.real < start.real
    low, high = np.where(turned, end, start), np.where(turned, start, end)
    wide = high.real - low.real
    over = (low.real <= expected.real + PLACED) & (high.real >= expected.real - PLACED)
    share = np.clip((expected.real - low.real) / np.where(wide > PLACED, wide, 1.0), 0.0, 1.0)
    sloped = low.imag + share * (high.imag - low.imag)
    upright = np.clip(expected.imag, np.minimum(low.imag, high.imag), np.maximum(low.imag, high.imag))
    return list(map(float, np.where(wide > PLACED, sloped, upright)[over]))


def _line(asked: FigureAsked, sheet: SeenSheet, blank: Blank | None) -> DrawnFigure | None:
    """Give a figure by the line on its axes or about its pole, where it is nearest to what is asked for."""
    if blank is not None:
        pole, scales, lines = blank.origin, blank.written(sheet, asked.stated), list(_curves(sheet, asked.plan))
    else:
        place = next((place for place in form_places(sheet.leaf) if place.plan[0] == asked.plan), None)
        if place is None or place.pole is None:
            return None
        pole, scales = place.pole, dict.fromkeys(asked.scales, place.scale)
        lines = _within(sheet, place)
    if not lines:
        return None
    written = asked.scales.keys() <= scales.keys()
    across, up = _measures(asked, scales if written else {}, lines)
    true = tuple(np.asarray((line - pole).real * across + 1j * (line - pole).imag * up) for line in lines)
    values = np.full(len(asked.true), complex(np.nan, np.nan))
    for k in asked.curved:
        values[k] = foot(true, complex(asked.true[k]))
    spots = {k: pole + complex(values[k].real / across, values[k].imag / up) for k in asked.curved}
    arrows, mu = {k: Arrow(spot, spot) for k, spot in spots.items()}, 0.0 if asked.on_paper else across
    outlined = not written and blank is not None and blank.is_outlined(sheet)
    return DrawnFigure(asked, values, arrows, written, free=True, mu=mu, lines=true, outlined=outlined)


def _measures(asked: FigureAsked, scales: Mapping[str, float], lines: Sequence[Complexes]) -> tuple[float, float]:
    """Give how much of a figure's values a mm shows across and up: where no scale is written, as large as it is due."""
    if scales:
        mu = [scales[letter] / (true if asked.on_paper else 1.0) for letter, true in asked.scales.items()]
        return mu[0], mu[-1]
    drawn, expected = np.concatenate(lines), asked.true[list(asked.curved)]
    return float(np.ptp(expected.real) / np.ptp(drawn.real)), float(np.ptp(expected.imag) / np.ptp(drawn.imag))


class ReadCurve(NamedTuple):
    """A curve read over the places of a graph: these along its axes, its heights, and those beside, by how far, mm."""

    frame: Frame
    places: Floats
    high: Floats
    shifts: dict[float, Floats]
    drawn: Complexes

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


def _graph(asked: FigureAsked, sheet: SeenSheet, blank: Blank) -> DrawnFigure | None:
    """Give a graph by the curve that is drawn on its axes; None where no curve is on them."""
    assert asked.paper is not None  # asked before
    written = blank.written(sheet, dict.fromkeys(ABSCISSAS, "") | asked.stated)
    step = _step(blank, written, asked.paper.turn)
    if step is None:
        return None
    # A graph of inertia stands on its side, its angles up or down.
    ways = (1 + 0j,) if asked.way == 1j else (1j, -1j)
    frames = (Frame(blank.origin, along, asked.way, 1.0, 1.0) for along in ways)
    mu = written.get(tuple(asked.scales)[-1])
    dues = [] if mu is None else _dues(asked, mu)
    found = [
        curve for frame in frames for curve in _read(sheet, asked, frame, asked.paper.along / step, dues, blank.ticks)
    ]
    best = max(found, key=lambda curve: int((~np.isnan(curve.high)).sum()), default=None)
    if best is None or np.isnan(best.high).all():
        return None
    shift, high = _shifted(asked, mu or _fitted(asked, best.high), best)
    values = np.asarray(asked.way * high * (mu or _fitted(asked, high)))
    doubled = any(curve.is_graph and curve.differs(best) for curve in found) and best.is_graph
    arrows = _arrows(best.frame, best.places + shift, high)
    drawn = DrawnFigure(asked, values, arrows, mu is not None, shift, free=True, mu=mu or 0.0, doubled=doubled)
    return replace(drawn, outlined=not drawn.written and blank.is_outlined(sheet))


def _arrows(frame: Frame, places: Floats, high: Floats) -> dict[int, Arrow]:
    feet = frame.zero + frame.along * places
    ends = feet + frame.rise * high
    return {k: Arrow(complex(feet[k]), complex(ends[k])) for k in np.flatnonzero(np.isfinite(high)).tolist()}


def _read(
    sheet: SeenSheet, asked: FigureAsked, frame: Frame, stations: Floats, dues: list[Floats], ticks: Sequence[float]
) -> Iterator[ReadCurve]:
    """Give the heights of each curve over the places, mm, and those a position to either side."""
    places = stations - stations[0]
    near = float(np.median(np.diff(np.unique(places))))
    steps = {near, float(np.median(np.diff(ticks))) if len(ticks) > 1 else near}  # a position, or a tick of the axis
    beside = max(steps)
    for curve in _curves(sheet, asked.plan):
        drawn = frame.true(curve)
        if drawn.real.min() >= -beside - PLACED and drawn.real.max() <= places.max() + 2 * beside + PLACED:
            shifts = {by: heights(drawn, places + by) for step in steps for by in (-step, step)}
            yield ReadCurve(frame, places, heights(drawn, places, dues), shifts, drawn)


def _step(blank: Blank, written: Mapping[str, float], turn: float | None) -> float | None:
    """Give the scale along the abscissa: that which is written, else a turn has as many positions as ticks."""
    stated = next((written[letter] for letter in ABSCISSAS if letter in written), None)
    if stated or turn is None or len(blank.ticks) < 2:
        return stated
    return turn / len(blank.ticks) / float(np.median(np.diff(blank.ticks)))


def _fitted(asked: FigureAsked, high: Floats) -> float:
    there, true = ~np.isnan(high), (asked.true / asked.way).real
    size = float((high[there] ** 2).sum())
    return abs(float((true[there] * high[there]).sum())) / size if size else 1.0


def _shifted(asked: FigureAsked, mu: float, curve: ReadCurve) -> tuple[float, Floats]:
    """Tell whether a graph is right but for a position along its axis."""

    def out(high: Floats) -> float:
        return float(np.nanmean(asked.off(np.asarray(asked.way * high * mu), asked.true)))

    there = {by: high for by, high in curve.shifts.items() if np.isfinite(high).any()}
    by, high = min(there.items(), key=lambda shift: out(shift[1]), default=(0.0, curve.high))
    fits = asked.off(np.asarray(asked.way * curve.high * mu), asked.true) <= PLACED * mu + asked.slack
    right = 2 * int(fits.sum()) > len(fits)  # most of it, where it stands
    return (by, high) if out(high) < SHIFTED * out(curve.high) and not right else (0.0, curve.high)
