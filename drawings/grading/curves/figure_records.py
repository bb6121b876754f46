"""The techniques whose curves are graded, and what the record of each tells of them (записи графиков)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Final

from drawings.grading.curves.asked_figure import FigureAsked
from drawings.grading.curves.own_sheet import OwnSheet
from drawings.original.originals import Originals
from plans.techniques import named, technique_of

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
