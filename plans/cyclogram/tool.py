"""The tool on its way (инструмент): laid off along its guide, or on its arc, from where the working stroke begins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from geometry.board import Mark
from geometry.meet import Sizes, cross, dot
from plans.linkage import leads
from plans.linkage.plan import Image, Plan
from plans.linkage.travel import frame_slide
from plans.model.cyclogram import Watched
from plans.model.dyad import Assur, Dyad
from plans.model.mechanism import FRAME, Mechanism, Output, Slide
from plans.model.motion import Floats
from plans.words.words import because


class Notch(NamedTuple):
    """A group to go back through: which of its ends hangs on the host that is found, and the host's pivot."""

    dyad: Dyad
    end: int
    pivot: str

    @property
    def host(self) -> int:
        """The link that is found."""
        return self.dyad.hosts[self.end]

    @property
    def pin(self) -> str:
        """The hinge by which the group hangs on it."""
        return self.dyad.hinge(self.end)


def way_back(mechanism: Mechanism, groups: Sequence[Assur], link: int) -> tuple[Notch, ...] | None:
    """Give the groups from a link back to the crank; None where some link on the way turns about no fixed pivot."""
    way: list[Notch] = []
    while link != mechanism.drive.link:
        notch = next((found for group in groups if (found := notch_of(mechanism, group, link))), None)
        if notch is None:
            return None
        way.append(notch)
        link = notch.host
    return tuple(way)


def notch_of(mechanism: Mechanism, group: Assur, link: int) -> Notch | None:
    """Give how a group is gone through from one of its links that hangs on the frame; None where it cannot be."""
    if not isinstance(group, Dyad) or link not in group.links:
        return None
    end = 1 - group.links.index(link)
    pivot = pivot_of(mechanism, group.hosts[end])
    plain = group.hosts[1 - end] == FRAME and isinstance(group.outer[end], str) and pivot is not None
    return Notch(group, end, pivot) if plain and pivot is not None else None


def pivot_of(mechanism: Mechanism, link: int) -> str | None:
    """Give the fixed hinge that a link turns about, if it has one."""
    fixed = mechanism.links[FRAME].points
    return next((name for name in mechanism.links[link].points if link != FRAME and name in fixed), None)


def go_back(plan: Plan, way: Sequence[Notch], there: Plan) -> Mark:
    """Notch from what stands on the plan back to the crank; its vector from pivot to end.

    `there` is the plan of the linkage near each of the positions: it tells on which side the meetings are.
    """
    for notch in way:
        found = _by_line(plan, notch, there) if isinstance(notch.dyad.inner, Slide) else _by_arc(plan, notch, there)
        keep(plan, notch.host, notch.pivot, plan.name(notch.pin, found))
    drive = plan.mechanism.drive
    points = plan.mechanism.links[drive.link].points
    arm = plan.vector(drive.link, points[drive.end] - points[drive.pivot], f"{drive.pivot}{drive.end}")
    assert arm is not None  # a crank turns
    if drive.end not in plan.letters:
        end = plan.board.lay_off(drive.end, plan.point(drive.pivot), arm, because("crank_there"))
        plan.name(drive.end, end)
    return arm


def keep(plan: Plan, link: int, pivot: str, pin: Mark) -> None:
    """Keep a link by the vector from its fixed hinge to a pin of it."""
    points = plan.mechanism.links[link].points
    start = plan.point(pivot)
    arm = plan.board.join(f"{pivot}{pin.name}", start, pin, because("link", link=link))
    plan.images[link] = Image(start, arm, points[pivot], points[pin.name] - points[pivot])


def circle(plan: Plan, link: int, pivot: str, pin: str) -> Mark:
    """Strike the arc that a pin of a link describes about the link's fixed hinge."""
    points = plan.mechanism.links[link].points
    why = because("pin_circle", point=pin, link=link)
    return plan.board.arc(f"{pivot}{pin}", plan.point(pivot), abs(points[pin] - points[pivot]), why)


def _by_arc(plan: Plan, notch: Notch, there: Plan) -> Mark:
    """Notch the rod's length from its known hinge on the arc that its other hinge describes."""
    dyad, pin = notch.dyad, notch.pin
    known = plan.point(dyad.pin)
    points = plan.mechanism.links[dyad.links[notch.end]].points
    rod = plan.board.arc(f"{dyad.pin}{pin}", known, abs(points[pin] - points[dyad.pin]), f"|{dyad.pin}{pin}|")
    centre, end, start = (np.asarray(there.point(name).point) for name in (notch.pivot, pin, dyad.pin))
    side = np.sign(cross(centre - start, end - start))
    why = because("notched_back", point=pin, start=dyad.pin)
    return plan.board.meet(pin, rod, circle(plan, notch.host, notch.pivot, pin), side, why)


