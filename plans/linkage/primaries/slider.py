"""A slider on the frame that is pushed along: a ram, the rod of a cylinder that stands still (ползун, гидроцилиндр)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from plans.linkage.crank_positions import CrankPositions
from plans.linkage.groups import guide
from plans.linkage.groups.vectors import Vector
from plans.linkage.plan import Image, Plan
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Complexes, Floats, Pace, Rates, stroke_rates
from plans.words.words import Message, because

FREE = "s"


def values(mechanism: Mechanism, turn: CrankPositions) -> Complexes:
    """Give its ways along the guide, (N,) m, as vectors; the circle of all ways is cut half a turn from nothing."""
    drive = mechanism.drive
    ways = drive.unit * (turn.phi - 2 * np.pi * np.round(turn.phi / (2 * np.pi)))
    return np.asarray(ways * pushed(mechanism).way(FRAME).direction)


def pace(mechanism: Mechanism) -> Pace:
    """Give the slider's rates by its law over the stroke, in units of the drive."""
    drive = mechanism.drive

    def rates(phi: Floats) -> Rates:
        speeds = stroke_rates(drive, drive.unit * phi, drive.unit * drive.omega, drive.unit * drive.epsilon)
        return Rates(*(rate / drive.unit for rate in speeds))

    return rates


def ends(mechanism: Mechanism, turn: CrankPositions) -> Complexes:
    """Give the places of its point, (N,) m."""
    slide = pushed(mechanism)
    on, line = slide.on_slider, slide.way(FRAME)
    left = ((mechanism.links[slide.slider].points[slide.point] - on.through) / on.direction).imag
    return np.asarray(line.through + 1j * left * line.direction + values(mechanism, turn))


def pushed(mechanism: Mechanism) -> Slide:
    """Give the slide that is pushed along."""
    slide = mechanism.drive.guide
    assert slide is not None  # it is of the kind of primary link
    return slide


def positions(mechanism: Mechanism, turn: CrankPositions) -> Plan:
    """Start a plan of positions: the guide, and the way of the slider's point laid off on it in every position."""
    plan, slide = Plan("positions", mechanism), pushed(mechanism)
    board, way = plan.board, slide.way(FRAME)
    along, link = guide.direction(plan, slide, FRAME), mechanism.drive.link
    start = plan.place(FRAME, way.through, f"K{link}")
    left = guide.offset(plan, slide, link, slide.point).left
    if left:
        step = board.turn(f"h{link}", along, 1j * left, because("offset"))
        start = board.lay_off(f"K{link}'", start, step, because("line_offset"))
    ways = board.given(FREE, values(mechanism, turn), because("stroke_ways"))
    end = plan.name(slide.point, board.lay_off(slide.point, start, ways, because("stroke_divided")))
    own = mechanism.links[link].points[slide.point]
    plan.images[link] = Image(end, along, own, slide.way(link).direction)
    return plan


def velocities(plan: Plan, rates: Rates) -> None:
    """Lay off from the pole the velocity of the slider, along its guide."""
    unit = plan.mechanism.drive.unit
    _pushed_on(plan, "v", unit * np.asarray(rates.omega), (because("stroke_speed"), because("slider_velocity")))


def accelerations(plan: Plan, rates: Rates) -> None:
    """Lay off from the pole the acceleration of the slider, along its guide."""
    unit = plan.mechanism.drive.unit
    why = because("stroke_acceleration") if np.any(rates.epsilon) else because("even_stroke")
    _pushed_on(plan, "a", unit * np.asarray(rates.epsilon), (why, because("slider_acceleration")))


def _pushed_on(plan: Plan, symbol: str, size: Floats, why: tuple[Message, Message]) -> None:
    """Lay off from the pole what the drive gives the slider, which does not turn."""
    slide, base = pushed(plan.mechanism), plan.positions.images[plan.mechanism.drive.link]
    along = plan.carry(guide.direction(plan, slide, FRAME))
    by = size.astype(complex) if size.ndim else complex(size)
    part = plan.board.turn(f"{symbol}_{slide.point}", along, by, why[0])
    end = plan.name(slide.point, plan.board.lay_off(plan.letter(slide.point), plan.pole, part, why[1]))
    plan.images[plan.mechanism.drive.link] = Image(end, None, base.at, base.span)


def vectors(mechanism: Mechanism) -> Iterator[Vector]:
    """Tell no vectors of its plans beside those of its points: it does not turn."""
    yield from ()
