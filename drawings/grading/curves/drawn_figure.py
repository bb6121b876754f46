"""Curves as a student drew them: the line through given places, its values, its written scale (график)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from statistics import median

import numpy as np
import numpy.typing as npt

from drawings.checks.readers import Frame
from drawings.grading.curves.figure_records import ORDINATES, PRICKED, FigureAsked, Paper
from drawings.grading.drawn_plan import Arrow
from drawings.grading.written_number import stated_scales
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Curve, Line, Polyline, Stroke
from drawings.paper.walk import flat, group_named, texts
from drawings.reading.marks import MeasuredVector
from drawings.reading.sheet import SeenSheet
from plans.model.motion import Complexes, Floats
from plans.quantity import SLIP

# mm: a curve goes through a place if a hand that slips by four times a fair one's has drawn it so.
THROUGH = 2 * np.sqrt(2) * 4 * SLIP
PLACED = 0.7  # mm: what begins, or ends, at a place does so if a fair hand may have pricked it there
UPRIGHT = 0.1  # mm: a line that goes along by no more is a jump
BESIDE = PLACED / 2  # mm to either side of a place, at which a jump that is drawn there shows both its values
SHARES = np.linspace(0.0, 1.0, 9)  # of a piece of a curve, between which it is straight enough
SAME = 0.5  # mm: by so much the axis of a sheet that was saved anew may be longer


def chains(strokes: Iterable[Stroke]) -> Iterator[Complexes]:
    """Give the lines that may be curves: chains of three corners or more, and curves in short chords."""
    for stroke in flat(strokes):
        if isinstance(stroke, Polyline) and len(stroke.points) > 2:
            yield np.array(stroke.points)
        elif isinstance(stroke, Curve):
            yield np.array([piece.at(float(share)) for piece in stroke.pieces for share in SHARES])


def foot(lines: Iterable[Complexes], spot: complex) -> complex:
    """Give the place on some lines that is nearest to a spot.

    >>> foot((np.array([0j, 4 + 0j]), np.array([5j, 4 + 5j])), 1 + 2j)
    (1+0j)
    """
    feet = np.concatenate([_feet(line, np.array([spot]))[0] for line in lines])
    return complex(feet[int(np.abs(feet - spot).argmin())])


def away(line: Complexes, spots: Complexes) -> Floats:
    """Give how far places are from a line, mm.

    >>> away(np.array([0j, 1 + 0j, 1 + 2j]), np.array([0.5 + 0.1j, 1 + 1j, 3 + 2j])).tolist()
    [0.1, 0.0, 2.0]
    """
    return np.asarray(np.abs(spots[:, None] - _feet(line, spots)).min(axis=1))


def _feet(line: Complexes, spots: Complexes) -> Complexes:
    """Give the place on each piece of a line that is nearest to each spot."""
    run, apart = np.diff(line), spots[:, None] - line[:-1]
    long = np.maximum(np.abs(run) ** 2, np.finfo(float).tiny)
    return np.asarray(line[:-1] + np.clip((apart * run.conj()).real / long, 0.0, 1.0) * run)


def heights(curve: Complexes, places: Floats, dues: Sequence[Floats] = ()) -> Floats:
    """Give how high a curve is over some places, mm, behind a jump; NaN where it does not reach.

    At a jump both values are drawn: the nearer one counts, to that of some curves to which all of it is nearest.

    >>> curve = np.array([0j, 1 + 1j, 1 + 5j, 2 + 5j])
    >>> heights(curve, np.array([0.5, 1.0, 2.0, 4.0])).tolist()
    [0.5, 5.0, 5.0, nan]
    >>> heights(curve, np.array([0.9, 1.1]), [np.array([5.0, 1.0])]).round(2).tolist()
    [5.0, 0.75]
    """
    start, end = curve[:-1], curve[1:]
    turned = end.real < start.real
    low, high = np.where(turned, end, start), np.where(turned, start, end)
    found = np.array([[_height(low, high, float(place + by)) for place in places] for by in (0.0, -BESIDE, BESIDE)])
    upright = (high.real - low.real <= UPRIGHT) & (np.abs(high.imag - low.imag) > THROUGH)
    jumps = (np.abs(low.real[upright] - np.asarray(places)[:, None]) <= BESIDE).any(axis=1)
    apart = (np.where(np.isnan(found), np.inf, np.abs(found - due)) for due in dues)
    ways = [np.where(jumps, found[rows.argmin(axis=0), np.arange(len(places))], found[0]) for rows in apart]
    return np.asarray(min(zip(ways, dues, strict=True), key=nearness, default=(found[0], found[0]))[0])


def nearness(both: tuple[Floats, Floats]) -> float:
    """Tell how far a curve is in all from another one."""
    return float(np.nansum(np.abs(both[0] - both[1])))


def _height(low: Complexes, high: Complexes, place: float) -> float:
    """Give the height over one place: of the segment that begins there or goes over it, else of one that ends there."""
    over = np.flatnonzero((low.real <= place + 2 * QUANTUM) & (high.real > place + 2 * QUANTUM))
    ends = np.flatnonzero(np.minimum(np.abs(high.real - place), np.abs(low.real - place)) <= PLACED)
    ends = over if over.size else ends
    if not ends.size:
        return float("nan")
    k = int(ends[-1])
    wide = high[k].real - low[k].real
    share = min(max((place - low[k].real) / wide, 0.0), 1.0) if wide else 1.0
    return float(low[k].imag + share * (high[k].imag - low[k].imag))


@dataclass(frozen=True)
class DrawnFigure:
    """A figure of a sheet: its values in true units by their places, NaN where there are none; its arrows on paper.

    `shift` is by how much all its ordinates stand beside their places, mm; `aside` are those that do so alone. Through
    the ends of those that are `apart` the curve does not go.
    """

    asked: FigureAsked
    values: Complexes
    arrows: Mapping[int, Arrow]
    written: bool = True
    shift: float = 0.0
    aside: frozenset[int] = field(default_factory=frozenset)
    apart: frozenset[int] = field(default_factory=frozenset)
    free: bool = False  # whether it was drawn on the axes of a form, without marks
    mu: float = 0.0  # true units a mm as it is drawn there
    doubled: bool = False  # whether another curve, which differs, is drawn on its axes
    outlined: bool = False  # whether its scale may be written in outlines
    lines: tuple[Complexes, ...] = ()  # in true units: of a figure that is read off lines at what is nearest

    def off(self, expected: Complexes) -> Floats:
        """Give how far what is drawn is from what is due, true units; NaN of what is not drawn."""
        if not self.lines:
            return self.asked.off(self.values, expected)
        apart = np.min([away(line, expected) for line in self.lines], axis=0)
        return np.where(self.there, apart, np.nan)

    def nearest(self, expected: Complexes) -> Complexes:
        """Give the values of a figure that is read off lines where these are nearest to what is due."""
        found = self.values.copy()
        for k in np.flatnonzero(self.there).tolist():
            found[k] = foot(self.lines, complex(expected[k]))
        return found

    def allowed(self, expected: Floats, behind: Iterable[float]) -> Floats:
        """Give what its values may be out: on a form by its own scale, points by those of what they are laid off by."""
        if not self.free or not self.mu:
            return expected
        plain, error = (expected - self.asked.slack) / self.asked.error, self.asked.error
        if self.asked.kind == ORDINATES:
            own, before = PRICKED * max(1.0, self.mu / self.asked.scale), np.maximum(error**2 - PRICKED**2, 0.0)
            return np.asarray(plain * np.sqrt(own**2 + before) + self.asked.slack)
        scales = [self.mu, self.mu, *behind]
        most = expected * max(1.0, self.mu / self.asked.scale)  # on a form that is coarser so much more
        return np.asarray(
            np.minimum(plain * PRICKED * float(np.hypot.reduce(scales)) / self.asked.scale + self.asked.slack, most)
        )

    @property
    def there(self) -> npt.NDArray[np.bool_]:
        """Which places have a value."""
        return ~np.isnan(self.values)


def from_marks(asked: FigureAsked, sheet: SeenSheet) -> DrawnFigure | None:
    """Give a figure by the marks of a sheet; None where it has none of it."""
    marks = {(mark.name, mark.position): mark for mark in sheet.measured.marks if mark.plan == asked.plan}
    drawn = {item.place: marks[item.name, item.position] for item in asked.items if (item.name, item.position) in marks}
    if not drawn:
        return None
    scale, written = scales_on(asked, sheet)
    arrows = dict[int, Arrow]()
    values = np.full(len(asked.true), complex(np.nan, np.nan))
    for place, mark in drawn.items():
        ends = (mark.start, mark.end) if isinstance(mark, MeasuredVector) else (mark.at, mark.at)
        values[place], arrows[place] = mark.value, Arrow(*ends)
    if asked.kind == ORDINATES and asked.paper is not None:
        mu = asked.scale * _ratio(tuple(scale.values())[-1], asked.scale)
        return _OnAxis(asked, sheet, asked.paper, arrows).read(values, mu, written)
    ratios = [_ratio(scale[letter], mu) for letter, mu in asked.scales.items()]
    values = np.asarray(values.real * ratios[0] + 1j * values.imag * ratios[-1])  # across by the first, up by the last
    return DrawnFigure(asked, values, arrows, written)


def scales_on(asked: FigureAsked, sheet: SeenSheet) -> tuple[Mapping[str, float], bool]:
    """Give the scales that stand over a figure, ours where none stand; and whether all do.

    On a sheet whose figures an editor has dissolved ours may stand anywhere.
    """
    group, mus = group_named(sheet.leaf.groups, asked.plan), {letter: asked.scales[letter] for letter in asked.stated}
    if group is not None:
        found = stated_scales(texts((group,)), asked.stated)
    else:
        every = [stated_scales((text,), asked.stated) for text in texts(sheet.leaf.groups)]
        ours = (name for name, mu in mus.items() if any(_ratio(one.get(name, 0.0), mu) == 1.0 for one in every))
        found = {letter: mus[letter] for letter in ours}
    return {**asked.scales, **found}, mus.keys() <= found.keys()


def _ratio(written: float, true: float) -> float:
    """Give by what factor a written scale differs from ours; one that is rounded as ours is, does not."""
    return 1.0 if abs(written - true) <= 1e-3 * true else written / true


@dataclass(frozen=True)
class _OnAxis:
    """A figure by its marks on an axis of paper, which may have been moved with it."""

    asked: FigureAsked
    seen: SeenSheet
    paper: Paper
    arrows: Mapping[int, Arrow]

    @property
    def moved(self) -> complex:
        """By how much the figure was moved with its axis, mm: to the axis that its feet are nearest to."""
        feet = [arrow.start - self.paper.feet[place] for place, arrow in self.arrows.items()]
        middle = complex(median(foot.real for foot in feet), median(foot.imag for foot in feet))
        return min([0j, *self._axes()], key=lambda move: (abs(move - middle) > PLACED, abs(move - middle)))

    def _axes(self) -> Iterator[complex]:
        """Give by how much lines that are as long as the axis, and go its way, are away from it."""
        start, end = self.paper.axis
        for line in flat(self.seen.leaf.groups):
            if isinstance(line, Line) and abs((line.end - line.start) - (end - start)) <= SAME:
                yield line.start - start

    def read(self, values: Complexes, mu: float, written: bool) -> DrawnFigure:
        """Read ordinates from the axis, whatever place they are drawn from, and see whether each is at its place."""
        start, end = self.paper.axis
        along, way, moved = (end - start) / abs(end - start), self.asked.way, self.moved
        beside = {}
        for place, arrow in self.arrows.items():
            foot, tip = (spot - moved - self.paper.feet[place] for spot in arrow)
            values[place] = way * (tip / way).real * mu
            beside[place] = (foot / along).real
        shift = median(beside.values())
        shift = shift if abs(shift) > PLACED else 0.0
        gone = frozenset[int]()
        if not self.asked.returns:
            gone = self._off_curve(values, Frame(self.paper.feet[0] + moved, along, way, 1.0, 1.0), mu, shift)
        aside = frozenset(place for place, off in beside.items() if abs(off - shift) > PLACED)
        return DrawnFigure(self.asked, values, self.arrows, written, shift, aside, gone)

    def _off_curve(self, values: Complexes, frame: Frame, mu: float, shift: float) -> frozenset[int]:
        """Read the places without an ordinate off the curve; give those with one that the curve does not go through.

        The curve is the one that goes through most ends of ordinates, if through more than half of them.
        """
        ends = frame.true(np.array([arrow.end for arrow in self.arrows.values()]))
        curves = [frame.true(chain) for chain in chains(self.seen.leaf.groups)]
        best = max(curves, key=lambda curve: _hits(curve, ends), default=None)
        if best is None or 2 * _hits(best, ends) <= len(ends):
            return frozenset()
        start, end = self.paper.axis
        places = ((self.paper.feet - self.paper.feet[0]) / ((end - start) / abs(end - start))).real
        bare = np.isnan(values)
        values[bare] = (self.asked.way * heights(best, places + shift) * mu)[bare]
        gone = zip(self.arrows, away(best, ends).tolist(), strict=True)
        return frozenset(place for place, off in gone if off > THROUGH) - self.asked.loose


def _hits(curve: Complexes, spots: Complexes) -> int:
    return int((away(curve, spots) <= THROUGH).sum())
