"""The self-check of a force sheet's table and title block: every row, in its unit (таблица, основная надпись)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks import reading
from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.wrong import Wrong
from drawings.lettering.words import word
from drawings.paper.strokes import Leaf
from plans.checks.comparison import Finding
from plans.checks.force_comparison import ForceComparison
from plans.words.words import message


def row_names(comparison: ForceComparison, floor: Floor) -> dict[str, Finding]:
    """Give the findings of forces by the letters of their rows."""
    found = {}
    for one in comparison.of("forces"):
        name, _, how = one.name.partition(" ")
        by = f" ({word(floor.language, f'by {how}')})" if how else ""
        found[f"{read(floor.letter(name))}{by}"] = one
    return found


def rows(leaves: Sequence[Leaf], comparison: ForceComparison, floor: Floor) -> Iterator[Wrong]:
    """Hold that the tables of one position have every row that is more than rounding, each with its unit."""
    named, told = row_names(comparison, floor), comparison.analysis
    nothing = dict(zip(("N", "N*m"), told.nothing_over, strict=True))
    heads = [row[0].plain for leaf in leaves for one in reading.value_tables(leaf) for row in reading.rows(one)]
    seen = dict(head.rsplit(", ", 1) for head in heads if ", " in head)
    for name, one in named.items():
        if name in seen and seen[name] != word(floor.language, one.unit):
            yield message("wrong.row_cell", text=seen[name], name=name)
        elif name not in seen and np.any(np.abs(told.counted(one.analysis)) > 2 * nothing[one.unit] + one.allowed):
            yield message("wrong.row_missing", name=name)
