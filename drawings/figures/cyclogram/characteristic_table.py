"""The table of characteristic positions: where the tool is, the turn of the main shaft by both roads (таблица)."""

from __future__ import annotations

import math

from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.words import fixed
from drawings.page.drafting import Drafting
from plans.checks.cyclogram_comparison import CyclogramComparison
from plans.model.cyclogram import BEGIN, END, Cyclogram, Position

NAME = "stations"
PLACES = 5  # decimals of a degree: what is left of an angle by any protractor, and a thousand times more
LENGTHS = 3  # decimals of a millimetre, or of a degree of a swing
TIMES = 3  # digits of a condition
HEADS = ("S, mm", "φ by plan, °", "φ by analysis, °", "condition")
SWINGS = ("ψ, °", "φ by plan, °", "φ by analysis, °", "condition")
INFINITE = "∞"


def characteristic(comparison: CyclogramComparison, drafting: Drafting) -> RuledTable:
    """Tell all characteristic positions by both roads."""
    found, other = comparison.construction, comparison.analysis
    pairs = zip(found.positions, other.positions, strict=True)
    lines = [_row(k, one, theirs, found, drafting) for k, (one, theirs) in enumerate(pairs)]
    heads = tuple(drafting.word(head) for head in (HEADS if found.sliding else SWINGS))
    return table(lines, drafting.word("characteristic position"), heads, drafting.hand.text)._replace(name=NAME)


def _row(k: int, one: Position, other: Position, found: Cyclogram, drafting: Drafting) -> TableRow:
    language = drafting.language
    gone = one.share * (1000 * found.stroke if found.sliding else math.degrees(found.stroke))
    turned = (fixed(round(math.degrees(road.turned), PLACES) % 360, language, PLACES) for road in (one, other))
    cells = fixed(gone, language, LENGTHS), *turned, condition(one, drafting)
    return TableRow(name(k, one, drafting), cells)


def name(k: int, one: Position, drafting: Drafting) -> str:
    """Write the number of a position and what it is."""
    return f"{k}  {drafting.word(f'role {one.role}')}"


def condition(one: Position, drafting: Drafting) -> str:
    """Write how many times a share of the stroke moves a share of the turn: without bound where the tool stands."""
    return INFINITE if one.role in (BEGIN, END) else drafting.number(one.condition, TIMES)
