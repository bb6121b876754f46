"""What must stand on the sheet of a task of synthesis, by closed forms alone (лист синтеза)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.expected import NOTES, Cell, Expected, by_hand, cells, course, measured
from drawings.lettering.words import Phrase, Slot, joined, with_index
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from drawings.synthesis.due_shown import NAME, ShownSynthesis, shown
from plans.analytic.synthesis import analysed, region_of
from plans.model.synthesis.design import unit_of
from plans.quantity import Comparison, Quantity
from plans.quantity import by_hand as slipping
from plans.study import Study
from plans.synthesis.quantities import FIRST, apart
from plans.synthesis.study import SynthesisStudy

VALUES, BEST = "values", "O_0"
UNITS = {"m": (1e3, "mm"), "rad": (math.degrees(1.0), "°")}  # times which a quantity is told, in which
NEAR = 1e-6  # of a curve: as its best place is known
FAR = 1e-9  # of a place: both roads agree far better
TOLD, DIGITS = 6, 4  # digits of a number of the notes, of a dimension
TURNED = 1e-3  # rad: the resolution of the paper over an arrow


def region_name(letter: str) -> str:
    """Name the graph of a size over the place of O."""
    return f"region-{letter}"


def told_in(name: str) -> tuple[float, str]:
    """Give how many times larger a size is told, and in which unit."""
    unit = unit_of(name)
    return UNITS.get(unit, (1.0, unit))


def told(name: str, value: float, drafting: Drafting, digits: int = TOLD) -> Phrase:
    """Tell a size with its letter and unit in the notes."""
    unit = told_in(name)[1]
    after = "" if not unit or unit == "°" else f" {drafting.word(unit)}"
    return joined("", (dimensioned(name, value, drafting, digits), after))


def dimensioned(name: str, value: float, drafting: Drafting, digits: int = DIGITS) -> Phrase:
    """Tell a size with its letter beside a dimension: there mm have no unit."""
    times, unit = told_in(name)
    number = drafting.slot(Slot(name, times * value, digits))
    return joined("", (f"{with_index(name)} = ", number, "°" if unit == "°" else ""))


def rows(comparison: Comparison, drafting: Drafting) -> dict[str, dict[str, Quantity]]:
    """Give the findings by the names of their rows and by their mechanisms, in the units that they are told in."""
    found: dict[str, dict[str, Quantity]] = {}
    for one in (one for one in comparison.findings if one.largest):  # no zeros
        (letter, mechanism), (times, unit) = apart(one.name), told_in(one.name)
        roads = times * one.construction, times * one.analysis
        row = f"{with_index(letter)}, {drafting.word(unit)}" if unit else with_index(letter)
        told = one._replace(construction=roads[0], analysis=roads[1], largest=times * one.largest)
        found.setdefault(row, {})[mechanism] = told
    return found


def others(comparison: Comparison) -> list[str]:
    """Letter the mechanisms beside the first: each has a column in the table."""
    return [one for one in dict.fromkeys(apart(one.name)[1] for one in comparison.findings) if one != FIRST]


def slips(comparison: Comparison, scales: Mapping[str, float]) -> dict[tuple[str, int], float]:
    """Give within what hands are of what is read off the first construction, by its scale."""
    read = [one for one in comparison.findings if apart(one.name)[1] == FIRST]
    return {key: told_in(key[0])[0] * error for key, error in slipping(read, {NAME: scales[NAME]}).items()}


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a task."""
    comparison, drafting = study.comparison(NAME), drafting_of(study.scene)
    found = study.of(SynthesisStudy)
    yield from _figures(found)
    off = slips(comparison, {name: mu for leaf in leaves for name, mu in leaf.metadata["scales"].items()})
    for row, quantities in rows(comparison, drafting).items():
        first, *beside = (quantities.get(one) for one in (FIRST, *others(comparison)))
        error = None if first is None else off.get((first.name, 0))
        hand: Cell = None if first is None or error is None else by_hand(error, first.largest)
        known: list[Cell] = [None if one is None else (float(one.analysis[0]), FAR) for one in (first, first, *beside)]
        yield from cells(VALUES, row, (*known, hand), digits=TOLD)
    yield from _region(found)
    for name, number in found.task.asked.items():
        told = told_in(name)[0] * number
        yield Expected(Kind.PHRASE, NOTES, name, told, FAR * max(told, 1.0), digits=TOLD)


def _figures(found: SynthesisStudy) -> Iterator[Expected]:
    """Give the points, circles and barred arcs of each figure, from the designs of the analysis."""
    known = [reading for reading in analysed(found.task).readings if reading.found]
    for one, reading in zip(shown(found), known, strict=True):
        due = one._replace(design=reading.found[reading.best]).based
        off = FAR * next(iter(due.design.sizes.values()))
        # the pole is what the others are measured from
        spots = ((letter, spot) for letter, spot in due.places.items() if spot)
        yield from (Expected(Kind.POINT, one.name, letter, spot, off) for letter, spot in spots)
        yield from _sizes(due)
        yield from (
            Expected(Kind.CURVE, one.name, letter, curve, off)
            for letter, curve in (due.circles | due.barred | {**due.design.curves}).items()
        )


def _sizes(due: ShownSynthesis) -> Iterator[Expected]:
    """Give the dimensions with their numbers."""
    kinds = ((Kind.LENGTH, due.lengths), (Kind.ANGLE, due.angles))
    for kind, letter in ((kind, letter) for kind, rows in kinds for letter, *_ in rows):
        size, times = due.design.sizes[letter], told_in(letter)[0]
        row = Expected(kind, due.name, letter, size, FAR * size + (TURNED if kind == Kind.ANGLE else 0.0))
        yield from measured(row, times * size, digits=DIGITS, unit=times)


def _region(found: SynthesisStudy) -> Iterator[Expected]:
    """Give the curves over the place of O, and the ordinates of O and of the best place."""
    region = region_of(found.task, analysed(found.task).chosen)
    if region is None:
        return
    x, marks = np.degrees(region.places), {"O": region.chosen, BEST: region.best[0]}
    for letter, curve in region.curves.items():
        name, values = region_name(letter), told_in(letter)[0] * curve
        most = float(np.abs(values).max())
        yield Expected(Kind.CURVE, name, letter, course(x, values), NEAR * most, ends=(float(x[0]), float(x[-1])))
        for mark, place in marks.items():
            value = float(np.interp(place, region.places, values))
            yield Expected(Kind.VECTOR, name, mark, 1j * value, NEAR * most, may_lack=mark == BEST)
