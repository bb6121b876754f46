"""The self-check of the guides of the frame on a plan of positions: axes, ticks, ground (направляющие)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.laid_poses import Segments
from drawings.checks.standing import hatching
from drawings.checks.wrong import on
from drawings.symbols.symbols import BLOCK, HATCH, TICK
from plans.model.mechanism import FRAME, Slide
from plans.model.motion import Complexes
from plans.model.order import POSITIONS
from plans.words.words import Message

AXES, GROUNDS = "guides", "grounds"  # the names of their groups
SHARES = np.linspace(0.0, 1.0, 17)  # of a block's travel, where its axis is looked for
PAST = 17.0  # mm of an axis past the outermost places of its block
HATCHES = 2  # lines of hatching that a ground has at the least
HALF = 14.5  # mm: half the length of a ground


def faults(plan: LaidPlan) -> Iterator[Message]:
    """See that each guide of the frame has its axis, a tick at each place of its block, and ground beside it."""
    slides = [slide for slide in plan.laid.mechanism.slides if slide.owner == FRAME]
    drawn, grounds = plan.lines(AXES), plan.lines(GROUNDS)
    known = [axis_of(plan, slide) for slide in slides]
    for slide, axis in zip(slides, known, strict=True):
        whole = axis.at(SHARES).ravel()
        due = plan.clear(whole) & (drawn.nearest(whole) > plan.near)
        if due.any() or not _ticked(plan, slide, drawn):
            yield on("guide", POSITIONS.plan, name=slide.point)
        if not grounded(plan, slide, grounds):
            yield on("ground", POSITIONS.plan, name=slide.point)
    ticks = Segments.joined([_ticks(plan, slide) for slide in slides])
    if not (Segments.joined([*map(partial(lengthened, plan), slides), ticks]).holds(drawn, plan.near)).all():
        yield on("line", POSITIONS.plan)


def axis_of(plan: LaidPlan, slide: Slide) -> Segments:
    """Give the travel of a block on paper."""
    way, through = slide.on_owner.direction, complex(plan.poses.on(FRAME, slide.on_owner.through)[0])
    low, high = plan.travel(slide)
    return Segments(np.array([through + low * way]), np.array([through + high * way]))


def lengthened(plan: LaidPlan, slide: Slide) -> Segments:
    """Give an axis as far as it may be drawn; how far blocks come is known where the crank turns freely."""
    axis, past = axis_of(plan, slide), PAST if plan.way is not None else plan.leaf.width
    more = past * slide.on_owner.direction
    return Segments(axis.starts - more, axis.ends + more)


def _ticks(plan: LaidPlan, slide: Slide) -> Segments:
    """Give ticks as long as they are drawn at the most, at all places of a block."""
    across, spots = 1j * slide.on_owner.direction * TICK, plan.poses.block(slide)
    return Segments(spots - across, spots + across).known()


def _ticked(plan: LaidPlan, slide: Slide, drawn: Segments) -> bool:
    """Tell whether a tick stands across the guide at each place of the block that is clear of symbols."""
    spots = plan.poses.block(slide)
    runs = drawn.ends - drawn.starts
    square = np.abs((runs * np.conj(slide.on_owner.direction)).real) <= plan.near
    middles = ((drawn.starts + drawn.ends) / 2)[square]
    due = spots[plan.clear(spots)]
    if not due.size:
        return True
    return bool(middles.size and (np.abs(due[:, None] - middles).min(axis=1) <= plan.near).all())


def grounded(plan: LaidPlan, slide: Slide, drawn: Segments) -> bool:
    """Tell whether ground stands along the shown block, hatched on the side away from it."""
    way, spot = slide.on_owner.direction, complex(plan.poses.block(slide)[plan.position])
    if not np.isfinite(spot):
        return True
    ends = np.array([(one - spot) * np.conj(way) for one in drawn]).reshape(2, -1)
    level, runs = ends.imag, ends[1] - ends[0]
    flat = (np.abs(runs.imag) <= plan.near) & (np.abs(ends.real).min(axis=0) <= HALF)
    based = flat & (np.abs(level[0]) <= BLOCK[1] / 2 + plan.near) & (np.abs(level[0]) > plan.near)
    hatched = _covered if _overlaid(plan, slide, spot) else _whole
    return any(hatched(plan, ends, int(k)) for k in np.flatnonzero(based))


def _overlaid(plan: LaidPlan, slide: Slide, spot: complex) -> bool:
    """Tell whether the block of another slide may hide some of the ground."""
    others = (plan.poses.block(one)[plan.position] for one in plan.laid.mechanism.slides if one is not slide)
    return any(abs(other - spot) <= HALF + abs(complex(*BLOCK)) + HATCH for other in others)


def _whole(plan: LaidPlan, ends: Complexes, base: int) -> bool:
    """Tell whether a base is hatched from end to end, by lines as its length has room for; along it, from the block."""
    start, end = (complex(one) for one in ends[:, base])
    size = abs(start.imag) / (BLOCK[1] / 2)
    return hatching(Segments(ends[0], ends[1]), start, end, 1j * start.imag, size) is not None


def _covered(plan: LaidPlan, ends: Complexes, base: int) -> bool:
    """Tell whether a base that another block hides some of is hatched."""
    level = float(ends[0, base].imag)
    feet = np.abs(ends.imag - level).min(axis=0) <= plan.near
    into = np.abs(ends.imag - level).max(axis=0)
    near = np.abs(ends.real).max(axis=0) <= HALF + HATCH
    return int((feet & (into > plan.near) & (into <= HATCH) & near).sum()) >= HATCHES
