"""Crank-rockers by closed forms: the inscribed angle, the cosine rule (M1.5).

With R = c / sin theta, c half of the chord, and gamma the angle at M from the middle of the chord's lesser arc to O:
l1 = 2 R cos(gamma/2) sin(theta/2), l2 = 2 R sin(gamma/2) cos(theta/2).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from typing import Final, NamedTuple

import numpy as np

from plans.model.synthesis.design import QUARTER, BarredArc, Design, LocusCircle, TaskReading
from plans.model.synthesis.extremes import CENTRES, RockerTask
from plans.model.synthesis.region import Region, stations


def readings(task: RockerTask) -> Iterator[TaskReading]:
    """Give every crank-rocker of each circle; the free parameter is given."""
    for side in task.sides:
        one = task._replace(side=side)
        yield TaskReading(("rocker", "swing", "overlap"), tuple(_design(one, made) for made in _made(one)))


class CrankRocker(NamedTuple):
    """The lengths of a crank-rocker m, and where its pivot O is from C."""

    crank: float
    coupler: float
    rocker: float
    frame: float
    pivot: complex

    @property
    def transmission(self) -> float:
        """The least transmission angle rad: that with the crank on the line of the frame, by half angles."""
        folded, stretched = (_angle(self.coupler, self.rocker, self.frame + sign * self.crank) for sign in (-1, 1))
        return min(folded, math.pi - stretched)


def _design(task: RockerTask, made: CrankRocker) -> Design:
    ends = complex(task.half, task.height), complex(-task.half, task.height)
    sizes = {"l_1": made.crank, "l_2": made.coupler, "l_3": made.rocker, "l_4": made.frame}
    sizes |= {"ψ": task.swing, "θ": task.overlap, "μ_min": made.transmission}
    places = {"C": 0j, **extremes(made.pivot, made.crank, *ends)}
    return Design(sizes, places, merit=made.transmission) if not task.overlap else _seen(task, sizes, places)


def _seen(task: RockerTask, sizes: dict[str, float], places: dict[str, complex]) -> Design:
    """Add the circle that sees the chord, and its arcs that admit no O: beyond the chord, and between CB1 and CB2."""
    side = task.side or 1
    (radius, middle), name, end = circle(task, side), CENTRES[side], end_of_arc(task, side)
    assert end is not None  # a mechanism is on the arc
    centre = complex(0, middle)
    left = centre + cmath.rect(radius, end)
    ends = (left, complex(-left.real, left.imag))  # CB1, produced through C, is left of it
    line = dict(zip(("K_1", "K_2") if left.imag < 0 else ("K_2", "K_1"), ends, strict=True))
    sizes["γ"] = side * (cmath.phase(places["O"] - centre) - start_of_arc(task, side)) % math.tau
    start = end if side > 0 else math.pi - end
    between = BarredArc(name, start, side * (math.pi - 2 * end) % math.tau)
    barred = (between, BarredArc(name, side * QUARTER - task.overlap, 2 * task.overlap))
    return Design(sizes, {**places, name: centre, **line}, {name: LocusCircle(centre, radius)}, barred, sizes["μ_min"])


def extremes(pivot: complex, crank: float, first: complex, second: complex) -> dict[str, complex]:
    """Give the places of crank and coupler, in one line with the ends of the coupler in its extreme places."""
    one, other = (crank * (end - pivot) / abs(end - pivot) for end in (first, second))
    return {"O": pivot, "A_1": pivot + one, "B_1": first, "A_2": pivot - other, "B_2": second}


def circle(task: RockerTask, side: int) -> tuple[float, float]:
    """Give the radius of a circle that sees the chord under theta, and its centre on the axis of C, m."""
    return task.half / math.sin(task.overlap), task.height - side * task.half / math.tan(task.overlap)


def start_of_arc(task: RockerTask, side: int) -> float:
    """Give the angle rad at M of B2, where the arc begins."""
    return (side * QUARTER + side * task.overlap) % math.tau


def end_of_arc(task: RockerTask, side: int) -> float | None:
    """Give the angle rad at M where the admissible arc left of the axis ends, which begins at B2; None: none of it is.

    There the circle meets one of the lines CB1, CB2, at a distance from C by the power of C.
    """
    radius, middle = circle(task, side)
    if side < 0 and task.swing / 2 + task.overlap >= QUARTER:
        return None
    reach = (middle**2 - radius**2) / task.rocker  # along CB2, or back along CB1
    end = cmath.rect(reach, QUARTER + math.copysign(task.swing / 2, reach))
    return cmath.phase(end - complex(0, middle)) % math.tau


def _made(task: RockerTask) -> Iterator[CrankRocker]:
    if task.place is None:
        yield from _framed(task)
    elif made := at_place(task, task.side or 1, task.place):
        yield made


def at_place(task: RockerTask, side: int, place: float) -> CrankRocker | None:
    """Give the crank-rocker whose O is at an angle rad of a circle; None where its arc admits none."""
    theta, radius, middle = task.overlap, *circle(task, side)
    gamma = (place - side * QUARTER) % math.tau
    pivot = complex(0, middle) + cmath.rect(radius, place)
    if not theta < gamma < math.tau - theta or not admissible(task, pivot):
        return None
    crank = 2 * radius * abs(math.cos(gamma / 2)) * math.sin(theta / 2)
    coupler = 2 * radius * math.sin(gamma / 2) * math.cos(theta / 2)
    frame = math.sqrt((radius - abs(middle)) ** 2 + 2 * radius * _versed(place, middle))
    return CrankRocker(crank, coupler, task.rocker, frame, pivot)


def _versed(place: float, middle: float) -> float:
    """Give |m| (1 ± sin place) without cancelling near where it vanishes."""
    away = place - math.copysign(QUARTER, -middle)  # from the direction of C at M
    return 2 * abs(middle) * math.sin(away / 2) ** 2


def admissible(task: RockerTask, pivot: complex) -> bool:
    """Tell whether O is outside the lines CB1, CB2 produced: inside them B1 and B2 are of two assemblies."""
    return abs(pivot.real) > abs(pivot.imag) * math.tan(task.swing / 2) and abs(pivot.real) > 0


def _angle(one: float, other: float, opposite: float) -> float:
    """Give the angle of a triangle between two of its sides, rad."""
    half = (one + other + opposite) / 2
    return 2 * math.atan2(
        math.sqrt(max((half - one) * (half - other), 0.0)), math.sqrt(max(half * (half - opposite), 0.0))
    )


def _framed(task: RockerTask) -> Iterator[CrankRocker]:
    """Give the crank-rockers with a frame, left of the axis: the others are their mirror images."""
    assert task.frame is not None and task.side is not None  # asked before
    if not task.overlap:
        along = math.sqrt(max(task.frame**2 - task.height**2, 0.0))
        if along > task.half:
            yield CrankRocker(task.half, along, task.rocker, task.frame, complex(-along, task.height))
        return
    radius, middle = circle(task, task.side)
    sine = (task.frame**2 - radius**2 - middle**2) / (2 * radius * middle) if middle else math.inf
    if abs(sine) < 1 and (made := at_place(task, task.side, math.pi - math.asin(sine))):
        yield made


def region(task: RockerTask, design: Design) -> Region | None:
    """Give the sizes over the place of O on the circle that a mechanism is on."""
    side = next((side for side, name in CENTRES.items() if name in design.circles), 0)
    end = end_of_arc(task, side) if side else None
    if end is None:
        return None
    start = start_of_arc(task, side)
    away = abs(end - start)
    places = stations(away)
    made = [one for turned in places.tolist() if (one := at_place(task, side, start + side * turned))]
    rows = {
        "μ_min": [one.transmission for one in made],
        "L": [max(one[:4]) / one.rocker for one in made],
        "Δ": [(sum(one[:4]) - 2 * min(one[:4]) - 2 * max(one[:4])) / one.rocker for one in made],
    }
    place, value = best(task, side)
    curves = {name: np.array(row) for name, row in rows.items()}
    return Region(places, curves, away, math.pi - task.overlap, (side * (place - start), value), design.sizes["γ"])


def best(task: RockerTask, side: int) -> tuple[float, float]:
    """Give the place and the value rad of the largest least transmission angle on an arc."""
    end = end_of_arc(task, side)
    if end is None:
        return math.nan, -math.inf

    def value(place: float) -> float:
        made = at_place(task, side, place)
        return -math.inf if made is None else made.transmission

    return largest(value, start_of_arc(task, side), end)


SAMPLES: Final = 240
GOLDEN: Final = (math.sqrt(5) - 1) / 2
SECTIONS: Final = 60  # each leaves 0.62 of the one before: below a rounding of the first


def largest(value: Callable[[float], float], start: float, end: float, samples: int = SAMPLES) -> tuple[float, float]:
    """Give where a value is largest, and that value, by the golden section about the best of many places."""
    step = (end - start) / samples
    k = max(range(samples + 1), key=lambda k: value(start + k * step))
    least, most = start + max(k - 1, 0) * step, start + min(k + 1, samples) * step
    for _ in range(SECTIONS):
        low, high = most - GOLDEN * (most - least), least + GOLDEN * (most - least)
        least, most = (least, high) if value(low) > value(high) else (low, most)
    return (least + most) / 2, value((least + most) / 2)
