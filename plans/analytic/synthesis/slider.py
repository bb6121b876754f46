"""Slider-cranks by closed forms: the quadratic of a stroke (M1.6)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from plans.analytic.synthesis.pace import paced
from plans.analytic.synthesis.rocker import extremes, largest
from plans.model.synthesis.design import QUARTER, BarredArc, Design, LocusCircle, TaskReading
from plans.model.synthesis.extremes import SliderTask
from plans.model.synthesis.region import Region, stations


class SliderLengths(NamedTuple):
    """A slider-crank: crank, rod and offset m."""

    crank: float
    rod: float
    offset: float

    @property
    def ratio(self) -> float:
        """The ratio l2/l1."""
        return self.rod / self.crank

    @property
    def pressures(self) -> tuple[float, float]:
        """The least and the largest signed pressure angle, rad (угол давления)."""
        return math.asin((self.offset - self.crank) / self.rod), math.asin((self.offset + self.crank) / self.rod)


def readings(task: SliderTask) -> Iterator[TaskReading]:
    """Give every slider-crank of each reading of a task."""
    for one in task.readings:
        yield TaskReading(one.demands, tuple(paced(_design(one, made), one.pace) for made in sliders(one)))


def _design(task: SliderTask, made: SliderLengths) -> Design:
    half, foot = task.stroke / 2, 2 * made.crank * made.rod / task.stroke
    least, most = made.pressures
    sizes = {"l_1": made.crank, "l_2": made.rod, "e": made.offset, "H": task.stroke}
    theta = math.atan2(made.offset, foot - half) - math.atan2(made.offset, foot + half)
    sizes |= {"θ": theta, "λ": made.ratio, "α_max": most, "α_min": least}
    if task.turned is not None:
        sizes["γ"] = task.turned
    if task.similar:  # a similar mechanism is drawn, from O
        steep, away = complex(0, -made.crank), complex(0, made.offset)
        ends = complex(foot + half) + away, complex(foot - half) + away
        led = {"E": away, "A": steep, "B": steep + cmath.rect(made.rod, most)}
        return Design(sizes, extremes(0j, made.crank, *ends) | led)
    places = {"E": 0j, **extremes(complex(-foot, -made.offset), made.crank, complex(half), complex(-half))}
    places |= {"F": complex(-foot)} if made.offset else {}
    circles, barred = dict[str, LocusCircle](), tuple[BarredArc, ...]()
    if task.overlap:
        theta = task.overlap
        circles["M"] = LocusCircle(complex(0, -half / math.tan(theta)), half / math.sin(theta))
        barred = (BarredArc("M", QUARTER - theta, 2 * theta), BarredArc("M", -QUARTER - theta, 2 * theta))
    if task.ratio is not None:
        middle, radius = (half * (task.ratio + sign / task.ratio) / 2 for sign in (1, -1))
        circles["N"] = LocusCircle(complex(-middle), radius)
        places |= {"D_1": complex(radius - middle), "D_2": complex(-radius - middle)}
    return Design(sizes, places | {name: one.centre for name, one in circles.items()}, circles, barred)


def sliders(task: SliderTask) -> Iterator[SliderLengths]:
    """Give every slider-crank that meets one reading of a task, that with the longer rod first."""
    stroke, offset, theta, ratio = task.stroke, task.offset, task.overlap, task.ratio
    if task.pressure is not None:
        yield from _pressed(task)
    elif not offset and not theta:
        if ratio is not None and (offset is None or theta is None):
            yield SliderLengths(stroke / 2, ratio * stroke / 2, 0.0)
    elif ratio is None:
        if offset and theta:
            yield from _seen(stroke, offset, theta)
        elif task.turned is not None and theta:
            yield turned_on(task, task.turned)
    elif theta is None and offset:
        yield from _proportioned(stroke, offset, ratio)
    elif offset is None and theta:
        yield from _overlapped(stroke, theta, ratio)


def _seen(stroke: float, offset: float, theta: float) -> Iterator[SliderLengths]:
    """Meet stroke, offset and overlap by the product and the sum of squares of OB1 and OB2."""
    product = stroke * offset / math.sin(theta)
    crank = math.sqrt(max(stroke**2 - 4 * product * math.sin(theta / 2) ** 2, 0.0)) / 2
    rod = math.sqrt(stroke**2 + 4 * product * math.cos(theta / 2) ** 2) / 2
    if 4 * crank * rod > stroke**2:
        yield SliderLengths(crank, rod, offset)


def _proportioned(stroke: float, offset: float, ratio: float) -> Iterator[SliderLengths]:
    """Meet stroke, offset and ratio by the quadratic of l1^2; each root beyond the foot is a mechanism."""
    square = (ratio**2 - 1) ** 2 - (4 * ratio * offset / stroke) ** 2
    if square < 0:
        return
    larger = (ratio**2 + 1 + math.sqrt(square)) * stroke**2 / (8 * ratio**2)
    smaller = (offset**2 + stroke**2 / 4) * stroke**2 / (4 * ratio**2) / larger
    for one in (larger, smaller) if square else (larger,):
        if 4 * ratio * one > stroke**2:
            yield SliderLengths(math.sqrt(one), ratio * math.sqrt(one), offset)


def _overlapped(stroke: float, theta: float, ratio: float) -> Iterator[SliderLengths]:
    """Meet stroke, overlap and ratio: with a ratio known the mechanism is a figure of known shape."""
    if math.cos(theta) > (ratio - 1) / (ratio + 1):
        crank = stroke / 2 / math.sqrt(1 + (ratio**2 - 1) * math.sin(theta / 2) ** 2)
        yield SliderLengths(crank, ratio * crank, (ratio**2 - 1) * crank**2 * math.sin(theta) / stroke)


def _pressed(task: SliderTask) -> Iterator[SliderLengths]:
    """Meet stroke and pressure angle, the offset none or such that a ratio is met too."""
    assert task.pressure is not None  # asked before
    sine = math.sin(task.pressure)
    if task.ratio is None:
        if not task.offset and not task.overlap:
            yield SliderLengths(task.stroke / 2, task.stroke / 2 / sine, 0.0)
        else:
            yield from _leaning(task, sine)
        return
    if task.ratio * sine >= 1:
        offset = task.ratio * sine - 1  # of a crank of length 1
        far, near = ((task.ratio + one - offset) * (task.ratio + one + offset) for one in (1, -1))
        crank = task.stroke * (math.sqrt(far) + math.sqrt(near)) / (far - near)
        yield SliderLengths(crank, task.ratio * crank, offset * crank)


def _leaning(task: SliderTask, sine: float) -> Iterator[SliderLengths]:
    """Meet a pressure angle beside an overlap or an offset by roots: that with the longer crank first."""
    if task.overlap:
        end = math.pi - 2 * task.overlap
        top, most = largest(lambda turned: _led(turned_on(task, turned)) if turned else 0.0, 0.0, end)
        asked = QUARTER - (task.pressure or 0.0)
        made = [
            turned_on(task, root(lambda turned: _led(turned_on(task, turned)) - asked if turned else -asked, side, top))
            for side in (0.0, end)
            if most > asked
        ]
        yield from sorted(made, reverse=True)
    elif offset := task.offset:

        def off(far: float) -> float:
            """Give far (1 - sine) + 2 e - near (1 + sine): nothing where the rod leans as is asked."""
            near = math.hypot(far, offset)
            return near * (1 + sine) - math.hypot(far + task.stroke, offset) * (1 - sine) - 2 * offset

        far = root(off, 0.0, (task.stroke + offset) * 1e4)
        near, long = math.hypot(far, offset), math.hypot(far + task.stroke, offset)
        yield SliderLengths((long - near) / 2, (long + near) / 2, offset)


def root(value: Callable[[float], float], low: float, high: float) -> float:
    """Give where a value that is less than 0 at the first end, and not at the other, is 0, by halving."""
    while (middle := (low + high) / 2) not in (low, high):
        low, high = (middle, high) if value(middle) < 0 else (low, middle)
    return high


def turned_on(task: SliderTask, turned: float) -> SliderLengths:
    """Give the slider-crank whose O is an angle rad from B2 on its circle: chords by their sines."""
    theta = task.overlap or 0.0
    near, far = (task.stroke * math.sin(angle) / math.sin(theta) for angle in (turned / 2, turned / 2 + theta))
    return SliderLengths((far - near) / 2, (far + near) / 2, near * far * math.sin(theta) / task.stroke)


def region(task: SliderTask, design: Design) -> Region | None:
    """Give the sizes over the place of O on the circle, where it is free."""
    if task.turned is None or task.overlap is None:
        return None
    end = math.pi - 2 * task.overlap
    places = stations(end)
    made = [turned_on(task, turned) for turned in places.tolist()]
    rows = {
        "μ_min": [_led(one) for one in made],
        "λ": [one.ratio for one in made],
        "ε": [one.offset / task.stroke for one in made],
    }
    best = largest(lambda turned: _led(turned_on(task, turned)) if turned else 0.0, 0.0, end)
    curves = {name: np.array(row) for name, row in rows.items()}
    return Region(places, curves, end, math.pi - task.overlap, best, design.sizes["γ"])


def _led(made: SliderLengths) -> float:
    """Give the least transmission angle rad, by the half angle of the right triangle where the rod leans most."""
    rise, rod = made.offset + made.crank, made.rod
    return 2 * math.atan2(math.sqrt(max(rod - rise, 0.0)), math.sqrt(rod + rise))
