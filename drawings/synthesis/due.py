"""What must stand on the sheet of a task of synthesis, by closed forms alone (лист синтеза)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from drawings.checks.expected import NOTES, Cell, Expected, by_hand, cells
from drawings.lettering.words import with_index
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from drawings.synthesis.due_shown import NAME, shown
from plans.analytic.synthesis import analysed
from plans.model.synthesis.design import unit_of
from plans.quantity import Comparison, Quantity
from plans.quantity import by_hand as slipping
from plans.study import Study
from plans.synthesis.study import SynthesisStudy

VALUES = "values"
UNITS = {"m": (1e3, "mm"), "rad": (math.degrees(1.0), "°")}  # times which a quantity is told, in which
FAR = 1e-9  # of a place: both roads agree far better
TOLD = 6  # digits of a number of the notes


def told_in(name: str) -> tuple[float, str]:
    """Give how many times larger a size is told, and in which unit."""
    unit = unit_of(name)
    return UNITS.get(unit, (1.0, unit))


def rows(comparison: Comparison, drafting: Drafting) -> Iterator[tuple[str, Quantity]]:
    """Give the findings by the names of their rows, in the units that they are told in; no zeros."""
    for one in (one for one in comparison.findings if one.largest):
        times, unit = told_in(one.name)
        roads = times * one.construction, times * one.analysis
        row = f"{with_index(one.name)}, {drafting.word(unit)}" if unit else with_index(one.name)
        yield row, one._replace(construction=roads[0], analysis=roads[1], largest=times * one.largest)


def slips(comparison: Comparison, scales: Mapping[str, float]) -> dict[tuple[str, int], float]:
    """Give within what hands are of what is read off the first construction, by its scale."""
    read = [one for one in comparison.findings if "," not in one.name and "'" not in one.name]
    return {key: told_in(key[0])[0] * error for key, error in slipping(read, {NAME: scales[NAME]}).items()}


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a task."""
    comparison, drafting = study.comparison(NAME), drafting_of(study.scene)
    found = study.of(SynthesisStudy)
    yield from _figures(found)
    off = slips(comparison, {name: mu for leaf in leaves for name, mu in leaf.metadata["scales"].items()})
    for row, quantity in rows(comparison, drafting):
        error = off.get((quantity.name, 0))
        hand: Cell = None if error is None else by_hand(error, quantity.largest)
        value = float(quantity.analysis[0]), FAR
        yield from cells(VALUES, row, (value, value, hand), digits=TOLD)
    for name, number in found.task.asked.items():
        told = told_in(name)[0] * number
        yield Expected(Kind.PHRASE, NOTES, name, told, FAR * max(told, 1.0), digits=TOLD)


def _figures(found: SynthesisStudy) -> Iterator[Expected]:
    """Give the points, circles and barred arcs of each figure, from the designs of the analysis."""
    known = [reading for reading in analysed(found.task).readings if reading.found]
    for one, reading in zip(shown(found), known, strict=True):
        due = one._replace(design=reading.found[reading.best])
        off = FAR * next(iter(due.design.sizes.values()))
        # the pole is what the others are measured from
        spots = ((letter, spot) for letter, spot in due.places.items() if spot)
        yield from (Expected(Kind.POINT, one.name, letter, spot, off) for letter, spot in spots)
        yield from (
            Expected(Kind.CURVE, one.name, letter, curve, off) for letter, curve in (due.circles | due.barred).items()
        )
