"""What a load diagram must show: a load over its stroke, there and back, as its scene states it (диаграмма)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from string import ascii_lowercase
from typing import NamedTuple

import numpy as np

from drawings.checks.expected import Expected, measured
from drawings.paper.statement import Kind
from plans.forces.stroke import Stroke, asks
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, IDLE, WORKING, Force, Moment, Track
from plans.model.motion import Floats

FIGURE = "load_diagram"
KNOWN = 1e-7  # of a stroke: where it ends is known to half the digits of an angle
FEW = 12  # corners that are lettered a, b, c; of more the layout chooses
STRAIGHT = 1e-3  # of two slopes: a bend that is less is none
SHORT = 2e-3  # of the greatest load: on paper a point
PIECES = 500  # of a line: corners that are lines apart are no arc
DOUBT = 4.0  # times more or less: rounding of a table decides whether it is one


class Branch(NamedTuple):
    """A load on the way there or back: its bounds and corners by shares of the stroke, rising, and what it is there."""

    back: bool
    shares: Floats
    sizes: Floats

    @property
    def bends(self) -> Floats:
        """How far each corner is from going straight on, as a share of both slopes; an end is one."""
        slopes = np.diff(self.sizes) / np.diff(self.shares)
        both = np.maximum(np.abs(slopes[1:]) + np.abs(slopes[:-1]), np.finfo(float).tiny)
        return np.concatenate(([1.0], np.abs(np.diff(slopes)) / both, [1.0]))


def branches(load: Force | Moment) -> Iterator[Branch]:
    """Give the load over its stroke there, and over that back; it may rest on one of them."""
    law = load.diagram if isinstance(load, Force) else None
    begin, end = load.overrun[0], 1 - load.overrun[1]
    shares = np.array(sorted({begin, end, *(share for share in (law.travel if law else ()) if begin < share < end)}))
    turns = load.against if isinstance(load, Moment) else load.resists or (load.direction is None and load.line is None)
    for during, sense in (((WORKING, FORWARD), 1.0), ((IDLE, BACKWARD), -1.0 if turns else 1.0)):
        if load.during in (ALWAYS, *during):
            back = IDLE in during
            sizes = (law.back or law.sizes if back else law.sizes) if law else ()
            found = np.interp(shares, law.travel, sizes) if law else np.ones(len(shares))
            yield Branch(back, shares, sense * load.size * found)


def diagrams(loads: Iterable[Force | Moment], strokes: Mapping[Track, Stroke]) -> Iterator[Expected]:
    """Give what the diagram of each load that changes over a stroke must show."""
    for load in loads:
        if asks(load):
            yield from _diagram(load, strokes[load.stroke])


def _diagram(load: Force | Moment, stroke: Stroke) -> Iterator[Expected]:
    figure, reach = f"{FIGURE}-{load.name}", abs(stroke.reach[1] - stroke.reach[0])
    length, whole = (reach, "H") if stroke.sliding else (math.degrees(reach), "ψ")
    written = 1000 * length if stroke.sliding else length
    row = Expected(Kind.VECTOR, figure, whole, complex(length), KNOWN * length)
    yield from measured(row, written, digits=4, unit=1000.0 if stroke.sliding else 1.0)
    for k, share in enumerate(load.overrun, 1):
        if share:
            yield Expected(Kind.VECTOR, figure, f"overrun_{k}", complex(share * length), KNOWN * length)
            yield Expected(Kind.PHRASE, figure, f"overrun_{k}", share, digits=4)
    for branch in branches(load):
        path = branch.shares * length + 1j * branch.sizes
        begin = [0j, complex(path[0].real)] if load.overrun[0] else []  # it jumps up and down at the overruns
        end = [complex(path[-1].real), complex(length)] if load.overrun[1] else []
        way = np.concatenate((begin, path, end))
        places = np.linspace(0, len(way) - 1, PIECES * (len(way) - 1) + 1)
        way = np.asarray(np.interp(places, np.arange(len(way)), way), dtype=np.complex128)
        yield Expected(Kind.CURVE, figure, "back" if branch.back else "out", way, KNOWN * length)
    yield from _corners(figure, load)


def _corners(figure: str, load: Force | Moment) -> Iterator[Expected]:
    """Give the ordinates of the corners that are not zero, lettered in the order of the motion."""
    found: dict[tuple[float, float], float] = {}
    for branch in branches(load):
        rows = zip(branch.shares.tolist(), branch.sizes.tolist(), branch.bends.tolist(), strict=True)
        for share, size, bend in reversed([*rows]) if branch.back else rows:
            if size and bend > STRAIGHT / DOUBT:
                found.setdefault((share, size), bend)
    doubtful = any(bend < STRAIGHT * DOUBT for bend in found.values())
    most = max((abs(size) for _, size in found), default=0.0)
    many = doubtful or len(found) > FEW
    for k, (_, size) in enumerate(found):
        for name in (ascii_lowercase[k],) if not many else (str(k + 1), *ascii_lowercase[k : k + 1]):
            allowed, short = math.inf if many else KNOWN * most, not abs(size) > SHORT * most
            yield Expected(Kind.VECTOR, figure, name, 1j * size, allowed, may_lack=many or short)
