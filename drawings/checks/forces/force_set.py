"""The self-check of the force sheets of one position together: no figure, row or note is missing (полнота листов)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks.forces.balancing_graph import PLAN as BALANCING
from drawings.checks.forces.force_notes_told import ForceNotes, notes_of
from drawings.checks.forces.force_rows import rows
from drawings.checks.forces.lever_forces import PLAN as LEVER
from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.wrong import Wrong
from drawings.paper.strokes import Leaf
from plans.checks.force_bill import ForceBill
from plans.checks.force_comparison import ForceComparison
from plans.forces.statics import Statics
from plans.words.words import message


class ForceSet(NamedTuple):
    """The sheets of one position, by the bills of its groups."""

    statics: Statics
    comparison: ForceComparison
    bills: Mapping[tuple[int, ...], ForceBill]
    floor: Floor
    position: int

    def faults(self, leaves: Sequence[Leaf], first: bool) -> Iterator[Wrong]:
        """Hold that the sheets have all figures, rows and notes; the first ones of a set the graph too."""
        names = {one.name for leaf in leaves for one in leaf.groups}
        due = [name for bill in self.bills.values() for name in self._of(bill)]
        due += [f"hodograph-{key}" for key in self.statics.form.sheet.hodographs]
        notes = ForceNotes(notes_of(leaves), self.statics, self.bills, self.floor)
        due += [*([BALANCING] if first else []), *([f"{LEVER}-{self.position}"] if notes.hung else [])]
        yield from (message("wrong.missing", name=name) for name in due if name not in names)
        yield from rows(leaves, self.comparison, self.floor)
        yield from notes.faults()

    def _of(self, bill: ForceBill) -> tuple[str, ...]:
        """Name the figures of a cut; one on which no force acts has no polygon."""
        label = "-".join(map(str, bill.links))
        scheme, polygon = (f"{kind}-{label}-{self.position}" for kind in ("scheme", "forces"))
        acting = [*bill.known, *([] if bill.driving is None else [bill.driving]), *(one.whole for one in bill.bearings)]
        loaded = any(abs(one.value) > self.floor.force for one in acting)
        return scheme, f"equations-{label}", *([polygon] if loaded else [])
