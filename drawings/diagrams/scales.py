"""How the scales of the kinematic diagrams are found: of time, and by the pole distances (масштабы диаграмм)."""

import math
from collections.abc import Iterator
from itertools import pairwise

from drawings.diagrams.rows import NAME, DiagramRow, DiagramsFrame, DiagramsPlate
from drawings.kinds.working import SCALES, Workings, amount
from drawings.layout.picture import Spot
from drawings.page.page import Drafting
from plans.diagrams.study import DiagramsStudy


def working(diagrams: DiagramsStudy, drafting: Drafting) -> Workings:
    """Write beside the diagrams how the scale of time and the pole distances are found."""
    return Workings(SCALES, NAME, lambda spot: list(_lines(DiagramsPlate(diagrams, drafting), spot)), drafting)


def _lines(plate: DiagramsPlate, spot: Spot | None) -> Iterator[tuple[str, ...]]:
    frame = None if spot is None else DiagramsFrame(plate, spot)
    yield _time(plate, math.nan if spot is None else spot.scale.mu)
    for above, row in pairwise(plate.rows):
        if not row.flat:
            yield _pole(above, row, plate, frame)


def _time(plate: DiagramsPlate, mu: float) -> tuple[str, ...]:
    """Write the scale of time by that of the crank angle, rad/mm."""
    drafting, letter = plate.drafting, f"ω_{{{plate.diagrams.linkage.mechanism.drive.link}}}"
    omega, (s, mm) = amount(plate.omega, drafting), map(drafting.word, ("s", "mm"))
    if drafting.notation == "K":
        return (
            f"K_t = K_φ·{letter}",
            f"{amount(1 / mu, drafting)}·{omega}",
            f"{amount(plate.omega / mu, drafting)} {mm}/{s}",
        )
    return f"μ_t = μ_φ/{letter}", f"{amount(mu, drafting)}/{omega}", f"{amount(mu / plate.omega, drafting)} {s}/{mm}"


def _pole(above: DiagramRow, row: DiagramRow, plate: DiagramsPlate, frame: DiagramsFrame | None) -> tuple[str, ...]:
    """Write a pole distance by the scales of its row, of the row above it, and of time."""
    drafting, (high, low) = plate.drafting, (f"{{{number.letter}}}" for number in (above, row))
    first, second, time, distance = _working_numbers(above, row, frame)
    result = f"{plate.pole_letters(row)[1]} = ", f"{amount(distance, drafting)} {drafting.word('mm')}"
    if drafting.notation == "K":
        lower, over, other = (amount(1 / number, drafting) for number in (second, time, first))
        return f"{result[0]}K_{low}·K_t/K_{high}", f"{lower}·{over}/{other}", result[1]
    over, lower, other = (amount(number, drafting) for number in (first, second, time))
    return f"{result[0]}μ_{high}/(μ_{low}·μ_t)", f"{over}/({lower}·{other})", result[1]


def _working_numbers(
    above: DiagramRow, row: DiagramRow, frame: DiagramsFrame | None
) -> tuple[float, float, float, float]:
    """Give the scales of both rows and of time, and the distance, mm; NaN before it is known where they stand."""
    distance = None if frame is None else frame.distance(row)
    if frame is None or distance is None:
        return math.nan, math.nan, math.nan, math.nan
    return frame.scales[above.key].mu, frame.scales[row.key].mu, frame.argument.mu, distance
