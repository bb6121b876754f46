"""The self-check of a written sheet of balancing: schemes, polygon, curves, tables, notes (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator

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
from drawings.checks.documents import title_block
from drawings.checks.graphs.scale_line import ratio
from drawings.checks.wrong import Wrong
from drawings.figures.balance import moment_graph, shaking_hodograph, share_graph, static_polygon
from drawings.figures.balance.scheme import BEFORE, SCHEME
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf
from drawings.report.balance.balance_report import drafting_for
from plans.study import Study
from plans.words.words import message

KIND = "balancing"  # of its sheets


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a balanced mechanism shows against the analysis (row of the table of sheets)."""
    shown = leaf.metadata["position"]
    expected = Expected(study["balance"], study.comparison("balance"), drafting_for(study["balance"]), shown, measured)
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
    yield from notes(leaf, expected)
    yield from _page(leaf, expected)


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
