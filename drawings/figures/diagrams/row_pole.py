"""The pole of a diagram with its rays along the chords of the one above it (полюс и лучи)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.figures.diagrams.frame import DiagramsPlate
from drawings.figures.diagrams.rows import VELOCITY, DiagramRow
from drawings.figures.graphs.axes import Axes, chosen
from drawings.figures.graphs.part import LEFT, OVER, Letter, Part
from drawings.paper.strokes import Line, Stroke
from drawings.symbols.dimension import Dimension
from drawings.symbols.symbols import pole

POLES = {True: ("P_1", "H_1"), False: ("P_2", "H_2")}  # of the velocity; of the acceleration
APART = 0.7  # sizes of a letter between the ends of two rays that are drawn
OFF = 1.2  # sizes of a letter from the highest ray to the dimension of the pole distance


def letters_of(row: DiagramRow) -> tuple[str, str]:
    """Give the letters of a row's pole and of its distance."""
    return POLES[row.key == VELOCITY]


def pole_part(row: DiagramRow, plate: DiagramsPlate, axes: Axes, distance: float) -> Part:
    """Draw the pole at its distance, mm, and rays along the chords, each carried to where its value belongs."""
    hand, (name, letter) = plate.hand, letters_of(row)
    at = axes.zero - distance
    size = Dimension(letter, at, axes.zero, 1j * (OFF * hand.letter + row.span[1] / axes.up.mu))
    rays = (line for k in rays_of(row, plate, axes) for line in _ray(k, row, at, axes, plate))
    base = Line(at, axes.zero, hand.drafted)
    marks = (Letter(at, name, hand.letter, LEFT), Letter(size.middle, letter, hand.letter, OVER))
    return Part(plate.named(f"{row.key}-pole"), (base, *rays, *size.draw(hand), pole(at)), marks)


def rays_of(row: DiagramRow, plate: DiagramsPlate, axes: Axes) -> tuple[int, ...]:
    """Choose the values whose rays are drawn: those whose ends lie apart."""
    return chosen((row.chords.y / axes.up.mu).tolist(), APART * plate.hand.letter)


def _ray(k: int, row: DiagramRow, at: complex, axes: Axes, plate: DiagramsPlate) -> Iterator[Stroke]:
    """Draw the ray of a chord, and what it cuts off carried from the axis to where it belongs."""
    cut = axes.on(0.0, float(row.chords.y[k]))
    yield Line(at, cut, plate.hand.drafted)
    if abs(cut - axes.zero) > 0:
        yield Line(cut, axes.on(float(row.chords.x[k]), float(row.chords.y[k])), plate.hand.drafted)
