"""The self-check of the trajectories on a plan of positions: each runs where its point goes (траектории)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from drawings.checks.linkage.bars import SHOWN, holds
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.laid_poses import LaidPoses, Segments
from drawings.checks.wrong import on
from drawings.paper.limits import MANY
from drawings.paper.strokes import Arc, Line, Polyline, Stroke
from drawings.symbols.symbols import TICK
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats
from plans.model.order import POSITIONS
from plans.words.words import Message

TICKS = "path-ticks"  # the name of the group of the positions on them
PATHS = "paths"  # the name of their group
# mm: a path may be straightened, and lie on another that is drawn, by a third of a line's width each.
WITHIN = 0.22
EVERY = 3  # places on the way round that are looked for: of a hundred and eighty every third
STILL = 0.5  # mm: a path that is no longer is a dot under its point's symbol
SAG = 4  # a path bulges over its piece by an eighth of its bend between pieces; where that grows, by less than twice so


def faults(plan: LaidPlan) -> Iterator[Message]:
    """See that each point that goes neither with the crank nor along a guide has its path, and no other is drawn."""
    strokes = plan.strokes(PATHS)
    drawn = Segments.of(_pieces(strokes))
    arcs = [one for one in strokes if isinstance(one, Arc)]
    within = WITHIN + plan.near
    marks = plan.lines(TICKS)
    ticks = (marks.starts + marks.ends) / 2
    for name, rows in _traced(plan):
        spots = np.concatenate([rows[0], *(_drawn(plan, name, row)[::EVERY] for row in rows[1:])])
        spots = spots[plan.clear(spots)]
        if spots.size and np.ptp(spots.real) + np.ptp(spots.imag) > STILL:
            off = np.fmin(drawn.nearest(spots, within), _off_arcs(arcs, spots, within))
            if plan.way is None:  # the path's own corners are not known: the positions lie beside its pieces
                off = np.fmin(off, _off_bends(strokes, spots, within))
            if (np.fmin(off, _off_links(plan, spots)) > within).any():
                yield on("trajectory", POSITIONS.plan, name=name)
            due = rows[0][_ticked(plan)]
            due = due[plan.clear(due, TICK)]
            if due.size and not (np.abs(due[:, None] - ticks).min(axis=1, initial=np.inf) <= plan.near).all():
                yield on("ticks", POSITIONS.plan, count=len(due))
    if plan.way is not None and not _all_known(plan, drawn, arcs, within):
        yield on("path", POSITIONS.plan, name=PATHS)


def _drawn(plan: LaidPlan, name: str, way: Complexes) -> Complexes:
    """Give a point's way round, NaN where it or its neighbour is farther off than paths are drawn.

    A mass centre that no point names is placed by the first point of its link, and goes no farther than that one.
    """
    reached = plan.reached(way)
    if name in plan.laid.centres and plan.way is not None:
        link, _ = plan.laid.centres[name]
        reached &= plan.reached(plan.way.point(next(iter(plan.laid.mechanism.links[link].points))))
    return np.where(reached & np.roll(reached, 1) & np.roll(reached, -1), way, np.nan)


def _ticked(plan: LaidPlan) -> slice:
    """Give the positions that are ticked: of very many those between every so many."""
    return slice(None, None, max(math.ceil(len(plan.poses.motion.phi) / MANY), 1))


def _pieces(strokes: Sequence[Stroke]) -> Iterator[tuple[complex, complex]]:
    for one in strokes:
        if isinstance(one, Line):
            yield one.start, one.end
        elif isinstance(one, Polyline):
            points = [*one.points, *one.points[: int(one.closed)]]
            yield from pairwise(points)


def _off_arcs(arcs: list[Arc], spots: Complexes, within: float) -> Floats:
    """Give 0 for each place that lies on an arc, infinity for the others."""
    return np.array([0.0 if any(holds(arc, complex(spot), within) for arc in arcs) else np.inf for spot in spots])


def _off_bends(strokes: Sequence[Stroke], spots: Complexes, within: float) -> Floats:
    """Give how far places are off what a piece may bulge by where a path bends hard, as all but at a dead centre."""
    off = np.full(len(spots), np.inf)
    for one in (one for one in strokes if isinstance(one, Polyline) and len(one.points) > 2):
        points = np.array(one.points)
        bends = np.abs(np.diff(points, 2)) / SAG
        bulges = np.fmax(np.append(bends, bends[-1]), np.append(bends[0], bends))
        for k in np.flatnonzero(bulges > within):
            piece = Segments(points[k : k + 1], points[k + 1 : k + 2])
            off = np.fmin(off, np.fmax(piece.nearest(spots) - bulges[k], 0.0))
    return off


def _off_links(plan: LaidPlan, spots: Complexes) -> Floats:
    """Give how far places are beside the links in full lines: a path that runs along one is hidden by it."""
    full = [one for one in plan.strokes(SHOWN) if isinstance(one, Line)]
    widest = max((one.style.width for one in full), default=0.0)
    return plan.lines(SHOWN).nearest(spots) - widest / 2


def _traced(plan: LaidPlan) -> Iterator[tuple[str, list[Complexes]]]:
    """Give the points that have paths: their places in the positions, and on the way round where that is known."""
    mechanism = plan.laid.mechanism
    poses: list[LaidPoses] = [plan.poses] if plan.way is None else [plan.poses, plan.way]
    guided = {slide.slider for slide in mechanism.slides if slide.owner == FRAME}
    still = {name for link in {FRAME, mechanism.drive.link, *guided} for name in mechanism.links[link].points}
    for name in sorted({name for link in mechanism.links.values() for name in link.points} - still):
        yield name, [one.point(name) for one in poses]
    for name, (link, own) in plan.laid.centres.items():
        if link not in guided:
            yield name, [one.on(link, own) for one in poses]


def _all_known(plan: LaidPlan, drawn: Segments, arcs: list[Arc], within: float) -> bool:
    """Tell whether all that is drawn is the path of some point."""
    rows = [np.append(row[-1], row[-1][:1]) for _, row in _traced(plan)]
    known = Segments.joined([Segments(row[:-1], row[1:]) for row in rows])
    bent = (float(np.nanmax(np.abs(np.diff(row, 2)), initial=0.0)) for row in rows)
    ends = [spot for arc in arcs for spot in (arc.at(0.0), arc.at(0.5), arc.at(1.0))]
    spots = np.array([*{*ends, *drawn.starts.tolist(), *drawn.ends.tolist()}])
    within += max(bent, default=0.0) / SAG
    return bool((known.nearest(spots, within) <= within).all())
