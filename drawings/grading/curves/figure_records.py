"""The techniques whose curves are graded, and what the record of each tells of them (записи графиков)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Final, NamedTuple

import numpy as np

from drawings.checks.written import written_scales
from drawings.grading.curves.asked_figure import FigureAsked, Item, Paper, Sizes, Values
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredPoint, MeasuredVector
from drawings.original.originals import Originals
from drawings.paper.strokes import Leaf, Line
from drawings.paper.walk import flat, group_named
from plans.techniques import named, technique_of

FLUSH = 0.05  # mm: a foot that is nearer to an axis stands on it; a sheet is written to a hundredth of that


class OwnSheet(NamedTuple):
    """A sheet of the scene as it is seen: its name, its strokes, its marks."""

    name: str
    leaf: Leaf
    measured: Measured

    def marks(self, plan: str) -> tuple[MeasuredVector | MeasuredPoint, ...]:
        """Give the marks of a plan."""
        return tuple(one for one in self.measured.marks if one.plan == plan)

    def vectors(self, plan: str) -> dict[int, MeasuredVector]:
        """Give the ordinates of a graph by their positions."""
        return {one.position: one for one in self.measured.vectors if one.plan == plan and one.position is not None}

    def scales(self, plan: str, *figures: str) -> dict[str, float]:
        """Give the scales that are written over a figure, by their letters."""
        groups = (group_named(self.leaf.groups, name) for name in (*figures, plan))
        return {letter: mu for group in groups if group is not None for letter, mu in written_scales(group).items()}

    def letter(self, plan: str, mu: float) -> str:
        """Give the letter that a scale of a figure is written with."""
        found = (letter for letter, own in self.scales(plan).items() if abs(own - mu) <= WRITTEN * mu)
        return next(found, "")

    def paper(self, plan: str, abscissas: Sizes, places: Mapping[int, int] | None = None) -> Paper | None:
        """Give where a graph lies, whose places are at some abscissas; None where two ordinates do not tell it.

        The places of its marks are their positions, or what `places` says of these.
        """
        own = {k if places is None else places[k]: one for k, one in self.vectors(plan).items()}
        if len(own) < 2:
            return None
        (first, one), (last, other) = min(own.items()), max(own.items())
        step = (other.start - one.start) / (abscissas[last] - abscissas[first])
        return self.over(plan, np.asarray(one.start + step * (abscissas - abscissas[first])), abscissas)

    def over(self, plan: str, feet: Values, abscissas: Sizes) -> Paper | None:
        """Give where a graph lies whose ordinates have some feet; None where they stand on no line of it."""
        axis = self._axis(plan, feet)
        return None if axis is None else Paper(axis, feet, abscissas)

    def ruled(self, plan: str, feet: Values) -> Paper | None:
        """Give where bars lie that begin at some places: the longest line of their figure is their axis."""
        group = group_named(self.leaf.groups, plan)
        lines = [one for one in flat((group,)) if isinstance(one, Line)] if group is not None else []
        longest = max(lines, key=lambda one: abs(one.end - one.start), default=None)
        return None if longest is None else Paper((longest.start, longest.end), feet, np.zeros(len(feet)))

    def _axis(self, plan: str, feet: Values) -> tuple[complex, complex] | None:
        """Give the longest line that all feet of a graph stand on."""
        group = group_named(self.leaf.groups, plan)
        lines = [one for one in flat((group,)) if isinstance(one, Line)] if group is not None else []
        own = [one for one in lines if one.start != one.end and _through(one, feet)]
        longest = max(own, key=lambda one: abs(one.end - one.start), default=None)
        return None if longest is None else (longest.start, longest.end)


WRITTEN = 1e-3  # of a scale: three digits are written at the least


def _through(line: Line, feet: Values) -> bool:
    along = (line.end - line.start) / abs(line.end - line.start)
    return bool((np.abs(((feet - line.start) / along).imag) <= FLUSH).all())


def items(marks: Mapping[int, MeasuredVector | MeasuredPoint]) -> tuple[Item, ...]:
    """Name the values of a graph by the letter of its quantity and the numbers of their places."""
    return tuple(Item(one.name, k, k, f"{one.quantity}_{one.name}") for k, one in sorted(marks.items()))


# By technique: of a study and our own sheet to the figures of that sheet, in the order in which they are drawn.
FIGURES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "dynamics": "drawings.grading.curves.dynamics_figures:figures_of",
        "bank": "drawings.grading.curves.arm_figures:figures_of",
        "forces": "drawings.grading.curves.load_figures:figures_of",
        "linkage": "drawings.grading.curves.diagram_figures:figures_of",
        "cyclogram": "drawings.grading.curves.cyclogram_figures:figures_of",
        "cam": "drawings.grading.curves.cam_figures:figures_of",
    }
)


def figures_asked(originals: Originals, kinds: Mapping[str, str] = FIGURES) -> tuple[FigureAsked, ...]:
    """Give the curves that the sheets of a scene ask for."""
    return tuple(one for sheet in originals.sheets for one in _of_sheet(originals, sheet.name, kinds))


def _of_sheet(originals: Originals, name: str, kinds: Mapping[str, str]) -> Sequence[FigureAsked]:
    sheet = next(one for one in originals.sheets if one.name == name)
    row = kinds.get(technique_of(sheet.kind))
    if row is None:
        return ()
    seen = originals.seen(sheet)
    return tuple(named(row)(originals.study, OwnSheet(sheet.name, seen.leaf, seen.measured)))
