"""The self-check of a written sheet of balancing: schemes, polygon, curves, tables, notes (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.checks.balance import (
    balance_axes,
    balance_cells,
    balance_curves,
    balance_graphs,
    balance_lines,
    scheme_lines,
)
from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance.balance_schemes import schemes
from drawings.checks.balance.balance_told import notes
from drawings.checks.documents_old import title_block, together
from drawings.checks.graphs.scale_line import ratio
from drawings.checks.workings import machine_workings
from drawings.checks.workings.due_line import DueLine, Quantity
from drawings.checks.workings.linkage_workings import lengths
from drawings.checks.wrong import Wrong
from drawings.figures.balance import balance_table, moment_graph, shaking_hodograph, share_graph, static_polygon
from drawings.figures.balance.scheme import BEFORE, SCHEME
from drawings.figures.workings.working import LENGTHS, SEGMENTS
from drawings.lettering.balance_letters import lowered
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf
from drawings.report.balance.balance_report import drafting_for
from plans.study import Study
from plans.words.words import message

KIND = "balancing"  # of its sheets


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a balanced mechanism shows against the analysis (row of the table of sheets)."""
    expected = _expected(measured, leaf, study)
    yield from _figures(leaf, expected)
    yield from schemes(leaf, expected)
    yield from balance_curves.polygon(leaf, expected)
    yield from balance_curves.shaking(leaf, expected)
    yield from balance_graphs.rocking(leaf, expected)
    yield from balance_graphs.shares(leaf, expected)
    yield from balance_cells.weights(leaf, expected)
    yield from balance_cells.costs(leaf, expected)
    yield from scheme_lines.schemes(leaf, expected)
    yield from balance_lines.polygon(leaf, expected)
    yield from balance_lines.shaking(leaf, expected)
    yield from balance_axes.rocking(leaf, expected)
    yield from balance_axes.shares(leaf, expected)
    yield from machine_workings.held(leaf, dict(_workings(leaf, expected)), expected.drafting)
    yield from notes(leaf, expected)
    yield from _page(leaf, expected)


def set_faults(sheets: Sequence[tuple[Measured, Leaf]], study: Study) -> Iterator[Wrong]:
    """See that the sheets have all figures, tables and notes between them, each once."""
    leaves = [leaf for _, leaf in sheets]
    for measured, leaf in sheets[:1]:
        expected = _expected(measured, leaf, study)
        tables = balance_table.COSTS, *([balance_table.WEIGHTS] if expected.balance.counterweights else [])
        yield from together.figures(leaves, [*_due(expected)])
        yield from together.parted(leaves, tables)
        yield from together.notes(leaves)


def _expected(measured: Measured, leaf: Leaf, study: Study) -> Expected:
    own, shown = study["balance"], leaf.metadata["position"]
    return Expected(own, study.comparison("balance"), drafting_for(own), shown, measured)


def _workings(leaf: Leaf, expected: Expected) -> Iterator[tuple[str, list[DueLine]]]:
    """Give what must be told of links and static moments laid off, by the figures of a sheet."""
    mechanism, drafting = expected.mechanism, expected.drafting
    scales = {name: marks.scale(expected.measured, name) for name in leaf.metadata["figures"]}
    for name in (SCHEME + state for state in expected.states if SCHEME + state in scales):
        due = lengths(mechanism, list(mechanism.links), scales[name], drafting)
        yield machine_workings.named(LENGTHS, name), due
    if (mu := scales.get(static_polygon.NAME)) is not None:
        sides, slack = balance_curves.static_moments(expected)
        own = {lowered(one.name): Quantity(abs(one.value), slack) for one in sides}
        yield machine_workings.named(SEGMENTS, static_polygon.NAME), machine_workings.segments(own, "mr", mu, drafting)


def _page(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold the paper and the title block; its scale is that of the scheme before."""
    first = SCHEME + BEFORE
    mu, language = marks.scale(expected.measured, first), expected.drafting.language
    scale = ratio(mu, language) if first in leaf.metadata["figures"] else ""
    subtitle = expected.drafting.word("balancing sheet title")
    yield from title_block.faults(leaf, expected.own.linkage.scene, KIND, subtitle, scale)


def _figures(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """See that a sheet bears no figure but those of this balance, and one that is alone all of them."""
    due, seen = list(_due(expected)), leaf.metadata["figures"]
    asked = expected.own.linkage.form.sheet.position
    if asked is not None and asked != expected.shown and not expected.own.linkage.lost.all():
        yield message("wrong.position", position=expected.shown)
    yield from (message("wrong.figure", name=name) for name in seen if name not in due)
    if leaf.metadata["of"] == 1:
        yield from (message("wrong.missing", name=name) for name in due if name not in seen)


def _due(expected: Expected) -> Iterator[str]:
    """Name the figures that the sheets must show between them."""
    states, none = expected.states.values(), expected.none
    yield from (SCHEME + state for state in expected.states)
    yield static_polygon.NAME
    if any(one.shaking > none.force for one in states):
        yield shaking_hodograph.NAME
    if any(one.rocking > none.moment for one in states) and len(expected.balance.before.centre.phi) > 1:
        yield moment_graph.NAME
    if expected.balance.shares is not None:
        yield share_graph.NAME
