"""Curves as a student drew them: the line through given places, its values, its written scale (график)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from statistics import median
from typing import NamedTuple

import numpy as np

from drawings.grading.curves.figure_records import CHAIN, ORDINATES, FigureAsked, Paper, Sizes, Values
from drawings.grading.drawn_plan import Arrow
from drawings.grading.written_number import stated_scales
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Curve, Line, Polyline, Stroke
from drawings.paper.walk import flat, group_named, texts
from drawings.reading.marks import MeasuredPoint, MeasuredVector
from drawings.reading.sheet import SeenSheet
from drawings.reading.transform import Affine
from plans.by_hand import SLIP

# mm: a curve goes through a place if a hand that slips by four times a fair one's has drawn it so.
THROUGH = 2 * np.sqrt(2) * 4 * SLIP
PLACED = 0.7  # mm: what begins, or ends, at a place does so if a fair hand may have pricked it there
SHARES = np.linspace(0.0, 1.0, 9)  # of a piece of a curve, between which it is straight enough


class Frame(NamedTuple):
    """The axes of a graph on paper: their origin, mm, and the ways along which places and values go."""

    origin: complex
    along: complex
    rise: complex

    def seen(self, spots: Values) -> Values:
        """Give places on paper in these axes: along, then up, mm."""
        apart = spots - self.origin
        across = self.along.real * self.rise.imag - self.along.imag * self.rise.real
        own = (apart.real * self.rise.imag - apart.imag * self.rise.real) / across
        high = (self.along.real * apart.imag - self.along.imag * apart.real) / across
        return np.asarray(own + 1j * high)


def chains(strokes: Iterable[Stroke]) -> Iterator[Values]:
    """Give the lines that may be curves: chains of three corners or more, and curves in short chords."""
    for one in flat(strokes):
        if isinstance(one, Polyline) and len(one.points) > 2:
            yield np.array(one.points)
        elif isinstance(one, Curve):
            yield np.array([piece.at(float(share)) for piece in one.pieces for share in SHARES])


def through(strokes: Iterable[Stroke], frame: Frame, ends: Values) -> Values | None:
    """Give the curve through most of some places, in the axes of a graph; None where none goes through half of them."""
    own = [frame.seen(one) for one in chains(strokes)]
    best = max(own, key=lambda one: hits(one, ends), default=None)
    return best if best is not None and 2 * hits(best, ends) > len(ends) else None


def hits(curve: Values, ends: Values) -> int:
    """Count the places that a curve goes through."""
    return int((away(curve, ends) <= THROUGH).sum())


def foot(lines: tuple[Values, ...], spot: complex) -> complex:
    """Give the place on some lines that is nearest to a spot.

    >>> foot((np.array([0j, 4 + 0j]), np.array([5j, 4 + 5j])), 1 + 2j)
    (1+0j)
    """
    return min((_foot(one, spot) for one in lines), key=lambda one: abs(one - spot))


def _foot(line: Values, spot: complex) -> complex:
    run = np.diff(line)
    long = np.maximum(np.abs(run) ** 2, np.finfo(float).tiny)
    share = np.clip(((spot - line[:-1]) * run.conj()).real / long, 0.0, 1.0)
    feet = line[:-1] + share * run
    return complex(feet[int(np.abs(feet - spot).argmin())])


def away(curve: Values, ends: Values) -> Sizes:
    """Give how far places are from a curve, mm.

    >>> away(np.array([0j, 1 + 0j, 1 + 2j]), np.array([0.5 + 0.1j, 1 + 1j, 3 + 2j])).tolist()
    [0.1, 0.0, 2.0]
    """
    run = np.diff(curve)
    apart = ends[:, None] - curve[:-1]
    long = np.maximum(np.abs(run) ** 2, np.finfo(float).tiny)
    share = np.clip((apart * run.conj()).real / long, 0.0, 1.0)
    return np.asarray(np.abs(apart - share * run).min(axis=1))


def heights(curve: Values, places: Sizes) -> Sizes:
    """Give how high a curve is over some places, mm, behind a jump; NaN where it does not reach.

    >>> heights(np.array([0j, 1 + 1j, 1 + 3j, 2 + 3j]), np.array([0.5, 1.0, 2.0, 4.0])).tolist()
    [0.5, 3.0, 3.0, nan]
    """
    start, end = curve[:-1], curve[1:]
    turned = end.real < start.real
    low, high = np.where(turned, end, start), np.where(turned, start, end)
    found = [_height(low, high, float(place)) for place in places]
    return np.array(found, dtype=np.float64)


def _height(low: Values, high: Values, place: float) -> float:
    """Give the height over one place: of the segment that begins there or goes over it, else of one that ends there."""
    over = np.flatnonzero((low.real <= place + 2 * QUANTUM) & (high.real > place + 2 * QUANTUM))
    ends = np.flatnonzero(np.abs(high.real - place) <= PLACED) if not over.size else over
    if not ends.size:
        return float("nan")
    k = int(ends[-1])
    wide = high[k].real - low[k].real
    share = min(max((place - low[k].real) / wide, 0.0), 1.0) if wide else 1.0
    return float(low[k].imag + share * (high[k].imag - low[k].imag))


SAME = 0.5  # mm: by so much the axis of a sheet that was saved anew may be longer


@dataclass(frozen=True)
class DrawnFigure:
    """A figure of a sheet: its values in true units by their places, NaN where there are none; its arrows on paper.

    `shift` is by how much all its ordinates stand beside their places, mm; `aside` are those that do so alone. Through
    the ends of those that are `apart` the curve does not go.
    """

    asked: FigureAsked
    values: Values
    arrows: Mapping[int, Arrow]
    written: bool = True
    shift: float = 0.0
    aside: frozenset[int] = field(default_factory=frozenset)
    apart: frozenset[int] = field(default_factory=frozenset)
    free: bool = False  # whether it was drawn on the axes of a form, without marks
    doubled: bool = False  # whether another curve, which differs, is drawn on its axes
    lines: tuple[Values, ...] = ()  # in true units: of a figure that is read off lines at what is nearest

    def off(self, due: Values) -> Sizes:
        """Give how far what is drawn is from what is due, true units; NaN of what is not drawn."""
        if not self.lines:
            return self.asked.off(self.values, due)
        apart = np.min([away(line, due) for line in self.lines], axis=0)
        return np.where(self.there, apart, np.nan)

    def nearest(self, due: Values) -> Values:
        """Give the values of a figure that is read off lines where these are nearest to what is due."""
        found = self.values.copy()
        for k in np.flatnonzero(self.there).tolist():
            found[k] = foot(self.lines, complex(due[k]))
        return found

    @property
    def there(self) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        """Which places have a value."""
        return ~np.isnan(self.values)


def from_marks(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    """Give a figure by the marks of a sheet; None where it has none of it."""
    marks = {(one.name, one.position): one for one in seen.measured.marks if one.plan == asked.plan}
    own = {one.place: marks[one.name, one.position] for one in asked.items if (one.name, one.position) in marks}
    if not own:
        return None
    scale, written = scales_on(asked, seen)
    arrows = {place: _arrow(mark, seen) for place, mark in own.items()}
    values = np.full(len(asked.true), complex(np.nan, np.nan))
    for place, mark in own.items():
        values[place] = mark.value
    if asked.kind == ORDINATES and asked.paper is not None:
        return _on_axis(asked, seen, values, arrows, scale, written)
    values = _scaled(asked, values, scale)
    beside = frozenset(_beside(asked, seen, values, arrows)) if asked.kind == CHAIN else frozenset[int]()
    return DrawnFigure(asked, values, arrows, written, aside=beside)


def _beside(asked: FigureAsked, seen: SeenSheet, values: Values, arrows: Mapping[int, Arrow]) -> Iterator[int]:
    """Give the bars that begin neither at their places nor where the bar before them in their row ends."""
    if asked.paper is None:
        return
    by, moved = seen.measured.moved, _moved(asked, asked.paper, seen, arrows)
    rows = {one.place: one.name.partition(".")[0] for one in asked.items}
    off = {place: (_back(arrow.start, by) - moved - asked.paper.feet[place]).real for place, arrow in arrows.items()}
    for place, aside in off.items():
        due = [0.0]
        if place - 1 in off and rows[place - 1] == rows[place]:
            due.append(off[place - 1] + (values[place - 1] - asked.true[place - 1]).real / asked.scale)
        if min(abs(aside - one) for one in due) > PLACED:
            yield place


def scales_on(asked: FigureAsked, seen: SeenSheet) -> tuple[Mapping[str, float], bool]:
    """Give the scales that stand over a figure, ours where none stand; and whether all do."""
    group = group_named(seen.leaf.groups, asked.plan)
    due = {letter: mu for letter, mu in asked.scales.items() if letter}
    found = _anywhere(asked, seen) if group is None else stated_scales(texts((group,)), asked.stated)
    return {**asked.scales, **{letter: found[letter] for letter in due if letter in found}}, due.keys() <= found.keys()


def _anywhere(asked: FigureAsked, seen: SeenSheet) -> dict[str, float]:
    """Give which of our scales stand somewhere on a sheet whose figures an editor has dissolved."""
    own = [stated_scales((text,), asked.stated) for text in texts(seen.leaf.groups)]
    due = {letter: asked.scales[letter] for letter in asked.stated}
    return {letter: mu for letter, mu in due.items() if any(_ratio(one.get(letter, 0.0), mu) == 1.0 for one in own)}


def _scaled(asked: FigureAsked, values: Values, scale: Mapping[str, float]) -> Values:
    """Give values by the scales that a student wrote: across by the first, up by the last."""
    ratios = [_ratio(scale[letter], mu) for letter, mu in asked.scales.items()]
    return np.asarray(values.real * ratios[0] + 1j * values.imag * ratios[-1])


def _ratio(written: float, own: float) -> float:
    """Give by what factor a written scale differs from ours; one that is rounded as ours is, does not."""
    return 1.0 if abs(written - own) <= 1e-3 * own else written / own


def _arrow(mark: MeasuredVector | MeasuredPoint, seen: SeenSheet) -> Arrow:
    by = seen.measured.moved
    if isinstance(mark, MeasuredVector):
        return Arrow(by(mark.start), by(mark.end))
    return Arrow(by(mark.at), by(mark.at))


def _on_axis(
    asked: FigureAsked,
    seen: SeenSheet,
    values: Values,
    arrows: Mapping[int, Arrow],
    scale: Mapping[str, float],
    written: bool,
) -> DrawnFigure:
    """Read ordinates from the axis, whatever place they are drawn from, and see whether each is at its place."""
    assert asked.paper is not None  # asked before
    by, paper = seen.measured.moved, asked.paper
    moved = _moved(asked, paper, seen, arrows)
    mu = asked.scale * _ratio(tuple(scale.values())[-1], asked.scale)
    along = (paper.axis[1] - paper.axis[0]) / abs(paper.axis[1] - paper.axis[0])
    beside = {}
    for place, arrow in arrows.items():
        # As our own sheet lies: what moved the whole sheet, and then the figure on it, is undone.
        end, start = (_back(spot, by) - moved - paper.feet[place] for spot in (arrow.end, arrow.start))
        values[place] = asked.way * (end / asked.way).real * mu
        beside[place] = (start / along).real
    shift = median(beside.values())
    shift = shift if abs(shift) > PLACED else 0.0
    gone = frozenset() if asked.returns else _read(_graph(asked, seen, moved), seen, (values, arrows), mu, shift)
    aside = frozenset(place for place, off in beside.items() if abs(off - shift) > PLACED)
    return DrawnFigure(asked, values, arrows, written, shift, aside, gone)


def _graph(asked: FigureAsked, seen: SeenSheet, moved: complex) -> tuple[FigureAsked, Frame, Sizes]:
    """Give a graph with its axes on paper and its places along them, mm."""
    assert asked.paper is not None  # asked before
    by, (start, end) = seen.measured.moved, asked.paper.axis
    along, feet = (end - start) / abs(end - start), asked.paper.feet
    return asked, Frame(by(feet[0] + moved), along * by.p, asked.way * by.p), ((feet - feet[0]) / along).real


def _read(
    graph: tuple[FigureAsked, Frame, Sizes],
    seen: SeenSheet,
    own: tuple[Values, Mapping[int, Arrow]],
    mu: float,
    shift: float,
) -> frozenset[int]:
    """Read the places without an ordinate off the curve; give those with one that the curve does not go through."""
    (asked, frame, places), (values, arrows) = graph, own
    ends = frame.seen(np.array([arrow.end for arrow in arrows.values()]))
    curve = through(seen.leaf.groups, frame, ends)
    if curve is None:
        return frozenset()
    bare = np.isnan(values)
    values[bare] = (asked.way * heights(curve, places + shift) * mu)[bare]
    off = away(curve, ends)
    gone = frozenset(place for place, apart in zip(arrows, off.tolist(), strict=True) if apart > THROUGH)
    return gone - asked.loose


def _back(spot: complex, by: Affine) -> complex:
    return complex((spot - by.t) / by.p)


def _moved(asked: FigureAsked, paper: Paper, seen: SeenSheet, arrows: Mapping[int, Arrow]) -> complex:
    """Give by how much a figure was moved with its axis, mm: to the axis that its feet are nearest to."""
    by = seen.measured.moved
    feet = [_back(arrow.start, by) - paper.feet[place] for place, arrow in arrows.items()]
    middle = complex(median(one.real for one in feet), median(one.imag for one in feet))
    moves = [0j, *_axes(paper, seen)]
    return min(moves, key=lambda one: (abs(one - middle) > PLACED, abs(one - middle)))


def _axes(paper: Paper, seen: SeenSheet) -> Iterator[complex]:
    """Give by how much lines that are as long as the axis, and go its way, are away from it."""
    by, (start, end) = seen.measured.moved, paper.axis
    for one in flat(seen.leaf.groups):
        if isinstance(one, Line):
            first, last = _back(one.start, by), _back(one.end, by)
            if abs((last - first) - (end - start)) <= SAME:
                yield first - start
