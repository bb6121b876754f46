"""Load diagrams without marks: a course there and back that a student drew on the axes of our form (на осях бланка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.eye.sheet import SeenSheet
from drawings.grading.curves.asked_figure import FigureAsked, Sizes, Values
from drawings.grading.curves.drawn_curve import PLACED, chains
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.curves.form.form_axes import AXES, FRAME, Blank, axes, written_at
from drawings.grading.drawn_plan import Arrow
from drawings.paper.strokes import Line
from drawings.paper.walk import flat


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
    high = min((_read(lines, places, due) for due in dues), key=lambda one: one.off).high
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


def _read(lines: Sequence[Values], places: Sizes, due: Sizes) -> Heights:
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