def _by_line(plan: Plan, notch: Notch, there: Plan) -> Mark:
    """Meet the slot with the arc that the pin in it describes: far from the slot's pivot, or near it."""
    dyad, pin = notch.dyad, notch.pin
    slide, driven = dyad.slide(), dyad.links[1 - notch.end]
    left = leads.offset(plan, slide, dyad.links[notch.end], pin)
    slot = leads.line(plan, slide, driven, left)
    along = np.asarray(there.units[leads.key(slide)].point)  # type: ignore[union-attr]  # a plan of positions has all
    centre, end = (np.asarray(there.point(name).point) for name in (notch.pivot, pin))
    side: Sizes = np.sign(dot(along, end - centre))
    why = because("slot_back", point=pin, link=driven)
    return plan.board.meet(pin, slot, circle(plan, notch.host, notch.pivot, pin), side, why)


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
    first = plan.board.given(f"{name}_0", path.ends[0], because("tool_begin", point=name))
    last = plan.board.given(f"{name}_H", path.ends[1], because("tool_end", point=name))
    stroke = plan.board.join("H", first, last, because("tool_stroke"))
    gone = plan.board.turn(f"S_{name}", stroke, shares + 0j, because("tool_share"))
    mark = plan.name(name, plan.board.lay_off(name, first, gone, because("tool_place", point=name)))
    local = plan.mechanism.links[out.link].points[name]
    plan.images[out.link] = Image(mark, leads.unit(plan, slide, FRAME), local, slide.way(out.link).direction)
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


class ToolWatch(NamedTuple):
    """A group whose pressure angle is watched: how it hangs on a link with a fixed pivot, and the way from there."""

    notch: Notch
    way: tuple[Notch, ...]

    @property
    def dyad(self) -> Dyad:
        """The group."""
        return self.notch.dyad

    @property
    def watched(self) -> Watched:
        """What of it is watched: the link on the host first."""
        dyad, end = self.dyad, self.notch.end
        links = dyad.links[end], dyad.links[1 - end]
        joint = dyad.outer[1 - end]
        if isinstance(joint, Slide):
            return Watched(links, dyad.pin, (self.notch.pin, ""), joint.way(FRAME))
        return Watched(links, dyad.pin, (self.notch.pin, joint))


def watch_of(mechanism: Mechanism, groups: Sequence[Assur]) -> ToolWatch | None:
    """Give the first group of a rod with a rocker or a slider on the frame that can be notched; or none."""
    for group in groups:
        links = group.links if isinstance(group, Dyad) and isinstance(group.inner, str) else ()
        notch = next((found for link in links if (found := notch_of(mechanism, group, link))), None)
        way = way_back(mechanism, groups, notch.host) if notch else None
        if notch is not None and way is not None:
            return ToolWatch(notch, way)
    return None


def construct(plan: Plan, watch: ToolWatch, there: Plan) -> Mark:
    """Put the pin where the pressure angle is extreme, then notch back; the crank's vector from pivot to end."""
    notch, board = watch.notch, plan.board
    line = _line(plan, watch)
    centre, end = (np.asarray(there.point(name).point) for name in (notch.pivot, notch.pin))
    assert isinstance(line.value, tuple)
    along = line.step.inputs[1].point * (1j if line.step.op == "square" else 1.0)
    arc = circle(plan, notch.host, notch.pivot, notch.pin)
    side = np.sign(dot(along, end - centre))
    found = board.meet(notch.pin, line, arc, side, because("watch_pin", point=notch.pin))
    keep(plan, notch.host, notch.pivot, plan.name(notch.pin, found))
    return go_back(plan, watch.way, there)


def _line(plan: Plan, watch: ToolWatch) -> Mark:
    """Draw through the host's pivot the line on which the pin stands in its farthest places."""
    notch, joint = watch.notch, watch.dyad.outer[1 - watch.notch.end]
    pivot = plan.point(notch.pivot)
    if isinstance(joint, Slide):
        way = leads.direction(plan, joint, FRAME)
        return plan.board.square(f"⊥ {notch.pivot}", pivot, way, because("watch_square"))
    fixed = plan.board.join(f"{notch.pivot}{joint}", pivot, plan.point(joint), because("watch_fixed"))
    return plan.board.parallel(f"{notch.pivot}{joint}", pivot, fixed, because("watch_line"))
