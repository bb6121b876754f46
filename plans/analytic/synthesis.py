"""Synthesis by closed forms: the inscribed angle, the quadratic of a stroke; no figure is drawn (M1.5, M1.6).

With R = c / sin theta, c half of the chord, and gamma the angle at M from the middle of the chord's lesser arc to O:
l1 = 2 R cos(gamma/2) sin(theta/2), l2 = 2 R sin(gamma/2) cos(theta/2).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from typing import Final

from plans.model.synthesis import (
    ANALYSIS,
    QUARTER,
    CrankRocker,
    Reading,
    RockerTask,
    SliderCrank,
    SliderTask,
    Synthesis,
    circle,
    end_of_arc,
    readings_of,
    start_of_arc,
)


def analysed(task: RockerTask | SliderTask) -> Synthesis:
    """Solve a task by closed forms; the free parameter of a crank-rocker is given."""
    return rocker_synthesis(task) if isinstance(task, RockerTask) else slider_synthesis(task)


def rocker_synthesis(task: RockerTask) -> Synthesis:
    """Give every crank-rocker that meets a task whose free parameter is given."""
    found = _framed(task) if task.frame is not None else _placed(task)
    return Synthesis(ANALYSIS, (Reading(("rocker", "swing", "overlap"), tuple(found)),))


def _placed(task: RockerTask) -> Iterator[CrankRocker]:
    assert task.place is not None  # asked before
    for side in task.sides:
        if made := at_place(task, side, task.place):
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
    return made_of(task, crank, coupler, frame, pivot)


def _versed(place: float, middle: float) -> float:
    """Give |m| (1 ± sin place) without cancelling near where it vanishes."""
    away = place - math.copysign(QUARTER, -middle)  # from the direction of C at M
    return 2 * abs(middle) * math.sin(away / 2) ** 2


def admissible(task: RockerTask, pivot: complex) -> bool:
    """Tell whether O is outside the lines CB1, CB2 produced: inside them B1 and B2 are of two assemblies."""
    return abs(pivot.real) > abs(pivot.imag) * math.tan(task.swing / 2) and abs(pivot.real) > 0


def made_of(task: RockerTask, crank: float, coupler: float, frame: float, pivot: complex) -> CrankRocker:
    """Give a crank-rocker with its least transmission angle."""
    lengths = crank, coupler, task.rocker, frame
    return CrankRocker(*lengths, pivot, transmission(*lengths))


def transmission(crank: float, coupler: float, rocker: float, frame: float) -> float:
    """Give the least transmission angle rad: that with the crank on the line of the frame, by half angles."""
    folded, stretched = (_angle(coupler, rocker, frame + sign * crank) for sign in (-1, 1))
    return min(folded, math.pi - stretched)


def _angle(one: float, other: float, opposite: float) -> float:
    """Give the angle of a triangle between two of its sides, rad."""
    half = (one + other + opposite) / 2
    return 2 * math.atan2(
        math.sqrt(max((half - one) * (half - other), 0.0)), math.sqrt(max(half * (half - opposite), 0.0))
    )


def _framed(task: RockerTask) -> Iterator[CrankRocker]:
    """Give the crank-rockers with a frame, left of the axis: the others are their mirror images."""
    assert task.frame is not None  # asked before
    if not task.overlap:
        along = math.sqrt(max(task.frame**2 - task.height**2, 0.0))
        if along > task.half:
            yield made_of(task, task.half, along, task.frame, complex(-along, task.height))
        return
    for side in task.sides:
        radius, middle = circle(task, side)
        sine = (task.frame**2 - radius**2 - middle**2) / (2 * radius * middle) if middle else math.inf
        if abs(sine) < 1 and (made := at_place(task, side, math.pi - math.asin(sine))):
            yield made


def slider_synthesis(task: SliderTask) -> Synthesis:
    """Give every slider-crank of each reading of a task."""
    return Synthesis(ANALYSIS, tuple(Reading(one.demands, tuple(sliders(one))) for one in readings_of(task)))


def sliders(task: SliderTask) -> Iterator[SliderCrank]:
    """Give every slider-crank that meets one reading of a task, that with the longer rod first."""
    stroke, offset, theta, ratio = task.stroke, task.offset, task.overlap, task.ratio
    if task.pressure is not None:
        yield from _pressed(task)
    elif not offset and not theta:
        if ratio is not None and (offset is None or theta is None):
            yield SliderCrank(stroke / 2, ratio * stroke / 2, 0.0)
    elif ratio is None:
        if offset and theta:
            yield from _seen(stroke, offset, theta)
    elif theta is None and offset:
        yield from _proportioned(stroke, offset, ratio)
    elif offset is None and theta:
        yield from _overlapped(stroke, theta, ratio)


def _seen(stroke: float, offset: float, theta: float) -> Iterator[SliderCrank]:
    """Meet stroke, offset and overlap by the product and the sum of squares of OB1 and OB2."""
    product = stroke * offset / math.sin(theta)
    crank = math.sqrt(max(stroke**2 - 4 * product * math.sin(theta / 2) ** 2, 0.0)) / 2
    rod = math.sqrt(stroke**2 + 4 * product * math.cos(theta / 2) ** 2) / 2
    if 4 * crank * rod > stroke**2:
        yield SliderCrank(crank, rod, offset)


def _proportioned(stroke: float, offset: float, ratio: float) -> Iterator[SliderCrank]:
    """Meet stroke, offset and ratio by the quadratic of l1^2; each root beyond the foot is a mechanism."""
    square = (ratio**2 - 1) ** 2 - (4 * ratio * offset / stroke) ** 2
    if square < 0:
        return
    larger = (ratio**2 + 1 + math.sqrt(square)) * stroke**2 / (8 * ratio**2)
    smaller = (offset**2 + stroke**2 / 4) * stroke**2 / (4 * ratio**2) / larger
    for one in (larger, smaller) if square else (larger,):
        if 4 * ratio * one > stroke**2:
            yield SliderCrank(math.sqrt(one), ratio * math.sqrt(one), offset)


def _overlapped(stroke: float, theta: float, ratio: float) -> Iterator[SliderCrank]:
    """Meet stroke, overlap and ratio: with a ratio known the mechanism is a figure of known shape."""
    if math.cos(theta) > (ratio - 1) / (ratio + 1):
        crank = stroke / 2 / math.sqrt(1 + (ratio**2 - 1) * math.sin(theta / 2) ** 2)
        yield SliderCrank(crank, ratio * crank, (ratio**2 - 1) * crank**2 * math.sin(theta) / stroke)


def _pressed(task: SliderTask) -> Iterator[SliderCrank]:
    """Meet stroke and pressure angle, the offset none or such that a ratio is met too."""
    assert task.pressure is not None  # asked before
    sine = math.sin(task.pressure)
    if task.ratio is None:
        if not task.offset and not task.overlap:
            yield SliderCrank(task.stroke / 2, task.stroke / 2 / sine, 0.0)
        return
    if task.ratio * sine >= 1:
        offset = task.ratio * sine - 1  # of a crank of length 1
        far, near = ((task.ratio + one - offset) * (task.ratio + one + offset) for one in (1, -1))
        crank = task.stroke * (math.sqrt(far) + math.sqrt(near)) / (far - near)
        yield SliderCrank(crank, task.ratio * crank, offset * crank)


def best(task: RockerTask, side: int) -> float:
    """Give the largest least transmission angle rad on an arc, by the golden section about the best of many places."""
    end = end_of_arc(task, side)
    if end is None:
        return -math.inf
    start = start_of_arc(task, side)
    step = (end - start) / SAMPLES

    def value(place: float) -> float:
        made = at_place(task, side, place)
        return -math.inf if made is None else made.transmission

    k = max(range(SAMPLES + 1), key=lambda k: value(start + k * step))
    return _golden(value, start + max(k - 1, 0) * step, start + min(k + 1, SAMPLES) * step)


SAMPLES: Final = 240
GOLDEN: Final = (math.sqrt(5) - 1) / 2
SECTIONS: Final = 60  # each leaves 0.62 of the one before: below a rounding of the first


def _golden(value: Callable[[float], float], least: float, most: float) -> float:
    for _ in range(SECTIONS):
        low, high = most - GOLDEN * (most - least), least + GOLDEN * (most - least)
        least, most = (least, high) if value(low) > value(high) else (low, most)
    return value((least + most) / 2)
