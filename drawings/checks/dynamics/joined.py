"""The self-check of what joins the graphs of a plate: lines into the loop, lines at jumps (линии связи чертежа)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from drawings.checks.dynamics.due_tables import jumps
from drawings.checks.dynamics.dynamics_expected import INERTIA, MOMENTS, SPEEDS, SURPLUS, WORKS, Expected
from drawings.checks.dynamics.dynamics_graphs import edges_on
from drawings.checks.dynamics.dynamics_loop import LOOP, loop_on
from drawings.checks.dynamics.joining_strokes import Joined, captions
from drawings.checks.wrong import Wrong
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import group_named
from plans.model.motion import Complexes
from plans.words.words import message

# What stands on each plate.
SHOWN: Mapping[str, tuple[str, ...]] = {
    "machine": (MOMENTS, WORKS, SURPLUS, SPEEDS, INERTIA, LOOP),
    "diagrams": (MOMENTS, WORKS, SURPLUS, SPEEDS),
    "energy-mass": (INERTIA, LOOP),
    "moments-works": (MOMENTS, WORKS),
    "energy-speeds": (SURPLUS, SPEEDS),
}
NONE = np.empty(0, dtype=complex)


def joined(measured: Measured, leaf: Leaf, expected: Expected, plate: str, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the lines that join the graphs of a plate with one another and with the loop."""
    group, names = group_named(leaf.groups, f"{plate}-transfer"), SHOWN[plate]
    parts = {name: one for name in names if (one := group_named(leaf.groups, name)) is not None}
    inertia = edges_on(measured, leaf, expected, INERTIA, INERTIA) if INERTIA in parts else NONE
    loop = loop_on(measured, leaf, expected) if LOOP in parts else NONE
    over = {name: edges_on(measured, leaf, expected, name, _stating(parts)) for name in (WORKS, SURPLUS)}
    over = {name: one for name, one in over.items() if name in parts}
    if inertia is None or loop is None or any(one is None for one in over.values()):
        return  # told of by the graphs
    if group is None:
        yield message("wrong.missing", name=plate)
        return
    ends = [_upright(one, k) for k in jumps(expected.cycle) for one in over.values() if one is not None]
    boxes = captions(list(parts.values()), drafting)
    own = Joined(group, inertia, over.get(SURPLUS), loop, ends, boxes, drafting.hand.symbol)
    yield from own.faults(expected if loop.size else None)


def _stating(parts: Mapping[str, Group]) -> str:
    """Give the graph whose heading states the scale of the angle."""
    return MOMENTS if MOMENTS in parts else SURPLUS


def _upright(places: Complexes, k: int) -> tuple[complex, complex]:
    """Give the line through a graph at an edge, as high as the graph is from its axis."""
    zero = float(places[0].imag)
    return complex(places[k].real, min(zero, *places.imag)), complex(places[k].real, max(zero, *places.imag))
