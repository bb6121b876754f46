"""A guide: the line of a host link along which a lead slides, at rest or moving (направляющая)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from geometry.board import Mark
from plans.linkage.groups.vectors import Sliding
from plans.linkage.plan import Image, Plan
from plans.model.dyad import Dyad
from plans.model.mechanism import FRAME, Slide
from plans.model.motion import Floats
from plans.words.words import because


class Offset(NamedTuple):
    """Where a point lies from a line of its own link: `along` it, and `left` of it, metres."""

    along: float
    left: float


def key(slide: Slide) -> tuple[int, int]:
    """Name a sliding pair by its two links."""
    return slide.slider, slide.owner


def offset(plan: Plan, slide: Slide, link: int, point: str) -> Offset:
    """Measure where a point of a link lies from the link's own sliding line."""
    way = slide.way(link)
    place = (plan.mechanism.links[link].points[point] - way.through) / way.direction
    return Offset(place.real, place.imag)


def unit(plan: Plan, slide: Slide, host: int) -> Mark | None:
    """Give a guide's unit direction, or its image on a plan above; there None means that the guide does not turn."""
    name = key(slide)
    if name not in plan.units:
        plan.units[name] = plan.vector(host, slide.way(host).direction, plan.written.own("u", host))
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
    start = plan.transport(host, over, plan.written.under(over.name, host))
    along = plan.carry(direction(plan, slide, host))
    return plan.board.parallel(f"∥{along.name}", start, along, because("along_guide"))


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
    start = plan.transport(host, over, plan.written.under(over.name, host))
    along = direction(plan, slide, host)
    name = plan.written.coriolis(over.name, host, key(slide))
    start = coriolis(plan, slide, start, along, unit(plan.velocities, slide, host), name)
    return plan.board.parallel(f"∥{along.name}", start, plan.carry(along), because("along_guide"))


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
    """Keep the image of a lead that slides on its host: it turns as the host does, and is read as the host is."""
    link, host, slide = dyad.links[end], dyad.hosts[end], dyad.slide(end)
    plan.images[link] = Image(origin, unit(plan, slide, host), at, slide.way(link).direction)
    if host in plan.readings:
        plan.readings[link] = plan.readings[host]
