"""The self-check of the symbols of pairs on a plan of positions: hinges, stands, blocks, mass centres (обозначения)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from drawings.checks.linkage.bars import SHOWN
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.laid_poses import Segments
from drawings.checks.linkage.position_marks import named
from drawings.checks.standing import ROUNDED, stands
from drawings.checks.wrong import on
from drawings.figures.linkage.masses import is_centre
from drawings.paper.strokes import Circle, Fill, Polyline, Stroke
from drawings.paper.walk import flat
from drawings.symbols.symbols import BLOCK, DOUBLE, HINGE, SLOT, STONE
from plans.model.mechanism import FRAME, Slide
from plans.model.order import POSITIONS
from plans.words.words import Message

PAIRS = "pairs"  # the name of the group of hinges and stands
QUARTERS = 2  # of a mass centre that are filled
CORNERS = 4  # of a block; a slot about a pin has more
ALIKE = 0.02  # share by which the sides of a block may be off: its corners are rounded


def faults(plan: LaidPlan) -> Iterator[Message]:
    """See that all symbols are there, and that no line stands among them."""
    yield from symbols(plan)
    yield from _beside_stands(plan, plan.lines(PAIRS))


def symbols(plan: LaidPlan) -> Iterator[Message]:
    """See that each pair of the shown position has its symbol at its place, and each mass centre its own."""
    drawn = [one for group in named(plan.leaf, PAIRS) for one in flat((group,))]
    mechanism, k = plan.laid.mechanism, plan.position
    lines, places = plan.lines(PAIRS), _places(plan)
    for name in sorted({name for link in mechanism.links.values() for name in link.points}):
        spot = complex(plan.poses.point(name)[k])
        if not math.isnan(spot.real):
            circles, fills = _at(drawn, spot, plan.near)
            joined = len(mechanism.hinges.get(name, ()))
            alone = sum(abs(spot - other) <= DOUBLE[0] for other in places) == 1
            if not (_is_symbol(circles, fills, joined, is_centre(name)) if alone else circles):
                yield on("symbol", POSITIONS.plan, name=name)
            elif joined and name in mechanism.links[FRAME].points:
                yield from _on_stand(name, spot, circles, joined, lines)
    for name, (link, own) in plan.laid.centres.items():
        spot = plan.laid.on(link, own)
        alone = sum(abs(spot - other) <= DOUBLE[0] for other in places) == 1
        if not math.isnan(spot.real) and alone and not _is_symbol(*_at(drawn, spot, plan.near), 0, True):
            yield on("symbol", POSITIONS.plan, name=name)
    yield from _blocks(plan)


def sizes(plan: LaidPlan) -> Iterator[float]:
    """Give the factor of the sizes of symbols by each hinge; one that stands on another may tell a larger one."""
    drawn = [one for one in plan.strokes(PAIRS) if isinstance(one, Circle) and one.style.width > 0]
    rings = [one for one in drawn if one.style.fill != "none"]
    for name, links in plan.laid.mechanism.hinges.items():
        spot = complex(plan.poses.point(name)[plan.position])
        own = [one.radius for one in rings if abs(one.centre - spot) <= plan.near]
        if own:
            yield max(own) / (HINGE if len(links) < 3 else DOUBLE[0])


def _places(plan: LaidPlan) -> list[complex]:
    """Give the places of all points and mass centres: symbols that fall on one place are not told apart."""
    points = sorted({name for link in plan.laid.mechanism.links.values() for name in link.points})
    spots = [complex(plan.poses.point(name)[plan.position]) for name in points]
    return [*spots, *(plan.laid.on(link, own) for link, own in plan.laid.centres.values())]


def _at(drawn: list[Stroke], spot: complex, near: float) -> tuple[list[Circle], list[Fill]]:
    """Give the circles about a place, and what is filled from it."""
    circles = [one for one in drawn if isinstance(one, Circle) and abs(one.centre - spot) <= near]
    fills = [one for one in drawn if isinstance(one, Fill) and min(abs(p - spot) for p in one.points) <= near]
    return circles, fills


def _is_symbol(circles: list[Circle], fills: list[Fill], joined: int, centre: bool) -> bool:
    """Tell whether circles are a hinge of so many links, a mass centre, or a point that is neither."""
    full = [one for one in circles if one.style.width == 0]
    if joined:
        own = sorted(one.radius for one in circles if one.style.width > 0)
        share = DOUBLE[1] / DOUBLE[0]
        double = len(own) == len(DOUBLE) and abs(own[0] / own[1] - share) <= ALIKE
        return double if joined > 2 else len(own) == 1
    return len(fills) == QUARTERS and len(circles) == 1 if centre else len(full) == len(circles) == 1


def _on_stand(name: str, spot: complex, circles: list[Circle], joined: int, lines: Segments) -> Iterator[Message]:
    """See that a fixed hinge has its stand, of the size of its own symbol."""
    size = max(one.radius for one in circles) / (HINGE if joined < 3 else DOUBLE[0])
    if not any(abs(one.size - size) <= ROUNDED for one in stands(lines, spot)):
        yield on("stand", POSITIONS.plan, name=name)


def _beside_stands(plan: LaidPlan, lines: Segments) -> Iterator[Message]:
    """See that among the symbols no line stands but those of stands."""
    mechanism = plan.laid.mechanism
    fixed = {complex(plan.poses.point(name)[plan.position]) for name in mechanism.links[FRAME].points}
    own = [one.own for spot in fixed for one in stands(lines, spot)]
    if len(lines.starts) and not np.any([np.zeros(len(lines.starts), dtype=bool), *own], axis=0).all():
        yield on("line", POSITIONS.plan)


def _blocks(plan: LaidPlan) -> Iterator[Message]:
    """See that each slide has a block, a stone or a slot about its pin, along its line; and that no other stands."""
    outlines = [one for one in plan.strokes(SHOWN) if isinstance(one, Polyline) and one.closed]
    slides = [one for one in plan.laid.mechanism.slides if np.isfinite(plan.poses.block(one)[plan.position])]
    for slide in slides:
        if not any(_is_block(plan, slide, one) for one in outlines):
            yield on("symbol", POSITIONS.plan, name=f"{slide.slider}-{slide.owner}")
    if len(outlines) != len(slides):
        yield on("symbol", POSITIONS.plan, name=str(len(outlines)))


def _is_block(plan: LaidPlan, slide: Slide, outline: Polyline) -> bool:
    """Tell whether an outline is the symbol of a slide, about its place and along its line."""
    spot, way = complex(plan.poses.block(slide)[plan.position]), complex(plan.poses.way(slide)[plan.position])
    own = (np.array(outline.points) - spot) * np.conj(way)
    high, wide = np.abs(own.real).max(), np.abs(own.imag).max()
    even = abs(own.sum()) / len(own) <= plan.near
    kinds = (BLOCK,) if slide.owner == FRAME else (STONE, (SLOT[0], 2 * SLOT[1]))
    cornered = len(own) > CORNERS or bool((np.abs(np.abs(own.imag) - wide) <= ROUNDED).all())
    return (
        even and cornered and any(abs(high / wide - along / across) <= ALIKE * high / wide for along, across in kinds)
    )
