"""The tool on its way (инструмент): laid off along its guide, or on its arc, from where the working stroke begins."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from geometry.board import Mark
from plans.cyclogram.backwards import circle, pivot_of
from plans.linkage.groups import guide
from plans.linkage.plan import Image, Plan
from plans.linkage.travel import frame_slide
from plans.model.mechanism import FRAME, Mechanism, Output
from plans.model.motion import Floats
from plans.words.words import because


def point_of(mechanism: Mechanism, out: Output) -> str | None:
    """Give the point of the output that shows its places: its own, that of its guide, or its end off the frame."""
    points, slide = mechanism.links[out.link].points, frame_slide(mechanism, out.link)
    fixed = mechanism.links[FRAME].points
    named = (out.point or "", slide.point if slide else "", *reversed(list(points)))
    return next((name for name in named if name in points and name not in fixed), None)


class Path(NamedTuple):
    """The tool's point, its extreme places m, where the working stroke begins first, and the swing rad between them."""

    point: str
    ends: tuple[complex, complex]
    swing: float


def lay_out(plan: Plan, out: Output, path: Path, shares: Floats) -> Mark:
    """Put the tool at shares of its stroke between its extreme places, and keep its link there."""
    name, slide = path.point, frame_slide(plan.mechanism, out.link)
    if slide is None:
        return _on_arc(plan, out, path, shares)
    first = plan.board.given(f"{name}_begin", path.ends[0], because("tool_begin", point=name))
    last = plan.board.given(f"{name}_end", path.ends[1], because("tool_end", point=name))
    stroke = plan.board.join("H", first, last, because("tool_stroke"))
    gone = plan.board.turn(f"S_{name}", stroke, shares + 0j, because("tool_share"))
    mark = plan.name(name, plan.board.lay_off(name, first, gone, because("tool_place", point=name)))
    own = plan.mechanism.links[out.link].points[name]
    plan.images[out.link] = Image(mark, guide.unit(plan, slide, FRAME), own, slide.way(out.link).direction)
    return mark


def _on_arc(plan: Plan, out: Output, path: Path, shares: Floats) -> Mark:
    name, pivot = path.point, pivot_of(plan.mechanism, out.link)
    assert pivot is not None  # an output that swings does so about the frame
    points, centre = plan.mechanism.links[out.link].points, plan.point(pivot)
    first = path.ends[0] - complex(centre.point)
    ways = plan.board.given("ψ", first / abs(first) * np.exp(1j * path.swing * shares), because("tool_swing"))
    arc = circle(plan, out.link, pivot, name)
    mark = plan.name(name, plan.board.divide(name, arc, ways, because("tool_place", point=name)))
    arm = plan.board.join(f"{pivot}{name}", centre, mark, because("link", link=out.link))
    plan.images[out.link] = Image(centre, arm, points[pivot], points[name] - points[pivot])
    return mark
