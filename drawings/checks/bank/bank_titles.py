"""The self-check of the titles over the figures of a bank, and of what stands beside their scales (надписи фигур)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.bank import bank_curves, bank_layouts
from drawings.checks.bank.bank_expected import Expected, Polygon
from drawings.checks.graphs.figure_strokes import figure
from drawings.checks.wrong import Wrong, on
from drawings.figures.bank import shaft, star, turn_graph
from drawings.figures.bank.bank_polygon import plan_of
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from plans.bank.letters import MOMENT

COUNTERWEIGHT = "counterweight on crank"  # of a compensator that the crank itself carries
GRAPHS = {"force_graph": "bank force title", "moment_graph": "bank moment title"}  # the phrases of their titles


def faults(leaf: Leaf, expected: Expected, drafting: Drafting, figures: frozenset[str]) -> Iterator[Wrong]:
    """See that each figure is called what it is, and that a polygon that closes by itself says so."""
    for name, title in _titles(expected, drafting):
        strokes = figure(leaf, name)
        if name in figures and strokes is not None and Text(0j, title).plain not in strokes.texts:
            yield on("title", name, text=title)
    closing = drafting.word("closes by itself")
    for one in expected.polygons():
        strokes = figure(leaf, plan_of(one.kind, one.signed))
        if strokes is not None and (one.open if any(closing in text for text in strokes.texts) else one.closed):
            yield on("title", plan_of(one.kind, one.signed), text=closing)


def _titles(expected: Expected, drafting: Drafting) -> Iterator[tuple[str, str]]:
    """Give the figures with their titles."""
    yield star.NAME, drafting.word("star of cranks")
    yield shaft.NAME, drafting.word("view across")
    for one in expected.polygons():
        yield plan_of(one.kind, one.signed), drafting.word(_phrase(one), order=abs(one.signed))
    for plan in (turn_graph.FORCE, turn_graph.LEFT, turn_graph.MOMENT):
        name = bank_curves.figure_of(expected, plan)
        yield name, drafting.word(GRAPHS.get(name, f"hodograph of {plan}"))
    for found in expected.analysis.compensators:
        own = {} if expected.carried(found) else {"order": found.asked.order}
        yield bank_layouts.name_of(found), drafting.word("compensator of order" if own else COUNTERWEIGHT, **own)


def _phrase(one: Polygon) -> str:
    """Give the phrase of a polygon's title."""
    return ("moments of order" if one.kind == MOMENT else "forces of order") + ("" if one.signed > 0 else " back")
