"""The self-check of a written sheet of a bank: figures, tables, notes against the analysis (проверка листа)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from drawings.checks import reading
from drawings.checks.bank import (
    bank_curves,
    bank_layouts,
    bank_lines,
    bank_marks,
    bank_strokes,
    bank_tables,
    bank_titles,
    bank_told,
    bank_views,
)
from drawings.checks.bank.bank_expected import Expected
from drawings.checks.bank.bank_titles import GRAPHS
from drawings.checks.documents_old import title_block, together
from drawings.checks.linkage.by_hand import wrong_scales
from drawings.checks.wrong import Wrong
from drawings.figures.bank import shaft, star
from drawings.figures.bank.bank_polygon import plan_of
from drawings.figures.rotor.letters import MOST
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups
from plans.checks.hand.bank import FIGURES
from plans.model.balance.bank import BankTask
from plans.study import Study
from plans.words.words import message

KIND = "bank"  # of its sheets


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a bank shows against the analysis (row of the table of sheets)."""
    bank = study["bank"]
    expected = Expected(bank.task, study.comparison("bank"), _crank(study))
    drafting = drafting_of(study.scene)
    yield from check(measured, leaf, expected, drafting)
    yield from bank_tables.by_hand(leaf, bank, expected, drafting)
    yield from wrong_scales(measured, leaf, tuple(FIGURES.values()))
    yield from title_block.faults(leaf, study.scene, KIND, drafting.word("bank sheet title"), "")


def _crank(study: Study) -> float:
    """Give the length m of the cranks: that of the unit, or of the scene's own primary link."""
    task: BankTask = study["bank"].task
    if task.unit is not None:
        return float(task.unit.crank)
    mechanism = study["linkage"].mechanism
    own = mechanism.links[mechanism.drive.link].points
    return float(abs(own[mechanism.drive.pivot] - own[mechanism.drive.end]))


def set_faults(sheets: Sequence[tuple[Measured, Leaf]], study: Study) -> Iterator[Wrong]:
    """See that the sheets have all figures, tables and notes between them, each once."""
    expected, leaves = Expected(study["bank"].task, study.comparison("bank")), [leaf for _, leaf in sheets]
    seen = {name for leaf in leaves for name in leaf.metadata["figures"]}
    yield from together.figures(leaves, [*due(expected, seen)])
    yield from together.parted(leaves, [*bank_tables.due(expected)])
    yield from together.notes(leaves)


def check(measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold what a sheet shows: the figures that its data name, tables, notes, scales."""
    figures = frozenset(leaf.metadata["figures"])
    own = set(due(expected, figures))
    wanted = figures if leaf.metadata["of"] > 1 else figures | own
    yield from (message("wrong.differs", name=name) for name in sorted(figures - own))
    lost = wanted - {one.name for one in groups(leaf.groups)}
    yield from (message("wrong.missing", name=name) for name in sorted(lost))
    yield from bank_marks.polygons(measured, expected, figures)
    yield from bank_marks.places(measured, expected, figures)
    yield from bank_views.faults(leaf, expected, drafting, figures)
    yield from bank_curves.faults(measured, leaf, expected, drafting, figures)
    yield from bank_layouts.faults(measured, leaf, expected, drafting, figures)
    yield from bank_lines.polygons(measured, leaf, expected, drafting, figures)
    yield from bank_lines.curves(measured, leaf, expected, drafting, figures)
    yield from bank_strokes.faults(leaf, expected, drafting, figures)
    yield from bank_titles.faults(leaf, expected, drafting, figures)
    yield from bank_tables.faults(leaf, expected, drafting)
    yield from bank_told.faults(leaf, expected, drafting)
    graphs = {bank_curves.figure_of(expected, plan) for plan in bank_curves.due(expected, figures)} & GRAPHS.keys()
    yield from reading.marked_scales(_without(leaf, graphs))


def _without(leaf: Leaf, graphs: set[str]) -> Leaf:
    """Leave the graphs out, which have a scale of each axis: they are held by themselves."""
    return Leaf(leaf.width, leaf.height, tuple(one for one in leaf.groups if one.name not in graphs))


def due(expected: Expected, figures: Collection[str]) -> Iterator[str]:
    """Name the figures that the sheets of a bank must bear."""
    yield star.NAME
    if any(one.place for one in expected.members):
        yield shaft.NAME
    for one in expected.polygons():
        if one.open or len(one.sides) <= MOST:
            yield plan_of(one.kind, one.signed)
    yield from {bank_curves.figure_of(expected, plan) for plan in bank_curves.due(expected, figures)}
    for found in expected.analysis.compensators:
        if any(expected.bodies(found)):
            yield bank_layouts.name_of(found)
