"""Leads of groups: links that turn about a hinge or slide along a guide of their host (поводки, направляющие)."""

from __future__ import annotations

import sys
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator
from typing import Any, Generic, TypeVar

import numpy as np

from geometry.board import Mark, Reading
from geometry.branch import Side
from plans.linkage.plan import Image, Plan, Sliding, Turning, Vector
from plans.model.dyad import Dyad
from plans.model.mechanism import FRAME, Slide
from plans.model.motion import Floats
from plans.words.words import Message, because

Of = TypeVar("Of")  # what groups of the kind are, such as dyads


class GroupKind(ABC, Generic[Of]):
    """What is special to one kind of group."""

    assemblies = 2  # that its position has at most (сборки)
    branched = False  # whether an assembly is followed along a branch, beyond whose end no side tells of another
    pivoted = False  # whether its meeting is the direction of a slot from a pivot, any where the pin comes to it

    def sides(self, plan: Plan, group: Of) -> list[Side]:
        """Give the sides that its assemblies may have at the positions of a plan."""
        return [1.0, -1.0]

    def followed(self, look: Callable[[Floats], Plan], group: Of, side: Side, home: float) -> Side:
        """Give what its assembly at a crank angle is over all; `look` draws what it hangs on, at any of them, rad."""
        return side

    def jammed(self, plan: Plan, group: Of) -> Message | None:
        """Say that its leads jam in the one position of a plan, where they meet their lengths as the sketch shows."""
        return None

    @abstractmethod
    def positions(self, plan: Plan, group: Of, side: Any) -> None:
        """Place its links on the plan of positions, on a side of its meeting."""

    @abstractmethod
    def velocities(self, plan: Plan, group: Of) -> None:
        """Draw its part of the velocity plan."""

    @abstractmethod
    def accelerations(self, plan: Plan, group: Of) -> None:
        """Draw its part of the acceleration plan."""

    @abstractmethod
    def meeting(self, plan: Plan, group: Of) -> Mark:
        """Give its meeting on the plan of positions: where that fails, the group bars the crank."""

    @abstractmethod
    def vectors(self, group: Of) -> Iterable[Vector]:
        """Tell the vectors that its plans must have, beside those of its points."""

    @abstractmethod
    def pressure(self, plan: Plan, group: Of) -> Floats:
        """Read its signed pressure angle, (N,) rad, off the plan of positions."""

    def extremes(self, plan: Plan, group: Of, side: Any) -> list[Mark]:
        """Give the crank's end in both extremes of the link that it drives, of a group between crank and frame."""
        return []


# Meets an arc about the crank's pivot, on a side, with what guides the inner pin; the third is the name of the meeting.
EQUAL = 4 * sys.float_info.epsilon  # of two lengths: what the roundings of their squares and roots leave
Notch = Callable[[Mark, float, str], Mark]


def crank_end(plan: Plan, dyad: Dyad) -> int:
    """Tell by which of its two leads a group hangs on the crank."""
    return dyad.hosts.index(plan.mechanism.drive.link)


def pin(plan: Plan, dyad: Dyad) -> complex:
    """Give the vector from the crank's pivot to the pin that a group hangs on, in the crank's own frame, m."""
    points, drive = plan.mechanism.links[plan.mechanism.drive.link].points, plan.mechanism.drive
    return points[dyad.hinge(crank_end(plan, dyad))] - points[drive.pivot]


def end(plan: Plan) -> complex:
    """Give the vector from the crank's pivot to its end, in the crank's own frame, m."""
    points, drive = plan.mechanism.links[plan.mechanism.drive.link].points, plan.mechanism.drive
    return points[drive.end] - points[drive.pivot]


def extremes(plan: Plan, dyad: Dyad, side: float, notch: Notch) -> list[Mark]:
    """Notch the crank and the coupler in one line: |l2 + l1| and |l2 - l1| from O; of equal ones none is folded."""
    board, drive = plan.board, plan.mechanism.drive
    pivot, name = plan.point(drive.pivot), dyad.pin
    near, far = abs(pin(plan, dyad)), abs(vector(plan, dyad, crank_end(plan, dyad)))
    found: list[Mark] = []
    if abs(far - near) <= EQUAL * far:
        return found
    for number, radius in ((1, far + near), (2, abs(far - near))):
        arc = board.arc(f"{pivot.name}{name}_{number}", pivot, radius, because("in_line"))
        # Of the folded pair the coupler points away from O where it is the longer: then B sees A as before.
        flip = -1.0 if number == 2 and far < near else 1.0
        b = notch(arc, side * flip, f"{name}_{number}")
        ray = board.join(f"{pivot.name}{b.name}", pivot, b)
        sense = flip if number == 2 else -1.0
        by = -sense * near / radius * (end(plan) / pin(plan, dyad))
        arm = board.turn(f"{pivot.name}{drive.end}_{number}", ray, by, because("crank_on_line"))
        found.append(board.lay_off(f"{drive.end}_{number}", pivot, arm, because("extreme", number=number)))
    return found


