"""Loops, diagrams of sizes and profiles without marks: a line that a student drew in its place on our form (линия)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.eye.sheet import SeenSheet
from drawings.grading.curves.asked_figure import FigureAsked, Values
from drawings.grading.curves.drawn_curve import chains, foot
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.curves.form.form_axes import AXES, FRAME, axes, every_axes, written_at
from drawings.grading.drawn_plan import Arrow
from drawings.paper.strokes import Circle, Group, Line
from drawings.paper.walk import flat, groups


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
    own = next((one for one in groups(seen.leaf.groups) if _is(one, "place", asked.plan)), None)
    pole = next((one for one in groups(seen.leaf.groups) if _is(one, "pole", asked.plan)), None)
    if own is None or pole is None:
        return None
    centre = next((one.centre for one in flat((pole,)) if isinstance(one, Circle)), None)
    corners = np.array([end for one in flat((own,)) if isinstance(one, Line) for end in (one.start, one.end)])
    if centre is None or not corners.size:
        return None
    low, high = complex(corners.real.min(), corners.imag.min()), complex(corners.real.max(), corners.imag.max())
    inside = (
        one
        for one in _drawn(seen)
        if low.real <= one.real.mean() <= high.real and low.imag <= one.imag.mean() <= high.imag
    )
    return Place(centre, {letter: float(own.data["scale"]) for letter in asked.scales}, tuple(inside))


def _is(group: Group, kind: str, plan: str) -> bool:
    return group.data.get("kind") == kind and group.data.get("plan") == plan


def _drawn(seen: SeenSheet) -> Iterator[Values]:
    """Give the curves that are no part of the form's own figures."""
    return chains([one for one in seen.leaf.groups if one.data.get("kind") != AXES and one.name != FRAME])
