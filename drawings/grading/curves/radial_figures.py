"""Rings of a cyclogram and arms of compensators, found on a sheet by their lines and letters (круги и плечи)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks.hold import NEAREST, labels_of, off
from drawings.grading.curves.drawn_figure import PLACED, THROUGH, DrawnFigure, scales_on
from drawings.grading.curves.figure_records import (
    BEARINGS,
    FigureAsked,
)
from drawings.grading.drawn_plan import Arrow
from drawings.grading.plans_on_form import paired
from drawings.lettering.words import lowered_bank
from drawings.paper.strokes import Circle, Leaf, Line, Text
from drawings.paper.walk import flat, group_named
from drawings.reading.sheet import SeenSheet
from plans.model.motion import Complexes

OPPOSITE = 2.0  # how far ways are apart that lead to opposite sides: no ray is farther from any


class Rings(NamedTuple):
    """Rings on paper: their centre and the radii of their circles, rising, mm."""

    centre: complex
    radii: tuple[float, ...]

    def ring(self, number: int) -> tuple[float, float]:
        """Give the radii of a ring; the first is the outermost."""
        return self.radii[-1 - number], self.radii[-number]


def from_rings(asked: FigureAsked, sheet: SeenSheet) -> DrawnFigure | None:
    """Give the bearings of the rays in the rings of a sheet; None where it has no rings of so many rows."""
    count = max(asked.rings, default=0)
    rings = _rings(sheet, count) if count else None
    if rings is None:
        return None
    lines, by = [stroke for stroke in flat(sheet.leaf.groups) if isinstance(stroke, Line)], sheet.measured.moved
    values = np.full(len(asked.true), complex(np.nan, np.nan))
    for number in range(1, count + 1):
        places = np.flatnonzero(np.array(asked.rings) == number)
        rays = np.array(list(_rays(lines, rings, number))) * np.conj(by.p) / abs(by.p)
        dues = [asked.true[places], *(mistake.values[places] for mistake in asked.mistakes)]
        values[places] = np.abs(asked.true[places]) * _paired(rays, dues)
    if np.isnan(values).all():
        return None
    arrows = {}
    for place in np.flatnonzero(~np.isnan(values)).tolist():
        ray, (low, high) = values[place] / abs(values[place]) * by.p / abs(by.p), rings.ring(asked.rings[place])
        arrows[place] = Arrow(rings.centre + low * ray, rings.centre + high * ray)
    return DrawnFigure(asked, values, arrows, free=True)


def _rings(sheet: SeenSheet, count: int) -> Rings | None:
    """Give the widest circles about one centre, one more than there are rings between them."""
    circles = [stroke for stroke in flat(sheet.leaf.groups) if isinstance(stroke, Circle)]
    found = []
    for middle in sorted(circles, key=lambda circle: -circle.radius):
        about = sorted(circle.radius for circle in circles if abs(circle.centre - middle.centre) <= PLACED)
        radii = [low for low, high in zip(about, [*about[1:], np.inf], strict=True) if high - low > PLACED]
        if len(radii) > count:
            found.append(Rings(middle.centre, tuple(radii[-count - 1 :])))
    return max(found, key=lambda rings: rings.radii[-1], default=None)


def _rays(lines: Sequence[Line], rings: Rings, number: int) -> Iterator[complex]:
    """Give the ways of the lines that lead across a ring, from the centre."""
    inner, outer = rings.ring(number)
    for line in lines:
        near, far = sorted((line.start - rings.centre, line.end - rings.centre), key=abs)
        if abs(near) <= inner + THROUGH and abs(far) >= outer - THROUGH and _radial(near, far):
            yield far / abs(far)


def _radial(near: complex, far: complex) -> bool:
    """Tell whether a line would go through the centre as a hand draws it, and begins on this side of it."""
    way = (far - near) / abs(far - near)
    return bool(abs((near / way).imag) <= THROUGH and (near / way).real >= -THROUGH)


def _paired(rays: Complexes, dues: Sequence[Complexes]) -> Complexes:
    """Give each bearing that is due the ray that is its: all together as near as they can be; NaN for none.

    >>> _paired(np.array([1j, 1 + 0j]), [np.array([2 + 0.1j, 2j])]).tolist()
    [(1+0j), 1j]
    """
    found = []
    for expected in dues:
        ways, none = expected / np.abs(expected), np.full(len(expected), complex(np.nan, np.nan))
        costs = np.hstack([np.abs(ways[:, None] - rays), np.full((len(ways), len(ways)), OPPOSITE)])
        columns = paired(costs.tolist())
        found.append((float(costs[np.arange(len(ways)), columns].sum()), np.append(rays, none)[columns]))
    return min(found, key=lambda pairing: pairing[0])[1]


HOLLOW = ("", "none", "#ffffff")  # what fills a circle that is no mass


def written(name: str) -> str:
    """Give the letter of a mass as it is read."""
    return Text(0j, lowered_bank(name)).plain


def from_arms(asked: FigureAsked, sheet: SeenSheet) -> DrawnFigure | None:
    """Give the arms of a figure by the letters of their masses; None where none is found."""
    found = {k: arm_at(sheet.leaf, asked.plan, letter) for k, letter in enumerate(asked.arms)}
    arrows = {k: Arrow(*arm) for k, arm in found.items() if arm is not None}
    if not arrows:
        return None
    scale, is_written = scales_on(asked, sheet)
    values, turn = np.full(len(asked.true), complex(np.nan, np.nan)), sheet.measured.moved.p
    for k, arrow in arrows.items():
        arm = arrow.vector / turn * (1.0 if asked.on_paper else scale["l"])
        values[k] = arm * abs(asked.true[k]) / abs(arm) if asked.kind == BEARINGS and arm else arm
    return DrawnFigure(asked, values, arrows, is_written, free=True)


def arm_at(leaf: Leaf, plan: str, letter: str) -> tuple[complex, complex] | None:
    """Give the ends of the arm of the mass that bears a letter, in its figure or where that is lost anywhere."""
    group = group_named(leaf.groups, plan)
    strokes = leaf.groups if group is None else (group,)
    masses = [
        stroke.centre for stroke in flat(strokes) if isinstance(stroke, Circle) and stroke.style.fill not in HOLLOW
    ]
    places = [label.place for label in labels_of(strokes).get(letter, ())]
    near = [(off(spot, place), spot) for spot in masses for place in places]
    far, mass = min(near, key=lambda pair: pair[0], default=(NEAREST, 0j))
    if far >= NEAREST:
        return None
    lines = [stroke for stroke in flat(strokes) if isinstance(stroke, Line)]
    both = [ends for line in lines for ends in ((line.start, line.end), (line.end, line.start))]
    arms = [ends for ends in both if abs(ends[1] - mass) <= PLACED]
    return max(arms, key=lambda ends: abs(ends[1] - ends[0]), default=None)