def vector(plan: Plan, dyad: Dyad, end: int) -> complex:
    """Give the vector from a lead's outer hinge to the inner one in the link's own frame."""
    points = plan.mechanism.links[dyad.links[end]].points
    return points[dyad.pin] - points[dyad.hinge(end)]


def outer_hinges(plan: Plan, dyad: Dyad) -> tuple[Mark, Mark]:
    """Give the outer hinges of a group that has two."""
    return plan.point(dyad.hinge(0)), plan.point(dyad.hinge(1))


def turning(dyad: Dyad, end: int) -> Turning:
    """Tell the vectors of the plans that a lead's turning about its outer hinge gives."""
    return Turning(dyad.links[end], dyad.hinge(end), dyad.pin)


def arm(plan: Plan, link: int) -> Mark:
    """Carry a lead's vector from the plan of positions."""
    return plan.carry(plan.arm(link))


def keep_place(plan: Plan, dyad: Dyad, end: int, start: Mark, tip: Mark) -> None:
    """Keep a lead of a dyad on the plan of positions."""
    keep_rod(plan, dyad.links[end], (dyad.hinge(end), dyad.pin), (start, tip))


def keep_rod(plan: Plan, link: int, hinges: tuple[str, str], ends: tuple[Mark, Mark]) -> None:
    """Keep a lead on the plan of positions by the vector between its hinges."""
    points, (start, tip) = plan.mechanism.links[link].points, ends
    drawn = plan.board.join(f"{start.name}{tip.name}", start, tip, because("link", link=link))
    plan.images[link] = Image(start, drawn, points[hinges[0]], points[hinges[1]] - points[hinges[0]])


def about(plan: Plan, link: int, start: Mark) -> Mark:
    """Draw the line of a lead's turning part: through a start, square to the lead."""
    along = arm(plan, link)
    return plan.board.square(f"⊥{along.name}", start, along, because("square_turning", line=along.name))


def normal(plan: Plan, link: int, start: Mark, ends: tuple[str, str]) -> Mark:
    """Lay off from an image a lead's normal acceleration, the third proportional v2/l, towards its start (M3.2).

    `ends` are the letters of the lead's start and tip: on the plan a start that translates may share another's image.
    """
    along, turning = arm(plan, link), plan.carry(plan.velocities.readings[link].turning)
    name = plan.written.normal(ends[1], "" if start is plan.pole else ends[0])
    part = plan.board.similar(f"a^{name}", turning, along, turning, why=because("normal", line=along.name))
    return plan.board.lay_off(name, start, part, because("to_centre"))


def meet_directions(plan: Plan, point: str, first: Mark, second: Mark) -> Mark:
    """Meet the two known directions in the image of the inner pair's point."""
    name = plan.letter(point)
    return plan.name(point, plan.board.meet(name, first, second, why=because("both_directions", point=name)))


def keep_turning(plan: Plan, link: int, start: Mark, turning_from: Mark, tip: Mark) -> None:
    """Keep a lead's image from start to tip, and the turning part that its omega or epsilon is read from."""
    base = plan.positions.images[link]
    relative = plan.board.join(f"{start.name}{tip.name}", start, tip)
    plan.images[link] = Image(start, relative, base.at, base.span)
    turning = relative
    if turning_from is not start:
        turning = plan.board.join(f"{turning_from.name}{tip.name}", turning_from, tip, because("tangential"))
    plan.readings[link] = Reading(arm(plan, link), turning)


def key(slide: Slide) -> tuple[int, int]:
    """Name a sliding pair by its two links."""
    return slide.slider, slide.owner


def offset(plan: Plan, slide: Slide, link: int, point: str) -> float:
    """Measure how far to the left of the link's own sliding line a point of a link lies, metres."""
    way = slide.way(link)
    return ((plan.mechanism.links[link].points[point] - way.through) / way.direction).imag


def unit(plan: Plan, slide: Slide, host: int) -> Mark | None:
    """Give a guide's unit direction, or its image on a plan above; there None means that the guide does not turn."""
    name = key(slide)
    if name not in plan.units:
        plan.units[name] = plan.vector(host, slide.way(host).direction, plan.written.of_link("u", host))
    return plan.units[name]


def direction(plan: Plan, slide: Slide, host: int) -> Mark:
    """Give a guide's unit direction on the plan of positions."""
    unit(plan.positions, slide, host)
    return known_direction(plan, slide)


def known_direction(plan: Plan, slide: Slide) -> Mark:
    """Give the direction of a sliding line that stands on the plan of positions already."""
    direction = plan.positions.units[key(slide)]
    assert direction is not None  # every line has a direction on the plan of positions
    return direction


