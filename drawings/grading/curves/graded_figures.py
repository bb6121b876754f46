"""The curves of one sheet graded: found, judged as they follow, or missing (оценка графиков)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from drawings.eye.sheet import SeenSheet
from drawings.grading import verdict
from drawings.grading.allowance import DEVIATIONS, Allowance, Allowances
from drawings.grading.curves.asked_figure import ORDINATES, FigureAsked, Sizes
from drawings.grading.curves.drawn_arms import from_arms
from drawings.grading.curves.drawn_figure import DrawnFigure, from_marks
from drawings.grading.curves.drawn_rings import from_rings
from drawings.grading.curves.figure_judge import FigureJudge
from drawings.grading.curves.form.form_figure import from_form
from drawings.grading.curves.form.form_line import line_on_form
from drawings.grading.verdict import Verdict


def figures_drawn(seen: SeenSheet, asked: Sequence[FigureAsked]) -> dict[str, tuple[DrawnFigure, ...]]:
    """Find the figures on a sheet, by the sheet of the task that it is: that of which it has most figures."""
    own: dict[str, list[DrawnFigure]] = {}
    for one in asked:
        drawn = _drawn(one, seen)
        if drawn is not None:
            own.setdefault(one.sheet, []).append(drawn)
    kept: dict[str, tuple[DrawnFigure, ...]] = {}
    for sheet in sorted(own, key=lambda name: _likeness(own[name]), reverse=True):
        plans = {one.asked.plan for found in kept.values() for one in found}
        if plans.isdisjoint(one.asked.plan for one in own[sheet]):
            kept[sheet] = tuple(own[sheet])
    return kept


def _drawn(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    if asked.rings or asked.arms:
        return from_rings(asked, seen) if asked.rings else from_arms(asked, seen)
    return from_marks(asked, seen) or from_form(asked, seen) or line_on_form(asked, seen)


def _likeness(found: Sequence[DrawnFigure]) -> tuple[int, float]:
    """Tell how much of a sheet is there, and how near it is: sheets of several cams have figures of one name."""
    apart = [np.nanmean(one.asked.off(one.values, one.asked.true)) / (one.asked.largest or 1.0) for one in found]
    return sum(len(one.arrows) for one in found), -float(np.mean(apart))


def figure_verdicts(
    drawn: Mapping[str, Sequence[DrawnFigure]],
    asked: Sequence[FigureAsked],
    sheets: Collection[str],
    marked: Collection[str],
    allowed: Callable[[FigureAsked], Sizes],
    vectors: Mapping[str, complex] = MappingProxyType({}),
    empty: Collection[str] = (),
) -> Iterator[Verdict]:
    """Judge the figures of a sheet; one of the same sheet of the task that is not there is missing.

    `sheets` are those that the plans beside them are of, `marked` those whose plans bear data: on any other one a curve
    cannot be read. `vectors` are those of plans beside them, by their names, that figures may rest on. On the axes of
    `empty` ones nothing is drawn.
    """
    for sheet in dict.fromkeys(one.sheet for one in asked):
        due, found = [one for one in asked if one.sheet == sheet], drawn.get(sheet, ())
        judge, there = FigureJudge(due, vectors), {one.asked.key: one for one in found}
        for one in due if found or sheet in sheets else ():
            if one.key in there:
                yield from judge.verdicts(there[one.key], allowed(one))
            elif (found and (_is_graph(one) or not any(drawn.free for drawn in found))) or (
                sheet in marked or one.plan in empty
            ):
                yield from _missing(one)
            else:
                yield Verdict(one.plan, None, "", verdict.UNREAD, unit=one.unit)


def _is_graph(asked: FigureAsked) -> bool:
    """Tell whether a figure has axes of its own on a form, and would be read there."""
    return asked.kind == ORDINATES and asked.paper is not None


def _missing(asked: FigureAsked) -> Iterator[Verdict]:
    for one in asked.items:
        yield Verdict(asked.plan, None, one.called, verdict.MISSING, unit=asked.unit, letters=("", one.name))


def allowed_of(asked: FigureAsked, by: Allowances, coarse: float) -> Sizes:
    """Give what each value of a figure may be out, true units."""
    found = np.array(_allowed(asked, by.by, coarse))
    for one in asked.items:
        found[one.place] = _allowed(asked, by.to(one.called), coarse)[one.place]
    return found


def _allowed(asked: FigureAsked, by: Allowance, coarse: float) -> Sizes:
    if by.share is not None:
        return np.full(len(asked.true), by.share * asked.largest) + asked.slack
    return asked.allowed(max(by.slip, coarse), DEVIATIONS)
