"""Chords timed and judged: graphical integration by strips and kinematic diagrams by positions (метод хорд).

Each diagram that is integrated has an integral in closed form, so that the true error is known at every edge.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from geometry.board import Board
from geometry.calculus import integral
from geometry.strips import departure, middles, strips
from plans.bench.error import Errors
from plans.bench.roads import prepared
from plans.bench.trial import Found, Order, Road, Row, orders, timed
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import Diagrams, chord_error
from plans.model.motion import Floats
from plans.scene.scene import Scene

STRIPS = (12, 24, 96, 384, 1024, 4096)
DEFINED = (
    "chord integration: the largest difference at the strips' edges from the integral in closed form, in shares of "
    "its largest; the means are the ordinates at mid-strip"
)
SMOOTH, ON_EDGES = "chords: smooth", "chords: jumps on edges"
CONSTANT, INSIDE = "chords: constant load", "chords: jump in a strip"
NOT_SO = "what not to do: put an edge on the jump"
TURN = 2 * math.pi
JUMPS = math.acos(0.9), math.acos(-0.9)  # where a planing tool bites and leaves: after 5 and 95 per cent of its stroke
LOAD = 2000.0  # N, of the planing tool
GOLDEN = (math.sqrt(5) - 1) / 2  # the section of the axis that no division comes near

KINEMATIC = "diagrams: v and a by chords"
POSITIONS = (12, 24, 48, 96, 192, 360)
KINEMATIC_DEFINED = (
    "kinematic diagrams: the largest differences of v by the chords of S and of a by the chords of v from the exact "
    "ones where they belong, in shares of the largest of each"
)


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

    def errors(self, count: int, values: Floats) -> Errors:
        """Judge an integral by the largest difference in shares of the largest value."""
        return Errors({"A": departure(values, self.whole(self.edges(count))).share}, "A")


def _load(x: Floats) -> Floats:
    """Give the load where the tool cuts."""
    return np.where((x > JUMPS[0]) & (x < JUMPS[1]), LOAD, 0.0)


def _work(x: Floats) -> Floats:
    return np.asarray(LOAD * (np.cos(JUMPS[0]) - np.cos(np.clip(x, *JUMPS))))


DIAGRAMS: Sequence[Diagram] = (
    Diagram(SMOOTH, np.exp, np.expm1, 2.0),
    Diagram(ON_EDGES, lambda x: _load(x) * np.sin(x), _work, TURN, JUMPS),
    Diagram(CONSTANT, _load, lambda x: LOAD * (np.clip(x, *JUMPS) - JUMPS[0]), TURN, JUMPS, "exact"),
    Diagram(INSIDE, lambda x: np.where(x > GOLDEN, 1.0, 0.0), lambda x: np.maximum(x - GOLDEN, 0.0), 1.0, note=NOT_SO),
)


def integration(rounds: int, counts: Sequence[int] = STRIPS) -> Found:
    """Time and judge chord integration at several numbers of strips."""
    pairs = [(one, count) for one in DIAGRAMS for count in counts]
    roads = [
        Road(partial(one.values, count), count, {one.name: partial(one.errors, count)}, one.note)
        for one, count in pairs
    ]
    rows = timed(roads, rounds)
    return Found(rows, [DEFINED, *_told(rows)])


def _told(rows: Sequence[Row]) -> Iterator[str]:
    for one in DIAGRAMS:
        if one.name == CONSTANT:
            most = max(row.error or 0.0 for row in rows if row.technique == CONSTANT)
            yield f"  {CONSTANT}: exact, at most {most:.1e} from rounding"
        else:
            yield from (line + (f" ({one.note})" if one.note else "") for line in orders(rows, one.name, "strips"))


def diagrams(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge the kinematic diagrams of a scene."""
    tell("the diagrams")
    return kinematic(scene, order.rounds, POSITIONS if order.startup else POSITIONS[:3])


def kinematic(scene: Scene, rounds: int, counts: Sequence[int] = POSITIONS) -> Found:
    """Time and judge the kinematic diagrams at several numbers of positions, over plans that are there."""
    studies = [DiagramsStudy(prepared(scene, count), True) for count in counts]
    why = next((one.left_out for one in studies if one.left_out), None)
    if why is not None:
        return Found([Row(KINEMATIC, None, note=f"left out: {why}")], [KINEMATIC_DEFINED])
    pairs = zip(studies, counts, strict=True)
    rows = timed([Road(partial(_drawn, one), count, {KINEMATIC: judged}) for one, count in pairs], rounds)
    return Found(rows, [KINEMATIC_DEFINED, *orders(rows, KINEMATIC, "positions")])


def _drawn(study: DiagramsStudy) -> Diagrams:
    return DiagramsStudy(study.linkage, True).drawn


def judged(found: Diagrams) -> Errors:
    """Give how far v and a by chords are out, in shares of the largest."""
    pairs = {"v": (found.speeds, found.true_speeds), "a": (found.growths, found.true_growths)}
    off = {name: chord_error(*pair) for name, pair in pairs.items()}
    kinds = {name: error.share if error else 0.0 for name, error in off.items()}
    return Errors(kinds, max(kinds, key=kinds.__getitem__))
