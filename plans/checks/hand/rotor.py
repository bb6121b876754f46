"""What the polygons of a rotor drawn by hand may be out in, vector by vector (многоугольники ротора от руки)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from geometry.hand_error import SlippingHand, slopes
from geometry.span import Span
from plans.checks.hand.quantity import MOST_SIDES, SLIP, Slipping, Told, errors_by_hand
from plans.rotor.balancing import COUPLES, UNBALANCES
from plans.rotor.letters import unbalance_letters
from plans.rotor.study import RotorStudy


def rotor_by_hand(
    rotor: RotorStudy, scales: Mapping[str, float], by: Slipping = slopes
) -> dict[tuple[str, int], float]:
    """Give what a hand may be out in the polygons that a sheet shows, by the names of the findings.

    `scales` are those of the figures, kg*m2 or kg*m a mm: "couples", "unbalances". Static moments and arms are known;
    what no figure shows, such as the reactions of bearings, is not drawn and has no error.
    """
    rows = {plan: np.array([scales[plan]]) for plan in (COUPLES, UNBALANCES) if plan in scales}
    read = {name: told for plan, name, told in _read(rotor) if plan in rows}
    found = errors_by_hand(read, SlippingHand(SLIP, rows), by)
    return {(name, 0): float(error[0]) for name, error in found.items()}


def _read(rotor: RotorStudy) -> Iterator[tuple[str, str, Told]]:
    """Give which polygon shows what: its closing vector, and of forces where the last of the masses ends."""
    drawing, planes = rotor.drawing, rotor.rotor.planes
    moments, forces = drawing.moments, drawing.forces
    if max(len(moments.sides), len(forces.sides)) > MOST_SIDES:
        return
    if rotor.rotor.dynamic:
        yield COUPLES, "ΣmDh", moments.closing
        yield COUPLES, unbalance_letters(planes[0].name), drawing.corrections[0].mark
    given = {one.mark for one in drawing.masses}
    ends = [side.end for side in forces.sides if side.vector in given]
    if ends:
        yield UNBALANCES, "ΣmD", Span(forces.board["0"], ends[-1])
    yield UNBALANCES, unbalance_letters(planes[-1].name), forces.closing
