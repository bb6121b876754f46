"""What must stand on the sheet of a task of synthesis, by closed forms alone (лист синтеза)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.expected import NOTES, Cell, Expected, by_hand, cells
from drawings.lettering.words import with_index
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.analytic.synthesis import analysed
from plans.model.motion import Complexes
from plans.model.synthesis import (
    CENTRES,
    CrankRocker,
    RockerTask,
    SliderCrank,
    SliderTask,
    circle,
    readings_of,
    start_of_arc,
)
from plans.quantity import Comparison, Quantity
from plans.quantity import by_hand as slipping
from plans.study import Study
from plans.synthesis.study import SynthesisStudy

NAME, VALUES = "synthesis", "values"
POINTS = 181  # of a circle
UNITS = {"m": (1e3, "mm"), "rad": (math.degrees(1.0), "°")}  # times which a quantity is told, in which
FAR = 1e-9  # of a place: both roads agree far better
TOLD = 6  # digits of a number of the notes


def rows(comparison: Comparison, drafting: Drafting) -> Iterator[tuple[str, Quantity]]:
    """Give the findings by the names of their rows, in the units that they are told in; no zeros."""
    for one in (one for one in comparison.findings if one.largest):
        times, unit = UNITS[one.unit]
        roads = times * one.construction, times * one.analysis
        row = f"{with_index(one.name)}, {drafting.word(unit)}"
        yield row, one._replace(construction=roads[0], analysis=roads[1], largest=times * one.largest)


def slips(comparison: Comparison, scales: Mapping[str, float]) -> dict[tuple[str, int], float]:
    """Give within what hands are of what is read off the first construction, by its scale."""
    units = {one.name: UNITS[one.unit][0] for one in comparison.findings}
    read = [one for one in comparison.findings if "," not in one.name and "'" not in one.name]
    return {key: units[key[0]] * error for key, error in slipping(read, {NAME: scales[NAME]}).items()}


def noted(task: RockerTask | SliderTask) -> dict[str, float]:
    """Give the numbers of the notes, by the names of their quantities: mm, degrees."""
    angles: dict[str, float | None]
    lengths: dict[str, float | None]
    if isinstance(task, RockerTask):
        angles, lengths = {"ψ": task.swing, "θ": task.overlap}, {"l_3": task.rocker, "l_4": task.frame}
    else:
        angles, lengths = {"θ": task.overlap, "α_max": task.pressure}, {"H": task.stroke, "e": task.offset}
    found = {name: 1e3 * one for name, one in lengths.items() if one is not None}
    found |= {name: math.degrees(one) for name, one in angles.items() if one is not None}
    return found | ({"λ": task.ratio} if isinstance(task, SliderTask) and task.ratio is not None else {})


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a task."""
    comparison, drafting = study.comparison(NAME), drafting_of(study.scene)
    task = study.of(SynthesisStudy).task
    yield from _figures(task)
    off = slips(comparison, {name: mu for leaf in leaves for name, mu in leaf.metadata["scales"].items()})
    for row, quantity in rows(comparison, drafting):
        error = off.get((quantity.name, 0))
        hand: Cell = None if error is None else by_hand(error, quantity.largest)
        value = float(quantity.analysis[0]), FAR
        yield from cells(VALUES, row, (value, value, hand), digits=TOLD)
    for name, number in noted(task).items():
        yield Expected(Kind.PHRASE, NOTES, name, number, FAR * max(number, 1.0), digits=TOLD)


def _figures(task: RockerTask | SliderTask) -> Iterator[Expected]:
    """Give the points and circles of each figure."""
    if isinstance(task, RockerTask):
        found = [*_sides(task)]
    else:
        pairs = zip(readings_of(task), analysed(task).readings, strict=True)
        found = [_slider(one, reading.found[0]) for one, reading in pairs if reading.found]
    for k, (points, circles, size) in enumerate(found, 1):
        name = NAME if k == 1 else f"{NAME}-{k}"
        # the pole is what the others are measured from
        spots = ((letter, spot) for letter, spot in points.items() if spot)
        yield from (Expected(Kind.POINT, name, letter, spot, FAR * size) for letter, spot in spots)
        yield from (Expected(Kind.CURVE, name, letter, curve, FAR * size) for letter, curve in circles.items())


Shown = tuple[dict[str, complex], dict[str, Complexes], float]


def _sides(task: RockerTask) -> Iterator[Shown]:
    """Give the figure of each circle that gives a mechanism."""
    for side in task.sides if task.overlap else (1,):
        found = analysed(task._replace(side=side)).readings[0].found
        rockers = [one for one in found if isinstance(one, CrankRocker)]
        if rockers:
            yield _rocker(task, side, max(rockers, key=lambda one: one.transmission))


def _rocker(task: RockerTask, side: int, made: CrankRocker) -> Shown:
    ends = complex(task.half, task.height), complex(-task.half, task.height)
    points = {"C": 0j, **_mechanism(made, made.pivot, *ends)}
    if not task.overlap:
        return points, {}, made.frame
    radius, middle = circle(task, side)
    sweep = side * (math.tau - 2 * task.overlap)
    points[CENTRES[side]] = complex(0, middle)
    return points, {"seen": _arc(complex(0, middle), radius, start_of_arc(task, side), sweep)}, made.frame


def _arc(centre: complex, radius: float, start: float, sweep: float) -> Complexes:
    ways = np.exp(1j * np.linspace(start, start + sweep, POINTS))
    return np.asarray(centre + radius * ways)


def _mechanism(made: CrankRocker | SliderCrank, pivot: complex, first: complex, second: complex) -> dict[str, complex]:
    crank = [made.crank * cmath.exp(1j * cmath.phase(end - pivot)) for end in (first, second)]
    return {"O": pivot, "B_1": first, "B_2": second, "A_1": pivot + crank[0], "A_2": pivot - crank[1]}


def _slider(task: SliderTask, made: CrankRocker | SliderCrank) -> Shown:
    assert isinstance(made, SliderCrank)  # of such a task
    half, foot = task.stroke / 2, 2 * made.crank * made.rod / task.stroke
    pivot, shift = complex(-foot, -made.offset), 0j
    points, circles = dict[str, complex]() if task.pressure else {"E": 0j}, dict[str, Complexes]()
    if task.pressure is not None:
        shift = -pivot
        steep = complex(0, -made.crank)
        points |= {"A": steep, "B": steep + cmath.rect(made.rod, made.pressures[1])}
    elif task.overlap:
        points["M"] = complex(0, -half / math.tan(task.overlap))
        start = math.pi / 2 + task.overlap
        circles["seen"] = _arc(points["M"], half / math.sin(task.overlap), start, math.tau - 2 * task.overlap)
    if task.ratio is not None and task.pressure is None:
        centre, radius = -half * (task.ratio + 1 / task.ratio) / 2, half * (task.ratio - 1 / task.ratio) / 2
        points |= {"N": complex(centre), "D_1": complex(centre + radius), "D_2": complex(centre - radius)}
        circles["ratio"] = _arc(complex(centre), radius, 0.0, math.tau)
    ends = complex(half) + shift, complex(-half) + shift
    return points | _mechanism(made, pivot + shift, *ends), circles, made.rod
