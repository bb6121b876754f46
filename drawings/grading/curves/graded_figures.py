"""The curves of one sheet graded: found, judged as they follow, or missing (оценка графиков)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from drawings.grading import verdict
from drawings.grading.asked import DEVIATIONS, Allowance, Allowances
from drawings.grading.curves.arm_figures import from_arms
from drawings.grading.curves.drawn_figure import PLACED, THROUGH, DrawnFigure, from_marks
from drawings.grading.curves.figure_judge import FigureJudge
from drawings.grading.curves.figure_records import ORDINATES, FigureAsked, Sizes, Values
from drawings.grading.curves.form.form_figure import from_form, line_on_form
from drawings.grading.drawn_plan import Arrow
from drawings.grading.plans_on_form import paired
from drawings.grading.verdict import Verdict
from drawings.paper.strokes import Circle, Line
from drawings.paper.walk import flat
from drawings.reading.sheet import SeenSheet

OPPOSITE = 2.0  # how far ways are apart that lead to opposite sides: no ray is farther from any


class Rings(NamedTuple):
    """Rings on paper: their centre and the radii of their circles, rising, mm."""

    centre: complex
    radii: tuple[float, ...]

    def ring(self, number: int) -> tuple[float, float]:
        """Give the radii of a ring; the first is the outermost."""
        return self.radii[-1 - number], self.radii[-number]


def from_rings(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    """Give the bearings of the rays in the rings of a sheet; None where it has no rings of so many rows."""
    count = max(asked.rings, default=0)
    rings = _rings(seen, count) if count else None
    if rings is None:
        return None
    lines, by = [one for one in flat(seen.leaf.groups) if isinstance(one, Line)], seen.measured.moved
    values = np.full(len(asked.true), complex(np.nan, np.nan))
    for number in range(1, count + 1):
        own = np.flatnonzero(np.array(asked.rings) == number)
        rays = np.array(list(_rays(lines, rings, number))) * np.conj(by.p) / abs(by.p)
        dues = [asked.true[own], *(one.values[own] for one in asked.mistakes)]
        values[own] = np.abs(asked.true[own]) * _paired(rays, dues)
    if np.isnan(values).all():
        return None
    arrows = {}
    for place in np.flatnonzero(~np.isnan(values)).tolist():
        ray, (low, high) = values[place] / abs(values[place]) * by.p / abs(by.p), rings.ring(asked.rings[place])
        arrows[place] = Arrow(rings.centre + low * ray, rings.centre + high * ray)
    return DrawnFigure(asked, values, arrows, free=True)


def _rings(seen: SeenSheet, count: int) -> Rings | None:
    """Give the widest circles about one centre, one more than there are rings between them."""
    circles = [one for one in flat(seen.leaf.groups) if isinstance(one, Circle)]
    found = []
    for middle in sorted(circles, key=lambda one: -one.radius):
        about = sorted(one.radius for one in circles if abs(one.centre - middle.centre) <= PLACED)
        radii = [low for low, high in zip(about, [*about[1:], np.inf], strict=True) if high - low > PLACED]
        if len(radii) > count:
            found.append(Rings(middle.centre, tuple(radii[-count - 1 :])))
    return max(found, key=lambda one: one.radii[-1], default=None)


def _rays(lines: Sequence[Line], rings: Rings, number: int) -> Iterator[complex]:
    """Give the ways of the lines that lead across a ring, from the centre."""
    inner, outer = rings.ring(number)
    for one in lines:
        near, far = sorted((one.start - rings.centre, one.end - rings.centre), key=abs)
        if abs(near) <= inner + THROUGH and abs(far) >= outer - THROUGH and _radial(near, far):
            yield far / abs(far)


def _radial(near: complex, far: complex) -> bool:
    """Tell whether a line would go through the centre as a hand draws it, and begins on this side of it."""
    way = (far - near) / abs(far - near)
    return bool(abs((near / way).imag) <= THROUGH and (near / way).real >= -THROUGH)


def _paired(rays: Values, dues: Sequence[Values]) -> Values:
    """Give each bearing that is due the ray that is its: all together as near as they can be; NaN for none.

    >>> _paired(np.array([1j, 1 + 0j]), [np.array([2 + 0.1j, 2j])]).tolist()
    [(1+0j), 1j]
    """
    found = []
    for due in dues:
        ways, none = due / np.abs(due), np.full(len(due), complex(np.nan, np.nan))
        costs = np.hstack([np.abs(ways[:, None] - rays), np.full((len(ways), len(ways)), OPPOSITE)])
        columns = paired(costs.tolist())
        found.append((float(costs[np.arange(len(ways)), columns].sum()), np.append(rays, none)[columns]))
    return min(found, key=lambda one: one[0])[1]


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
            if one.key in there and there[one.key].doubled:
                yield Verdict(one.plan, None, "", verdict.DOUBLED, unit=one.unit)
            elif one.key in there:
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
