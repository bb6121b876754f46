"""What must stand on the sheet of a train whose teeth were sought: each solution's ratio and size (подбор зубьев)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from drawings.checks.expected import NOTES, Cell, Expected, cells
from drawings.paper.strokes import Kind
from plans.analytic.gears import TrainSpeeds
from plans.gears.study import GearsStudy
from plans.gears.synthesis import Solution, Wanted
from plans.model.gears import Train

SHOWN = 12  # solutions on the sheet
DIGITS, OFF = 5, 3
ROUNDED = 0.005  # per cent


def expected(study: GearsStudy) -> Iterator[Expected]:
    """Give the rows of solutions and the numbers of the notes: each ratio by the linear system of its train."""
    found = study.searched
    if found is None:
        return
    wanted = float(found.wanted.ratio)
    for k, one in enumerate(found.solutions[:SHOWN], 1):
        ratio, across = _found(study.train, one)
        off = 100 * (ratio - wanted) / abs(wanted)
        numbers: list[Cell] = [*map(abs, one.teeth.values()), one.planets, (ratio, 0.0), (off, ROUNDED), (across, 0.0)]
        yield from cells("solutions", str(k), numbers, digits=DIGITS)
        if k == 1:
            yield from _noted(found.wanted, off, across)


def _noted(wanted: Wanted, off: float, across: float) -> Iterator[Expected]:
    ratio, part = float(wanted.ratio), float(wanted.tolerance)
    numbers = {"wanted U": ratio, "tolerance": 100 * part, "D": across, "ΔU": off}
    numbers |= {"U lo": ratio - abs(ratio) * part, "U hi": ratio + abs(ratio) * part}
    for name, value in numbers.items():
        yield Expected(Kind.PHRASE, NOTES, name, value, digits={"ΔU": OFF, "tolerance": 4}.get(name, DIGITS))


def _found(train: Train, one: Solution) -> tuple[float, float]:
    """Give the ratio of a train with other teeth, and the diameter mm of the circle about its pitch circles."""
    wheels = {name: train.wheels[name]._replace(teeth=teeth) for name, teeth in one.teeth.items()}
    other = replace(train, wheels=wheels)
    ratio = TrainSpeeds(other).ratio(train.gears[0])
    assert ratio is not None  # it was sought by it
    planets = [name for name in wheels if wheels[name].link in train.carrier_of]
    a, b = next((wheels[a], wheels[b]) for a, b in train.meshes)
    far = a.module * abs(a.teeth + b.teeth) / 2
    return float(ratio), 2 * 1000 * float(far + max(wheels[name].radius for name in planets))
