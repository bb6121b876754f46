"""Judging curves: each value held against the analysis and against what it goes on from; a mistake is named once."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.grading import verdict
from drawings.grading.allowance import DEVIATIONS, Allowance, Allowances
from drawings.grading.curves.drawn_figure import DrawnFigure, from_marks
from drawings.grading.curves.figure_records import BEARINGS, ORDINATES, FigureAsked, Mistake, ValueAsked
from drawings.grading.curves.form_figure import from_form
from drawings.grading.verdict import Verdict
from drawings.reading.sheet import SeenSheet
from plans.model.motion import Complexes, Floats

SHORT = 0.1  # mm: an ordinate that is shorter may be a point
ROUNDS = 8  # of fitting to a line, each of which leaves a share of what is left: that of the lean of line to way
SEVERAL = 2  # values that say that a whole figure is out
Truths: TypeAlias = npt.NDArray[np.bool_]


class FigureJudge:
    """Judges the figures of a sheet in the order in which they follow from one another.

    It keeps what a student has drawn of those so far, at all their places, and by what factor a whole one is out.
    """

    def __init__(self, asked: Sequence[FigureAsked]) -> None:
        self.values: dict[str, Complexes] = {figure.key: figure.true for figure in asked}
        self.wholes: dict[str, Complexes] = {}
        self.factors: dict[str, float] = {}
        self.right = {figure.key for figure in asked}

    def verdicts(self, drawn: DrawnFigure, allowed: Floats) -> Iterator[Verdict]:
        """Judge one figure, and keep it for those that go on from it."""
        asked = drawn.asked
        judged = _Answer(drawn, allowed, self._going_on(asked), set(asked.behind) <= self.right)
        again = judged.mistake is not None and judged.mistake.kind == verdict.IDLE and bool(self.wholes)
        yield from (said for said in judged.verdicts() if not (again and said.kind == verdict.IDLE))  # it costs once
        self.values[asked.key] = judged.whole_values
        if judged.mistake is not None:
            self.wholes[asked.key] = judged.mistake.values
        factor = judged.factor or self._factor(asked)
        if factor != 1.0 and (judged.factor is not None or judged.fits(factor * asked.true)):
            self.factors[asked.key] = factor
        if not judged.good:
            self.right.discard(asked.key)

    def pass_by(self, asked: FigureAsked) -> None:
        """Take a figure that is not drawn as it follows from those that are."""
        if not set(asked.behind) <= self.right and (going_on := self._going_on(asked)):
            self.values[asked.key] = going_on[0]
            self.right.discard(asked.key)

    def _going_on(self, asked: FigureAsked) -> list[Complexes]:
        """Give what a figure is if it is drawn on from those before it as they are, or as their mistakes say."""
        if asked.course is None or not set(asked.behind) <= self.values.keys():
            return []  # what it goes on from is on another sheet
        found, wholes = [asked.course(self.values)], {k: self.wholes[k] for k in asked.behind if k in self.wholes}
        if wholes:
            found.append(asked.course({**self.values, **wholes}))
        factor = self._factor(asked)
        return [*found, factor * asked.true] if factor != 1.0 else found

    def _factor(self, asked: FigureAsked) -> float:
        """Give the one factor that all figures before it are out by, where it is out as they are."""
        factors = {self.factors.get(name, 1.0) for name in asked.behind} if asked.linear else set()
        return factors.pop() if len(factors) == 1 else 1.0


class _Answer:
    """What is said of one figure."""

    def __init__(self, drawn: DrawnFigure, allowed: Floats, going_on: Sequence[Complexes], rightly: bool) -> None:
        self.drawn, self.asked, self.allowed = drawn, drawn.asked, allowed
        self.going_on, self.rightly = going_on, rightly
        self.near = self._fits(self.asked.true)
        self.follows = np.zeros(len(self.near), dtype=np.bool_)
        for values in going_on:
            self.follows |= self._fits(values)
        self.mistake, self.factor = self._whole()

    @property
    def marked(self) -> Truths:
        """Which places have a value that is asked for."""
        return np.asarray(self.drawn.there & np.isin(np.arange(len(self.drawn.values)), self.asked.places))

    def fits(self, expected: Complexes) -> bool:
        """Tell whether all values are as they are due."""
        return bool(self._fits(expected)[self.marked].all())

    def _fits(self, expected: Complexes) -> Truths:
        """Tell which values are as they are due; one that is not there is none."""
        with np.errstate(invalid="ignore"):
            near = np.asarray(self.drawn.off(expected) <= self.allowed)
        if not self.asked.stepped:
            return near
        last = 0  # where the curve begins
        for k in np.flatnonzero(near).tolist():
            near[k] = self._stepped(last, k, expected) or k == 0
            last = k if near[k] else last
        return near

    def _stepped(self, start: int, end: int, expected: Complexes) -> bool:
        """Tell whether the step from one place to another is as it is due."""
        return self._step_off(start, end, expected) <= float(self.allowed[end]) * self.asked.step(start, end)

    def _step_off(self, start: int, end: int, expected: Complexes) -> float:
        drawn = self.drawn.values
        begun = drawn[start] if self.drawn.there[start] else expected[start]
        return float(self.asked.off(drawn[end : end + 1] - begun, expected[end : end + 1] - expected[start])[0])

    @property
    def good(self) -> bool:
        """Whether all its values are right."""
        fine = self.near | self.follows if self.rightly else self.near
        return bool(fine[self.asked.places].all()) and self.drawn.shift == 0.0

    @property
    def whole_values(self) -> Complexes:
        """The values at all places: as that says which most of them fit, out between marks as these are out of it."""
        true, there = self.asked.true, self.drawn.there
        if not there.any():
            return true
        named = () if self.mistake is None else (self.mistake.values,)
        base = max((*self.going_on, true, *named), key=lambda values: int(self._fits(values)[self.marked].sum()))
        # What is too short to be drawn is not marked: it is where it should be.
        known = there | (np.abs(true) <= SHORT * self.asked.scale)
        at, moved = np.arange(len(true)), np.where(there, self.drawn.values - base, 0)[known]
        return np.asarray(base + np.interp(at, at[known], moved.real) + 1j * np.interp(at, at[known], moved.imag))

    def _whole(self) -> tuple[Mistake | None, float | None]:
        """Give the mistake by which most of a figure is out, and the factor, if it is one."""
        left = self.marked & ~self.near & ~self.follows
        if not left.any():
            return None, None
        known = map(self._fitted, self.asked.mistakes)
        named = next((mistake for mistake in known if self._tells(mistake, left)), None)
        fitting = [
            (int(fits.sum()), -self._out(mistake), mistake, factor)
            for base in ((self.asked.true, *self.going_on) if left.sum() >= SEVERAL else ())
            for mistake, factor in self._generals(base)
            if ((fits := self._fits(mistake.values)) & left).sum() >= SEVERAL and 2 * fits.sum() > self.marked.sum()
        ]
        best = max(fitting, key=lambda fit: fit[:2], default=None)
        # What has a name of its own goes before, but where another is twice as near.
        if named is not None and (best is None or self._out(named) <= 2 * self._out(best[2])):
            return named, None
        return (None, None) if best is None else best[2:]

    def _tells(self, mistake: Mistake, left: Truths) -> bool:
        """Tell whether all that a mistake alters is as it has it, and something of that is wrong."""
        distinct = self.marked & (self.asked.off(mistake.values, self.asked.true) > self.allowed)
        return bool((self._fits(mistake.values) | ~distinct).all() and (left & distinct).any())

    def _out(self, mistake: Mistake) -> float:
        return float(np.nansum(self.drawn.off(mistake.values)[self.marked]))

    def _fitted(self, mistake: Mistake) -> Mistake:
        """Give a mistake by the size that the figure has it by; of lines step by step, as they are nearest to it."""
        if not self.drawn.lines:
            return mistake.fitted(self.drawn.values)
        for _ in range(ROUNDS if mistake.along is not None else 0):
            mistake = mistake.fitted(self.drawn.nearest(mistake.values))
        return mistake

    def _generals(self, base: Complexes) -> Iterator[tuple[Mistake, float | None]]:
        """Give what may be wrong with any figure: all the other way, by one factor, from another zero line."""
        there, asked = self.marked, self.asked
        drawn = self.drawn.values[there]
        yield Mistake(verdict.INVERTED, -base), -1.0
        size = float((np.abs(base[there]) ** 2).sum())
        if size and asked.kind != BEARINGS:
            factor = float((drawn * base[there].conj()).real.sum() / size)
            if self.drawn.lines:  # by what they reach farther
                most = max(float(np.abs(line).max()) for line in self.drawn.lines)
                factor = most / float(np.abs(base[there]).max())
            if factor > 0:
                yield Mistake(verdict.FACTOR, factor * base), factor
        if asked.kind == ORDINATES:
            away = asked.way * float(np.median(((drawn - base[there]) / asked.way).real))
            yield Mistake(verdict.LEVEL, base + away), None

    def verdicts(self) -> Iterator[Verdict]:
        """Judge the figure as a whole, then each value that is asked for."""
        if not self.drawn.written:
            yield self._said(verdict.ILLEGIBLE if self.drawn.outlined else verdict.UNSCALED)
        if self.drawn.shift:
            yield self._said(verdict.SHIFTED)
        if self.mistake is not None:
            yield self._said(self.mistake.kind)
        apart = (item for item in self.asked.items if item.place in self.drawn.apart)
        yield from (self._said(verdict.APART, item) for item in apart)
        within = self._fits(self.mistake.values) if self.mistake is not None else np.zeros_like(self.near)
        seen = (item for item in self.asked.items if not (self.drawn.lines and np.isnan(self.drawn.values[item.place])))
        yield from (self._verdict(item, within) for item in seen)

    def _verdict(self, item: ValueAsked, within: Truths) -> Verdict:
        k, value = item.place, self.drawn.values[item.place]
        if np.isnan(value):
            return self._said(verdict.MISSING, item)
        off = float(self.asked.off(self.drawn.values, self.asked.true)[k])
        if k in self.drawn.aside:
            return self._said(verdict.ASIDE, item, off)
        if self.near[k] or (self.follows[k] and self.rightly):
            return self._said(verdict.RIGHT, item, off)
        if self.follows[k] or within[k] or self._goes_on(k):
            return self._said(verdict.FOLLOWS, item, off)
        back = not self.drawn.lines and self.asked.off(-self.drawn.values, self.asked.true)[k] <= self.allowed[k]
        said = self._said(verdict.REVERSED if back else verdict.WRONG, item, off)
        return said if off > self.allowed[k] else self._of_step(said, k)

    def _of_step(self, said: Verdict, k: int) -> Verdict:
        """Give by how much the step to a place is out that is itself within what slips may add up to."""
        last = max(np.flatnonzero(self.near[:k]).tolist(), default=0)
        allowed = float(self.allowed[k]) * self.asked.step(last, k)
        return said._replace(off=self._step_off(last, k, self.asked.true), allowed=allowed)

    def _goes_on(self, k: int) -> bool:
        """Tell whether a value of a curve that is drawn on from place to place is right from the one before it."""
        before = np.flatnonzero(self.drawn.there[:k])
        if not self.asked.stepped or not before.size:
            return False
        return any(self._stepped(int(before[-1]), k, expected) for expected in (self.asked.true, *self.going_on))

    def _said(self, kind: str, item: ValueAsked | None = None, off: float | None = None) -> Verdict:
        asked = self.asked
        if item is None:
            return Verdict(asked.plan, None, "", kind, unit=asked.unit)
        arrow = self.drawn.arrows.get(item.place)
        at = None if arrow is None else (arrow.start, arrow.end)
        allowed = float(self.allowed[item.place])
        return Verdict(asked.plan, None, item.called, kind, off, allowed, asked.unit, at, ("", item.name))


def figures_drawn(drawn_sheet: SeenSheet, asked: Sequence[FigureAsked]) -> dict[str, tuple[DrawnFigure, ...]]:
    """Find the figures on a sheet, by the sheet of the task that it is: that of which it has most figures."""
    sheets: dict[str, list[DrawnFigure]] = {}
    for figure in asked:
        drawn = from_marks(figure, drawn_sheet) or from_form(figure, drawn_sheet)
        if drawn is not None:
            sheets.setdefault(figure.sheet, []).append(drawn)
    kept: dict[str, tuple[DrawnFigure, ...]] = {}
    for sheet in sorted(sheets, key=lambda name: _likeness(sheets[name], drawn_sheet.leaf.title), reverse=True):
        plans = {drawn.asked.plan for found in kept.values() for drawn in found}
        if plans.isdisjoint(drawn.asked.plan for drawn in sheets[sheet]):
            kept[sheet] = tuple(sheets[sheet])
    return kept


def _likeness(found: Sequence[DrawnFigure], title: str) -> tuple[int, bool, float]:
    """Tell how much of a sheet is there, and how near it is: sheets of several cams have figures of one name."""
    pairs = ((figure.asked, figure.values) for figure in found)
    apart = [np.nanmean(asked.off(values, asked.true)) / (asked.largest or 1.0) for asked, values in pairs]
    return sum(len(figure.arrows) for figure in found), found[0].asked.title == title, -float(np.mean(apart))


def figure_verdicts(
    drawn: Mapping[str, Sequence[DrawnFigure]],
    asked: Sequence[FigureAsked],
    sheets: Collection[str],
    marked: Collection[str],
    allowed: Callable[[FigureAsked], Floats],
    filled: Mapping[str, bool] | None = None,
    kept: list[tuple[FigureAsked, Complexes]] | None = None,
) -> Iterator[Verdict]:
    """Judge the figures of a sheet; one of the same sheet of the task that is not there is missing.

    `sheets` are those that the plans beside them are of, `marked` those whose plans bear data: on any other one a curve
    cannot be read, nor on a form what has no line of its own there. Of a form due is what it has axes or a place for,
    `filled` or not. What all figures are to the student is `kept`.
    """
    for sheet in dict.fromkeys(figure.sheet for figure in asked):
        figures, found = [figure for figure in asked if figure.sheet == sheet], drawn.get(sheet, ())
        judge, there = FigureJudge(figures), {figure.asked.key: figure for figure in found}
        for figure in figures if found or sheet in sheets else ():
            if figure.key in there and there[figure.key].doubled:
                yield Verdict(figure.plan, None, "", verdict.DOUBLED, unit=figure.unit)
                continue
            if figure.key in there:
                one, scales = there[figure.key], [there[key].mu for key in figure.behind if key in there]
                yield from judge.verdicts(one, one.allowed(allowed(figure), scales))
                continue
            judge.pass_by(figure)
            if filled is not None and not (figure.plan in filled and (figure.curved or figure.is_graph)):
                continue
            if sheet in marked or (found if filled is None else not filled[figure.plan]):
                missing = Verdict(figure.plan, None, "", verdict.MISSING, unit=figure.unit)
                yield from (missing._replace(name=item.called, letters=("", item.name)) for item in figure.items)
            else:
                yield Verdict(figure.plan, None, "", verdict.UNREAD, unit=figure.unit)
        if kept is not None:
            kept += [(figure, judge.values[figure.key]) for figure in figures if not figure.on_paper]


def allowed_of(asked: FigureAsked, by: Allowances, coarse: float) -> Floats:
    """Give what each value of a figure may be out, true units."""
    found = np.array(_allowed(asked, by.by, coarse))
    for item in asked.items:
        found[item.place] = _allowed(asked, by.to(item.called), coarse)[item.place]
    return found


def _allowed(asked: FigureAsked, by: Allowance, coarse: float) -> Floats:
    if by.share is not None:
        return np.full(len(asked.true), by.share * asked.largest) + asked.slack
    return asked.allowed(max(by.slip, coarse), DEVIATIONS)
