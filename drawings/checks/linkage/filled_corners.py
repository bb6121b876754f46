"""The self-check of the rigid corners of links: which the analysis has, on a plan of positions (жёсткие углы)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TypeAlias

import numpy as np

from drawings.checks.arrowheads import FINE
from drawings.checks.linkage.bars import SHOWN
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.link_bars import bars, flat, hanging
from drawings.checks.linkage.pair_symbols import PAIRS, sizes
from drawings.checks.rigid_corners import Corner, Corners, around, between, welded
from drawings.checks.wrong import on
from drawings.paper.strokes import Circle, Fill, Polyline
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.order import POSITIONS
from plans.words.words import Message

Placed: TypeAlias = Callable[[int, complex], complex]
Blocks: TypeAlias = Mapping[Slide, Sequence[Polyline]]  # what stands at the place of each slide
FAR = 1e3  # mm: a slot may go on as far as the paper


def faults(plan: LaidPlan) -> Iterator[Message]:
    """See that each rigid corner of the shown position is filled, and nothing else."""
    mechanism, k = plan.laid.mechanism, plan.position
    strokes = plan.strokes(SHOWN)
    rings = [
        one
        for one in plan.strokes(PAIRS)
        if isinstance(one, Circle) and one.style.width > 0 and one.style.fill != "none"
    ]
    size = min(sizes(plan), default=None)
    if size is None:
        return
    chains = [one for one in strokes if isinstance(one, Polyline) and one.closed]
    spots = {one: complex(plan.poses.block(one)[k]) for one in mechanism.slides}
    blocks = {one: [own for own in chains if centred(own, spot)] for one, spot in spots.items()}
    moving = [link for link in mechanism.links if link != FRAME]
    due = [one for link in moving for one in corners_of(mechanism, link, plan.laid.on, blocks)]
    fills = [one for one in strokes if isinstance(one, Fill)]
    held = Corners([one for one in due if np.isfinite(one.at)], fills, rings, size, True)
    if held.missing() or held.stray():
        yield on("rigid", POSITIONS.plan)


def centred(block: Polyline, spot: complex) -> bool:
    """Tell whether the symbol of a slide is about a place."""
    return abs(sum(block.points) / len(block.points) - spot) <= FINE


def corners_of(mechanism: Mechanism, link: int, on_paper: Placed, blocks: Blocks) -> Iterator[Corner]:
    """Give the corners of a link on paper: those about its points, those of its slots, those where it leaves blocks."""
    own = [(on_paper(link, start), on_paper(link, end)) for start, end in bars(mechanism, link)]
    if len(own) > 1:
        yield from around([start for start, _ in own])
    lines, slots = list(own), [_slot(slide, link, on_paper) for slide in mechanism.slides if slide.owner == link]
    for slide in mechanism.slides:
        if slide.owner == link and not any(flat(slide, ends) for ends in bars(mechanism, link)):
            point, foot = (on_paper(link, spot) for spot in hanging(mechanism, slide))
            yield from between(foot, [*_slot(slide, link, on_paper), point, *_ends(own, foot)])
        if slide.slider == link:
            pin, foot = _rod(mechanism, slide, on_paper)
            yield from between(pin, [foot, *_ends([*lines, *slots], pin)])
            lines.append((pin, foot))
    for slide in (one for one in mechanism.slides if one.slider == link):
        for block in blocks[slide]:
            alone = len(blocks[slide]) == 1
            found = [corner for line in lines if line[0] != line[1] for corner in welded(*line, block.points)]
            yield from (one._replace(due=one.due and alone) for one in found)
            yield from (one._replace(due=False) for line in slots for one in welded(*line, block.points))


def _slot(slide: Slide, link: int, on_paper: Placed) -> tuple[complex, complex]:
    """Give a slot's line, as far as it may go."""
    through, ahead = (on_paper(link, slide.on_owner.through + k * slide.on_owner.direction) for k in (0, 1))
    far = FAR * (ahead - through) / abs(ahead - through)
    return through - far, through + far


def _rod(mechanism: Mechanism, slide: Slide, on_paper: Placed) -> tuple[complex, complex]:
    """Give the rod to a block off its point: from the point to its foot on the slide's line."""
    way, pin = slide.on_slider, mechanism.links[slide.slider].points[slide.point]
    off = ((pin - way.through) / way.direction).imag
    return on_paper(slide.slider, pin), on_paper(slide.slider, pin - 1j * off * way.direction)


def _ends(lines: Sequence[tuple[complex, complex]], spot: complex) -> Iterator[complex]:
    """Give the ends of the lines that go through a place, or whose line does."""
    for start, end in lines:
        if abs(((spot - start) * (end - start).conjugate()).imag) <= FINE * abs(end - start):
            yield from (start, end)
