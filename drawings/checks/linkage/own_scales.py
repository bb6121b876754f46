"""The self-check of what is said of plans with scales of their own, beside a common one (собственные масштабы)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from drawings.checks.graphs.figure_strokes import read
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.precise import ALL_DIGITS, tells
from drawings.checks.reading import NOTES, notes
from drawings.checks.wrong import Wrong, within
from drawings.lettering.words import number, runs
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from plans.model.order import ORDERS, Order

FINE = 1e-3  # of a size: what the ends of short vectors that are read back are out by
WHOLE = (0,)  # digits: sizes have no decimals, all else stands as it must

Sheets = Sequence[tuple[Measured, Leaf]]


def faults(sheets: Sheets, drafting: Drafting) -> Iterator[Wrong]:
    """See that the notes of a set say of each order which plans are enlarged beside the common scale, and no more."""
    said = " ".join(notes(leaf) for _, leaf in sheets)
    for order in ORDERS[1:]:
        due = list(_due(sheets, order, drafting))
        begin = _sentence(order, drafting, positions="|").partition("|")[0]
        if due and not any(_among(said.split(), one.split()) for one in due):
            yield within("missing_from", NOTES, name=due[0])
        if said.count(begin) > bool(due):
            yield within("note_beside", NOTES, text=begin)


def cut(said: str, drafting: Drafting) -> str:
    """Cut the sentences about plans with scales of their own out of notes, one of each order."""
    for order in ORDERS[1:]:
        parts = _sentence(order, drafting, positions="|", scale="|", sizes="|").split("|")
        said = re.sub(".*?".join(map(re.escape, parts)), "", said, count=1)
    return said


def _due(sheets: Sheets, order: Order, drafting: Drafting) -> Iterator[str]:
    """Give the sentence about plans that have not the largest scale of their order, measured; none where all have it.

    Two sizes that may be written alike are told as both or as one.
    """
    plans: dict[int, list[MeasuredVector]] = {}
    for vector in (one for measured, _ in sheets for one in measured.vectors if one.plan == order.plan):
        plans.setdefault(vector.position or 0, []).append(vector)
    common = max((own[0].scale for own in plans.values()), default=0.0)
    sizes = {k: _extent(own) / common for k, own in sorted(plans.items()) if own[0].scale != common}
    if not sizes:
        return
    least, most = min(sizes.values()), max(sizes.values())
    scale = scale_line(common, order.point.symbol, order.point.unit, drafting)
    for ends in [(least, most)] * (round(least) < round(most)) + [(least,)] * (most - least <= 1):
        told = " … ".join(number(end, drafting.language, ALL_DIGITS) for end in ends)
        yield _sentence(order, drafting, positions=runs(sizes), scale=scale, sizes=told)


def _extent(plan: Sequence[MeasuredVector]) -> float:
    """Give the larger side of a plan in true units."""
    ends = [end for vector in plan for end in (vector.start, vector.end)]
    wide, high = (max(row) - min(row) for row in ([end.real for end in ends], [end.imag for end in ends]))
    return max(wide, high) * plan[0].scale


def _sentence(order: Order, drafting: Drafting, positions: str, scale: str = "", sizes: str = "") -> str:
    return read(drafting.word(f"own scale {order.plan}", positions=positions, scale=scale, sizes=sizes))


def _among(seen: Sequence[str], due: Sequence[str]) -> bool:
    """Tell whether a sentence is among words, its sizes rounded to whole millimetres."""
    starts = (k for k, one in enumerate(seen) if one == due[0])
    return any(tells(" ".join(seen[k : k + len(due)]), " ".join(due), WHOLE, FINE) for k in starts)
