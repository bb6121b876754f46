"""The self-check of the lines of a plan of velocities or accelerations: vectors, known directions (линии плана)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

import numpy as np

from drawings.checks.linkage.laid_poses import Flags, Segments
from drawings.checks.linkage.position_marks import EXACT
from drawings.checks.vectors.laid_vectors import LaidVectorPlan
from drawings.checks.wrong import on
from drawings.paper.strokes import Fill, Group, Line
from drawings.paper.walk import groups
from plans.linkage.letters import POLES
from plans.model.dyad import Dyad
from plans.model.motion import Complexes
from plans.model.order import ORDERS, VELOCITIES
from plans.words.words import Message

BEFORE, PAST = 4.5, 9.0  # mm on A1 that a line of known direction is drawn before its start, and past the meeting
HEADED = 0.2  # mm: a shorter vector is a point, and has no head
POINTED = 1e-3  # rad by which a head may lean from its vector: its corners are rounded


def faults(laid: LaidVectorPlan) -> Iterator[Message]:
    """Hold the heads and the beginnings of all vectors, and the lines of known direction."""
    if laid.figure is None or laid.pole is None or not laid.vectors:
        return
    yield from _heads(laid)
    yield from _starts(laid)
    yield from _results(laid)
    yield from _directions(laid)


def _heads(laid: LaidVectorPlan) -> Iterator[Message]:
    """See that each vector has its head at its end, along it."""
    assert laid.figure is not None
    for one in groups((laid.figure,)):
        if one.data.get("kind") == "vector" and isinstance(one.strokes[0], Line) and not _headed(one.strokes[0], one):
            yield on("head", laid.plan, name=one.data["name"], position=laid.position)


def _headed(line: Line, group: Group) -> bool:
    length = abs(line.end - line.start)
    heads = [one for one in group.strokes if isinstance(one, Fill)]
    if length < HEADED:
        return len(heads) <= 1
    return len(heads) == 1 and _points(heads[0], line, length)


def _points(head: Fill, line: Line, length: float) -> bool:
    """Tell whether a head is a triangle whose sharp corner is the end of a line, and which lies along it."""
    if len(head.points) != 3:
        return False
    tip = min(head.points, key=lambda spot: abs(spot - line.end))
    back = sum(spot for spot in head.points if spot != tip) / 2
    along = (tip - back) * (line.end - line.start).conjugate()
    return abs(tip - line.end) <= EXACT and abs(back - tip) <= length and abs(cmath.phase(along)) <= POINTED


def _starts(laid: LaidVectorPlan) -> Iterator[Message]:
    """See that each vector begins at the image of its first letter."""
    for one in laid.vectors:
        start = one.name.split(" ")[0]
        if start in laid.images and not abs(one.start - laid.on(laid.images[start])) <= laid.near:
            yield on("start", laid.plan, name=one.name)


def _results(laid: LaidVectorPlan) -> Iterator[Message]:
    """See that each vector from the pole is drawn with the main pen, but those to mass centres."""
    assert laid.figure is not None
    centres = _centres(laid)
    for one in groups((laid.figure,)):
        line = one.strokes[0] if one.data.get("kind") == "vector" else None
        if isinstance(line, Line) and one.data["name"].partition(" ")[0] == POLES[laid.plan]:
            main = line.style.width == laid.drafting.hand.main
            if not main and not (np.abs(line.end - centres) <= laid.near).any():
                yield on("line_kind", laid.plan)


def _directions(laid: LaidVectorPlan) -> Iterator[Message]:
    """See that each group's point is met by both lines on which the analysis has it, and that no other line stands."""
    assert laid.figure is not None
    drawn = Segments.of(iter(_lines(laid.figure)))
    due = [(name, laid.on(start), laid.on(end)) for name, start, end in _due(laid)]
    known = _sides(laid, drawn)
    for name, start, end in due:
        whole, near = _lengthened(laid, start, end)
        if abs(end - start) > 2 * HEADED and not drawn.holds(whole, near).any():
            yield on("known_direction", laid.plan, name=name, position=laid.position)
        known |= whole.holds(drawn, near)
    if not known.all():
        yield on("line", laid.plan)


def _lengthened(laid: LaidVectorPlan, start: complex, end: complex) -> tuple[Segments, float]:
    """Give a line of known direction as far as it is drawn, and how far it may be off at its ends, mm."""
    if start == end:
        return Segments.of(iter([(start, end)])), laid.near
    length, size = abs(end - start), laid.drafting.hand.symbol
    before, past = BEFORE * size, PAST * size
    way = (end - start) / length
    return Segments.of(iter([(start - before * way, end + past * way)])), laid.near * (1 + (before + past) / length)


def _sides(laid: LaidVectorPlan, drawn: Segments) -> Flags:
    """Tell which lines end in the image of a mass centre: sides of the figure that is similar to its link."""
    images = _centres(laid)
    starts, ends = ((np.abs(one[:, None] - images) <= laid.near).any(axis=1) for one in drawn)
    return np.asarray(starts | ends)


def _centres(laid: LaidVectorPlan) -> Complexes:
    """Give the images of the mass centres on paper."""
    order = next(k for k, one in enumerate(ORDERS) if one.plan == laid.plan)
    own = (laid.expected.centre(*mass, order) for mass in laid.centres.values())
    return np.array([laid.on(one) for one in own], dtype=complex)


def _lines(figure: Group) -> Iterator[tuple[complex, complex]]:
    """Give the straight lines of a plan that are no vectors, no leaders, and not of another figure beside it."""
    for one in figure.strokes:
        if isinstance(one, Group) and one.strokes and not one.data:
            lines = [line for line in one.strokes if isinstance(line, Line)]
            yield from ((line.start, line.end) for line in lines if len(lines) == len(one.strokes))


def _due(laid: LaidVectorPlan) -> Iterator[tuple[str, complex, complex]]:
    """Give the lines of known direction: what they lead to, from where, to where, true units."""
    for group in laid.groups:
        if isinstance(group, Dyad):
            for one in laid.sums.of(group):
                parts = one.velocity if laid.plan == VELOCITIES.plan else one.acceleration
                start = sum(parts[:-1])
                yield one.images[-1], start, start + parts[-1]