def crossing(plan: Plan, first: Slide, second: Slide) -> Floats:
    """Give 90 degrees less the angle between the sliding lines of a group with two of them, (N,) rad."""
    turned = np.asarray(known_direction(plan, first).point) / np.asarray(known_direction(plan, second).point)
    return np.asarray(np.arctan2(turned.real, np.abs(turned.imag)))


def shift(plan: Plan, through: Mark, along: Mark, left: float, name: str) -> Mark:
    """Draw the line through a point along a unit direction, shifted to the left by a distance."""
    board = plan.board
    if left != 0:
        step = board.turn(f"h {name}", along, 1j * left, because("offset"))
        through = board.lay_off(f"{through.name}'", through, step, because("line_offset"))
    return board.parallel(name, through, along, because("distance"))


def line(plan: Plan, slide: Slide, host: int, left: float) -> Mark:
    """Draw on the plan of positions the line that a pin `left` of a host's guide runs along."""
    through = plan.place(host, slide.way(host).through, f"K{slide.slider}")
    return shift(plan, through, direction(plan, slide, host), left, f"guide of {slide.point}")


def sliding_line(plan: Plan, slide: Slide, host: int, over: Mark) -> Mark:
    """Draw on a velocity plan the line of a pin's velocity over a guide: from the guide's own point, along it."""
    along = plan.carry(direction(plan, slide, host))
    return plan.board.parallel(f"∥{along.name}", sliding_start(plan, host, over), along, because("along_guide"))


def sliding_start(plan: Plan, host: int, over: Mark) -> Mark:
    """Give the image of the host's point that lies under a pin."""
    return plan.transport(host, over, plan.written.under(over.name, host))


def slip(plan: Plan, slide: Slide, along: Mark, end: Mark, over: tuple[str, int]) -> Mark:
    """Keep the velocity of a pin along its guide: from the start of the line `along` to its end (относительная).

    The slip is `over` a host: the pin, and the host's number.
    """
    start = along.step.inputs[0]
    found = plan.board.join(f"{start.name}{end.name}", start, end, because("slip"))
    plan.slips[key(slide)] = found
    plan.written.slides(key(slide), *over)
    return found


def coriolis_line(plan: Plan, slide: Slide, host: int, over: Mark) -> Mark:
    """Draw on an acceleration plan the line of a pin's acceleration over a guide: its point, Coriolis, along it."""
    start, along = coriolis_start(plan, slide, host, over), direction(plan, slide, host)
    return plan.board.parallel(f"∥{along.name}", start, plan.carry(along), because("along_guide"))


def coriolis_start(plan: Plan, slide: Slide, host: int, over: Mark) -> Mark:
    """Lay the Coriolis part off from the image of the host's point that lies under a pin."""
    start, along = sliding_start(plan, host, over), direction(plan, slide, host)
    name = plan.written.coriolis(over.name, host, key(slide))
    return coriolis(plan, slide, start, along, unit(plan.velocities, slide, host), name)


def coriolis(plan: Plan, slide: Slide, start: Mark, along: Mark, turned: Mark | None, name: str) -> Mark:
    """Lay off the Coriolis acceleration: the slip turned 90 degrees with the guide, 2 omega times (правило Жуковского).

    `turned` is the image of the guide's direction on the velocity plan; a guide that does not turn adds nothing.
    """
    if turned is None:
        return start
    carried = [plan.carry(turned), plan.carry(along), plan.carry(plan.velocities.slips[key(slide)])]
    part = plan.board.similar(f"a^{name}", carried[0], carried[1], carried[2], 2.0, because("slip_turned"))
    return plan.board.lay_off(name, start, part, because("coriolis"))


def sliding(dyad: Dyad, end: int) -> Iterator[Sliding]:
    """Tell the vectors of a pin that slides on a host which moves; over the frame its own are all that it has."""
    if dyad.hosts[end] != FRAME:
        yield Sliding(key(dyad.slide(end)), dyad.hosts[end], dyad.pin)


def ride(plan: Plan, dyad: Dyad, end: int, origin: Mark, at: complex) -> None:
    """Keep the image of a lead of a dyad that slides on its host."""
    ride_on(plan, dyad.links[end], dyad.hosts[end], dyad.slide(end), (origin, at))


def ride_on(plan: Plan, link: int, host: int, slide: Slide, point: tuple[Mark, complex]) -> None:
    """Keep the image of a link that slides on another: it turns as that does, and is read as that is.

    `point` is the image of one of its points, and the place of this in its own frame.
    """
    origin, at = point
    plan.images[link] = Image(origin, unit(plan, slide, host), at, slide.way(link).direction)
    if host in plan.readings:
        plan.readings[link] = plan.readings[host]
