"""The axes of our form on a sheet, and the scales that a student wrote beside them (оси бланка)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from drawings.eye.sheet import SeenSheet
from drawings.grading.curves.asked_figure import Values
from drawings.grading.curves.drawn_curve import PLACED
from drawings.grading.seeing.written_scale import stated_scales
from drawings.paper.strokes import Group, Line
from drawings.paper.walk import groups, texts

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
