"""The pole of a diagram with its rays along the chords of the one above it (полюс и лучи)."""

from __future__ import annotations

from drawings.figures.diagrams.frame import VELOCITY, DiagramRow, DiagramsPlate
from drawings.figures.graphs.axes import Axes
from drawings.figures.graphs.part import Part
from drawings.figures.graphs.pole import Pole

POLES = {True: ("P_1", "H_1"), False: ("P_2", "H_2")}  # of the velocity; of the acceleration
APART = 0.7  # sizes of a letter between the ends of two rays that are drawn
OFF = 1.2  # sizes of a letter from the highest ray to the dimension of the pole distance


def letters_of(row: DiagramRow) -> tuple[str, str]:
    """Give the letters of a row's pole and of its distance."""
    return POLES[row.key == VELOCITY]


def pole_part(row: DiagramRow, plate: DiagramsPlate, axes: Axes, distance: float) -> Part:
    """Draw the pole at its distance, mm, and rays along the chords, each carried to where its value belongs."""
    size = plate.hand.letter
    off = 1j * (OFF * size + row.span[1] / axes.up.mu)
    own = Pole(letters_of(row), distance, row.chords.x, row.chords.y, APART * size, off)
    return own.part(plate.named(f"{row.key}-pole"), axes, plate.hand)
