"""Graphical integration timed and judged: its error against the number of strips, and the order of it (порядок метода).

Each diagram has an integral in closed form, so that the true error is known at every edge.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from geometry.board import Board
from geometry.calculus import integral
from geometry.strips import departure, middles, strips
from plans.bench.clock import interleaved
from plans.bench.convergence import order
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.model.motion import Floats

COUNTS = (12, 24, 96, 384, 1024, 4096)  # of strips
DEFINED = (
    "chord integration: the largest difference at the strips' edges from the integral in closed form, in shares of "
    "its largest; the means are the ordinates at mid-strip"
)
SMOOTH, ON_EDGES, CONSTANT, INSIDE = (
    "chords: smooth",
    "chords: jumps on edges",
    "chords: constant load",
    "chords: jump in a strip",
)
NOT_SO = "what not to do: put an edge on the jump"
TURN = 2 * math.pi
JUMPS = math.acos(0.9), math.acos(-0.9)  # where a planing tool bites and leaves: after 5 and 95 per cent of its stroke
LOAD = 2000.0  # N, of the planing tool
GOLDEN = (math.sqrt(5) - 1) / 2  # the section of the axis that no division comes near


class Diagram(NamedTuple):
    """A diagram with a known integral: over which axis, with which breaks as edges, and what is said of it."""

    name: str
    ordinate: Callable[[Floats], Floats]
    whole: Callable[[Floats], Floats]
    end: float
    breaks: tuple[float, ...] = ()
    note: str = ""

    def edges(self, count: int) -> Floats:
        """Divide its axis."""
        return strips(0.0, self.end, count, self.breaks)

    def values(self, count: int) -> Floats:
        """Integrate it by chords."""
        edges = self.edges(count)
        return integral(Board("bench"), "A", edges, self.ordinate(middles(edges))).values

    def error(self, count: int) -> float:
        """Give the largest error in shares of the largest value."""
        return departure(self.values(count), self.whole(self.edges(count))).share


def _load(x: Floats) -> Floats:
    """Give the load where the tool cuts."""
    return np.where((x > JUMPS[0]) & (x < JUMPS[1]), LOAD, 0.0)


DIAGRAMS: Sequence[Diagram] = (
    Diagram(SMOOTH, np.exp, np.expm1, 2.0),
    Diagram(
        ON_EDGES,
        lambda x: _load(x) * np.sin(x),
        lambda x: LOAD * (np.cos(JUMPS[0]) - np.cos(np.clip(x, *JUMPS))),
        TURN,
        JUMPS,
    ),
    Diagram(CONSTANT, _load, lambda x: LOAD * (np.clip(x, *JUMPS) - JUMPS[0]), TURN, JUMPS, "exact"),
    Diagram(INSIDE, lambda x: np.where(x > GOLDEN, 1.0, 0.0), lambda x: np.maximum(x - GOLDEN, 0.0), 1.0, note=NOT_SO),
)


def rows(rounds: int, budget: float, counts: Sequence[int] = COUNTS) -> tuple[list[Row], list[str]]:
    """Time and judge chord integration at several numbers of strips; give the rows, and the orders in words."""
    found = {one: [one.error(count) for count in counts] for one in DIAGRAMS}
    runs = [_run(one, count) for one in DIAGRAMS for count in counts]
    times = iter(interleaved(runs, rounds, budget))
    made = [
        Row(one.name, count, count, Errors({"A": error}, "A"), times=next(times), note=one.note)
        for one, errors in found.items()
        for count, error in zip(counts, errors, strict=True)
    ]
    return made, [DEFINED, *_orders(found, counts)]


def _run(diagram: Diagram, count: int) -> Callable[[], Any]:
    return lambda: diagram.values(count)


def _orders(found: dict[Diagram, list[float]], counts: Sequence[int]) -> Iterator[str]:
    for one, errors in found.items():
        if one.name == CONSTANT:
            yield f"  {one.name}: exact, at most {max(errors):.1e} from rounding"
        else:
            told = f"order {order(errors, counts):.2f} from {counts[0]} to {counts[-1]} strips"
            yield f"  {one.name}: {told}" + (f" ({one.note})" if one.note else "")
