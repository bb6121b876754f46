"""The self-check of the kinematics sheets of a set together: no figure, table or note is missing (полнота листов)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks import reading
from drawings.checks.diagrams.diagram_told import output_tables, too_few
from drawings.checks.linkage import accord, by_hand
from drawings.checks.linkage.laid import mass_centres
from drawings.checks.linkage.value_rows import TABLE, due_rows, named
from drawings.checks.wrong import Wrong
from drawings.figures.diagrams.frame import NAME as DIAGRAMS
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from drawings.paper.walk import texts
from plans.checks.diagrams_comparison import DiagramsComparison
from plans.checks.hand.motion import MotionByHand
from plans.diagrams.study import DiagramsStudy
from plans.linkage.study import LinkageStudy
from plans.model.order import ORDERS, POSITIONS
from plans.study import Study
from plans.words.words import message


def faults(leaves: Sequence[Leaf], study: Study) -> Iterator[Wrong]:
    """Hold that the sheets have all figures, all parts of their tables, and the notes; a sheet alone is held so too."""
    names = {group.name for leaf in leaves for group in leaf.groups}
    linkage: LinkageStudy = study["linkage"]
    planned = [k for k in linkage.form.sheet.plans if not linkage.lost[k]]
    due = [POSITIONS.plan, *(f"{order.plan}-{k}" for k in planned for order in ORDERS[1:])]
    yield from (message("wrong.missing", name=name) for name in due if name not in names)
    yield from _no_plans(leaves, study)
    if reading.NOTES not in names:
        yield message("wrong.notes")
    if not linkage.lost.all():
        yield from _values(leaves, study)
    yield from _diagrams(leaves, study, names)


def _no_plans(leaves: Sequence[Leaf], study: Study) -> Iterator[Wrong]:
    """Hold the sentences that stand where the analysis has no motion for a plan: which plan, where, and why not."""
    drafting = drafting_of(study.scene)
    gone = {gap.position: gap.reason for gap in study.comparison("linkage").analysis.gaps}
    for group in (one for leaf in leaves for one in leaf.groups):
        plan, _, k = group.name.rpartition("-")
        if plan in {order.plan for order in ORDERS[1:]} and k.isdigit() and int(k) in gone:
            shown = drafting.word(f"{plan} plan")
            due = drafting.word("no plan", plan=shown, position=int(k), reason=drafting.word(gone[int(k)]))
            yield from (message("wrong.told", text=own.plain) for own in texts((group,)) if own.plain != due)


def _values(leaves: Sequence[Leaf], study: Study) -> Iterator[Wrong]:
    """Hold the table of values: all positions that have plans, all rows; and the sentence about both roads."""
    linkage, comparison = study["linkage"], study.comparison("linkage")
    told = MotionByHand(linkage, comparison, mass_centres(linkage))
    due = list(named(due_rows(comparison, told), linkage.language))
    tables = [group for leaf in leaves for group in reading.value_tables(leaf)]
    heads = [text.plain.rsplit(", ", 1)[0] for group in tables for row in reading.rows(group) for text in row]
    seen = {name for head in heads for name in head.split(by_hand.EQUAL)}
    positions = {k for group in tables for k in reading.positions_of(group)}
    planned = {k for leaf in leaves for _, k in leaf.metadata["vectors"]}
    if due and positions != planned:
        yield message("wrong.missing", name=TABLE)
    yield from (message("wrong.row_missing", name=name) for name in due if tables and name not in seen)
    if np.isfinite(comparison.kappa).any() and not any(accord.is_told(leaf, linkage.language) for leaf in leaves):
        yield message("wrong.notes")


def _diagrams(leaves: Sequence[Leaf], study: Study, names: set[str]) -> Iterator[Wrong]:
    """Hold the diagrams and the table of the output's course, where there are any."""
    own: DiagramsStudy = study["diagrams"]
    if not own.wanted:
        return
    comparison = study.comparison("diagrams")
    if isinstance(comparison, DiagramsComparison):
        if DIAGRAMS not in names:
            yield message("wrong.missing", name=DIAGRAMS)
        rows = [row for leaf in leaves for table in output_tables(leaf) for row in reading.rows(table)]
        numbers = {int(row[0].plain) for row in rows if row[0].plain.isdigit()}
        yield from too_few(numbers, comparison)
