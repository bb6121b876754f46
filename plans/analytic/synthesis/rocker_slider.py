"""A rocker-slider by closed forms: what its rod leans, what its stroke is to the rocker (theme 6, tasks 8 and 9)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from plans.model.synthesis.design import QUARTER, Design, TaskReading
from plans.model.synthesis.positions import TOUCH
from plans.model.synthesis.swings import STILL, RockerSliderTask


def readings(task: RockerSliderTask) -> tuple[TaskReading, ...]:
    """Give every rocker-slider of each reading of a task: an axial one's slider beyond the rocker's end, or before."""
    if task.angles is None:
        return (TaskReading(task.kept, tuple(symmetric(task))),)
    return tuple(TaskReading(one.kept, tuple(axial(one, sense))) for one in task.readings for sense in (1, -1))


def symmetric(task: RockerSliderTask) -> Iterator[Design]:
    """Give the rocker-slider whose rod leans alike to both sides: r (1 - cos half) = 2 l sin alpha."""
    assert task.ratio is not None and task.pressure is not None  # asked before
    half = 2 * math.asin(min(math.sqrt(math.sin(task.pressure) / task.ratio), 1.0))
    if half + task.pressure >= QUARTER - STILL:  # the slider turns back before the rocker does
        return
    rocker = task.stroke / (2 * math.sin(half))
    rod, offset = rocker / task.ratio, rocker * math.cos(half / 2) ** 2
    pivot, rise = complex(0, -rocker * math.cos(half)), complex(0, 2 * rod * math.sin(task.pressure))
    ends = complex(task.stroke / 2), complex(-task.stroke / 2)
    up, down = cmath.rect(rod, task.pressure), cmath.rect(rod, -task.pressure)
    places = {"C": pivot, "A": rise, "B": rise + down, "A_1": ends[0], "B_1": ends[0] + up}
    places |= {"A_2": ends[1], "B_2": ends[1] + up, "E": 0j, "G": complex(0, rise.imag / 2)}
    sizes = {"l_1": rocker, "l_2": rod, "e": offset, "ψ": 2 * half, "α_max": task.pressure, "H": task.stroke}
    yield Design(sizes, places)


def axial(task: RockerSliderTask, sense: int) -> Iterator[Design]:
    """Give the axial rocker-slider whose slider is to one side of the rocker's end."""
    assert task.angles is not None  # asked before
    upright = min(task.angles) < QUARTER < max(task.angles)
    high = 1.0 if upright else max(map(math.sin, task.angles))
    if task.ratio is None:
        assert task.pressure is not None  # asked before
        sine = math.sin(task.pressure)
        ratio = sine / high
    else:
        ratio, sine = task.ratio, task.ratio * high
    if (1 - sine) * (1 + sine) > TOUCH**2:
        yield from _laid(task, ratio, sine, sense)


def _laid(task: RockerSliderTask, ratio: float, sine: float, sense: int) -> Iterator[Design]:
    """Lay the rod to one side: the slider's way over the rocker, by differences of cosines that do not cancel."""
    assert task.angles is not None
    first, second = task.angles
    leans = [math.asin(ratio * math.sin(angle)) for angle in task.angles]
    way = _fall(first, second) + sense * _fall(*leans) / ratio
    if abs(way) < STILL:
        return
    rocker = task.stroke / abs(way)
    rod = rocker / ratio
    places = {"C": 0j}
    for k, (angle, lean) in enumerate(zip(task.angles, leans, strict=True), 1):
        end = cmath.rect(rocker, angle)
        places |= {f"A_{k}": end, f"B_{k}": complex(end.real + sense * rod * math.cos(lean))}
    swing = abs(second - first)
    yield Design({"l_1": rocker, "l_2": rod, "ψ": swing, "α_max": math.asin(sine), "H": task.stroke}, places)


def _fall(first: float, second: float) -> float:
    """Give cos first - cos second."""
    return 2 * math.sin((first + second) / 2) * math.sin((second - first) / 2)
