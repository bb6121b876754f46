"""The self-check of the headings of plans: title, position, scale with its unit and ratio (заголовки планов)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.graphs.scale_line import ratio
from drawings.checks.vectors.laid_vectors import LaidVectorPlan
from drawings.checks.wrong import on
from drawings.lettering.words import number
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import texts
from plans.model.order import ORDERS, POSITIONS
from plans.words.words import Message, message


def of_positions(leaf: Leaf, mu: float, drafting: Drafting) -> Iterator[Message]:
    """See that the plan of positions has its title and its scale."""
    written = {text.plain for text in texts(leaf.groups)}
    yield from _of(POSITIONS.plan, drafting.word(POSITIONS.plan), _scale("l", mu, "m", drafting), written)


def of_vectors(laid: LaidVectorPlan) -> Iterator[Message]:
    """See that a plan has its title with its position, and its scale or that nothing moves."""
    if laid.figure is None:
        return
    point, by = next(one.point for one in ORDERS if one.plan == laid.plan), laid.drafting
    scale = _scale(point.symbol, laid.scale, point.unit, by) if laid.vectors else by.word("at rest")
    written = {text.plain for text in texts((laid.figure,))}
    yield from _of(laid.plan, by.word(laid.plan, position=laid.position), scale, written)


def _of(plan: str, title: str, scale: str, written: set[str]) -> Iterator[Message]:
    if Text(0j, title).plain not in written:
        yield on("title", plan, text=title)
    if scale not in written:
        yield message("wrong.scale", text=scale)


def _scale(letter: str, mu: float, unit: str, by: Drafting) -> str:
    """Write a scale as it is read, mu with the ratio of lengths, or K."""
    true, mm = by.word(unit), by.word("mm")
    true = f"({true})" if "/" in true else true
    if by.notation == "K":
        return f"K{letter} = {number(1 / mu, by.language)} {mm}/{true}"
    return f"μ{letter} = {number(mu, by.language)} {true}/{mm}" + (
        f" ({ratio(mu, by.language)})" if letter == "l" else ""
    )
