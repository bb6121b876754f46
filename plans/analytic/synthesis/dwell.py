"""A dwell from the arc of a coupler's curve, by closed loops: the circle, the rocker that rests, how it deviates."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from typing import Final

import numpy as np

from plans.analytic.synthesis.guided import centres
from plans.analytic.synthesis.rocker import largest
from plans.model.synthesis.design import Design, LocusCircle, TaskReading
from plans.model.synthesis.positions import PATH, TIED, TOUCH, DwellTask

SAMPLES: Final = 720


def readings(task: DwellTask) -> tuple[TaskReading, ...]:
    """Give the dwell linkages of a four-bar, the rocker's pivot to either side of the rod."""
    return (TaskReading(("dwell", "output"), tuple(_dwells(task))),)


def crank(task: DwellTask, angle: float) -> tuple[complex, complex, complex]:
    """Give A, B and K at a crank angle rad, O being 0 and C on the right: the coupler's angle by the cosine rule."""
    l1, l2, l3, l4 = task.lengths
    pin = cmath.rect(l1, angle)
    line = l4 - pin
    reach = abs(line)
    cosine = (l2**2 + reach**2 - l3**2) / (2 * l2 * reach)
    way = cmath.phase(line) + (-1 if task.crossed else 1) * math.acos(cosine)
    return pin, pin + cmath.rect(l2, way), pin + cmath.rect(task.arm, way + task.lean)


def turns(task: DwellTask) -> bool:
    """Tell whether the crank goes round: at both places on the line OC the other links reach, and not just."""
    l1, l2, l3, l4 = task.lengths
    cosines = ((l2**2 + l3**2 - (l4 + sense * l1) ** 2) / (2 * l2 * l3) for sense in (1, -1))
    return all((1 - cosine) * (1 + cosine) > TOUCH**2 for cosine in cosines)


def _dwells(task: DwellTask) -> Iterator[Design]:
    if not turns(task):
        return
    poses = [crank(task, angle) for angle in task.stations]
    path = np.array([crank(task, math.tau * k / (PATH - 1))[2] for k in range(PATH)])
    for centre in centres([poses[k][2] for k in (0, 2, 4)], None):
        radius = abs(poses[2][2] - centre)
        deviation = _most(_missing(task, centre, radius), *task.dwell)
        for side in (1, -1):
            if spread := _spread(task, centre, radius, side):
                pivot, swing, off = spread
                places = {"O": 0j, "C": complex(task.lengths[3]), "D": centre, "F": pivot}
                for k, (pin, end, point) in enumerate(poses, 1):
                    places |= {f"A_{k}": pin, f"B_{k}": end, f"K_{k}": point}
                sizes = dict(zip(("l_1", "l_2", "l_3", "l_4"), task.lengths, strict=True))
                sizes |= {"l_5": radius, "l_6": task.output, "ψ": swing, "ψ_d": off, "h": deviation}
                yield Design(sizes, places, {"D": LocusCircle(centre, radius)}, (), round(swing, TIED), {"K": path})


def _missing(task: DwellTask, centre: complex, radius: float) -> Callable[[float], float]:
    """Give how far K is off a circle at a crank angle, m."""
    return lambda angle: abs(abs(crank(task, angle)[2] - centre) - radius)


def _spread(task: DwellTask, centre: complex, radius: float, side: int) -> tuple[complex, float, float] | None:
    """Give the pivot of the rocker that rests, its swing and how far it leaves its rest, rad; None: it cannot follow.

    In its rest it is square to the rod KD, so that the force of the rod leads it best.
    """
    middle = crank(task, task.stations[2])[2]
    pivot = centre + side * 1j * task.output * (middle - centre) / abs(middle - centre)
    rest = cmath.phase(centre - pivot)

    def turned(angle: float) -> float:
        way = crank(task, angle)[2] - pivot
        cosine = (task.output**2 + abs(way) ** 2 - radius**2) / (2 * task.output * abs(way))
        if abs(cosine) >= 1:
            return math.nan
        return math.remainder(cmath.phase(way) - side * math.acos(cosine) - rest, math.tau)

    least, most = -_most(lambda angle: -turned(angle), 0.0, math.tau), _most(turned, 0.0, math.tau)
    if math.isnan(least + most) or most - least >= math.pi:
        return None
    return pivot, most - least, _most(lambda angle: abs(turned(angle)), *task.dwell)


def _most(value: Callable[[float], float], begin: float, end: float) -> float:
    """Give the largest value; NaN where one is not a number."""
    if any(math.isnan(value(begin + (end - begin) * k / SAMPLES)) for k in range(SAMPLES + 1)):
        return math.nan
    return largest(value, begin, end, SAMPLES)[1]
