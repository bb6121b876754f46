"""The sizes of the arrowheads of a sheet: sharp as they must be, none too large, all of a figure alike (стрелки)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from drawings.checks.wrong import Wrong, on
from drawings.paper.strokes import Arc, Fill, Group, Leaf, Line, Polyline
from drawings.paper.walk import flat
from plans.model.order import ORDERS

LONG, SHARP = 5.0, math.radians(20)  # mm of a straight head on A1, and its angle
SHARE = 1.5  # lengths of its head that a vector has at the least: a shorter one has a smaller head
BENT = (3.5, 0.9)  # mm: length along its arc and half width of the head of an arc on A1
WHOLE = tuple(order.plan for order in ORDERS[1:])  # the heads of their vectors are as on A1 on any paper
ALIKE = 1e-3  # of a head's size by which two may differ: their corners are rounded
FINE = 0.02  # mm: less than a twentieth of the thinnest line


class Head(NamedTuple):
    """A head of an arrow: its factor of the sizes of symbols by its length, and by its width; whether it is cut short.

    That of a short vector is `short`, by the vector's length.
    """

    long: float
    wide: float
    bent: bool
    short: float = math.inf


def faults(leaf: Leaf, symbol: float) -> Iterator[Wrong]:
    """Hold the heads of each figure of a sheet whose symbols have some factor."""
    for group in leaf.groups:
        heads = [*_straight(group), *_bent(group)]
        most = 1.0 if group.name.startswith(WHOLE) else symbol
        if any(map(_misshapen, heads)) or not _alike(heads) or any(one.long > most + ALIKE for one in heads):
            yield on("head_size", group.name)


def _misshapen(one: Head) -> bool:
    return abs(one.wide - one.long) > ALIKE * max(one.long, ALIKE) + FINE / LONG


def _alike(heads: list[Head]) -> bool:
    """Tell whether the heads that are not cut short are all of one size, and the others as small as they must be."""
    for own in ([one for one in heads if one.bent is bent] for bent in (False, True)):
        full = max((one.long for one in own), default=0.0)
        if any(abs(one.long - min(full, one.short)) > ALIKE for one in own):
            return False
    return True


def _straight(group: Group) -> Iterator[Head]:
    """Give the heads of straight arrows, filled or open: each after its line."""
    line: Line | None = None
    for stroke in flat((group,)):
        match stroke:
            case Line():
                line = stroke
            case Fill((tip, one, other)) | Polyline((one, tip, other), False) if line is not None:
                yield from _head(line, tip, one, other)


def _head(line: Line, tip: complex, one: complex, other: complex) -> Iterator[Head]:
    """Give a head whose tip is an end of a line and whose back lies along it; of a dimension it may lie outside."""
    back, run = (one + other) / 2, line.end - line.start
    if min(abs(tip - line.start), abs(tip - line.end)) > FINE or not abs(run) > FINE or not abs(back - tip) > FINE:
        return
    if abs(((back - tip) * run.conjugate()).imag) > FINE * abs(run) or abs(one - other) <= FINE:
        return  # what is so slim is no head: the filling of a corner that is all but one line
    away = line.start if abs(tip - line.end) <= FINE else line.end
    inside = ((back - tip) * (away - tip).conjugate()).real > 0
    short = abs(run) / (SHARE * LONG) if inside else math.inf
    yield Head(abs(back - tip) / LONG, abs(one - back) / (LONG * math.tan(SHARP / 2)), False, short)


def _bent(group: Group) -> Iterator[Head]:
    """Give the heads of arcs."""
    for arc, head in pairwise(flat((group,))):
        match arc, head:
            case Arc(centre, radius), Fill((tip, one, other)):
                yield from _of_arc(centre, radius, tip, (one, other))


def _of_arc(centre: complex, radius: float, tip: complex, wings: tuple[complex, complex]) -> Iterator[Head]:
    one, other = wings
    back = (one + other) / 2
    if max(abs(abs(spot - centre) - radius) for spot in (tip, back)) <= FINE and tip != back:
        turn = abs(cmath.phase((tip - centre) / (back - centre)))
        yield Head(turn * radius / BENT[0], abs(one - back) / BENT[1], True)
