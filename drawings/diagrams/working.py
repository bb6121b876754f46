"""How the scales and poles of the kinematic diagrams belong together: H_1 = μ_S/(μ_v·μ_t) with numbers (масштабы)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from drawings.diagrams.frame import NAME, DiagramRow, DiagramsFrame, DiagramsPlate
from drawings.diagrams.rows import letters_of
from drawings.kinds.working import SCALES, Working, told
from drawings.layout.picture import Spot
from drawings.page.drafting import Drafting
from plans.diagrams.study import DiagramsStudy


def working(own: DiagramsStudy, drafting: Drafting) -> Working:
    """Write beside the diagrams how the scale of time and the pole distances are found."""
    return Working(SCALES, NAME, lambda spot: list(_lines(DiagramsPlate(own, drafting), spot)), drafting)


def _lines(plate: DiagramsPlate, spot: Spot | None) -> Iterator[tuple[str, ...]]:
    frame = None if spot is None else DiagramsFrame(plate, spot)
    yield _time(plate, math.nan if spot is None else spot.scale.mu)
    for above, row in pairwise(plate.rows):
        if not row.flat:
            yield _pole(above, row, plate, frame)


def _time(plate: DiagramsPlate, mu: float) -> tuple[str, ...]:
    """Write the scale of time by that of the crank angle, rad/mm."""
    drafting, letter = plate.drafting, f"ω_{{{plate.own.linkage.mechanism.drive.link}}}"
    omega, (s, mm) = told(plate.omega, drafting), map(drafting.word, ("s", "mm"))
    if drafting.notation == "K":
        return (
            f"K_t = K_φ·{letter}",
            f"{told(1 / mu, drafting)}·{omega}",
            f"{told(plate.omega / mu, drafting)} {mm}/{s}",
        )
    return f"μ_t = μ_φ/{letter}", f"{told(mu, drafting)}/{omega}", f"{told(mu / plate.omega, drafting)} {s}/{mm}"


def _pole(above: DiagramRow, row: DiagramRow, plate: DiagramsPlate, frame: DiagramsFrame | None) -> tuple[str, ...]:
    """Write a pole distance by the scales of its row, of the row above it, and of time."""
    drafting, (high, low) = plate.drafting, (f"{{{one.letter}}}" for one in (above, row))
    first, second, time, distance = _numbers(above, row, frame)
    result = f"{letters_of(row)[1]} = ", f"{told(distance, drafting)} {drafting.word('mm')}"
    if drafting.notation == "K":
        own, over, other = (told(1 / one, drafting) for one in (second, time, first))
        return f"{result[0]}K_{low}·K_t/K_{high}", f"{own}·{over}/{other}", result[1]
    over, own, other = (told(one, drafting) for one in (first, second, time))
    return f"{result[0]}μ_{high}/(μ_{low}·μ_t)", f"{over}/({own}·{other})", result[1]


def _numbers(above: DiagramRow, row: DiagramRow, frame: DiagramsFrame | None) -> tuple[float, float, float, float]:
    """Give the scales of both rows and of time, and the distance, mm; NaN before it is known where they stand."""
    distance = None if frame is None else frame.distance(row)
    if frame is None or distance is None:
        return math.nan, math.nan, math.nan, math.nan
    return frame.scales[above.key].mu, frame.scales[row.key].mu, frame.argument.mu, distance
