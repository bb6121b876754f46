"""The self-check of the working beside the kinematic diagrams: scale of time, pole distances (масштабы диаграмм)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from drawings.checks.diagrams.diagram_rows import RowGraph
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.workings.due_line import DueLine, Quantity, faults
from drawings.checks.wrong import Wrong
from drawings.figures.diagrams.frame import NAME
from drawings.figures.workings.working import SCALES
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf


def of_diagrams(
    leaf: Leaf, graphs: Sequence[RowGraph], omega: float, crank: int, drafting: Drafting
) -> Iterator[Wrong]:
    """Hold the working beside the diagrams, by their scales as they are held to the ordinates."""
    for group in (one for one in leaf.groups if one.name == f"{SCALES}-{NAME}"):
        yield from faults(group, list(_due(graphs, omega, crank, drafting)), NAME, drafting)


def _due(graphs: Sequence[RowGraph], omega: float, crank: int, drafting: Drafting) -> Iterator[DueLine]:
    along = graphs[0].along
    time, speed, k = along / omega, Quantity(omega), drafting.notation == "K"
    if k:
        yield DueLine("Kt", f"Kφ·ω{crank}", (Quantity(1 / along), speed), Quantity(1 / time, unit="mm per s"))
    else:
        yield DueLine("μt", f"μφ/ω{crank}", (Quantity(along), speed), Quantity(time, unit="s per mm"))
    for number, (above, own) in enumerate(pairwise(graphs), 1):
        if own.row.flat:
            continue
        high, low = read(above.row.letter), read(own.row.letter)
        distance = Quantity(above.mu / (own.mu * time), unit="mm")
        if k:
            numbers = tuple(Quantity(1 / one) for one in (own.mu, time, above.mu))
            yield DueLine(f"H{number}", f"K{low}·Kt/K{high}", numbers, distance)
        else:
            numbers = tuple(map(Quantity, (above.mu, own.mu, time)))
            yield DueLine(f"H{number}", f"μ{high}/(μ{low}·μt)", numbers, distance)
