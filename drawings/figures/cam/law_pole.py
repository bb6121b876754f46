"""The pole of a law's diagram with its rays to the mean ordinates of the strips (полюс и лучи)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.figures.cam.law_frame import LawPlate
from drawings.figures.cam.law_rows import LawRow
from drawings.figures.graphs.axes import Axes, chosen
from drawings.figures.graphs.part import LEFT, OVER, Letter, Part
from drawings.paper.strokes import Line, Stroke
from drawings.report.cam_letters import ACCELERATION
from drawings.symbols.dimension import Dimension
from drawings.symbols.symbols import pole
from geometry.strips import middles
from plans.model.motion import Floats

POLES = {True: ("P_1", "H_1"), False: ("P_2", "H_2")}  # of the acceleration; of the velocity
APART = 0.7  # sizes of a letter between the ends of two rays that are drawn
OFF = 1.2  # sizes of a letter from the highest ray to the dimension of the pole distance


def letters_of(row: LawRow) -> tuple[str, str]:
    """Give the letters of a row's pole and of its distance."""
    return POLES[row.key == ACCELERATION]


def pole_part(row: LawRow, plate: LawPlate, axes: Axes, distance: float) -> Part:
    """Draw the pole at its distance, mm, and rays to the mean ordinates that lie apart, each carried to the axis."""
    hand, (name, letter), means = plate.hand, letters_of(row), means_of(row, plate)
    at = axes.zero - distance
    size = Dimension(letter, at, axes.zero, _off(row, axes, OFF * hand.letter))
    rays = (line for k in rays_of(means, axes, plate) for line in _ray(k, means, at, axes, plate))
    base = Line(at, axes.zero, hand.drafted)
    marks = (Letter(at, name, hand.letter, LEFT), Letter(size.middle, letter, hand.letter, OVER))
    return Part(plate.named(f"{row.key}-pole"), (base, *rays, *size.draw(hand), pole(at)), marks)


def means_of(row: LawRow, plate: LawPlate) -> Floats:
    """Give the mean ordinates of the strips of a row."""
    return plate.shown.means if row.key == ACCELERATION else plate.shown.travel.means


def rays_of(means: Floats, axes: Axes, plate: LawPlate) -> tuple[int, ...]:
    """Choose the strips whose rays are drawn: those whose ends lie apart."""
    return chosen((means / axes.up.mu).tolist(), APART * plate.hand.letter)


def _off(row: LawRow, axes: Axes, size: float) -> complex:
    """Give the way from the axis to the dimension: above the highest ray, where the axis goes on."""
    return 1j * (size + row.span[1] / axes.up.mu)


def _ray(k: int, means: Floats, at: complex, axes: Axes, plate: LawPlate) -> Iterator[Stroke]:
    """Draw the ray of a strip, and its mean ordinate carried to the axis."""
    carried = axes.on(0.0, float(means[k]))
    yield Line(at, carried, plate.hand.drafted)
    if np.abs(carried - axes.zero) > 0:
        yield Line(carried, axes.on(float(middles(plate.shown.strips.edges)[k]), float(means[k])), plate.hand.drafted)
