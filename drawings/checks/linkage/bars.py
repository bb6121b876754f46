"""The self-check of the links on a plan of positions: shown, thin, extreme, the circle of the crank (звенья на плане).

Each link must lie in each position where the analysis has it, and no other line stands among them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.laid_poses import LaidPoses, Segments
from drawings.checks.wrong import on
from drawings.paper.limits import MANY
from drawings.paper.strokes import Arc
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes
from plans.model.order import POSITIONS
from plans.words.words import Message

SHOWN, OTHERS, EXTREME = "shown-position", "all-positions", "extremes"  # the groups of the links on the plan
SHARES = np.linspace(0.0, 1.0, 11)[1:-1]  # of a bar, where it is looked for
AROUND = 36  # places of the crank's circle where it is looked for
ONE = 1e-6  # rad: an extreme that is a position of the scene differs from it by the rounding of both roads
PAST = 25.0  # mm that a slot may be drawn past its stone's outermost places
SHORT = 5.0  # mm: ticks, crosses and hatching on the way of the drive are no longer


class Row(NamedTuple):
    """A link in one position: its number, the position, and its pieces on paper."""

    link: int
    position: int
    pieces: Segments


def faults(plan: LaidPlan) -> Iterator[Message]:
    """Hold the links of all positions that are drawn, and the crank's circle."""
    extremes = plan.extremes
    own = _extreme_positions(plan)
    thin = [k for k in _thin(plan) if k not in own and k != plan.position]
    yield from _hold(plan, SHOWN, rows_of(plan.poses, [plan.position]), "link_missing", slots_of(plan))
    # An extreme that is all but a position may be drawn as both.
    beside = [row.pieces for row in rows_of(plan.poses, [k for k in own if k is not None])]
    more = Segments.joined([*beside, *_stroke(plan)])
    yield from _hold(plan, OTHERS, rows_of(plan.poses, thin), "link_missing", more, SHORT)
    if extremes is not None:
        which = [k for k in range(2) if own[k] != plan.position]
        yield from _hold(plan, EXTREME, rows_of(extremes, which), "link_extreme")
    if not plan.laid.mechanism.drive.pushed:
        yield from _circle(plan)


def _extreme_positions(plan: LaidPlan) -> list[int | None]:
    """Give the positions of the scene that are the output's extreme ones."""
    if plan.extremes is None:
        return []
    turns = np.exp(1j * plan.poses.motion.phi)
    off = [np.abs(turns - np.exp(1j * phi)) for phi in plan.extremes.motion.phi]
    return [int(np.argmin(one)) if one.min() <= ONE else None for one in off]


def _thin(plan: LaidPlan) -> range:
    """Give the positions that are drawn with all links: of very many, those between every so many."""
    count = len(plan.poses.motion.phi)
    steps = count - (not plan.laid.mechanism.drive.turns)
    return range(0, count, max(math.ceil(steps / MANY), 1))


def rows_of(poses: LaidPoses, positions: list[int]) -> Iterator[Row]:
    """Give the moving links in some positions with their pieces."""
    for link in poses.mechanism.links:
        pieces = poses.bars(link) if link != FRAME else []
        for k in positions:
            own = [(complex(one.starts[k]), complex(one.ends[k])) for one in pieces]
            yield Row(link, k, Segments.of(iter(own)).known())


def _hold(
    plan: LaidPlan, name: str, rows: Iterator[Row], key: str, more: Segments | None = None, short: float = 0.0
) -> Iterator[Message]:
    """See that each row is drawn in a group, and that each of its lines is on a row."""
    due = list(rows)
    drawn = plan.lines(name)
    spots = [one.pieces.at(SHARES).ravel() for one in due]
    whole: Complexes = np.concatenate([*spots, np.zeros(0, dtype=np.complex128)])
    missing = plan.clear(whole) & (drawn.nearest(whole) > plan.near)
    parts = np.split(missing, np.cumsum([len(one) for one in spots])[:-1]) if due else []
    for row, own in zip(due, parts, strict=True):
        if own.any():
            yield on(key, POSITIONS.plan, link=row.link, position=row.position)
    every = [one.pieces for one in due] + ([] if more is None else [more])
    known = Segments.joined(every)
    stray = ~known.holds(drawn, plan.near) & (np.abs(drawn.ends - drawn.starts) > short)
    if stray.any():
        yield on("bars", POSITIONS.plan, count=int(stray.sum()))


def slots_of(plan: LaidPlan) -> Segments:
    """Give the slots of the shown position as far as they may reach: past the outermost places of their stones."""
    found = []
    for slide in plan.laid.mechanism.slides:
        if slide.owner != FRAME:
            way = plan.poses.way(slide)[plan.position]
            through = plan.laid.on(slide.owner, slide.on_owner.through)
            past = PAST if plan.way is not None else plan.leaf.width  # the way between the positions is not known
            low, high = plan.travel(slide)
            found.append((through + (low - past) * way, through + (high + past) * way))
    return Segments.of(iter(found)).known()


def _stroke(plan: LaidPlan) -> list[Segments]:
    """Give the stroke of a primary link that slides."""
    ends = plan.crank_ends
    return [Segments(ends[:1], ends[-1:])] if plan.laid.mechanism.drive.pushed else []


def _circle(plan: LaidPlan) -> Iterator[Message]:
    """Hold the circle of the crank's end, as far as the drive turns."""
    drive, study = plan.laid.mechanism.drive, plan.laid.study
    pivot, ends = complex(plan.poses.point(drive.pivot)[0]), plan.crank_ends
    radius = abs(ends[0] - pivot)
    arcs = [one for one in plan.strokes(OTHERS) if isinstance(one, Arc)]
    low, high = study.span
    spots = pivot + radius * np.exp(1j * np.linspace(low, high, AROUND))
    there = np.array([[holds(arc, complex(spot), plan.near) for arc in arcs] for spot in spots]).reshape(AROUND, -1)
    wrong = any(abs(arc.centre - pivot) > plan.near or abs(arc.radius - radius) > plan.near for arc in arcs)
    if wrong or (plan.clear(spots) & ~there.any(axis=1)).any():
        yield on("circle", POSITIONS.plan, name=drive.end)


def holds(arc: Arc, spot: complex, near: float) -> bool:
    """Tell whether a place lies on an arc."""
    off, slack = spot - arc.centre, near / max(arc.radius, near)
    turn = (math.atan2(off.imag, off.real) - arc.start_angle + slack) % math.tau
    return abs(abs(off) - arc.radius) <= near and turn <= arc.sweep + 2 * slack
