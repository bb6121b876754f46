"""The self-check of the headings of plans: title, position, scale with its unit and ratio (заголовки планов)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.vectors.laid_vectors import LaidVectorPlan
from drawings.checks.wrong import on
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import texts
from plans.model.order import ORDERS, POSITIONS
from plans.words.words import Message, message


def of_positions(leaf: Leaf, mu: float, drafting: Drafting, title: str = POSITIONS.plan) -> Iterator[Message]:
    """See that the plan of positions has its title, by its word, and its scale."""
    written = {text.plain for text in texts(leaf.groups)}
    yield from _of(POSITIONS.plan, drafting.word(title), scale_line(mu, "l", "m", drafting), written)


def of_vectors(laid: LaidVectorPlan) -> Iterator[Message]:
    """See that a plan has its title with its position, and its scale or that nothing moves."""
    if laid.figure is None:
        return
    point, by = next(one.point for one in ORDERS if one.plan == laid.plan), laid.drafting
    scale = scale_line(laid.scale, point.symbol, point.unit, by) if laid.vectors else by.word("at rest")
    written = {text.plain for text in texts((laid.figure,))}
    yield from _of(laid.plan, by.word(laid.plan, position=laid.position), scale, written)


def _of(plan: str, title: str, scale: str, written: set[str]) -> Iterator[Message]:
    if Text(0j, title).plain not in written:
        yield on("title", plan, text=title)
    if scale not in written:
        yield message("wrong.scale", text=scale)
