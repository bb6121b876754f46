"""Slotted links, sine and tangent mechanisms by closed forms; no figure is drawn (M1.7).

With s and c the sine and cosine of half the overlap: of an oscillating link OA = s OC and H = 2 s CB, of a rotating one
OC = s OA and H = 2 CB.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from plans.analytic.synthesis.pace import paced
from plans.model.synthesis.design import Design, LocusCircle, TaskReading
from plans.model.synthesis.slots import (
    LEVER,
    TANGENT,
    WHITWORTH,
    LeverTask,
    SineTask,
    TangentTask,
    WhitworthTask,
    demands,
)


def readings(task: LeverTask | WhitworthTask | SineTask | TangentTask) -> Iterator[TaskReading]:
    """Give every mechanism of each reading of a task."""
    for one in task.readings:
        match one:
            case LeverTask():
                yield TaskReading(demands(one, LEVER), tuple(paced(made, one.pace) for made in _levers(one)))
            case WhitworthTask():
                yield TaskReading(demands(one, WHITWORTH), tuple(paced(made, one.pace) for made in _whitworths(one)))
            case SineTask():
                yield TaskReading(("stroke",), tuple(paced(made, one.pace) for made in _sines(one)))
            case TangentTask():
                yield TaskReading(demands(one, TANGENT), tuple(_tangents(one)))


class _Half(NamedTuple):
    """Half of an overlap angle by its sine and cosine."""

    sine: float
    cosine: float

    @classmethod
    def of(cls, overlap: float | None, part: float | None, whole: float | None) -> _Half | None:
        """Take it from the overlap rad, or as the ratio of two lengths; None where there is none."""
        if overlap is not None:
            return cls(math.sin(overlap / 2), math.cos(overlap / 2)) if overlap else None
        if part is None or whole is None or part >= whole:
            return None
        return cls(part / whole, math.sqrt((whole - part) * (whole + part)) / whole)

    @property
    def overlap(self) -> float:
        """The overlap angle rad."""
        return 2 * math.atan2(self.sine, self.cosine)

    @property
    def rise(self) -> float:
        """One less the cosine, without cancelling."""
        return self.sine**2 / (1 + self.cosine)

    @property
    def ratio(self) -> float:
        """The coefficient of mean speeds K."""
        return (math.pi + self.overlap) / (math.pi - self.overlap)


def _levers(task: LeverTask) -> Iterator[Design]:
    """Give the oscillating slotted link that meets one reading of a task, if there is one."""
    half = _Half.of(task.overlap, task.crank, task.frame)
    if half is None and task.overlap is None and (task.crank is None or task.frame is None):
        half = _Half.of(None, None if task.stroke is None else task.stroke / 2, task.lever)
    if half is None:
        return
    crank = task.crank if task.crank is not None else half.sine * (task.frame or 0.0)
    frame = task.frame if task.frame is not None else crank / half.sine
    way = complex(half.sine, half.cosine)  # from C to A1
    sizes = {"l_1": crank, "l_0": frame}
    places = {"C": 0j, "O": complex(0, frame), "A_1": frame * half.cosine * way}
    places["A_2"] = -places["A_1"].conjugate()
    if task.driven:
        lever = task.lever if task.lever is not None else (task.stroke or 0.0) / 2 / half.sine
        sizes["l_3"] = lever
        places |= {"B_1": lever * way, "B_2": -lever * way.conjugate()}
        if task.pressure is not None:
            if half.sine >= math.cos(task.pressure):
                return
            rod = sizes["l_4"] = lever * half.rise / 2 / math.sin(task.pressure)
            places |= _ram(rod, task.pressure, complex(0, lever), lever * way, -lever * way.conjugate(), -1)
        sizes["H"] = 2 * lever * half.sine
    circles = {"O": LocusCircle(places["O"], crank)}
    if task.overlap is None and task.crank is not None and task.frame is not None:
        places["T"] = complex(0, frame / 2)  # the middle of OC
        circles["T"] = LocusCircle(places["T"], frame / 2)
    yield _design(sizes, places, circles, half, task)


def _ram(rod: float, pressure: float, steep: complex, first: complex, second: complex, ends: int) -> dict[str, complex]:
    """Give the ram's places: the rod falls from B at the pressure angle; from both ends it rises so, or is level."""
    lean = cmath.rect(rod, pressure)
    end = lean if ends else complex(rod)
    return {"B": steep, "D": steep + lean.conjugate(), "D_1": first + end, "D_2": second + end}


def _whitworths(task: WhitworthTask) -> Iterator[Design]:
    """Give the rotating slotted link that meets one reading of a task, if there is one."""
    half = _Half.of(task.overlap, task.frame, task.crank)
    if half is None:
        return
    frame = task.frame if task.frame is not None else half.sine * (task.crank or 0.0)
    crank = task.crank if task.crank is not None else frame / half.sine
    pivot, pin = complex(0, -frame), crank * half.cosine
    sizes = {"l_1": crank, "l_0": frame}
    places = {"O": 0j, "C": pivot, "A_1": pivot + pin, "A_2": pivot - pin}
    if task.stroke is not None:
        lever = sizes["l_3"] = task.stroke / 2
        places |= {"B_1": pivot + lever, "B_2": pivot - lever}
        if task.pressure is not None:
            rod = sizes["l_4"] = lever / math.sin(task.pressure)
            places |= _ram(rod, task.pressure, pivot + 1j * lever, pivot + lever, pivot - lever, 0)
        sizes["H"] = task.stroke
    yield _design(sizes, places, {"O": LocusCircle(0j, crank)}, half, task)


def _design(
    sizes: dict[str, float],
    places: dict[str, complex],
    circles: dict[str, LocusCircle],
    half: _Half,
    task: LeverTask | WhitworthTask,
) -> Design:
    """Put the angles beside the lengths, and how fast the crank turns."""
    angles = {"θ": half.overlap, "ψ": half.overlap} if isinstance(task, LeverTask) else {"θ": half.overlap}
    pressure = {} if task.pressure is None else {"α_max": task.pressure}
    return Design({**sizes, **angles, "K": half.ratio, **pressure}, places, circles)


def _sines(task: SineTask) -> Iterator[Design]:
    """Give the sine mechanism of a stroke; it is shown with its crank at 60 degrees too."""
    crank = task.stroke / 2
    pin = complex(crank / 2, crank * math.sqrt(0.75))
    places = {"O": 0j, "A_1": complex(crank), "A_2": complex(-crank), "A": pin, "B": complex(crank / 2)}
    yield Design({"l_1": crank, "H": task.stroke}, places, {"O": LocusCircle(0j, crank)})


def _tangents(task: TangentTask) -> Iterator[Design]:
    """Give the tangent mechanism that meets one reading of a task: half of H, or the whole, is h tan α."""
    if task.pressure is None:
        assert task.stroke is not None and task.distance is not None  # two of three are kept
        stroke, distance = task.stroke, task.distance
        pressure = math.atan2(stroke * task.share, distance)
    else:
        pressure = task.pressure
        distance = task.distance or (task.stroke or 0.0) * task.share / math.tan(pressure)
        stroke = task.stroke or distance * math.tan(pressure) / task.share
    places = {"E": 0j, "O": complex(-distance), "A_1": complex(0, stroke * task.share)}
    if not task.one_sided:
        places["A_2"] = complex(0, -stroke / 2)
    yield Design({"h": distance, "H": stroke, "α_max": pressure}, places)
