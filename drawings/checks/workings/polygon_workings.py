"""The self-check of workings beside force polygons: what is laid off, what closes them read off (отрезки плана сил)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.checks.forces.polygon_chain import PolygonChain
from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.workings.due_line import DueLine, Quantity, laid_off, scaled
from drawings.checks.workings.machine_workings import named
from drawings.figures.workings.working import READING, SEGMENTS
from drawings.page.drafting import Drafting
from drawings.paper.limits import SEEN
from plans.checks.force_bill import ForceBill

STONE = "RPR"  # its stone's reaction is found by moments, whole where it has no part along the slot


def due(chain: PolygonChain, floor: Floor, mu: float, drafting: Drafting) -> Mapping[str, list[DueLine]]:
    """Give the lines that must stand in the workings beside a polygon, by their names; `mu` N/mm is its scale."""
    sizes, laid = _sizes(chain.bill), set(_laid(chain))
    found: dict[str, list[DueLine]] = {named(kind, chain.plan): [] for kind in (SEGMENTS, READING)}
    for name in dict.fromkeys(one.name for one in chain.vectors if one.name in sizes):
        letter, size = read(floor.letter(name)), Quantity(sizes[name], chain.nothing, "N")
        segment = f"[{letter}]"
        if name in laid:
            line = laid_off(letter, segment, "F", size._replace(unit=""), mu, drafting)._replace(none=SEEN)
            found[named(SEGMENTS, chain.plan)].append(line)
        else:
            line = scaled(letter, segment, "F", size, mu, drafting)._replace(none=SEEN * mu)
            found[named(READING, chain.plan)].append(line)
    return found


def _sizes(bill: ForceBill) -> dict[str, float]:
    """Give how large each force is that a polygon may show, N."""
    shown = bill.expected.polygon(bill.groups, bill.group) | bill.expected.parts(bill.group)
    return {name: abs(value) for name, value in shown.items()}


def _laid(chain: PolygonChain) -> Iterator[str]:
    """Name the forces that are known before a polygon is closed: given ones, and those that moments give."""
    bill, closing, drawn = chain.bill, chain.closing, {one.name for one in chain.vectors}
    yield from (one.name for one in bill.known)
    for k, one in enumerate(bill.bearings):
        parts = [part.name for part in one.parts if part.name in drawn]
        yield from (name for name in parts if name not in closing)
        if not parts and not k and bill.group is not None and bill.group.kind == STONE:
            yield one.name
    if bill.driving is not None and bill.driving.name not in closing:
        yield bill.driving.name
