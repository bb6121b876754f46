"""What the sheets of a scene ask for, to be graded: plans, curves, tables (задание листов)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from drawings.grading.asked import PlanAsked, plans_asked
from drawings.grading.cells.asked_table import TableAsked
from drawings.grading.cells.own_tables import tables_asked
from drawings.grading.curves.figure_records import FigureAsked, figures_asked
from drawings.redrawn.originals import Originals


class SheetTask(NamedTuple):
    """The plans, curves and tables that are asked for."""

    plans: Sequence[PlanAsked] = ()
    curves: Sequence[FigureAsked] = ()
    tables: Sequence[TableAsked] = ()

    @property
    def sheets(self) -> frozenset[str]:
        """The sheets that ask for something, by name."""
        drawn = (*(one.sheet for one in self.plans), *(one.sheet for one in self.curves))
        return frozenset((*drawn, *(name for table in self.tables for name in table.sheets)))


def sheet_task(originals: Originals) -> SheetTask:
    """Gather what a scene's own sheets ask for."""
    return SheetTask(plans_asked(originals), figures_asked(originals), tables_asked(originals))
