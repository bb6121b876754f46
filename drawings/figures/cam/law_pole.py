"""The pole of a law's diagram with its rays to the mean ordinates of the strips (полюс и лучи)."""

from __future__ import annotations

from drawings.figures.cam.law_frame import LawPlate, LawRow
from drawings.figures.graphs.axes import Axes
from drawings.figures.graphs.part import Part
from drawings.figures.graphs.pole import Pole
from drawings.report.cam_letters import ACCELERATION
from geometry.strips import middles

POLES = {True: ("P_1", "H_1"), False: ("P_2", "H_2")}  # of the acceleration; of the velocity
APART = 0.7  # sizes of a letter between the ends of two rays that are drawn
OFF = 1.2  # sizes of a letter from the highest ray to the dimension of the pole distance


def letters_of(row: LawRow) -> tuple[str, str]:
    """Give the letters of a row's pole and of its distance."""
    return POLES[row.key == ACCELERATION]


def pole_part(row: LawRow, plate: LawPlate, axes: Axes, distance: float) -> Part:
    """Draw the pole at its distance, mm, and rays to the mean ordinates that lie apart, each carried to its strip."""
    size, shown = plate.hand.letter, plate.shown
    means = shown.means if row.key == ACCELERATION else shown.travel.means
    off = 1j * (OFF * size + row.span[1] / axes.up.mu)  # above the highest ray, where the axis goes on
    own = Pole(letters_of(row), distance, middles(shown.strips.edges), means, APART * size, off)
    return own.part(plate.named(f"{row.key}-pole"), axes, plate.hand)
