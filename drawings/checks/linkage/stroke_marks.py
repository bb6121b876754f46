"""The self-check of a primary link that slides: the division of its stroke, the arrows of how it is pushed (ход)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from drawings.checks.letters import NEAREST, distance, labels_of
from drawings.checks.linkage.laid import LaidMechanism
from drawings.checks.linkage.position_marks import EXACT, named
from drawings.checks.wrong import on
from drawings.figures.linkage.position_plan import OTHERS, ROTATION
from drawings.page.page import page_of
from drawings.paper.strokes import Leaf, Line
from drawings.symbols.symbols import BLOCK, TICK
from plans.linkage.travel import frame_slide
from plans.model.order import POSITIONS
from plans.words.words import Message

SQUARE = 1e-3  # rad by which a tick or an arrow may lean: ends that are rounded on so short a line


def faults(leaf: Leaf, laid: LaidMechanism) -> Iterator[Message]:
    """Hold the ticks of the stroke and both arrows against the analysis."""
    yield from _ticks(leaf, laid)
    yield from _arrows(leaf, laid)


def _along(laid: LaidMechanism) -> complex:
    slide = frame_slide(laid.mechanism, laid.mechanism.drive.link)
    assert slide is not None  # it is what drives
    return slide.on_owner.direction


def _ticks(leaf: Leaf, laid: LaidMechanism) -> Iterator[Message]:
    """See that every tick on the stroke stands at a position, and that no position but what a pair covers lacks one."""
    places = laid.motion.points[laid.mechanism.drive.end].r
    due = {k: laid.at.on(complex(place)) for k, place in enumerate(places) if not math.isnan(place.real)}
    lines = [line for group in named(leaf, OTHERS) for line in group.strokes if isinstance(line, Line)]
    middles = [(line.start + line.end) / 2 for line in lines if _is_tick(line, laid)]
    near = {k: min((abs(middle - spot) for middle in middles), default=math.inf) for k, spot in due.items()}
    ends = [end for line in lines if _is_along(line, laid) for end in (line.start, line.end)]
    for k in {0, len(places) - 1} & due.keys():
        hidden = abs(complex(*BLOCK)) if _covered(due[k], laid) else 0.0  # a line ends where the shown block does
        if not min((abs(end - due[k]) for end in ends), default=math.inf) <= EXACT + hidden:
            yield on("line", POSITIONS.plan)
    for k, spot in due.items():
        if near[k] > EXACT and not _covered(spot, laid):
            yield on("missing_at", POSITIONS.plan, name=laid.mechanism.drive.end, position=k)


def _covered(spot: complex, laid: LaidMechanism) -> bool:
    """Tell whether a pair of the drawn position may stand before a spot on paper: no symbol is larger than a block."""
    reach = abs(complex(*BLOCK)) / 2 * page_of(laid.study.scene).hand.symbol
    points = (complex(moved.r[laid.position]) for moved in laid.motion.points.values())
    return any(abs(laid.at.on(point) - spot) <= reach for point in points)


def _is_along(line: Line, laid: LaidMechanism) -> bool:
    run = (line.end - line.start) / _along(laid)
    return abs(run.imag) <= SQUARE * abs(run)


def _is_tick(line: Line, laid: LaidMechanism) -> bool:
    run = (line.end - line.start) / _along(laid)
    return abs(run.real) <= SQUARE * abs(run) and abs(run) <= 3 * TICK


def _arrows(leaf: Leaf, laid: LaidMechanism) -> Iterator[Message]:
    """See that there is an arrow for the velocity and for the acceleration of the slider, each the way that it goes."""
    point = laid.motion.points[laid.mechanism.drive.end]
    stated = laid.study.rates.at(laid.position)  # of a rate of zero the analysis leaves a rounding
    told = [complex(row[laid.position]) for row, rate in zip(point[1:], stated, strict=False) if rate]
    lines = [line for group in named(leaf, ROTATION) for line in group.strokes if isinstance(line, Line)]
    senses = [float(np.sign(((line.end - line.start) / _along(laid)).real)) for line in lines]
    labels = labels_of(leaf.groups)
    for symbol, line in zip((symbol for symbol, rate in zip("va", stated, strict=True) if rate), lines, strict=False):
        spots = [line.start, (line.start + line.end) / 2, line.end]
        if not distance(labels.get(f"{symbol}{laid.mechanism.drive.end}", ()), spots) <= NEAREST:
            yield on("letter", POSITIONS.plan, name=f"{symbol}_{laid.mechanism.drive.end}")
    if senses != [float(np.sign((value / _along(laid)).real)) for value in told]:
        yield on("sense", POSITIONS.plan, name=laid.mechanism.drive.end)
